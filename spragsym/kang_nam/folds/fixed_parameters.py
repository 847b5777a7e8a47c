"""The parameters that stay where θ₀ and μ₀ are spanned."""

from typing import NamedTuple


class Fixed(NamedTuple):
    """κ, α, σ and β."""

    kappa: float
    alpha: float
    sigma: float
    beta: float


#: Their names.
FIXED = Fixed._fields
