"""The same for rays and triangles in space."""
