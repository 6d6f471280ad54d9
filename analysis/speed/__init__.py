"""Tables, charts and chapters on time."""
