"""Every mistake in a file of data is told with the file, the line, the key, the value and the
remedy.
"""

import re
from pathlib import Path

import pytest

import spragsym as ss
from spragsym.report.data import read_brake
from spragsym.report.friction_curve import read_friction
from spragsym.report.units import read
from tests.oracles.mistakes import TOLERANT

#: What stands behind =.
GOOD = {name: f'"{text}"' for name, text in TOLERANT.items()}
#: Line of a key: the table's name is line 1.
LINES = {name: number for number, name in enumerate(GOOD, 2)}

#: (key, what stands behind =, what the message must say besides file, line and key).
VALUES = [
    ("m", "0.35", ["0.35", "no unit", '"0.35 kg"']),
    ("m", '"0.35 N"', ["'N' (newton) does not measure what kg does", '"0.35 kg"']),
    ("m", '""', ["not a number with a point", '"0.35 kg"']),
    ("m", "true", ["True", "neither text nor a number"]),
    ("m", '"1e400 kg"', ["too large"]),
    (
        "m",
        '"0.35 kg ± 120 %"',
        [
            "'0.35 kg ± 120 %'",
            "tolerance reaches -0.07 kg, out of range; all of it must be above 0 kg",
        ],
    ),
    ("m", '"0.35 kg; import os"', ["the unit 'kg; import os' can't be read"]),
    ("m", '"' + "9" * 300 + ' kg"', ["303 characters are too many"]),
    ("k", '"180 N/mm ± -15 %"', ["not a number with a point", '"180 N/mm ± 15 %"']),
    ("k", '"180 ± 15 %"', ["no unit"]),
    ("k", '"[210, 150] N/mm"', ["begins above its end", '"[150, 210] N/mm"']),
    ("k", '"[150, 180, 210] N/mm"', ["not a number with a point", '"[150, 210] N/mm"']),
    (
        "k",
        '"[0, 210] N/mm"',
        [
            "reaches 0 N/mm, out of range",
            "; all of it must be above 0 N/mm: without the inclined spring",
        ],
    ),
    ("L_0", '"38 degC"', ["'degC' is not known; write m, g"]),
    (
        "theta0",
        '"180 deg"',
        ["'180 deg'", "180 deg is out of range; it must be above 0 deg and below 180 deg"],
    ),
    ("k_y", '"-1 N/mm"', ["at least 0"]),
    ("k", '"150-210 N/mm"', ["not a number with a point", "[150, 210] N/mm"]),
    ("k", '"150 to 210 N/mm"', ["'to 210 N/mm' can't be read", "[150, 210] N/mm"]),
    ("k", '"180 N/mm +15% -10%"', ["'N/mm +15% -10%' can't be read", "[150, 210] N/mm"]),
    ("mu0", '"0.45 N"', ["'N'", "number without unit", '"0.45 ± 10 %"']),
    ("V", '"-1.2 m/s"', ["'-1.2 m/s'", "mirror image"]),
    ("theta0", '"52 grad"', ["'grad' has two meanings, deg and gon", '"52 deg ± 1 deg"']),
    (
        "mu0",
        '"45 % ± 10 %"',
        ["may be points or a share of the value", "(45 ± 10) %, for points", '"0.45 ± 10 %"'],
    ),
    ("k_y", '"0 N/mm ± 10 %"', ["10 % of 0, which is 0", '"0 N/mm"']),
    ("k", '"180 N/mm sd 40 %"', ["tolerance reaches -252 N/mm, out of range"]),
    ("k", '"180 N/mm sd 5 % in [200, 210] N/mm"', ["mean does not lie between"]),
    ("theta0", '"52° 30\'"', ["can't be read", '"52 deg ± 1 deg"']),
]


def written(folder: Path, lines: dict[str, str], *more: str, head: str = "[brake]") -> Path:
    file = folder / "brake.toml"
    file.write_text(
        "\n".join([head, *(f"{key} = {value}" for key, value in lines.items()), *more]) + "\n",
        encoding="utf-8",
    )
    return file


def message(file: Path) -> str:
    with pytest.raises(ss.errors.ParameterError) as caught:
        read_brake(file)
    text = str(caught.value)
    assert str(file) in text
    assert "\n" not in text
    return text


@pytest.mark.parametrize(
    ("key", "value", "parts"), VALUES, ids=[f"{key}={value[:24]}" for key, value, _ in VALUES]
)
def test_a_wrong_value(key: str, value: str, parts: list[str], tmp_path: Path) -> None:
    text = message(written(tmp_path, GOOD | {key: value}))
    assert f", line {LINES[key]}: {key} = " in text
    assert ";" in text  # the remedy
    for part in parts:
        assert part in text
    for remedy in re.findall(r'"([^"]*)"', text.partition("; write ")[2]):  # each of them is read
        read_brake(written(tmp_path, GOOD | {key: f'"{remedy}"'}))


#: What is done to the file: (lines, more lines, head, where, parts of the message).
WHOLE = {
    "a key is missing": (
        {k: v for k, v in GOOD.items() if k != "k_c"},
        (),
        "[brake]",
        "line 1",
        ["k_c", '"1500 N/mm"'],
    ),
    "all are missing": (
        {},
        (),
        "[brake]",
        "line 1",
        ["m, k_c, L_0", "add lines", 'k_y = "0 N/mm"', 'k_c = "1500 N/mm"'],
    ),
    "a misspelt key": (GOOD, ('kx = "9 N/mm"',), "[brake]", "line 13", ["kx", "did you mean k_x?"]),
    "an unknown key": (GOOD, ('colour = "red"',), "[brake]", "line 13", ["colour", "the keys are"]),
    "a key twice": (GOOD, ('m = "0.4 kg"',), "[brake]", "line 13", ["m is there twice"]),
    "the table twice": (GOOD, ("[brake]",), "[brake]", "line 13", ["[brake] is there twice"]),
    "begins too high": (
        GOOD,
        ('vary = "F_L"', 'begin = "0.5 kN"'),
        "[brake]",
        "line 14",
        ["begin = 500 N is above F_L = 4"],
    ),
    "no table": (GOOD, (), "# nothing", "line 2", ["[brake] is missing"]),
    "another table": (GOOD, (), "[brakes]", "line 1", ["'brakes'", "[brake] is missing"]),
    "two tables": (
        GOOD,
        ("[extra]", "a = 1"),
        "[brake]",
        "line 13",
        ["'extra'", "below one line [brake]"],
    ),
    "no quotes": (GOOD | {"m": "0.35 kg"}, (), "[brake]", "line 2", ["not TOML", 'm = "0.35 kg"']),
    "an open quote": (GOOD | {"k": '"180 N/mm'}, (), "[brake]", "line 3", ["not TOML", "quotes"]),
    "a colon": (GOOD, ('x: "1 m"',), "[brake]", "line 13", ["not TOML"]),
    "a bracket": (GOOD, (), "[brake", "line 1", ["not TOML"]),
    "an unknown model": (GOOD, ('model = "kang"',), "[brake]", "line 13", ["'kang'", "kang_nam"]),
    "a model's number": (
        GOOD,
        ("model = 3",),
        "[brake]",
        "line 13",
        ["model = 3", 'model = "kang_nam"'],
    ),
    "friction twice": (GOOD, ('friction = "a.csv"',), "[brake]", "line 13", ["mu0 is given too"]),
    "friction a number": (GOOD, ("friction = 0.4",), "[brake]", "line 13", ["0.4", "measured.csv"]),
}


@pytest.mark.parametrize("name", WHOLE)
def test_a_wrong_file(name: str, tmp_path: Path) -> None:
    lines, more, head, where, parts = WHOLE[name]
    text = message(written(tmp_path, lines, *more, head=head))
    assert f", {where}: " in text
    assert ";" in text
    for part in parts:
        assert part in text


MEASURED = {
    "missing": (None, ["a.csv", "can't be read"]),
    "words": ("v [m/s],mu\n0.1,0.2\nfast,0.4\n", ["line 3", "'fast,0.4'", "0.5;0.41"]),
    "no head": ("0.1,0.2\n0.2,0.3\n", ["line 1", "is no head", "v [m/s],mu"]),
    "no unit": ("v,mu\n0.1,0.2\n0.2,0.3\n", ["line 1", "'v' has no unit", "v [mm/s]"]),
    "a unit of another quantity": (
        "v [Hz],mu\n0.1,0.2\n0.2,0.3\n",
        ["line 1", "'Hz'", "does not measure what m/s", "v [m/s]"],
    ),
    "any file": ("secret:x:0\n", ["line 1", "the sliding speed is not among the names"]),
    "one speed": ("v [m/s],mu\n0.1,0.2\n0.1,0.21\n", ["at least two", "different"]),
    "negative": ("v [m/s],mu\n0.1,0.2\n0.2,-0.3\n", ["line 3", "negative"]),
    "decimal commas between commas": (
        "v [m/s],mu\n0,1,0,2\n0,2,0,3\n",
        ["line 2", "4 columns", "semicolons"],
    ),
    "nothing but zeros": ("v [m/s],mu\n0.1,0\n0.2,0\n", ["all coefficients are 0"]),
    "not a number": ("v [m/s],mu\n0.1,0.2\n0.2,nan\n", ["line 3", "'0.2,nan'"]),
    "percent without its sign": (
        "v [m/s],mu\n0.1,20\n0.2,40\n",
        ["line 2", "more than any brake has", "mu [%]"],
    ),
}


@pytest.mark.parametrize("name", MEASURED)
def test_a_wrong_measurement(name: str, tmp_path: Path) -> None:
    content, parts = MEASURED[name]
    if content is not None:
        (tmp_path / "a.csv").write_text(content, encoding="utf-8")
    lines = {key: value for key, value in GOOD.items() if key not in ("mu0", "d")} | {
        "friction": '"a.csv"'
    }
    text = message(written(tmp_path, lines))
    assert ", line 11: friction = 'a.csv'" in text
    for part in parts:
        assert part in text
    assert "secret" not in text  # the file that is named may be any, of other people too


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_files_as_editors_and_shells_write_them(
    encoding: str, newline: str, tmp_path: Path
) -> None:
    """Windows PowerShell's ``>`` writes UTF-16, Notepad a mark before UTF-8."""
    path = written(tmp_path, GOOD)
    plain = read_brake(path).quantities
    path.write_text(path.read_text(encoding="utf-8"), encoding=encoding, newline=newline)
    assert read_brake(path).quantities == plain


def test_the_good_file_is_good(tmp_path: Path) -> None:
    found = read_brake(written(tmp_path, GOOD)).quantities
    # By hand: 180 N/mm = 180 000 N/m, 15 % of it 27 000; 38 mm = 0.038 m; 52° = 52 π/180.
    assert (found["k"].value, found["k"].low, found["k"].high) == (180e3, 153e3, 207e3)
    assert found["L_0"].value == pytest.approx(0.038, rel=1e-15)
    assert found["theta0"].value == pytest.approx(0.90757121103705141, rel=1e-15)
    assert found["theta0"].high == pytest.approx(0.92502450355699461, rel=1e-15)
    as_list = read_brake(written(tmp_path, {**GOOD, "mu0": "[0.3, 0.6]"})).quantities["mu0"]
    as_text = read_brake(written(tmp_path, {**GOOD, "mu0": '"[0.3, 0.6]"'})).quantities["mu0"]
    assert as_list == as_text
    assert (as_list.low, as_list.high) == (0.3, 0.6)
    assert (found["mu0"].value, found["mu0"].low, found["mu0"].high) == (0.45, 0.3, 0.6)


#: Text, SI unit, value by hand.
CONVERSIONS = [
    ("1 lbf/in", "N/m", 4.4482216152605 / 0.0254),
    ("1 kgf", "N", 9.80665),
    ("2.5 lb", "kg", 2.5 * 0.45359237),
    ("1.5 in", "m", 0.0381),
    ("90 km/h", "m/s", 25.0),
    ("30 arcmin", "rad", 0.5 * 3.141592653589793 / 180),
    ("200 gon", "rad", 3.141592653589793),
    ("1500 N/mm", "N/m", 1.5e6),
    ("1.5 MN/m", "N/m", 1.5e6),
    ("0.01 s/mm", "s/m", 10.0),
    ("45 %", "1", 0.45),
    ("1.2e3 mm/s", "m/s", 1.2),
    ("10 1/(m/s)", "s/m", 10.0),
    ("52°", "rad", 52 * 3.141592653589793 / 180),
]


@pytest.mark.parametrize(("text", "si", "value"), CONVERSIONS)
def test_conversions_by_hand(text: str, si: str, value: float) -> None:
    assert read(text, si).value == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize("sign", ["±", "+-", "+/-", "± ", " +- "])
def test_signs_of_a_tolerance(sign: str) -> None:
    found = read(f"180 N/mm {sign} 15 %", "N/m")
    assert (found.low, found.high) == (153e3, 207e3)
    for text in (f"180 {sign} 27 N/mm", f"(180 {sign} 27) N/mm", f"180 N/mm {sign} 15 percent"):
        assert (read(text, "N/m").low, read(text, "N/m").high) == (153e3, 207e3)
    assert read(f"(45 {sign} 5) %", "1").high == pytest.approx(0.5)
    assert read(f"0.5{sign}0.1", "1").high == 0.6


def test_normal_distributions_and_their_correlation(tmp_path: Path) -> None:
    lines = GOOD | {
        "k": '"180 N/mm sd 5 %"',
        "k_x": '"(9 sd 0.5) N/mm"',
        "k_c": '"1500 N/mm sd 100 N/mm in [1300, 1800] N/mm"',
    }
    data = read_brake(
        written(tmp_path, lines, 'correlation = [["k", "k_x", 0.9], ["mu0", "theta0", -0.5]]')
    )
    k, k_x, k_c = (data.quantities[name] for name in ("k", "k_x", "k_c"))
    # Three standard deviations on either side, or where it is cut off.
    assert (k.sd, k.low, k.high, k.cut) == (
        pytest.approx(9e3),
        pytest.approx(153e3),
        pytest.approx(207e3),
        False,
    )
    assert (k_x.sd, k_x.low) == (pytest.approx(500.0), pytest.approx(7500.0))
    assert (k_c.sd, k_c.low, k_c.high, k_c.cut) == (pytest.approx(1e5), 1.3e6, 1.8e6, True)
    assert data.correlation == {("k", "k_x"): 0.9, ("mu0", "theta0"): -0.5}


@pytest.mark.parametrize(
    ("value", "part"),
    [
        ('[["k", "k_x", 1.5]]', "is not in [-1, 1]"),
        ('[["k", "kx", 0.5]]', "two of the quantities that vary"),
        ('[["k", "m", 0.5]]', "two of the quantities that vary"),
        ('[["k", "k_x"]]', "two names and a number"),
        ("0.9", "two names and a number"),
        ('[["k", "k_x", 0.5], ["k_x", "k", 0.5]]', "has a pair twice"),
        (
            '[["k", "k_x", 0.9], ["k_x", "k_c", 0.9], ["k", "k_c", -0.9]]',
            "can't all be true at once",
        ),
    ],
)
def test_a_wrong_correlation(value: str, part: str, tmp_path: Path) -> None:
    text = message(written(tmp_path, GOOD, f"correlation = {value}"))
    assert part in text
    assert ", line 13" in text


# ------------------------------------------------------------------------------------------------
# friction curves


@pytest.mark.parametrize(
    "text",
    [
        "# rig 7\nv [m/s];mu\n0.5;0.41\n1;0.43\n",
        "v [m/s]\tmu\n0,5\t0,41\n1\t0,43\n",
        "mu,speed (km/h)\n0.41,1.8\n0.43,3.6\n",
        'v [m/s], mu\n"0,5", "0,41"\n"1", "0,43"\n',
        "v_rel [mm/s] | T [K] | µ_k\n500 | 300 | 0.41\n1000 | 301 | 0.43\n",
        "sliding speed/(m/s);mu [%]\n−5.0E-01;41\n-1;43\n",
        "v [m/s]  mu\n0.5   0.41\n1     0.43\n",
    ],
)
def test_what_has_one_meaning_is_read(text: str, tmp_path: Path) -> None:
    (tmp_path / "mu.csv").write_text(text, encoding="utf-8")
    speed, friction = read_friction(tmp_path / "mu.csv")
    assert speed.tolist() == [0.5, 1.0]
    assert friction.tolist() == pytest.approx([0.41, 0.43], rel=1e-15)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("v [m/s];mu;mu_k\n0.5;0.41;0.3\n1;0.43;0.3\n", "line 1: .* is named 2 times"),
        ("v [mm/s];mu\n1,000;0.41\n2,000;0.43\n", "line 2: .* thousands"),
        ("Run 7; 2.5 bar\n0.5;0.41\n1;0.43\n", "line 1: .* is not among the names"),
        ("v [m/s];mu\n" + "1" * 200_000, "a line of 200000 characters is too long"),
    ],
)
def test_what_has_two_meanings_is_refused(text: str, words: str, tmp_path: Path) -> None:
    (tmp_path / "mu.csv").write_text(text, encoding="utf-8")
    with pytest.raises(ss.errors.ParameterError, match=words):
        read_friction(tmp_path / "mu.csv")
