"""Generated algebra in Fortran: a subroutine for each function, with the statements of Python."""

import re
import textwrap
import unicodedata
from collections.abc import Iterable, Mapping

from ...definitions import Definition, ported, with_reals
from ...names import apart
from .. import Angles, taken

#: Largest lengths of a line and of a name in free form.
WIDTH, LONGEST = 120, 63
#: Names in every subroutine that no argument of it has.
OWN = ("values", "sgn", "pi")


def ascii_name(name: str) -> str:
    """A name in the letters, digits and underscores of Fortran, that begins with a letter."""
    spelled = "".join(map(_letter, unicodedata.normalize("NFKD", name)))
    return spelled[: LONGEST - 3] if spelled[:1].isalpha() else f"of_{spelled[: LONGEST - 6]}"


def _letter(character: str) -> str:
    if character.isascii():
        return character
    words = unicodedata.name(character, f"u {ord(character):x}").split()
    return "" if unicodedata.combining(character) else words[-1].lower().replace("-", "_")


def distinct(names: Iterable[str]) -> dict[str, str]:
    """The names in Fortran, of which none is another in other letters, large or small."""
    given = list(dict.fromkeys(names))
    return dict(zip(given, apart(map(ascii_name, given), str.casefold), strict=True))


def definition(function: Definition, name: str, angles: Angles) -> str:
    """A subroutine; the results come in a row, in ``values``."""
    arguments = [*taken(function, angles), *function.further]
    angle_of = {
        part: f"{turn}({angle})"
        for angle, parts in angles.items()
        if angle in arguments
        for turn, part in zip(("cos", "sin"), parts[-2:], strict=True)
        if part in function.read
    }
    locals_ = [*angle_of, *(symbol for symbol, _ in function.statements)]
    table = distinct((*OWN, name, *arguments, *locals_))

    def printed(text: str) -> str:
        said = re.sub(r"(?<![\w.])[^\W\d]\w*", lambda at: table.get(at[0], at[0]), text)
        return with_reals(ported(said, {"sign": "sgn"}), "{}.0d0").replace("*", " * ")

    given = [table[one] for one in arguments]
    assigned = [
        *((table[part], printed(value)) for part, value in angle_of.items()),
        *((table[symbol], printed(value)) for symbol, value in function.statements),
        *((f"values({index})", printed(leaf)) for index, leaf in enumerate(function.leaves, 1)),
    ]
    inputs = [f"  double precision, intent(in) :: {', '.join(given)}"] if given else []
    inner = [f"  double precision :: {', '.join(table[one] for one in locals_)}"]
    return "\n".join(
        [
            *comment(f"{function.summary} Values: {function.returns}. {function.origin}"),
            *wrapped(f"subroutine {name}({', '.join([*given, 'values'])})"),
            *(line for one in inputs for line in wrapped(one)),
            f"  double precision, intent(out) :: values({len(function.leaves)})",
            *(line for one in inner if locals_ for line in wrapped(one)),
            *(line for left, right in assigned for line in wrapped(f"  {left} = {right}")),
            f"end subroutine {name}",
            "",
        ]
    )


def comment(text: str, indent: str = "") -> list[str]:
    """Lines of a comment."""
    return textwrap.wrap(text, WIDTH, initial_indent=f"{indent}! ", subsequent_indent=f"{indent}! ")


def wrapped(line: str) -> list[str]:
    """A statement on as many lines as it needs, broken at spaces."""
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    parts = textwrap.wrap(
        line, WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    )
    return [*(f"{part} &" for part in parts[:-1]), parts[-1]]


def meanings(named: Mapping[str, str]) -> list[str]:
    """Lines of a comment with names and what they mean."""
    return [line for name, said in named.items() for line in comment(f"{name}: {said}")]
