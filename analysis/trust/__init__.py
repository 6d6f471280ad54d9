"""How far a number may be believed: intervals, noise, controls, placement."""
