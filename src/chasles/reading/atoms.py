"""Lexemes of an equation in one spelling of all that look the same in print."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from chasles.reading import commands
from chasles.reading.lexemes import LEXEME, BadPage, Token, spelled
from chasles.reading.printed_atoms import (
    PrintedAtom,
    braced,
    bracket,
    flat,
    styled,
    text_atoms,
    with_scripts,
    without_empty_cells,
)

DEEPEST = 60
SCRIPTLESS = commands.RELATIONS | commands.OPERATORS | {r"\\", "&", ",", ";", "(", "[", r"\{", r"\quad", r"\qquad"}


def respelled(raw: Sequence[Token]) -> list[Token]:
    """The same tokens in print, in one spelling; raises `BadPage` where braces or environments do not match."""
    return _Respelling(raw).whole()


class _Respelling:
    """Reads lexemes from left to right into atoms."""

    def __init__(self, raw: Sequence[Token]) -> None:
        self.raw = [new for token in raw for new in _in_ascii(token)]
        self.at = 0
        self.depth = 0

    def whole(self) -> list[Token]:
        atoms = self.atoms()
        if self.peek():
            raise _bad(f"{self.raw[self.at].text} closes nothing", self.raw[self.at])
        return flat(atoms)

    def peek(self) -> str:
        while self.at < len(self.raw) and self.raw[self.at].text == " ":
            self.at += 1
        return self.raw[self.at].text if self.at < len(self.raw) else ""

    def deeper(self, read: Callable[[], list[PrintedAtom]]) -> list[PrintedAtom]:
        self.depth += 1
        if self.depth > DEEPEST:
            raise _bad(f"groups nested more than {DEEPEST} deep", self.raw[min(self.at, len(self.raw) - 1)])
        found = read()
        self.depth -= 1
        return found

    def atoms(self) -> list[PrintedAtom]:
        """What stands before the end of a group, with scripts; a switch of typeface and `over` reach to that end."""
        found: list[PrintedAtom] = []
        while (text := self.peek()) and text not in ("}", r"\end"):
            token = self.raw[self.at]
            if text in commands.SWITCHES or text == r"\over":
                self.at += 1
                rest = self.deeper(self.atoms)
                if text != r"\over":
                    return found + styled(commands.SWITCHES[text], rest, token)
                return [PrintedAtom([token._replace(text=r"\frac"), *braced(found, token), *braced(rest, token)])]
            found += self.scripted()
            bracket(found)
        return found

    def scripted(self) -> list[PrintedAtom]:
        start = self.raw[self.at]
        nuclei = [] if start.text in ("_", "^", "'", r"\prime") else self.nucleus()
        if start.text in SCRIPTLESS:  # what follows is a script at the left of the next letter
            return nuclei
        scripts: dict[str, list[Token]] = {}
        while (text := self.peek()) in ("_", "^", "'", r"\prime", r"\limits", r"\nolimits"):
            token = self.raw[self.at]
            self.at += 1
            if text in ("'", r"\prime"):
                scripts.setdefault("'", []).append(token._replace(text="'"))
            elif text in ("_", "^"):
                script = self.argument(token)
                primes = [each for each in flat(script) if each.text not in ("{", "}")]
                if text == "^" and {each.text for each in primes} == {"'"}:
                    scripts.setdefault("'", []).extend(primes)
                elif text in scripts:
                    raise _bad(f"two scripts {text} at one place", token)
                else:
                    scripts[text] = [token, *braced(script, token)]
        if not scripts or start.text in (r"\underbrace", r"\overbrace"):
            return nuclei
        return with_scripts(nuclei, PrintedAtom([], *(scripts.get(kind, []) for kind in "_'^")), start)

    def argument(self, owner: Token) -> list[PrintedAtom]:
        text = self.peek()
        if text in ("", "}", "&", r"\\", r"\end"):
            raise _bad(f"an argument is missing after {owner.text}", owner)
        if text == "{":
            return self.group()
        return self.deeper(lambda: self.nucleus(single=True))

    def group(self) -> list[PrintedAtom]:
        opening = self.raw[self.at]
        self.at += 1
        found = self.deeper(self.atoms)
        if self.peek() != "}":
            raise _bad("{ is not closed", opening)
        self.at += 1
        return found

    def raw_argument(self, owner: Token, brackets: str = "{}") -> list[Token]:
        """The lexemes of a braced argument as they stand."""
        if self.peek() != brackets[0]:
            self.at += 1
            return self.raw[self.at - 1 : self.at] if self.at <= len(self.raw) else []
        depth, start = 0, self.at + 1
        while self.at < len(self.raw):
            text = self.raw[self.at].text
            depth += (text in ("{", brackets[0])) - (text in ("}", brackets[1]))
            self.at += 1
            if depth == 0:
                return self.raw[start : self.at - 1]
        raise _bad(f"the argument of {owner.text} is not closed", owner)

    def nucleus(self, single: bool = False) -> list[PrintedAtom]:
        """One thing that may carry scripts, or nothing for layout; with `single` one digit, not a whole number."""
        token = self.raw[self.at]
        text = commands.SYNONYMS.get(token.text, token.text)
        if text == "{":
            return self.group()
        self.at += 1
        if text in commands.DROPPED:
            return []
        if text in commands.LENGTHS:
            return self.after_length()
        if text in commands.ARGUMENT_DROPPED:
            self.at += self.peek() == "*"
            for brackets in ("[]", "{}") if self.peek() == "[" else ("{}",):
                self.raw_argument(token, brackets)
            return [PrintedAtom([token._replace(text=r"\quad")])] if text == r"\hspace" else []
        if text in commands.DELIMITER_SIZES:
            return self.delimiter(token)
        if text in commands.SPACES:
            return [PrintedAtom([token._replace(text=r"\quad")])]
        if text in commands.COLOURED:
            for brackets in ("[]", "{}") if self.peek() == "[" else ("{}",):
                self.raw_argument(token, brackets)
        if text in commands.ARGUMENT_KEPT | commands.COLOURED:
            return self.argument(token)
        if text in commands.TEXT:
            return text_atoms(token, self.raw_argument(token), lambda formula: _Respelling(formula).atoms())
        if text in commands.STYLES:
            self.at += self.peek() == "*"
            return styled(commands.STYLES[text], self.argument(token), token)
        if text in commands.MARKS or text == r"\sqrt":
            degree = self.raw_argument(token, "[]") if text == r"\sqrt" and self.peek() == "[" else None
            root = (
                [] if degree is None else [Token("[", *token[1:]), *_Respelling(degree).whole(), Token("]", *token[1:])]
            )
            return [PrintedAtom([token, *root, *braced(self.argument(token), token)])]
        if text in commands.TWO_ARGUMENTS:
            first = braced(self.argument(token), token)
            return [PrintedAtom([token._replace(text=text), *first, *braced(self.argument(token), token)])]
        if text == r"\begin":
            return self.environment(token)
        if text == r"\arctan" and self.ahead() == "2" and self.ahead(1) in ("(", *commands.DELIMITER_SIZES):
            self.at += 1
            return [PrintedAtom([token._replace(text=r"\operatorname{arctan2}")])]
        if text in (r"\pmatrix", r"\matrix", r"\cases") and self.peek() == "{":
            begin, end = (token._replace(text=rf"\{side}{{{text[1:]}}}") for side in ("begin", "end"))
            return [PrintedAtom([begin, *flat(self.group()), end])]
        if (sign := commands.IN_ASCII.get(text + self.ahead())) is not None:
            self.at += 1
            text = sign
        elif text == "." and self.ahead() == self.ahead(1) == ".":
            self.at += 2
            text = r"\ldots"
        elif text.isdigit() or (text == "." and self.ahead().isdigit()):
            text = text if single else self.rest_of_number(text)
        return [PrintedAtom([token._replace(text=text)])]

    def ahead(self, count: int = 0) -> str:
        return self.raw[self.at + count].text if self.at + count < len(self.raw) else ""

    def rest_of_number(self, text: str) -> str:
        while True:
            is_parted = self.ahead() == r"\," and all(self.ahead(k).isdigit() for k in (1, 2, 3))
            self.at += is_parted
            if not (self.ahead().isdigit() or (self.ahead() == "." and "." not in text and self.ahead(1).isdigit())):
                break
            text += self.ahead()
            self.at += 1
        return text

    def after_length(self) -> list[PrintedAtom]:
        for taken in ("-", *["0123456789."] * 9, *["cehimnptuwx"] * 2):
            self.at += bool(self.peek()) and self.peek() in taken
        return []

    def delimiter(self, size: Token) -> list[PrintedAtom]:
        if self.peek() in ("", "{", "}", "&", r"\\"):
            raise _bad(f"a bracket is missing after {size.text}", size)
        token = self.raw[self.at]
        self.at += 1
        text = commands.SYNONYMS.get(token.text, token.text)
        if text == "." and size.text in (r"\left", r"\right", r"\middle"):
            return [PrintedAtom([])] if size.text == r"\right" else []
        return [PrintedAtom([token._replace(text={"<": r"\langle", ">": r"\rangle"}.get(text, text))])]

    def environment(self, begin: Token) -> list[PrintedAtom]:
        name = spelled(self.raw_argument(begin))
        if (
            self.peek() == "["
            and name in commands.OPTIONAL_ARGUMENT
            and self.ahead(1) in "tbc"
            and self.ahead(2) == "]"
        ):
            self.raw_argument(begin, "[]")
        if name in commands.TAKES_COLUMNS:
            self.raw_argument(begin)
        inside = flat(self.deeper(self.atoms))
        if self.peek() != r"\end":
            raise _bad(rf"\begin{{{name}}} has no \end{{{name}}}", begin)
        end = self.raw[self.at]
        self.at += 1
        if (other := spelled(self.raw_argument(end))) != name:
            raise _bad(rf"\begin{{{name}}} is closed by \end{{{other}}}", end)
        inside = without_empty_cells(inside) if name.endswith(("matrix", "array")) else inside
        return [
            PrintedAtom([begin._replace(text=rf"\begin{{{name}}}"), *inside, end._replace(text=rf"\end{{{name}}}")])
        ]


def _bad(message: str, token: Token) -> BadPage:
    return BadPage(message, token.line, token.column)


def _in_ascii(token: Token) -> list[Token]:
    if token.text.isascii():
        return [token]
    return [token._replace(text=match[0]) for match in LEXEME.finditer(commands.ascii_spelling(token.text))]
