"""The report of a study: its facts as text, HTML page and JSON."""

from __future__ import annotations

import os

from ..core.errors import ParameterError
from ..display import Table
from ..files.storage import put
from ..results import Result
from . import texts
from .advice import next_steps, warnings
from .facts import Facts


class Report(Facts, Result):
    """Report on a brake. The facts are attributes; methods write them as text, page and JSON."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about answers that may mislead or are not known, a sentence each."""
        return warnings(self)

    @property
    def verdict(self) -> str:
        """Sentences on the jump, on other states, on the motion and on the tolerances."""
        return " ".join(texts.verdict(self))

    @property
    def about(self) -> dict[str, str]:
        """Title, date and file as given, model, and version of spragsym."""
        return texts.about(self)

    @property
    def next_steps(self) -> tuple[str, ...]:
        """Next steps, at most five."""
        return tuple(f"{verb} {what}" for verb, what in next_steps(self))

    def to_dict(self) -> texts.Json:
        """The report as JSON data; quantities are in the units of the file.

        Returns
        -------
        dict

        Examples
        --------
        >>> from math import radians
        >>> import spragsym as ss
        >>> brake = {"m": 0.35, "k": 1.8e5, "k_x": 9e3, "k_y": 0.0, "k_c": 1.5e6, "F_L": 420.0}
        >>> brake |= {"L_0": 0.038, "theta0": radians(52), "mu0": 0.3}
        >>> report = ss.Study(brake).report(probability=False, redesign=False)
        >>> round(report.to_dict()["mu_jump"], 4)
        0.3663
        """
        return texts.as_json(self)

    def text(self) -> str:
        """The report as text: the verdict, then the numbers.

        Returns
        -------
        str

        Examples
        --------
        >>> from math import radians
        >>> import spragsym as ss
        >>> brake = {"m": 0.35, "k": 1.8e5, "k_x": 9e3, "k_y": 0.0, "k_c": 1.5e6, "F_L": 420.0}
        >>> brake |= {"L_0": 0.038, "theta0": radians(52), "mu0": 0.3}
        >>> report = ss.Study(brake).report(probability=False, redesign=False)
        >>> print(report.text().partition(":")[0])
        It does not sprag
        """
        return "\n".join(texts.blocks(self))

    def to_html(self, path: str | os.PathLike[str]) -> None:
        """Write the report as one HTML page with pictures (extra ``plot``).

        Parameters
        ----------
        path : str or path
            The file, which is overwritten.

        Raises
        ------
        MissingExtraError
            Without matplotlib.

        Examples
        --------
        >>> import pathlib, tempfile
        >>> import spragsym as ss
        >>> block = {"m": 2.0, "k": 800.0, "c": 1.0, "N_0": 1.0, "mu_s": 0.5, "v_s": 0.1, "V": 1.0}
        >>> report = ss.Study(block, model="stick_slip").report(oscillation=False)
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     report.to_html(pathlib.Path(folder, "report.html"))
        ...     pathlib.Path(folder, "report.html").read_text(encoding="utf-8")[:15]
        '<!DOCTYPE html>'
        """
        import spragsym  # a shorthand: no room imports one behind it

        put(path, spragsym.figures.report_page(self))

    def as_table(self) -> Table:
        """The rows of the text as a table.

        Returns
        -------
        Table
            Title, header and rows of text.

        Examples
        --------
        >>> from math import radians
        >>> import spragsym as ss
        >>> brake = {"m": 0.35, "k": 1.8e5, "k_x": 9e3, "k_y": 0.0, "k_c": 1.5e6, "F_L": 420.0}
        >>> brake |= {"L_0": 0.038, "theta0": radians(52), "mu0": 0.3}
        >>> report = ss.Study(brake).report(probability=False, redesign=False)
        >>> report.as_table().header
        ('', 'value')
        """
        return Table(
            self.verdict,
            ("", "value"),
            tuple(row for _, rows in texts.sections(self) for row in rows),
        )

    def _for_file(self) -> Report:
        raise ParameterError(
            "path: a report is computed anew from its study; "
            "write to_html(path), or json.dumps(to_dict())"
        )

    def _shown(self) -> texts.Json:
        """Fields of the table: none."""
        return {}

    __str__ = text

    def __repr__(self) -> str:
        return f"Report({self.verdict!r}, {self.study!r})"
