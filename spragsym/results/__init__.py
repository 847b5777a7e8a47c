"""Results on equilibria, and on the points, curves and paths on which they change: one class each, for every model."""
