"""Our assumptions, in one place: values that the figures and claims need and the article does not state."""

#: Belt speed and steepness of the friction law.
V, D = 0.5, 10.0
#: Frictions of Figures 11 to 14.
MU0_RANGE = (0.0, 1.0)
