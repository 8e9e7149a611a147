"""Long lines of Python source broken as formatters do: at operators, or between the brackets that end an expression."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

WIDTH = 120
PIECE = re.compile(r"""r?"(?:\\.|[^"])*"|r?'(?:\\.|[^'])*'|[(\[{]|[)\]}]| (?:[-+*/@]|\*\*) |, ?|.""", re.DOTALL)
LOOSEST_FIRST = ((" + ", " - "), (" * ", " / ", " @ "), (" ** ",))
"""The operators at which an expression is broken."""


def laid_out(text: str, indent: int = 0, behind: int = 0, at: Sequence[tuple[str, ...]] = LOOSEST_FIRST) -> str:
    """An expression or assignment within the width, as far as strings allow; it begins at an indent, more is behind."""
    if indent + len(text) + behind <= WIDTH:
        return text
    for place, signs in enumerate(at if indent else (), 1):
        first, *more = _parted(text, signs)
        if more:
            lines = [first, *(f"{sign.lstrip()}{part}" for sign, part in zip(*[iter(more)] * 2, strict=True))]
            return f"\n{' ' * indent}".join(laid_out(line, indent, 0, at[place:]) for line in lines)
    return _between_brackets(text, indent)


def _between_brackets(text: str, indent: int) -> str:
    """What stands in the brackets at its end in lines of its own: arguments in one if that has room for them."""
    if text[-1:] not in (")", "]", "}"):
        return text
    opening = _opening(text)
    head, inside = text[: opening + 1], text[opening + 1 : -1]
    deeper, parts = indent + 4, [part for part in _parted(inside, (", ", ","))[::2] if part]
    is_call = head[-1] == "(" and re.search(r"\w\($", head) is not None
    if inside == parts[0] or (is_call and deeper + len(inside) <= WIDTH):
        lines = [laid_out(inside, deeper)]
    else:
        lines = [f"{laid_out(part, deeper, 1)}," for part in parts]
    return "\n".join([head, *(f"{' ' * deeper}{line}" for line in lines), f"{' ' * indent}{text[-1]}"])


def _pieces(text: str) -> Iterator[tuple[str, int, int]]:
    """Strings, signs and brackets in their order, with the depth in which each stands, and where."""
    depth = 0
    for found in PIECE.finditer(text):
        depth -= found[0] in ")]}"
        yield found[0], depth, found.start()
        depth += found[0] in "([{"


def _parted(text: str, signs: tuple[str, ...]) -> list[str]:
    """The text cut at signs outside of all brackets, the signs between its parts."""
    parts = [""]
    for piece, depth, _ in _pieces(text):
        if depth == 0 and piece in signs:
            parts += [piece, ""]
        else:
            parts[-1] += piece
    return parts


def _opening(text: str) -> int:
    """Where the bracket is opened that the text ends with."""
    return [at for piece, depth, at in _pieces(text) if depth == 0 and piece in ("(", "[", "{")][-1]
