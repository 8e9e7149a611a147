"""Tokens grouped for the grammar: what braces hold, the arguments of commands, matrices, bars that open and close."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from lark import Token as Terminal

from chasles.reading import commands
from chasles.reading.commands import MARKS, OPERATORS, STYLES, TWO_ARGUMENTS
from chasles.reading.lexemes import Token, cut

Tokens = tuple[Token, ...]
TYPEFACES = frozenset(STYLES)
ARGUMENTS = dict.fromkeys((*TYPEFACES, *MARKS, r"\sqrt"), 1) | dict.fromkeys(TWO_ARGUMENTS, 2)
RELATIONS = {sign: sign for sign in commands.RELATIONS} | dict.fromkeys((":=", r"\triangleq", r"\doteq"), r"\equiv")
"""Relations, and the sign that each is in words; of those that have none, the sign itself."""
INFIXES = (OPERATORS | {"*", ":", r"\ominus", r"\boxminus", r"\vee"}) - {"+", "-", r"\pm", r"\mp"}
OPENING = ("(", "[", r"\{", r"\langle", r"\lfloor", r"\lceil", r"\llbracket")
CLOSING = (")", "]", r"\}", r"\rangle", r"\rfloor", r"\rceil", r"\rrbracket")
DEEPEST = 40
BARS = ("|", r"\|")
BEGIN, END = r"\begin{", r"\end{"


class Unread(ValueError):
    """Tokens that are no formula, or that the notation gives no meaning; `place` is the token at which it shows."""

    def __init__(self, why: str, place: Token | None = None) -> None:
        super().__init__(why)
        self.place = place


@dataclass(frozen=True, slots=True)
class Grid:
    """An environment with rows and columns: its name and the tokens of its cells."""

    name: str
    rows: tuple[tuple[Tokens, ...], ...]
    place: Token


def closing(tokens: Sequence[Token], start: int) -> int:
    """Where the brace, or the environment, that opens at `start` closes."""
    depth = 0
    for place in range(start, len(tokens)):
        text = tokens[place].text
        depth += (text == "{" or text.startswith(BEGIN)) - (text == "}" or text.startswith(END))
        if depth == 0:
            return place
    raise Unread("a brace is not closed", tokens[start])


def lines_of(tokens: Iterable[Token], marks: tuple[str, ...]) -> list[list[Token]]:
    """The tokens cut at these marks, outside of all braces, brackets and environments."""
    return cut(tokens, marks, OPENING, CLOSING)


def grouped(tokens: Tokens) -> list[Terminal]:
    """The terminals of the grammar, each with its tokens; a bar that says where something is taken is its script.

    Raises `Unread` for what is not closed.
    """
    found: list[Terminal] = []
    place, open_bars = 0, [""]
    while place < len(tokens):
        token = tokens[place]
        text = token.text
        if text in ("^", "_"):
            argument, place = _argument(tokens, place + 1, token)
            found += [_terminal("SUP" if text == "^" else "SUB", token), _terminal("ARGUMENT", argument)]
        elif text == "|" and open_bars[-1] != "|" and _is_behind(found) and _text_at(tokens, place + 1) == "_":
            end = closing(tokens, place + 2)
            if _text_at(tokens, end + 1) == "^":
                raise Unread("a bar that says where something is taken bears an exponent: put it in brackets", token)
            found += [_terminal("SUP", token), _terminal("ARGUMENT", tokens[place : end + 1])]
            place = end + 1
        elif text in ARGUMENTS:
            place = _command(tokens, place, found)
        elif text == "{":
            end = closing(tokens, place)
            found.append(_terminal("GROUP", tokens[place : end + 1]))
            place = end + 1
        elif text.startswith(BEGIN):
            end = closing(tokens, place)
            rows = [tuple(map(tuple, lines_of(line, ("&",)))) for line in lines_of(tokens[place + 1 : end], (r"\\",))]
            found.append(_terminal("GRID", Grid(text[len(BEGIN) : -1], tuple(rows), token)))
            place = end + 1
        else:
            found.append(_single(token, found, open_bars))
            place += 1
    return found


def _terminal(kind: str, value: object) -> Terminal:
    return Terminal(kind, value)


def _command(tokens: Tokens, place: int, found: list[Terminal]) -> int:
    """A command with its arguments; a sign that is put over a relation makes it a definition."""
    token = tokens[place]
    if token.text == r"\sqrt" and tokens[place + 1].text == "[":
        raise Unread("only square roots are known", token)
    arguments = []
    place += 1
    for _ in range(ARGUMENTS[token.text]):
        argument, place = _argument(tokens, place, token)
        arguments.append(argument)
    if token.text in (r"\overset", r"\stackrel") and [each.text for each in arguments[-1]] in [["="], [r"\equiv"]]:
        found.append(_terminal("RELATION", token._replace(text=r"\triangleq")))
    else:
        found.append(_terminal("COMMAND" if len(arguments) == 1 else "COMMAND_OF_TWO", token))
        found += [_terminal("ARGUMENT", argument) for argument in arguments]
    return place


def _is_behind(before: list[Terminal]) -> bool:
    """Whether something stands before that a bar can close."""
    return bool(before) and before[-1].type not in ("OPEN", "SIGN", "INFIX", "RELATION", "COMMA")


def _text_at(tokens: Tokens, place: int) -> str:
    return tokens[place].text if place < len(tokens) else ""


def _single(token: Token, before: list[Terminal], open_bars: list[str]) -> Terminal:
    text = token.text
    if text in BARS:
        kind = "CLOSE" if open_bars[-1] == text and _is_behind(before) else "OPEN"
    elif text in OPENING or text in CLOSING:
        kind = "OPEN" if text in OPENING else "CLOSE"
    elif text in RELATIONS:
        kind = "RELATION"
    elif text in ("+", "-", r"\pm", r"\mp"):
        kind = "SIGN"
    elif text in INFIXES:
        kind = "INFIX"
    elif text[0].isdigit() or (text[0] == "." and len(text) > 1):
        kind = "NUMBER"
    elif text == "'":
        kind = "PRIME"
    elif text in (",", ";"):
        kind = "COMMA"
    elif text in ("&", r"\\", "}", r"\quad"):
        raise Unread(f"{text} is not expected here", token)
    else:
        kind = "LETTER"
    if kind == "OPEN":
        open_bars.append(text)
        if len(open_bars) > DEEPEST:
            raise Unread(f"brackets nested more than {DEEPEST} deep", token)
    elif kind == "CLOSE" and len(open_bars) > 1:
        open_bars.pop()
    return _terminal(kind, token)


def _argument(tokens: Tokens, place: int, of: Token) -> tuple[Tokens, int]:
    """What the braces behind a command or the sign of a script hold."""
    if place >= len(tokens) or tokens[place].text != "{":
        raise Unread(f"{of.text} is put on nothing", of)
    end = closing(tokens, place)
    return tokens[place + 1 : end], end + 1
