"""Generated algebra in MATLAB, for arrays of equal sizes; nested results are returned one after the
other.
"""

import textwrap

from ...definitions import WIDTH, Definition, ported


def definition(function: Definition) -> str:
    """A function's definition."""
    names = _outputs(function)
    given = ", ".join(function.accepted)
    returned = names[0] if len(names) == 1 else f"[{', '.join(names)}]"
    lines = [
        *wrapped(f"function {returned} = {function.name}({given})"),
        *comment(
            f"{function.name.upper()}  {function.summary} Returns {function.returns}. "
            f"{function.origin}",
            "",
        ),
    ]
    for index, name in enumerate(function.further, len(function.arguments) + 1):
        lines += [f"  if nargin < {index}", f"    {name} = 0;", "  end"]
    for name, value in (*function.statements, *zip(names, function.leaves, strict=True)):
        if name != value:
            lines += wrapped(f"  {name} = {_printed(value)};")
    return "\n".join([*lines, "end", ""])


def _printed(expression: str) -> str:
    """An expression whose products and quotients are taken element by element."""
    return ported(expression, {}).replace("*", ".*").replace("/", "./")


def _outputs(function: Definition) -> list[str]:
    """Names of the results: that of a shorthand where a result is one, else a new one."""
    leaves, statements = function.leaves, dict(function.statements)
    return [
        leaf if leaf in statements and leaves.count(leaf) == 1 else f"result{index}"
        for index, leaf in enumerate(leaves, 1)
    ]


def comment(text: str, indent: str) -> list[str]:
    """Lines of a help text."""
    return textwrap.wrap(
        text, WIDTH, initial_indent=f"%{indent}", subsequent_indent="%  ", break_on_hyphens=False
    )


def wrapped(line: str) -> list[str]:
    """A statement on as many lines as it needs, broken at spaces, and after brackets where these
    leave a line too long.
    """
    if len(line) <= WIDTH:
        return [line]
    width = WIDTH - len(" ...")
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    wrapper = textwrap.TextWrapper(
        width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    )
    broken = wrapper.wrap(line)
    if max(map(len, broken)) > width:
        broken = [
            part.replace("(\0 ", "(").replace("(\0", "(")
            for part in wrapper.wrap(line.replace("(", "(\0 "))
        ]
    return [*(f"{part} ..." for part in broken[:-1]), broken[-1]]
