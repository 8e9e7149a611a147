"""Lexemes of an equation as atoms, in one spelling of all that look the same in print."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from chasles.reading import commands
from chasles.reading.atoms import CLOSING, DEEPEST_BRACKET, NAME, OPENING, ROW_END, Atom, Atoms, single
from chasles.reading.lexemes import LEXEME, BadPage, Token, lexemes, spelled
from chasles.reading.typefaces import array_in_brackets, styled, text_atoms, with_scripts, without_empty_cells

DEEPEST = 60
SCRIPTLESS = commands.RELATIONS | commands.OPERATORS | {ROW_END, "&", ",", ";", *OPENING, r"\quad", r"\qquad"}
TURNS = (r"\top", r"\intercal")
"""Signs of a transpose that some set behind a letter without raising them."""
_INFIX = commands.RELATIONS | commands.OPERATORS | {"&", ROW_END, r"\quad"}
BEGINNING = commands.LETTERS | commands.MARKS | commands.STYLES.keys()
_OPEN = _INFIX | {"(", "[", r"\{"}
_CLOSE = _INFIX | {")", "]", r"\}", ",", ";", "."}


def atoms_in(latex: str, line: int = 1, column: int = 1) -> Atoms:
    r"""The atoms of an equation whose LaTeX begins at this place; what is layout alone is dropped.

    Of space \quad is left where it parts two equations. Raises `BadPage` where braces or environments do not match, or
    an argument is missing.
    """
    return tuple(without_layout(respelled(lexemes(latex, line, column))))


def without_layout(atoms: Sequence[Atom]) -> list[Atom]:
    """Without space that parts nothing, and without punctuation at the end."""
    found = _without_space(atoms)
    while found and found[-1].text in (".", ",", ";", r"\quad", ROW_END) and not found[-1].is_marked:
        found.pop()
    return found


def _without_space(atoms: Sequence[Atom]) -> list[Atom]:
    found: list[Atom] = []
    for atom in atoms:
        is_empty = atom.kind == "GROUP" and not (atom.arguments[0] or atom.is_marked)
        if is_empty or (atom.text == r"\quad" and (not found or found[-1].text in _OPEN)):
            continue
        if found and found[-1].text == r"\quad" and atom.text in _CLOSE:
            found.pop()
        found.append(atom)
    return found[:-1] if found and found[-1].text == r"\quad" else found


def respelled(raw: Sequence[Token]) -> list[Atom]:
    """The same in print, in one spelling; raises `BadPage` where braces do not match or brackets nest too deep."""
    depth = 0
    for token in raw:
        depth = max(depth + (token.text in OPENING) - (token.text in CLOSING), 0)
        if depth > DEEPEST_BRACKET:
            raise _bad(f"brackets nested more than {DEEPEST_BRACKET} deep", token)
    return _Respelling(raw).whole()


class _Respelling:
    """Reads lexemes from left to right into atoms."""

    def __init__(self, raw: Sequence[Token]) -> None:
        self.raw = [new for token in raw for new in _in_ascii(token)]
        self.at = 0
        self.depth = 0

    def whole(self) -> list[Atom]:
        atoms = self.atoms()
        if self.peek():
            raise _bad(f"{self.raw[self.at].text} closes nothing", self.raw[self.at])
        return atoms

    def peek(self) -> str:
        while self.at < len(self.raw) and self.raw[self.at].text == " ":
            self.at += 1
        return self.raw[self.at].text if self.at < len(self.raw) else ""

    def deeper(self, read: Callable[[], list[Atom]]) -> list[Atom]:
        self.depth += 1
        if self.depth > DEEPEST:
            raise _bad(f"groups nested more than {DEEPEST} deep", self.raw[min(self.at, len(self.raw) - 1)])
        found = read()
        self.depth -= 1
        return found

    def atoms(self) -> list[Atom]:
        """What stands before the end of a group, with scripts; a switch of typeface and `over` reach to that end."""
        found: list[Atom] = []
        while (text := self.peek()) and text not in ("}", r"\end"):
            token = self.raw[self.at]
            if text in commands.SWITCHES or text == r"\over":
                self.at += 1
                rest = self.deeper(self.atoms)
                if text != r"\over":
                    return found + styled(commands.SWITCHES[text], rest, token)
                return [Atom("COMMAND_OF_TWO", r"\frac", token._replace(text=r"\frac"), (tuple(found), tuple(rest)))]
            found += self.scripted()
            array_in_brackets(found)
        return _without_space(found) if self.depth else found

    def scripted(self) -> list[Atom]:
        start = self.raw[self.at]
        nuclei = [] if start.text in ("_", "^", "'", r"\prime") else self.nucleus()
        if nuclei and nuclei[-1].text in SCRIPTLESS:  # what follows is a script at the left of the next letter
            return nuclei
        name = NAME.fullmatch(nuclei[0].text) if len(nuclei) == 1 and self.peek() not in ("", "}") else None
        if name and name[1] in commands.PLAIN_NAMES:  # with an argument behind it
            nuclei = [replace(nuclei[0], text=commands.PLAIN_NAMES[name[1]])]
        scripts: dict[str, Atoms] = {}
        primes = 0
        is_apart = False  # over a blank in place of a subscript stands what is printed at the left of the next letter
        while (text := self.peek()) in ("_", "^", "'", r"\prime", r"\limits", r"\nolimits", *(TURNS if nuclei else ())):
            token = self.raw[self.at]
            self.at += text not in TURNS
            if text in ("'", r"\prime"):
                primes += 1
            elif text in ("_", "^", *TURNS):
                text = "^" if text in TURNS else text
                is_apart |= text == "_" and [self.ahead(k) for k in range(3)] == ["{", "\\ ", "}"]
                script = self.argument(token)
                if text == "^" and script and script[0].primes and not any(script[0].arguments or [script[0].text]):
                    primes += script.pop(0).primes
                    if not script:
                        continue
                if text in scripts:
                    raise _bad(f"two scripts {text} at one place", token)
                scripts[text] = tuple(script)
        if not (scripts or primes) or start.text in (r"\underbrace", r"\overbrace"):
            return nuclei
        sups = (scripts["^"],) if scripts.get("^") else ()
        if nuclei and sups and is_apart and not primes:
            return [*nuclei, *with_scripts([], (None, 0, sups), start)]
        return with_scripts(nuclei, (scripts.get("_"), primes, sups), start)

    def argument(self, owner: Token) -> list[Atom]:
        text = self.peek()
        if text in ("", "}", "&", ROW_END, r"\end"):
            raise _bad(f"an argument is missing after {owner.text}", owner)
        if text == "{":
            return self.group()
        if text in ("'", r"\prime"):
            self.at += 1
            return with_scripts([], (None, 1, ()), owner)
        return self.deeper(lambda: self.nucleus(single_digit=True))

    def group(self) -> list[Atom]:
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

    def nucleus(self, single_digit: bool = False) -> list[Atom]:
        """One thing that may carry scripts, or nothing for layout; a number, or one digit where only that is taken."""
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
            return [single(token._replace(text=r"\quad"))] if text == r"\hspace" else []
        if text in commands.DELIMITER_SIZES:
            return self.delimiter(token)
        if text in commands.SPACES:
            return [single(token._replace(text=r"\quad"))]
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
        if text in commands.MARKS or text == r"\sqrt" or text in commands.TWO_ARGUMENTS:
            return [self.command(token._replace(text=text))]
        if text == r"\begin":
            return self.environment(token)
        if text == r"\arctan" and self.ahead() == "2" and self.ahead(1) in ("(", *commands.DELIMITER_SIZES):
            self.at += 1
            return [single(token._replace(text=r"\operatorname{arctan2}"))]
        if text in (r"\pmatrix", r"\matrix", r"\cases") and self.peek() == "{":
            return [_environment(text[1:], token, self.group())]
        if name := self.plain_name(text):
            self.at += len(name) - 1
            return [single(token._replace(text=commands.PLAIN_NAMES[name]))]
        if text == r"\not" and self.peek() == "=":
            text, self.at = r"\neq", self.at + 1
        if (sign := commands.IN_ASCII.get(text + self.ahead())) is not None:
            self.at += 1
            text = sign
        elif text == "." and self.ahead() == self.ahead(1) == ".":
            self.at += 2
            text = r"\ldots"
        elif text == "." and self.is_product():
            text = r"\cdot"
        elif text.isdigit() or (text == "." and self.ahead().isdigit()):
            text = text if single_digit else self.rest_of_number(text)
        return [single(token._replace(text=text))]

    def ahead(self, count: int = 0) -> str:
        return self.raw[self.at + count].text if self.at + count < len(self.raw) else ""

    def is_product(self) -> bool:
        """Whether a full stop stands right between two factors, as in a.b, where no sentence ends and no word."""
        before, behind = self.raw[self.at - 2].text if self.at > 1 else "", self.ahead()
        ends = before in ("}", ")") or before.isalpha() or before in commands.LETTERS
        is_word = before.isalpha() and self.ahead(1) == "."
        return ends and not is_word and (behind == "(" or behind.isalpha() or behind in BEGINNING)

    def plain_name(self, text: str) -> str:
        """The name of a function that is typed in letters, as in 2cos(x), where its argument follows.

        An a before it may be a factor, or part of the name.
        """
        run = text
        while len(self.ahead(len(run) - 1)) == 1 and self.ahead(len(run) - 1).isalpha():
            run += self.ahead(len(run) - 1)
        if self.ahead(len(run) - 1) == "2" and f"{run}2" in commands.PLAIN_NAMES:
            run += "2"
        behind = next((each for k in (0, 1) if (each := self.ahead(len(run) - 1 + k)) != " "), "")
        is_argument = behind == "(" or behind in commands.DELIMITER_SIZES
        if run in commands.NAMES_OF_ANGLES:
            is_argument |= behind in ("^", "{", *commands.LETTERS)
        is_whole = self.at < 2 or self.raw[self.at - 2].text not in ("a", "c")
        return run if run in commands.PLAIN_NAMES and is_argument and is_whole else ""

    def command(self, token: Token) -> Atom:
        """A command with its arguments; a sign that is put over a relation makes it a definition."""
        degree = self.raw_argument(token, "[]") if token.text == r"\sqrt" and self.peek() == "[" else None
        arguments = [tuple(self.argument(token)) for _ in range(1 + (token.text in commands.TWO_ARGUMENTS))]
        if token.text in (r"\overset", r"\stackrel") and [each.text for each in arguments[1]] in (["="], [r"\equiv"]):
            return single(token._replace(text=r"\triangleq"))
        if token.text in (r"\overset", r"\underset") and len(arguments[1]) == 1:
            script, (sign,) = arguments
            name = NAME.fullmatch(sign.text)
            sign = replace(sign, text=rf"\{name[1]}") if name and rf"\{name[1]}" in commands.WITH_LIMITS else sign
            if sign.text in commands.WITH_LIMITS:
                return replace(sign, sub=script) if token.text == r"\underset" else replace(sign, sups=(script,))
        kind = "COMMAND" if len(arguments) == 1 else "COMMAND_OF_TWO"
        arguments += [] if degree is None else [tuple(_Respelling(degree).whole())]
        return Atom(kind, token.text, token, tuple(arguments))

    def rest_of_number(self, text: str) -> str:
        while True:
            is_parted = self.ahead() == r"\," and all(self.ahead(k).isdigit() for k in (1, 2, 3))
            self.at += is_parted
            if not (self.ahead().isdigit() or (self.ahead() == "." and "." not in text and self.ahead(1).isdigit())):
                break
            text += self.ahead()
            self.at += 1
        return text

    def after_length(self) -> list[Atom]:
        for taken in ("=", "-", *["0123456789."] * 9, *["cehimnptuwx"] * 2):
            text = self.peek()
            self.at += bool(text) and text in taken
        return []

    def delimiter(self, size: Token) -> list[Atom]:
        r"""The bracket behind its size; for none behind \right an END, which may carry scripts."""
        if self.peek() in ("", "{", "}", "&", ROW_END):
            raise _bad(f"a bracket is missing after {size.text}", size)
        token = self.raw[self.at]
        self.at += 1
        text = commands.SYNONYMS.get(token.text, token.text)
        if text == "." and size.text in (r"\left", r"\right", r"\middle"):
            return [Atom("END", "", token)] if size.text == r"\right" else []
        return [single(token._replace(text={"<": r"\langle", ">": r"\rangle"}.get(text, text)))]

    def environment(self, begin: Token) -> list[Atom]:
        name = spelled(self.raw_argument(begin))
        has_option = self.peek() == "[" and self.ahead(1) in "tbc" and self.ahead(2) == "]"
        if has_option and name in commands.OPTIONAL_ARGUMENT:
            self.raw_argument(begin, "[]")
        if name in commands.TAKES_COLUMNS:
            self.raw_argument(begin)
        inside = self.deeper(self.atoms)
        if self.peek() != r"\end":
            raise _bad(rf"\begin{{{name}}} has no \end{{{name}}}", begin)
        end = self.raw[self.at]
        self.at += 1
        if (other := spelled(self.raw_argument(end))) != name:
            raise _bad(rf"\begin{{{name}}} is closed by \end{{{other}}}", end)
        return [_environment(name, begin, inside)]


def _environment(name: str, begin: Token, inside: list[Atom]) -> Atom:
    inside = without_empty_cells(inside) if name.endswith(("matrix", "array")) else inside
    return Atom("GRID", name, begin._replace(text=rf"\begin{{{name}}}"), (tuple(inside),))


def _bad(message: str, token: Token) -> BadPage:
    return BadPage(message, token.line, token.column)


def _in_ascii(token: Token) -> list[Token]:
    if token.text.isascii():
        return [token]
    return [token._replace(text=match[0]) for match in LEXEME.finditer(commands.ascii_spelling(token.text))]
