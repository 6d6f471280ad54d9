"""What charts share: frame, colours, letters, marks; and the chart of speed against error."""
