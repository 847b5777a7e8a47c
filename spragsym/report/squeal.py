"""``[matrices]`` of a file: a brake of a finite-element model, and its verdict on squeal."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, TypeAlias, cast

import numpy as np

from ..core.errors import ModelError, ParameterError, hint
from ..core.type_variables import T
from ..files.text import FilePath, brake_text, has_shape, path_text, printed
from ..matrices.answers import MatrixOnsets, Modes, flutter_onsets, modes
from ..matrices.contacts import read_contacts
from ..matrices.files import read as read_matrix
from ..matrices.model import LARGEST, Matrix, MatrixModel, matrices
from ..models.parameters import (
    FINITE,
    NOT_NEGATIVE,
    POSITIVE,
    FloatArray,
    ParameterSet,
    Range,
    Span,
)
from ..models.quantities import factor
from .data import DataFile, looked_at
from .units import Measured, hertz, read, read_exact

#: Rows of a section: what it is, and what is said of it.
Section: TypeAlias = list[tuple[str, str]]
_NUMBER = int | float


@dataclass(frozen=True, eq=False)
class SquealStudy:
    """A brake of matrices, in seconds, and what is asked of it.

    ``value`` is where the parameter that varies works, in the middle of its range unless the file
    says another; ``band`` are frequencies in Hz.
    """

    source: str
    title: str
    parameters: ParameterSet
    vary: str
    between: Span
    value: float
    threshold: float | None
    band: Span | None
    remarks: tuple[str, ...]

    @property
    def model(self) -> MatrixModel:
        """The model of its parameters."""
        return cast(MatrixModel, self.parameters.model)

    def report(self) -> SquealReport:
        """The verdict."""
        onsets = flutter_onsets(
            self.parameters,
            self.vary,
            between={self.vary: self.between},
            threshold=self.threshold,
        )
        at = modes(self.parameters.replace(**{self.vary: self.value}))
        begins = modes(self.parameters.replace(**{self.vary: self.between[0]}))
        return SquealReport(self, onsets, at, begins)

    def over(self, name: str, values: FloatArray) -> list[tuple[float, MatrixOnsets]]:
        """The onsets at each value of another parameter than the one that varies."""
        self.model.require_parameter(name)
        if name == self.vary:
            raise ParameterError(f"--over {name} is what varies already; name another parameter")
        asked, between = self.parameters, {self.vary: self.between}
        return [
            (
                float(one),
                flutter_onsets(
                    asked.replace(**{name: float(one)}),
                    self.vary,
                    between=between,
                    threshold=self.threshold,
                ),
            )
            for one in values
        ]

    def of_band(self, frequency_hz: float) -> bool:
        """Whether a frequency lies in the band; that of a divergence, 0, always does."""
        return self.band is None or not frequency_hz or self.band[0] <= frequency_hz <= self.band[1]


@dataclass(frozen=True, eq=False)
class SquealReport:
    """The onsets of a brake of matrices, in its band, and its modes."""

    study: SquealStudy
    onsets: MatrixOnsets
    modes: Modes  #: where it works
    first: Modes  #: at the lower end of the range

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The onsets in the band."""
        return [row for row in self.onsets if self.study.of_band(row["frequency_hz"])]

    @property
    def squeals(self) -> bool | None:
        """Whether a mode of the band grows faster than the threshold; None if it is not known."""
        counts = self.onsets.growing[:, 2]
        if self.rows or self._at_first():
            return True
        return None if counts.any() or not self.onsets.complete else False

    def _at_first(self) -> list[float]:
        """Frequencies of the modes of the band that grow at the lower end, if any is proved to."""
        low, growing = self.study.between[0], self.onsets.growing
        if not any(count for start, _, count in growing if start == low):
            return []
        return [
            float(row["frequency_hz"])
            for row in self.first
            if row["growth"] > self.onsets.threshold and self.study.of_band(row["frequency_hz"])
        ]

    def verdict(self) -> str:
        """A sentence or two."""
        study, on = self.study, self.onsets
        name, (low, high) = study.vary, study.between
        within = f"of {name} from {low:g} to {high:g}"
        faster = f" faster than {on.threshold:.3g} 1/s" if on.threshold else ""
        band = "" if study.band is None else " of {} to {}".format(*map(hertz, study.band))
        these = "these" if study.model.full is None else "the reduced"
        text, first = "", self._at_first()
        if first:
            text = f"It squeals already at {name} = {low:g}, at {', '.join(map(hertz, first))}."
        elif self.rows:
            row = self.rows[0]
            where = f"{'from' if row['direction'] == 'up' else 'up to'} {name} = {row[name]:.6g} on"
            if row["kind"] == "divergence":
                text = f"It diverges: {where} it leaves its state without oscillating."
            else:
                what = f"a mode of {hertz(row['frequency_hz'])} grows{faster}"
                text = f"It squeals: {where} {what}."
        elif self.squeals is False:
            return (
                f"It does not squeal: at no value {within} does a mode{band} grow{faster}. That "
                f"is proved for {these} matrices."
            )
        elif on.complete:
            text = f"No mode{band} begins to grow{faster} {within}, but others do."
        else:
            text = f"Whether a mode{band} grows{faster} is not decided everywhere {within}."
        if on.complete:
            text += f" These are all onsets{band} {within}: proved for {these} matrices."
        return text

    def remarks(self) -> list[str]:
        """What limits the answer."""
        beyond, unique = len(self.onsets) - len(self.rows), self.unique_up_to
        more = [f"{beyond} more onsets lie outside of the band"] if beyond else []
        if unique is not None:
            more.append(
                f"with contacts that open, there is one state of sliding under every load up to mu "
                f"= {unique:.6g}: proved; beyond it there may be several, and jumps"
            )
        return [*self.study.remarks, *self.onsets.remarks, *more]

    @cached_property
    def unique_up_to(self) -> float | None:
        """The friction up to which sliding is unique; None where that is not asked: without contact
        pairs, in a large model, or where only contacts hold a body.
        """
        study, model = self.study, self.study.model
        whole = model.full or model
        if not whole.pairs or whole.size > LARGEST:
            return None
        try:
            return model.unique_up_to(study.parameters.replace(**{study.vary: study.value}))
        except ModelError:
            return None

    def sections(self) -> dict[str, Section]:
        """Onsets, the least damped modes of the band, and the data."""
        study, name = self.study, self.study.vary
        found = dict[str, Section]()
        found["Onsets"] = [
            (
                f"{name} = {row[name]:.8g}",
                f"{row['kind']}, {hertz(row['frequency_hz'])}, grows "
                f"{'above' if row['direction'] == 'up' else 'below'} it; error {row['error']:.1e}"
                + (f"; full model {row['full_model']:.6g}" if "full_model" in row else "")
                + f"; with a mode of {hertz(row['partner_hz'])}"
                * bool(np.isfinite(row["partner_hz"])),
            )
            for row in self.rows
        ]
        shown = sorted(
            (row for row in self.modes if study.of_band(row["frequency_hz"])),
            key=lambda row: float(row["damping_ratio"]),
        )
        found[f"Least damped modes at {name} = {study.value:g}, computed"] = [
            (
                hertz(row["frequency_hz"]),
                f"damping ratio {row['damping_ratio']:.3g}, growth {row['growth']:.3g} 1/s",
            )
            for row in shown[:8]
        ]
        model = study.model
        found["Data"] = [
            ("file", study.source),
            ("matrices", model.about["summary"]),
            *(
                (one, f"{float(study.parameters[one]):g}")
                for one in model.parameters
                if one != name
            ),
            (name, f"{study.between[0]:g} to {study.between[1]:g}"),
            ("threshold of growth", f"{self.onsets.threshold:.4g} 1/s"),
            *([] if study.band is None else [("band", " to ".join(map(hertz, study.band)))]),
        ]
        return found

    def to_dict(self) -> dict[str, Any]:
        """All of it as data for JSON."""
        study, on = self.study, self.onsets
        held = {
            name: float(study.parameters[name])
            for name in study.parameters.model.parameters
            if name != study.vary
        }
        return {
            "model": "matrices",
            "parameters": held,
            "vary": study.vary,
            "between": [*study.between],
            "threshold": on.threshold,
            "band_hz": None if study.band is None else [*study.band],
            "squeals": self.squeals,
            "unique_up_to": self.unique_up_to,
            "onsets": self.rows,
            "complete": on.complete,
            "undecided": on.undecided.tolist(),
            "growing": on.growing.tolist(),
            "modes": [*self.modes],
            "remarks": self.remarks(),
        }


def read_squeal(path: FilePath) -> SquealStudy:
    """Read a brake of matrices from a TOML file.

    Its table ``[matrices]`` has ``M``, ``K``, and ``friction`` or ``contacts``; further ``C``,
    ``G``, ``stiffnesses``, ``dampings``, ``dofs`` and ``units``, each matrix the name of a file or
    ``["file.mat", "name"]``. Its table ``[parameters]`` has numbers, and one range of the one that
    varies, ``mu = "[0, 0.8]"``. Above the tables may stand ``title``, ``band``, ``threshold``,
    ``damping_ratio``, ``rayleigh``, and ``modes``, to how many the model is reduced. Mistakes raise
    a ParameterError with file, line, key, value and what to write.
    """
    return _Reader(path_text(path), brake_text(path)).read()


class _Reader(DataFile):
    def read(self) -> SquealStudy:
        """The study that the file describes."""
        content = self.content()
        for key, value in content.items():
            printed(self.of(key), {key: value})
        self._known(
            content,
            (
                "title",
                "band",
                "threshold",
                "damping_ratio",
                "rayleigh",
                "modes",
                "matrices",
                "parameters",
            ),
        )
        table, values = (self._table(content, name) for name in ("matrices", "parameters"))
        own = {"M", "K", "C", "G", "friction", "contacts", "stiffnesses", "dampings"}
        self._known(table, (*sorted(own), "dofs", "units"))
        missing = [one for one in ("M", "K") if one not in table]
        if ("friction" in table) == ("contacts" in table):
            missing.append("either friction or contacts")
        if missing:
            raise ParameterError(
                f"{self.table('matrices')}: [matrices] needs {', '.join(missing)}; write a line "
                'such as K = "stiffness.mtx"'
            )
        with self.at("units"):
            second = _second(table.get("units", "kg m s"))
        powers = {"M": 2, "G": 2, "C": 1, "dampings": 1}
        given = dict[str, Any]()
        for key in [one for one in table if one in own]:
            with self.at(key):
                scale = second ** powers.get(key, 0)
                if key == "contacts":
                    given["friction"] = read_contacts(self._path(table[key]))
                elif key in ("stiffnesses", "dampings"):
                    given[key] = {one: self._matrix(of, scale) for one, of in table[key].items()}
                else:
                    given[key] = self._matrix(table[key], scale)
        if "dofs" in table:
            with self.at("dofs"):
                given["dofs"] = self._path(table["dofs"])
        ratio = self._number(content, "damping_ratio", "1", NOT_NEGATIVE, read_exact)
        with self.at("matrices"):
            model = matrices(**given, damping_ratio=ratio, rayleigh=content.get("rayleigh"))
        if "modes" in content:
            with self.at("modes"):
                model = model.reduced(content["modes"])
        read_values = {name: self._value(name, one) for name, one in values.items()}
        self._known(read_values, model.parameters)
        varying = [name for name, one in read_values.items() if one.varies] or ["mu"]
        if len(varying) > 1:
            raise ParameterError(
                f"{self.of(varying[1])}: {' and '.join(varying)} have ranges; leave one to vary"
            )
        name = varying[0]
        vary = read_values.setdefault(name, Measured(0.5, 0.0, 1.0, ""))
        if not vary.varies:
            raise ParameterError(f'{self.of(name)}: nothing varies; write {name} = "[0, 1]"')
        others = {one: each.value for one, each in read_values.items() if one != name}
        band = self._number(content, "band", "Hz", POSITIVE, read)
        return SquealStudy(
            source=Path(self.path).name,
            title=str(content.get("title", "")),
            parameters=model.Parameters(**others),
            vary=name,
            between=(vary.low, vary.high),
            value=vary.value,
            threshold=self._number(content, "threshold", "1/s", FINITE, read_exact),
            band=None if band is None else (band.low, band.high),
            remarks=_on_units(second),
        )

    def _known(self, given: Mapping[str, object], allowed: tuple[str, ...]) -> None:
        for key in given:
            if key not in allowed:
                remark = hint(key, allowed) or f"; the keys are {', '.join(allowed)}"
                raise ParameterError(f"{self.of(key)}: {key} does not belong here{remark}")

    def _table(self, content: Mapping[str, Any], name: str) -> dict[str, Any]:
        table = content.get(name, {} if name == "parameters" else None)
        if not isinstance(table, dict):
            raise ParameterError(f"{self.path}: [{name}] is missing; begin with a line [{name}]")
        return table

    def _path(self, given: object) -> Path:
        if not isinstance(given, str) or not given.strip():
            raise ParameterError(f'{given!r} is no file name; write K = "stiffness.mtx"')
        return self.beside() / given

    def _matrix(self, given: object, scale: float) -> Matrix:
        """A matrix of a file in seconds; of several, the named one."""
        file, name = given if isinstance(given, list) and len(given) == 2 else (given, None)
        if file != given and not isinstance(name, str):
            raise ParameterError(f'{name!r} names no matrix; write K = ["brake.mat", "K"]')
        one = read_matrix(self._path(file), name)
        return one if scale == 1.0 else one * scale

    def _number(
        self,
        content: Mapping[str, Any],
        key: str,
        unit: str,
        allowed: Range,
        how: Callable[..., T],
    ) -> T | None:
        """A quantity, if there is one; numbers alone are in the given unit."""
        if key not in content:
            return None
        given = content[key]
        if unit != "1" and any(has_shape(given, one) for one in (_NUMBER, (_NUMBER, _NUMBER))):
            given = f"{given!r} {unit}"
        with self.at(key):
            return looked_at(how, key, given, unit, allowed)

    def _value(self, name: str, given: object) -> Measured:
        """A number or a range of a parameter."""
        with self.at(name):
            return looked_at(read, name, given, "1/s" if name == "Omega" else "1", FINITE)


def _second(units: object) -> float:
    """The unit of time of a consistent system, as ``t mm s``, in seconds."""
    words = units.split() if isinstance(units, str) else []
    if len(words) != 3:
        raise ParameterError(
            f'units = {units!r} are not those of mass, length and time; write units = "t mm s"'
        )
    return [factor(word, si) for word, si in zip(words, ("kg", "m", "s"), strict=True)][2]


def _on_units(second: float) -> tuple[str, ...]:
    if second == 1.0:
        return ()
    return (
        f"the matrices are taken in seconds: M and C times {second**2:g} and {second:g}, rounded "
        "to floats",
    )
