"""Tables, charts and chapters on right and wrong answers."""
