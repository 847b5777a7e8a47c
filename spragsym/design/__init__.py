"""From a brake to a verdict: how sure a jump is, how far it is, and what to change, for every model."""
