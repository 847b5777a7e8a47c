"""What axes call the parameters and coordinates of a model."""

from __future__ import annotations

from ..models import Model

#: Names that are letters.
GREEK = {
    "alpha", "beta", "gamma", "delta", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu", "rho", "sigma", "tau", "phi", "psi",
}  # fmt: skip


def label(model: Model, name: str) -> str:
    """A parameter, a coordinate or its rate as an axis names it; the page's own symbol is that of a quantity with its unit."""
    if name in model.rates:
        return rf"$\dot{{{label(model, model.coordinates[model.rates.index(name)])[1:-1]}}}$"
    entries = {entry["name"]: entry for entry in model.about["parameters"]}
    if name in entries and entries[name]["quantity"] == name:
        symbol = entries[name]["symbol"]
    else:
        base, _, index = name.partition("_")
        symbol = rf"\{base}" if base in GREEK else base
        symbol += rf"_{{\rm {index}}}" if index else ""
    return f"${symbol}$ (deg)" if name in model.about["angles"] else f"${symbol}$"
