"""What is known of equilibria, and of the points, curves and paths on which they change: one class each, for every model."""
