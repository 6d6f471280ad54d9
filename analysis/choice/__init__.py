"""Which method a scene needs, and the error bounds that prove it."""
