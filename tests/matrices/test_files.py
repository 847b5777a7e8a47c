"""Files of finite-element programs, written by hand and by other writers; contact pairs."""

import copy
import io
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io
from scipy.sparse import coo_array, csc_array, save_npz

import spragsym as ss
from spragsym.matrices.files import read

ABAQUS = """** any remark
7,1, 7,1, 2.5
7,2, 7,1, -1.25E+00
7,2, 7,2, 4.
9,1, 9,1, 1.
"""
#: The same matrix as DMIG in fields of 8, of 16, and between commas.
DMIG = """BEGIN BULK
$ a remark
DMIG    K       0       6       1       0
DMIG    K       7       1               7       1       2.5
        7       2       -1.25
DMIG*   K                              7               2
*                      7               2 4.000000000D+00
DMIG,K,9,1,,9,1,1.+0
ENDDATA
"""
MATRIX = np.array([[2.5, -1.25, 0.0], [-1.25, 4.0, 0.0], [0.0, 0.0, 1.0]])
DOFS = ((7, 1), (7, 2), (9, 1))
#: The same in Harwell and Boeing's format, the lower triangle, with a right-hand side announced.
BOEING = f"""{"by hand":72}{"key":8}
{6:14d}{1:14d}{1:14d}{2:14d}{1:14d}
RSA{"":11}{3:14d}{3:14d}{4:14d}{0:14d}
{"(4I8)":16}{"(4I8)":16}{"(2E20.12)":20}{"(2E20.12)":20}
F{"":13}{1:14d}{0:14d}
{1:8d}{3:8d}{4:8d}{5:8d}
{1:8d}{2:8d}{2:8d}{3:8d}
{2.5:20.12E}{-1.25:20.12E}
{4.0:20.12E}{1.0:20.12E}
{0.0:20.12E}{0.0:20.12E}
"""
FORMAT = "1P,2E24.16"


def output4(kind: str) -> str:
    """The same as OUTPUT4 writes it: dense, sparse, or sparse with BIGMAT."""
    lines = [f"{3:8d}{-3 if kind == 'bigmat' else 3:8d}{2:8d}{2:8d}{'K':8}{FORMAT}"]
    for column, (first, values) in enumerate(((1, [2.5, -1.25]), (1, [-1.25, 4.0]), (3, [1.0])), 1):
        words = 2 * len(values)
        length = {"dense": len(values), "sparse": words + 1, "bigmat": words + 2}[kind]
        lines.append(f"{column:8d}{first if kind == 'dense' else 0:8d}{length:8d}")
        if kind == "sparse":
            lines.append(f"{first + 65536 * (words + 1):8d}")
        if kind == "bigmat":
            lines.append(f"{words + 1:8d}{first:8d}")
        lines.append("".join(f"{one:24.16E}" for one in values))
    return "\n".join([*lines, f"{4:8d}{1:8d}{1:8d}", f"{1.0:24.16E}", ""])


def boeing() -> str:
    text = io.StringIO()
    scipy.io.hb_write(text, csc_array(MATRIX))
    return text.getvalue()


FILES = {
    "K.mtx": ABAQUS,
    "full.mtx": ABAQUS + "7,1, 7,2, -1.25\n",
    "K.pch": DMIG,
    "K.matrix": BOEING,
    "K.rua": boeing(),
    **{f"{kind}.op4": output4(kind) for kind in ("dense", "sparse", "bigmat")},
}


def written(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.write_text(text, encoding="ascii")
    return path


@pytest.mark.parametrize("name", FILES)
def test_every_format_is_read_to_the_bit(name: str, tmp_path: Path) -> None:
    found = read(written(tmp_path, name, FILES[name]))
    if name.endswith((".mtx", ".pch")):
        assert found.dofs == DOFS
        found = found.matrix
    assert (found.toarray() == MATRIX).all()


@pytest.mark.parametrize("name", FILES)
def test_a_damaged_file_is_a_named_error(name: str, tmp_path: Path) -> None:
    text = FILES[name]
    last = max(text.rfind("1.", 0, -30), text.rfind("4.0"))
    for damaged in (text[: last + 1] + "?" + text[last + 2 :], "\0" * 400, ""):
        with pytest.raises(ss.errors.ParameterError, match=name):
            read(written(tmp_path, name, damaged))
    if not name.endswith((".mtx", ".pch")):  # whose lines could be fewer
        with pytest.raises(ss.errors.ParameterError, match=name):
            read(written(tmp_path, name, text[: len(text) * 2 // 3]))


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("a.mtx", ABAQUS + "7,1, 7,1, 2.5\n", "twice"),
        ("a.pch", DMIG.replace("0       6       1", "0       6       3"), "type 3"),
        ("a.pch", DMIG.replace("DMIG    K       0", "DMIG    X       0"), "before its header"),
        ("a.pch", "", "nothing"),
        ("a.op4", output4("dense").replace("1P,2E24.16", "by hand"), "the format 'by hand'"),
        ("a.hb", BOEING.replace("RSA", "CSA"), "the type CSA"),
    ],
)
def test_what_a_file_may_not_hold(name: str, text: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(ss.errors.ParameterError, match=words):
        read(written(tmp_path, name, text))


def written_by_scipy(one: np.ndarray) -> dict[str, bytes]:
    """A matrix and its parts in every format that SciPy and NumPy write."""
    sparse, found = csc_array(one), {}

    def kept(name: str, write: Callable[[Any], object]) -> None:
        stream = io.BytesIO()
        write(stream)
        found[name] = stream.getvalue()

    for name, own in (("sparse", coo_array(one)), ("dense", one)):
        for kind in ("general", "symmetric", "skew-symmetric"):
            kept(f"{name} {kind}.mtx", partial(scipy.io.mmwrite, a=own, symmetry=kind))
        for packed in (False, True):
            whole = {"text": "K", "K": own, "cell": np.array([1, "a"], dtype=object)}
            kept(
                f"{name}{packed}.mat", partial(scipy.io.savemat, mdict=whole, do_compression=packed)
            )
    kept("a.npz", partial(save_npz, matrix=sparse))
    kept("b.npz", partial(np.savez, K=one))
    kept("a.npy", partial(np.save, arr=one))
    text = io.StringIO()
    scipy.io.hb_write(text, sparse)
    return found | {"a.hb": text.getvalue().encode()}


def test_numbers_of_another_writer_round_trip(tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    one = np.where(rng.random((9, 9)) < 0.4, rng.standard_normal((9, 9)), 0.0)
    parts = {" symmetric.mtx": one + one.T, " skew-symmetric.mtx": one - one.T}
    for kind, own in (("", one), *parts.items()):
        for name, data in written_by_scipy(own).items():
            if not name.endswith(kind or (".mat", ".npz", ".npy", ".hb", " general.mtx")):
                continue
            (tmp_path / name).write_bytes(data)
            found = read(tmp_path / name, "K" if name.endswith(".mat") else None)
            found = found.toarray() if hasattr(found, "toarray") else found
            assert (found == own).all(), name
    for own in (np.eye(3, dtype=np.int16), np.array([[True, False]]), np.eye(2, dtype=np.float32)):
        scipy.io.savemat(tmp_path / "small.mat", {"K": own})
        assert (read(tmp_path / "small.mat") == own).all()
    for own, words in (({"K": 1j * one}, "holds nothing"), ({"K": one, "M": one}, "holds K, M")):
        scipy.io.savemat(tmp_path / "other.mat", own)
        with pytest.raises(ss.errors.ParameterError, match=words):
            read(tmp_path / "other.mat")


def test_damaged_bytes_end_no_process(tmp_path: Path) -> None:
    """Each is read, or refused by its name; SciPy's readers of .mat and .mtx end the process."""
    rng = np.random.default_rng(0)
    whole = written_by_scipy(MATRIX + MATRIX.T) | {name: FILES[name].encode() for name in FILES}
    refused = 0
    for name, data in whole.items():
        for _ in range(12):
            damaged = bytearray(data)
            for place in rng.integers(len(damaged), size=rng.integers(1, 4)):
                damaged[place] = rng.choice([rng.integers(256), *b"0123456789+-.E"])
            if rng.random() < 0.3:
                del damaged[rng.integers(len(damaged)) :]
            (tmp_path / name).write_bytes(damaged)
            try:
                read(tmp_path / name)
            except ss.errors.ParameterError as error:
                refused += name in str(error)
    assert refused > 100
    # The two by which they were seen to: a tag of an unknown type, and an exponent without digits.
    tag = whole["denseFalse.mat"].replace(b"\x09\x00\x00\x00\x48", b"\x49\x00\x00\x00\x48")
    end = b"%%MatrixMarket matrix coordinate real symmetric\n3 3 1\n3 3 1+"
    for name, data in (("tag.mat", tag), ("end.mtx", end)):
        (tmp_path / name).write_bytes(data)
        with pytest.raises(ss.errors.ParameterError, match=name):
            read(tmp_path / name, "K")


def test_labels_are_kept_and_name_the_rows_of_all_matrices(tmp_path: Path) -> None:
    M = written(tmp_path, "M.mtx", "7,1,7,1,1.\n7,2,7,2,1.\n9,1,9,1,1.\n")
    K = written(tmp_path, "K.mtx", ABAQUS)
    F = written(tmp_path, "F.mtx", "*MATRIX INPUT, TYPE=UNSYMMETRIC\n9,1, 7,2, 3.\n")
    m = ss.matrices(M, K, F)
    assert m.dofs == DOFS
    assert m.given["friction"].tolist() == [[0, 0, 0], [0, 0, 0], [0, 3, 0]]
    mapping = written(tmp_path, "K.mapping", " Eqn Node DOF\n 1 7 UX\n 2 7 UY\n 3 9 UX\n")
    pair = ss.ContactPair(across=((7, 2),), along=((9, 1),), stiffness=3.0)
    assert (
        ss.matrices(np.eye(3), MATRIX, [pair], dofs=mapping).given["friction"]
        == m.given["friction"]
    ).all()
    other = written(tmp_path, "X.mtx", "8,1, 8,1, 1.\n")
    with pytest.raises(ss.errors.ParameterError, match=r"friction has .* \(8, 1\)"):
        ss.matrices(M, K, other)
    broken = written(tmp_path, "X.mapping", " Eqn Node DOF\n 1 7 UX\n 3 9 UX\n")
    with pytest.raises(ss.errors.ParameterError, match=r"X\.mapping"):
        ss.matrices(M, K, F, dofs=broken)


def test_friction_of_a_pair_is_what_its_force_does(tmp_path: Path) -> None:
    """A first body that slides to the right drags the second one to the right, by the pressure."""
    table = written(
        tmp_path,
        "pairs.csv",
        "across_1,across_2,along_1,along_2,stiffness,direction\n0,1,2,3,5.0,-1\n,1,,3,2.0,1\n",
    )
    friction = ss.matrices(np.eye(4), np.eye(4), table).given["friction"]
    rng = np.random.default_rng(0)
    for q in rng.standard_normal((5, 4)):
        force = np.zeros(4)
        pressure = 5.0 * (q[0] - q[1])
        force[3] -= pressure
        force[2] += pressure
        force[3] += 2.0 * -q[1]
        assert -friction @ q == pytest.approx(force)
    for line, words in (
        ("0,1,2,9,5.0,1", "9 is no degree"),
        ("0,1,2,3,5.0,2", "line 2: direction = 2"),
        ("0,1,2,3,-5.0,1", "line 2: stiffness = -5"),
        ("0,1,2,,5.0,1", "line 2: across and along"),
        ("0,x,2,3,5.0,1", "line 2"),
        ("", "no contact pair"),
    ):
        head = "across_1,across_2,along_1,along_2,stiffness,direction\n"
        with pytest.raises(ss.errors.ParameterError, match=words):
            ss.matrices(np.eye(4), np.eye(4), written(tmp_path, "bad.csv", head + line))


def test_a_reduced_model_says_what_it_lost() -> None:
    """Modes alone are 2 % off; with corrections, and by Newton's method in the whole model, not."""
    n, band = 16, 100.0
    K = 1e6 * (2.0 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1))
    pair = ss.ContactPair(across=(2, 3), along=(5, 9), stiffness=3e6)
    m = ss.matrices(np.eye(n), K, [pair], rayleigh=(1.0, 1e-6))
    whole = ss.flutter_onsets(m.Parameters())
    exact = whole.mu[whole.frequency_hz < band]
    small, poor = m.reduced(10), m.reduced(10, 0)
    on, off = (ss.flutter_onsets(one.Parameters()) for one in (small, poor))
    assert small.highest_hz == pytest.approx(poor.highest_hz)
    assert len(whole) > len(on) == len(exact) == 2
    assert (on.frequency_hz < small.highest_hz).all()
    assert "reduced from 16 coordinates" in on.remarks[-1]
    assert on.full_model == pytest.approx(exact, rel=1e-9)
    assert on.mu == pytest.approx(exact, rel=1e-4)
    assert np.abs(off.mu / exact - 1.0).max() > 0.02
    assert copy.copy(small).full.size == n


def test_the_whole_model_diverges_where_the_reduced_one_does() -> None:
    """At 2/5 the stiffness is singular to the bit."""
    friction = np.diag([-5.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    m = ss.matrices(np.eye(6), np.diag(2.0 ** np.arange(1, 7)), friction, rayleigh=(0.1, 0.0))
    on = ss.flutter_onsets(m.reduced(3).Parameters())
    assert on.kind.tolist() == ["divergence"]
    assert on.full_model == pytest.approx([0.4], rel=1e-12)
