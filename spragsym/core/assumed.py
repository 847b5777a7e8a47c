"""Our assumptions, in one place: values that the figures and claims need and the article does not
state.
"""

#: Belt speed and steepness of the friction law.
V, D = 0.5, 10.0
#: Frictions of Figures 11 to 14.
MU0_RANGE = (0.0, 1.0)
#: A state on the oscillation of period 34 at 42°.
ON_CYCLE = (2.538161566773, 3.361504868710, 0.0, 0.361278176249)
