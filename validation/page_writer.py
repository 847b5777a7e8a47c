"""Pages at random, from everything that the vocabulary allows, each as text and as what its
statements are made of.

The parts are kept as text, and :mod:`validation.page_mechanics` evaluates them as numbers: nothing
of ``derive/`` is used. Units become 1, so that the dimensionless values of the parameters are what
the quantities are.
"""

from dataclasses import dataclass, field

import numpy as np

Point = tuple[str, str]

#: Names of coordinates: lengths, and angles.
LENGTHS, ANGLES = (
    ("x", "y", "u", "w", "z", "s_1", "q_2", "xi"),
    ("phi", "psi_1", "theta", "gamma", "p_hi"),
)
#: Names that once were in the way of something.
ODD = (
    "speed",
    "creep",
    "w0",
    "h",
    "e",
    "i",
    "one_half",
    "E",
    "S",
    "N",
    "pi_1",
    "x_2",
    "lam",
    "root0",
    "k_c2",
    "f",
    "J",
)


@dataclass
class Drawn:
    """A page: the parts of its statements."""

    coordinates: list[tuple[str, str]] = field(default_factory=list)
    parameters: list[tuple[str, str, str, float]] = field(
        default_factory=list
    )  #: name, unit, domain, base value
    kinetic: list[tuple[str, list[str]]] = field(
        default_factory=list
    )  #: a mass, and displacements whose squared rates it multiplies
    springs: list[tuple[str, str, str]] = field(default_factory=list)  #: stiffness, along, length
    lines: list[tuple[str, Point, Point, str]] = field(default_factory=list)
    torsions: list[tuple[str, Point, Point, str]] = field(default_factory=list)
    dampers: list[tuple[str, str]] = field(default_factory=list)
    line_dampers: list[tuple[str, Point, Point]] = field(default_factory=list)
    potentials: list[str] = field(default_factory=list)
    forces: list[tuple[list[str], list[str]]] = field(
        default_factory=list
    )  #: components, and the displacements that they act along
    contact: tuple[str, str, bool] | None = None  #: gap, law of ``depth``, unilateral
    normal: str = ""  #: a given normal force
    friction: tuple[str, str, str, str] | None = None  #: along, belt, law of ``v``, at_rest

    def text(self) -> str:
        """The page."""
        lines = [
            '"""A page at random, which has no drawing."""',
            "from spragsym.derive.model import Abs, Page, atan, cos, exp, log, pi, sgn, sin, "
            "sqrt, tanh",
            'page = Page("A page at random.")',
            'm = page.unit("m", "kg", "mass")',
            'k_c = page.unit("k_c", "N/m", "stiffness")',
            'L_0 = page.unit("L_0", "m", "length")',
        ]
        lines += [
            f'{n} = page.parameter("{n}", "{unit}", "a quantity", "{domain}", {base})'
            for n, unit, domain, base in self.parameters
        ]
        lines += [
            f'{n} = page.coordinate("{n}", "{unit}", "a coordinate")'
            for n, unit in self.coordinates
        ]
        squares = [
            f"{mass} * ({' + '.join(f'page.rate({part}) ** 2' for part in parts)}) / 2"
            for mass, parts in self.kinetic
        ]
        lines += [f"page.kinetic({' + '.join(squares)})"]
        lines += [
            f"page.spring({k}, along={along}" + (f", length={r})" if r else ")")
            for k, along, r in self.springs
        ]
        lines += [
            f"page.spring({k}, {_point(a)}, {_point(b)}, length={r})" for k, a, b, r in self.lines
        ]
        lines += [
            f"page.torsion({k}, {_point(a)}, {_point(b)}, rest={r})" for k, a, b, r in self.torsions
        ]
        lines += [f"page.damper({c}, along={along})" for c, along in self.dampers]
        lines += [f"page.damper({c}, {_point(a)}, {_point(b)})" for c, a, b in self.line_dampers]
        lines += [f"page.potential({energy})" for energy in self.potentials]
        for parts, places in self.forces:
            lines += [
                f"page.force({parts[0]}, along={places[0]})"
                if len(parts) == 1
                else f"page.force({parts[0]}, {parts[1]}, at=({places[0]}, {places[1]}))"
            ]
        if self.contact:
            gap, law, unilateral = self.contact
            lines += [
                f"page.contact({gap}, lambda depth: {law}"
                + ("" if unilateral else ", unilateral=False")
                + ")"
            ]
        if self.normal:
            lines += [f"page.normal_force({self.normal})"]
        if self.friction:
            along, belt, law, at_rest = self.friction
            lines += [
                f"page.friction({along}, {belt}, lambda v: {law}"
                + (f", at_rest={at_rest})" if at_rest else ")")
            ]
        return "\n".join(lines) + "\n"


def _point(point: Point) -> str:
    return f"({point[0]}, {point[1]})"


class _Writer:
    """Draws the parts of a page."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.rng, self.page = rng, Drawn()
        self.names = iter(rng.permutation(ODD))

    def pick(self, *parts: str) -> str:
        return str(self.rng.choice(list(parts)))

    def chance(self, share: float) -> bool:
        return bool(self.rng.random() < share)

    def parameter(self, name: str, unit: str, domain: str, low: float, high: float) -> str:
        """A quantity of the page, once; now and then by an odd name."""
        name = str(next(self.names, name)) if self.chance(0.1) and "_" in name else name
        base = round(float(np.exp(self.rng.uniform(np.log(low), np.log(high)))), 4)
        if all(name != known for known, *_ in self.page.parameters):
            self.page.parameters.append((name, unit, domain, base))
        return name

    # ---------------------------------------------------------------------------------------------
    # displacements

    def simple(self) -> str:
        """A coordinate, as a length."""
        name, unit = self.page.coordinates[int(self.rng.integers(len(self.page.coordinates)))]
        return (
            name
            if unit == "m"
            else self.pick(
                f"L_0 * sin({name})",
                f"L_0 * {name}",
                f"L_0 * (1 - cos({name}))",
                f"L_0*sin({name})/3",
            )
        )

    def displacement(self) -> str:
        """A length that depends on the coordinates."""
        one, two = self.simple(), self.simple()
        match int(self.rng.integers(8)):
            case 0:
                return f"{one} + {self.parameter('a_1', '1', 'real', 0.2, 1.5)} * {two}"
            case 1:
                angle = self.parameter("eps_1", "rad", "(-pi, pi)", 0.2, 1.2)
                return f"{one} * cos({angle}) + {two} * sin({angle})"
            case 2:
                return f"{one} - {two}" if one != two else one
            case 3:
                return f"{one} + {self.parameter('b_1', '1', '>= 0', 0.05, 0.3)} * ({two})**2 / L_0"
            case _:
                return one

    def point(self) -> Point:
        """A point that moves."""
        one, two = self.simple(), self.simple()
        return (one, two if two != one else "0")

    def anchor(self) -> Point:
        """One that does not."""
        match int(self.rng.integers(3)):
            case 0:
                angle = self.parameter("theta0", "rad", "(0, pi)", 0.4, 2.0)
                return f"L_0 * cos({angle})", f"L_0 * sin({angle})"
            case 1:
                return "L_0", self.parameter("h_1", "m", "> 0", 0.3, 1.5)
            case _:
                return self.pick("-L_0", "L_0/2"), self.pick("L_0", "3*L_0/2")

    # ---------------------------------------------------------------------------------------------
    # statements

    def write(self) -> Drawn:
        rng, page = self.rng, self.page
        count = int(rng.choice([1, 2, 3, 4], p=[0.25, 0.4, 0.2, 0.15]))
        lengths, angles = iter(rng.permutation(LENGTHS)), iter(rng.permutation(ANGLES))
        for place in range(count):
            angle = self.chance(0.4 if place == 0 and count == 1 else 0.2)
            page.coordinates.append(
                (str(next(angles)), "rad") if angle else (str(next(lengths)), "m")
            )
        self.kinetic()
        for place, (name, unit) in enumerate(page.coordinates):
            if unit == "rad":
                self.hold_angle(name, place)
            elif self.chance(0.9):
                page.springs.append((self.stiffness(place), name, self.pick("", "", "", "L_0/3")))
        for _ in range(int(rng.integers(0, 3))):
            self.extra()
        if not page.forces or self.chance(0.5):
            self.load()
        self.laws()
        return page

    def stiffness(self, place: int) -> str:
        return self.parameter(f"k_{place}", "N/m", self.pick("> 0", ">= 0"), 0.05, 2.0)

    def kinetic(self) -> None:
        page = self.page
        for place, (name, unit) in enumerate(page.coordinates):
            mass = (
                "m"
                if place == 0 and unit == "m"
                else self.pick("m", "m/3", self.parameter(f"m_{place}", "kg", "> 0", 0.2, 3.0))
            )
            page.kinetic.append((mass, [name if unit == "m" else f"L_0 * {name}"]))
        if self.chance(0.3):
            a, b = self.point()
            page.kinetic.append(
                (self.parameter("m_e", "kg", "> 0", 0.1, 1.0), [a, b] if b != "0" else [a])
            )

    def hold_angle(self, name: str, place: int) -> None:
        page = self.page
        strength = self.parameter(f"k_{place}", "N/m", "> 0", 0.1, 2.0)
        others = [other for other, unit in page.coordinates if unit == "rad" and other != name]
        if others and self.chance(0.4):
            # A joint between two links, which turn together.
            rest = self.parameter(f"rest_{place}", "rad", "(-pi, pi)", 0.1, 1.0)
            joint = f"{name} - {others[0]} - {rest}"
            page.potentials.append(f"{strength} * L_0**2 * ({joint})**2 / 2")
            return
        match int(self.rng.integers(3)):
            case 0:
                rest = self.parameter(f"rest_{place}", "rad", "(-pi, pi)", 0.1, 1.0)
                page.potentials.append(f"{strength} * L_0**2 * ({name} - {rest})**2 / 2")
            case 1:
                rest = self.parameter(f"rest_{place}", "rad", "(-pi, pi)", 0.1, 1.0)
                page.torsions.append(
                    (
                        f"{strength} * L_0**2",
                        ("0", "0"),
                        (f"L_0 * cos({name})", f"L_0 * sin({name})"),
                        rest,
                    )
                )
            case _:
                page.potentials.append(f"{strength} * L_0**2 * (1 - cos({name}))")

    def extra(self) -> None:
        page = self.page
        match int(self.rng.integers(9)):
            case 0 | 1:
                page.lines.append(
                    (
                        self.parameter("k_l", "N/m", "> 0", 0.05, 0.8),
                        self.point(),
                        self.anchor(),
                        self.pick("L_0", "L_0", "0", "L_0/3"),
                    )
                )
            case 2:
                page.springs.append(
                    (
                        self.parameter("k_s", "N/m", ">= 0", 0.05, 1.0),
                        self.displacement(),
                        self.pick("", "L_0*a_2"),
                    )
                )
                if "a_2" in page.springs[-1][2]:
                    page.springs[-1] = (
                        *page.springs[-1][:2],
                        f"L_0*{self.parameter('a_2', '1', '>= 0', 0.1, 0.6)}",
                    )
            case 3 | 4:
                page.dampers.append(
                    (self.parameter("c_1", "N s/m", ">= 0", 0.01, 0.5), self.displacement())
                )
            case 5:
                page.line_dampers.append(
                    (self.parameter("c_2", "N s/m", ">= 0", 0.01, 0.5), self.point(), self.anchor())
                )
            case 6:
                one = self.displacement()
                page.potentials.append(
                    self.pick(
                        f"k_c * ({one})**4 / L_0**2 / 8",
                        f"k_c * L_0**2 * (sqrt(1 + ({one})**2 / L_0**2) - 1) / 5",
                        f"k_c * L_0**2 * log(1 + ({one})**2 / L_0**2) / 7",
                        f"k_c * L_0**2 * exp(-({one})**2 / L_0**2) / 9",
                    )
                )
            case 7:
                page.springs.append(
                    (
                        f"k_c * ({self.parameter('a_3', '1', 'real', 0.1, 0.7)})**2",
                        self.displacement(),
                        "",
                    )
                )
            case _:
                self.load()

    def load(self) -> None:
        force = self.parameter("F_L", "N", "> 0", 0.01, 0.4)
        if self.chance(0.5):
            self.page.forces.append(
                (
                    [f"-{force}"],
                    [self.page.contact[0] if self.page.contact else self.displacement()],
                )
            )
        else:
            self.page.forces.append((["0", f"-{force}"], list(self.point())))

    def laws(self) -> None:
        page = self.page
        if self.chance(0.1):
            return
        if self.chance(0.12):
            page.normal = self.parameter("F_n", "N", "> 0", 0.05, 1.0) + self.pick(
                "", "", f" * (1 + ({self.simple()})**2 / L_0**2)"
            )
        else:
            law = self.contact_law()
            page.contact = (
                self.gap(),
                law,
                self.chance(0.8) or "log" in law or "depth / L_0)" in law,
            )
            if self.chance(0.95):  # else nothing may press, and what rests is on the border
                page.forces.append(
                    ([f"-{self.parameter('F_g', 'N', '> 0', 0.02, 0.3)}"], [page.contact[0]])
                )
        if self.chance(0.9):
            mu, d = (
                self.parameter("mu0", "1", ">= 0", 0.1, 1.2),
                self.parameter("d", "s/m", "> 0", 2.0, 20.0),
            )
            law, at_rest = self.friction_law(mu, d)
            page.friction = (
                self.slide(),
                self.parameter("V", "m/s", ">= 0", 0.1, 1.0),
                law,
                at_rest if self.chance(0.6) else "",
            )

    def gap(self) -> str:
        one, two = self.simple(), self.simple()
        names = dict(self.page.coordinates)
        angles = [name for name, unit in names.items() if unit == "rad"]
        if angles and self.chance(0.5):
            h = self.parameter("h_2", "m", "(0.1, 2)", 0.5, 0.95)
            return f"{h} - L_0 * cos({self.pick(*angles)})"
        match int(self.rng.integers(6)):
            case 0:
                return f"{one} - {two}" if one != two else one
            case 1:
                return (
                    f"{one} - {self.parameter('b_2', 'm', '>= 0', 0.02, 0.3)} * sin(({two}) / L_0)"
                    if one != two
                    else one
                )
            case 2:
                return (
                    f"{one} + {self.parameter('a_4', '1', 'real', 0.1, 0.6)} * {two}"
                    if one != two
                    else one
                )
            case 3:
                return f"{one} + ({two})**2 / L_0 / 5" if one != two else one
            case _:
                return one

    def contact_law(self) -> str:
        hard = self.parameter("k_h", "N/m", ">= 0", 0.1, 3.0)
        return self.pick(
            "k_c * depth",
            "k_c * depth",
            f"k_c * depth + {hard} * depth**2 / L_0",
            "k_c * L_0 * (depth / L_0) ** (3 / 2)",
            "k_c * depth / (1 + depth / L_0)",
            "k_c * L_0 * log(1 + depth / L_0)",
            f"k_c * L_0 * (depth/L_0 + {hard}*(depth/L_0)**3/k_c)",
        )

    def slide(self) -> str:
        one, two = self.simple(), self.simple()
        if self.chance(0.6):
            return one
        return self.displacement() if self.chance(0.5) else f"{one} - {two}" if one != two else one

    def friction_law(self, mu: str, d: str) -> tuple[str, str]:
        low = self.parameter("r_mu", "1", "[0, 1]", 0.3, 0.9)
        fall = self.parameter("d_f", "s/m", "> 0", 0.5, 3.0)
        laws = [
            (f"{mu} * (1 - exp(-{d} * Abs(v))) * sgn(v)", mu),
            (f"{mu} * tanh({d} * v)", mu),
            (f"2 / pi * {mu} * atan({d} * v)", mu),
            (
                f"{mu} * ({low} + (1 - {low}) * exp(-{fall} * Abs(v))) * tanh({d} * v)",
                f"{mu} * {low}",
            ),
            (
                f"{mu} * ({low} + (1 - {low}) * exp(-{fall} * Abs(v))) * (1 - exp(-{d} * "
                "Abs(v))) * sgn(v)",
                f"{mu} * {low}",
            ),
            (f"{mu} * {d} * v / (1 + {d} * Abs(v))", mu),
            (f"{mu} * {d} * v / sqrt(1 + {d}**2 * v**2)", mu),
        ]
        return laws[int(self.rng.integers(len(laws)))]


def draw(seed: int, number: int) -> Drawn:
    """The page of a number: the same wherever it is drawn. Parameters that no statement uses are
    left out.
    """
    page = _Writer(np.random.default_rng([seed, number])).write()
    import re

    body = "\n".join(
        line
        for line in page.text().splitlines()
        if "page.parameter(" not in line and "page.unit(" not in line
    )
    used = set(re.findall(r"[A-Za-z_]\w*", body))
    page.parameters = [entry for entry in page.parameters if entry[0] in used]
    return page
