"""Functions between newtons, metres and seconds and the dimensionless model."""

from __future__ import annotations

from ...emit.function import Function, Module
from .. import mechanics
from .. import nomenclature as nm


def module() -> Module:
    scales, groups = mechanics.scales(), mechanics.groups()
    published = (nm.kappa, nm.alpha, nm.sigma, nm.beta, nm.V, nm.creep)
    dimensionless = (*published, *mechanics.further_parameters())
    dimensional = tuple(groups[symbol][0] for symbol in published)
    brought_in = tuple(groups[symbol][0] for symbol in mechanics.further_parameters())
    return Module(
        "scales",
        "Between newtons, metres and seconds and the dimensionless model: text after (9).",
        (
            Function(
                "scales", "Scales of length, time and force.", "text after (9)", (nm.m_mass, nm.k_c, nm.L_0),
                (scales["length"], scales["time"], scales["force"]), "length, time, force", share=False,
            ),
            Function(
                "dimensionless_groups", "The dimensionless parameters of dimensional data.", "text after (9)",
                (nm.m_mass, nm.k_c, nm.L_0, *dimensional),
                tuple(groups[symbol][0] / groups[symbol][1] for symbol in dimensionless),
                ", ".join(str(symbol) for symbol in dimensionless), share=False, further=brought_in,
            ),
        ),
    )  # fmt: skip
