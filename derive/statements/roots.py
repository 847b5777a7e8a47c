"""Roots printed with ±, as the equation that both satisfy: (λ − a)² − b = 0 for λ = a ± √b.

Every printed part stands in that equation once, so that an edit of the print is one edit of it.
"""

from __future__ import annotations

from dataclasses import replace

from .tree import ONE, TWO, ZERO, Equation, Node, Unread, joined, minus, nodes, undone

#: The name of the imaginary unit, which stands in no polynomial.
IMAGINARY = "1j"


def has_sign(tree: Node) -> bool:
    """Whether a tree has a ± or ∓."""
    return any(one.value in ("pm", "mp") for one in nodes(tree) if one.kind == "call")


def without_signs(equation: Equation) -> Equation:
    """The equation without ± that is satisfied by the roots of both signs.

    Raises
    ------
    Unread
        If a ± stands on both sides, or can't be isolated on one side.
    """
    left, tree = equation.left, equation.right
    if has_sign(left) and not has_sign(tree):
        return without_signs(replace(equation, left=tree, right=left))
    if has_sign(left):
        raise Unread("two signs at once on both sides", left.at[0])
    while has_sign(tree):
        left, tree = _one_step(left, tree)
    for one in (*nodes(left), *nodes(tree)):
        if one.value == IMAGINARY:
            raise Unread("i stands elsewhere than behind ±; print the polynomial", one.at[0])
    if not has_sign(equation.right):
        return equation
    return replace(equation, left=Node("add", (left, minus(tree)), at=tree.at), right=ZERO)


def _one_step(left: Node, tree: Node) -> tuple[Node, Node]:
    """Both sides after the outermost operation on the right was moved to the left."""
    if tree.kind == "call" and tree.value in ("pm", "mp"):
        (size,) = tree.args
        if not has_sign(size) or size.value == "sqrt":
            return _square(left, tree.at), _square(size, size.at)
    inside = [one for one in tree.args if has_sign(one)]
    words = [one.value for one in inside]
    if tree.kind == "add" and {*words} == {"pm", "mp"} and words.count("pm") == 1:
        # a ± b ∓ c is a ± (b − c).
        others = (one for one in tree.args if not has_sign(one))
        signed = (one.args[0] if one.value == "pm" else minus(one.args[0]) for one in inside)
        size = Node("add", tuple(signed), at=tree.at)
        return left, replace(tree, args=(*others, Node("call", (size,), "pm", tree.at)))
    if tree.kind != "pow" and (sides := undone(tree, left, has_sign)):
        return sides[1], sides[0]
    raise Unread("several signs at once; print the square", tree.at[0])


def _square(tree: Node, at: tuple[int, int]) -> Node:
    """The square of a tree; of a square root its radicand, which may be negative."""
    if tree.kind == "call" and tree.value == "sqrt":
        return tree.args[0]
    if tree.value == IMAGINARY:
        return minus(replace(ONE, at=at))
    if tree.kind == "mul" and any(it.value == IMAGINARY for it in tree.args):
        rest = [it for it in tree.args if it.value != IMAGINARY]
        return minus(_square(joined("mul", rest, at), at))
    if tree.kind in ("mul", "div"):
        return replace(tree, args=tuple(_square(one, one.at) for one in tree.args))
    return Node("pow", (tree, TWO), at=at)
