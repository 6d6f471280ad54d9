"""Several runs side by side, and those that are kept for it."""
