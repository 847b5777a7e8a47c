"""Greek names of a page's quantities: as letters in figures and in the explorer, against Unicode."""

import json
import shutil
import subprocess
import unicodedata

import pytest

pytest.importorskip("matplotlib")

from matplotlib.mathtext import MathTextParser

from spragsym.figures.style import symbol
from tests.support import ROOT

#: Letters that Latin has too; π is a number.
LATIN = "ΑΒΕΖΗΙΚΜΝΟΡΤΧΠοπς\u03a2"
LETTERS = {
    (name.lower() if letter.islower() else name.capitalize()): letter
    for letter in map(chr, (*range(0x391, 0x3AA), *range(0x3B1, 0x3CA)))
    if letter not in LATIN
    for name in [unicodedata.name(letter).split()[-1].replace("LAMDA", "LAMBDA")]
}


def test_figures_write_every_greek_letter() -> None:
    assert len(LETTERS) == 32
    for name in LETTERS:
        assert symbol(name) == symbol(f"{name}_") == f"\\{name}"
        MathTextParser("path").parse(f"${symbol(name)}_0$")
    assert symbol("rate") == r"\mathrm{rate}"


@pytest.mark.skipif(shutil.which("node") is None, reason="no node on this machine")
def test_the_explorer_writes_every_greek_letter() -> None:
    source = (ROOT / "explorer" / "src" / "symbols.js").as_uri()
    asked = json.dumps([f"{name}{end}" for name in LETTERS for end in ("", "_", "0_b")])
    code = (
        f'import {{ symbolOf }} from "{source}"; console.log(JSON.stringify({asked}.map(symbolOf)))'
    )
    told = subprocess.run(
        ["node", "--input-type=module", "-e", code], capture_output=True, text=True, check=True
    )
    expected = [f"{letter}{end}" for letter in LETTERS.values() for end in ("", "", "₀_b")]
    assert json.loads(told.stdout) == expected
