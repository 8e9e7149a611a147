"""LaTeX of an equation as tokens in one spelling, each with its place; what is layout alone is dropped."""

from __future__ import annotations

from chasles.reading import commands
from chasles.reading.atoms import respelled
from chasles.reading.lexemes import Token, lexemes

_INFIX = commands.RELATIONS | commands.OPERATORS | {"&", r"\\", r"\quad"}
_OPEN = _INFIX | {"(", "[", r"\{", "{"}
_CLOSE = _INFIX | {")", "]", r"\}", "}", ",", ";", "."}


def tokens(latex: str, line: int = 1, column: int = 1) -> tuple[Token, ...]:
    r"""The tokens of an equation whose LaTeX begins at this place, in one spelling of all that look the same in print.

    A token's text is a control word (\frac, \begin{bmatrix}, \operatorname{vect} and \text{or} are each one), one
    letter, one number with its decimal point, or one sign. Arguments and scripts always stand in braces, subscripts
    before primes before superscripts; other braces are gone. Of space \quad is left where it parts two equations.
    Raises `BadPage` where braces or environments do not match, or an argument is missing.
    """
    return tuple(without_layout(respelled(lexemes(latex, line, column))))


def without_layout(flat: list[Token]) -> list[Token]:
    """Without punctuation at the end, and without space that parts nothing."""
    found: list[Token] = []
    for token in flat:
        if token.text == r"\quad" and (not found or found[-1].text in _OPEN):
            continue
        if found and found[-1].text == r"\quad" and token.text in _CLOSE:
            found.pop()
        found.append(token)
    while found and (found[-1].text in (".", ",", ";", r"\quad", r"\\")):
        found.pop()
    return found
