"""Roots printed with ±, as the equation that both satisfy: (λ − a)² − b = 0 for λ = a ± √b.

Every printed part stands in that equation once, so that an edit of the print is one edit of it.
"""

from __future__ import annotations

from dataclasses import replace

from .tree import ZERO, Equation, Node, Unread, minus, nodes


def has_sign(tree: Node) -> bool:
    """Whether a tree has a ± or ∓."""
    return any(one.value in ("pm", "mp") for one in nodes(tree) if one.kind == "call")


def without_signs(equation: Equation) -> Equation:
    """The equation without ± that is satisfied by the roots of both signs.

    Raises
    ------
    Unread
        If a ± stands on the left, or can't be isolated on one side.
    """
    left, tree = equation.left, equation.right
    if not has_sign(left) and not has_sign(tree):
        return equation
    if has_sign(left):
        raise Unread("two signs at once on the left", left.at[0])
    while has_sign(tree):
        left, tree = _one_step(left, tree)
    return replace(equation, left=Node("add", (left, minus(tree)), at=tree.at), right=ZERO)


def _one_step(left: Node, tree: Node) -> tuple[Node, Node]:
    """Both sides after the outermost operation on the right was moved to the left."""
    inside = [one for one in tree.args if has_sign(one)]
    others = tuple(one for one in tree.args if not has_sign(one))
    match tree.kind:
        case "call" if tree.value in ("pm", "mp"):
            (size,) = tree.args
            if not has_sign(size) or size.value == "sqrt":
                return _square(left, tree.at), _square(size, size.at)
        case "add" if len(inside) == 1:
            return Node("add", (left, *map(minus, others)), at=tree.at), inside[0]
        case "add" if [one.value for one in inside].count("pm") == 1:
            # a ± b ∓ c is a ± (b − c).
            if all(one.value == "mp" for one in inside if one.value != "pm"):
                signed = tuple(
                    one.args[0] if one.value == "pm" else minus(one.args[0]) for one in inside
                )
                size = Node("add", signed, at=tree.at)
                one_sign = Node("call", (size,), "pm", tree.at)
                return left, replace(tree, args=(*others, one_sign))
        case "neg":
            return minus(left), inside[0]
        case "mul" if len(inside) == 1:
            below = others[0] if len(others) == 1 else replace(tree, args=others)
            return Node("div", (left, below), at=tree.at), inside[0]
        case "div" if inside == [tree.args[0]]:
            return Node("mul", (left, tree.args[1]), at=tree.at), inside[0]
    raise Unread("several signs at once; print the square", tree.at[0])


def _square(tree: Node, at: tuple[int, int]) -> Node:
    """The square of a tree; of a square root its radicand, which may be negative."""
    if tree.kind == "call" and tree.value == "sqrt":
        return tree.args[0]
    if tree.kind in ("mul", "div"):
        return replace(tree, args=tuple(_square(one, one.at) for one in tree.args))
    return Node("pow", (tree, Node("number", value="2")), at=at)
