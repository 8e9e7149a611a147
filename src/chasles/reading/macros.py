"""The text of a page as TeX's lexemes, with the macros that it defines expanded within bounds."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Sequence
from contextlib import suppress
from typing import NamedTuple

from chasles.reading.lexemes import LEXEME, MOST_LEXEMES, BadPage, Token, blank, lexemes, spelled

MOST_MACROS = 5_000
MOST_WASTED = 200_000
DEFINING = re.compile(
    r"\\(?:(?:re|provide)?newcommand|providecommand|DeclareRobustCommand|[gex]?def|let|DeclareMathOperator"
    r"|DeclarePairedDelimiter|DeclareMathAlphabet|(?:re)?newenvironment|(?:New|Renew|Provide|Declare)DocumentCommand)$"
)
STRUCTURAL = re.compile(r"\\(?:begin|end|\[|\]|(?:sub)*section|chapter|input|include)$")


class Macro(NamedTuple):
    """What a macro is replaced by: #1, #2 in its body are its arguments, of which the first may have a default."""

    arguments: int
    default: list[Token] | None
    body: list[Token]
    starred: bool = False


class MacroTable(dict[str, Macro]):
    """The macros that a page has defined so far; `wasted` counts the lexemes of expansions and rereadings in vain."""

    wasted = 0


class Source:
    """Lexemes of a text from a place on; those of a macro's expansion have the place where it is used."""

    def __init__(self, text: str, macros: MacroTable, file: str = "", first: tuple[int, int] = (1, 1)) -> None:
        self.text, self.macros, self.file, self._first = text, macros, file, first
        self.at, self.end = 0, len(text)
        self.waiting: list[Token] = []
        self._begun = -1
        self.start_anew()
        self._structural: dict[str, bool] = {}
        self._lines = [0, *(match.end() for match in re.finditer("\n", text))]

    def start_anew(self) -> None:
        """From here macros may expand to as much as in any display; to little where much was in vain.

        Nothing begins anew where no text has been read since.
        """
        if self.at != self._begun:
            self.left = MOST_LEXEMES if self.macros.wasted < MOST_WASTED else MOST_LEXEMES // 100
            self._begun = self.at

    def place(self, at: int) -> tuple[int, int]:
        """Line and column of a place in the text, from 1."""
        line = bisect_right(self._lines, at)
        column = at - self._lines[line - 1] + (self._first[1] if line == 1 else 1)
        return line + self._first[0] - 1, column

    def before(self, token: Token, length: int) -> str:
        """As much of the text as that before the place of a lexeme."""
        line = token.line - self._first[0]
        at = self._lines[line] + token.column - (1 if line else self._first[1])
        return self.text[max(0, at - length) : at]

    def lexeme(self) -> Token | None:
        """The next lexeme, macros unexpanded; None at the end."""
        while not self.waiting and self.at < self.end:
            match = LEXEME.match(self.text, self.at, self.end)
            assert match
            start, self.at = self.at, match.end()
            if not match[0].startswith("%"):
                return Token(blank(match[0]), *self.place(start))
        return self.waiting.pop() if self.waiting else None

    def next(self) -> Token | None:
        """The next lexeme that is no macro; raises `BadPage` for one that expands to too much."""
        while token := self.lexeme():
            if DEFINING.match(token.text):
                self.define(token)
            elif token.text == r"\noexpand":
                return self.lexeme()
            elif (macro := self.macros.get(token.text)) is None:
                return token
            else:
                self.expand(token, macro)
        return None

    def expand(self, call: Token, macro: Macro) -> None:
        """Puts what the macro is replaced by before what follows."""
        is_derivative = bool(macro.body) and macro.body[0].text == r"\derivative"
        if macro.starred or is_derivative:
            self.drop_star()
        if is_derivative or (call.text == r"\qty" and self.peek() in ("(", "[", "|", r"\{")):
            self.waiting += reversed(self.derivative(call, macro.body[-1]) if is_derivative else [])
            return
        optional = self.optional(call) if macro.default is not None else None
        arguments = [] if macro.default is None else [macro.default if optional is None else optional]
        arguments += [self.argument(call) for _ in range(macro.arguments - len(arguments))]
        body: list[Token] = []
        parameter = False
        for token in macro.body:
            if parameter and token.text.isdigit() and 0 < int(token.text) <= len(arguments):
                body += arguments[int(token.text) - 1]
            elif token.text != "#":
                body.append(Token(token.text, call.line, call.column))
            parameter = token.text == "#"
        self.left -= len(body) + 1
        if self.left < 0:
            self.waiting.clear()
            self.macros.wasted += MOST_LEXEMES
            raise BadPage(f"{call.text} expands without end: does it use itself?", *call[1:])
        self.waiting += reversed(body)

    def derivative(self, call: Token, sign: Token) -> list[Token]:
        r"""A derivative of the package physics: \dv[2]{x}{t}, \pdv{f}{x}{y}, or \dv{t} of what follows."""
        order = self.optional(call)
        said = [self.argument(call)]
        while self.peek() == "{" and len(said) < (2 if sign.text == "d" else 3):
            said.append(self.argument(call))
        *of, first = said[:2]
        order = [Token("2")] if len(said) == 3 else order
        power = [Token("^"), *_group(order)] if order else []
        by = [sign, *first, *([sign, *said[2]] if len(said) == 3 else power)]
        found = [Token(r"\frac"), *_group([sign, *power, *(token for each in of for token in each)]), *_group(by)]
        return [token._replace(line=call.line, column=call.column) for token in found]

    def peek(self) -> str:
        """The next lexeme that is not blank, which stays."""
        while True:
            before = None if self.waiting else self.at
            token = self.lexeme()
            if token is None or token.text != " ":
                break
        if before is not None:
            self.at = before
        elif token:
            self.waiting.append(token)
        return token.text if token else ""

    def argument(self, owner: Token, brackets: str = "{}", most: int = MOST_LEXEMES) -> list[Token]:
        """The next group without its braces, or the next lexeme; raises `BadPage` where there is none."""
        start, is_long = (None if self.waiting else self.at), bool(DEFINING.match(owner.text))
        found: list[Token] = []
        depth = 0
        if self.peek() != brackets[0]:
            if (token := self.lexeme()) and token.text not in ("}", r"\par"):
                return [token]
            raise BadPage(f"an argument is missing after {owner.text}", *owner[1:])
        while (token := self.lexeme()) and (token.text != r"\par" or is_long) and len(found) < most:
            depth += (token.text in ("{", brackets[0])) - (token.text in ("}", brackets[1]))
            found.append(token)
            if depth == 0:
                return found[1:-1]
        self.macros.wasted += len(found)
        if start is not None and self.macros.wasted < MOST_WASTED:
            self.at = start
            self.waiting.clear()
        raise BadPage(f"the argument of {owner.text} is not closed", *owner[1:])

    def name(self, owner: Token) -> str:
        """A short argument as text."""
        return spelled(self.argument(owner, most=200)).strip()

    def define(self, command: Token) -> None:
        """Takes in a definition; one that is broken, or in a form not known, leaves its name without a meaning."""
        self._structural.clear()
        with suppress(BadPage):
            if len(self.macros) < MOST_MACROS:
                self.macros.update(self.definition(command))

    def definition(self, command: Token) -> dict[str, Macro]:
        """What the command defines, by name; an environment is two macros."""
        kind = command.text.lstrip("\\")
        self.drop_star()
        name = self.name(command)
        if kind.endswith("def"):
            parameters: list[Token | None] = []
            while self.peek() not in ("{", "") and len(parameters) < 18:
                parameters.append(self.lexeme())
            if any(token and token.text != "#" and not token.text.isdigit() for token in parameters):
                raise BadPage(f"{name} has arguments that are set off by signs", *command[1:])
            return {name: Macro(len(parameters) // 2, None, self.argument(command))}
        if kind == "let":
            if self.peek() == "=":
                self.lexeme()
            meaning = self.argument(command)
            return {name: self.macros.get(spelled(meaning), Macro(0, None, [Token(r"\noexpand"), *meaning]))}
        if kind == "DeclareMathOperator":
            return {name: Macro(0, None, [Token(r"\operatorname"), *_group(self.argument(command))])}
        if kind == "DeclareMathAlphabet":
            said = [spelled(self.argument(command)) for _ in range(4) if self.peek() == "{"]
            _, family, series, shape = said if len(said) == 4 else ("", "", "", "")
            style = r"\mathbf" if series.startswith("b") else r"\mathnormal" if shape in ("it", "sl") else r"\mathrm"
            style = r"\mathcal" if "cmsy" in family else style
            return {name: Macro(0, None, [Token(style)])}
        if kind == "DeclarePairedDelimiter":
            ends = self.argument(command), self.argument(command)
            return {name: Macro(2, [], [*ends[0], Token("#"), Token("2"), *ends[1]], starred=True)}
        if kind.endswith("DocumentCommand"):
            optional = re.fullmatch(r"(?:O\{(.*?)\})?((?:\s*m)*)", spelled(self.argument(command)))
            if not optional:
                raise BadPage(f"{name} has arguments of a kind that is not known", *command[1:])
            default = None if optional[1] is None else lexemes(optional[1])
            return {name: Macro(optional[2].count("m") + (default is not None), default, self.argument(command))}
        count = self.optional(command)
        default = self.optional(command)
        first = Macro(
            int(spelled(count or []) or 0) if spelled(count or []).isdigit() else 0, default, self.argument(command)
        )
        if kind.endswith("environment"):
            return {rf"\begin{{{name}}}": first, rf"\end{{{name}}}": Macro(0, None, self.argument(command))}
        return {} if kind == "providecommand" and name in self.macros else {name: first}

    def optional(self, owner: Token) -> list[Token] | None:
        """An argument in square brackets, if there is one."""
        return self.argument(owner, "[]") if self.peek() == "[" else None

    def drop_star(self) -> None:
        """Passes over a star that follows."""
        if self.peek() == "*":
            self.lexeme()

    def is_structural(self, name: str) -> bool:
        """Whether the macro opens or closes displays or sections, by itself or by what it uses."""
        if name not in self._structural:
            waiting, seen = [name], {name}
            while waiting and not self._structural.get(name):
                texts = [token.text for token in self.macros[waiting.pop()].body]
                body = {*texts}
                self._structural[name] = any(map(STRUCTURAL.match, body)) or "$$" in "".join(texts)
                waiting += [each for each in body if each in self.macros and each not in seen]
                seen |= body
        return self._structural[name]


def _group(inside: Sequence[Token]) -> list[Token]:
    return [Token("{"), *inside, Token("}")]
