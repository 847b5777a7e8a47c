"""Values that the figures and statements need and the article does not state: our assumptions."""

from ..kang_nam.parameters import Parameters as Parameters

#: Belt speed.
V: float = Parameters.V
#: Steepness of the friction law.
D: float = Parameters.d
#: Smallest and largest friction of Figures 11 to 14.
MU0_RANGE = (0.0, 1.0)
#: A state on the oscillation of period 34 at 42°.
ON_CYCLE = (2.538161566773, 3.361504868710, 0.0, 0.361278176249)
