"""A page in LaTeX: its displays, counted as LaTeX counts them. Programs in TeX are passed over, not run."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import suppress

from chasles.reading.alignment import DisplayedEquation, equations_of, rows_of, states_relation
from chasles.reading.lexemes import MOST_LEXEMES, BadPage, Token, spelled
from chasles.reading.macros import DEFINING, MacroTable, Source
from chasles.reading.named_in_prose import SEPARATE
from chasles.reading.numbering import LEVELS, Numbering
from chasles.reading.packages import ALWAYS, PACKAGES
from chasles.reading.printed import PrintedEquation, Remark

Included = Callable[[str], tuple[str, str]]

MOST_CHARACTERS = 5_000_000
MOST_EQUATIONS = 20_000
DEEPEST_INPUT = 10
LONGEST_INLINE = 2_000
LONGEST_REMARK, MOST_REMARKS, AROUND, LEADING = 60, 20_000, 60, 240
DEFINITION = re.compile(r"\\(?:\w*newcommand|def|let|Declare\w+|NewDocumentCommand)\b")
DISPLAYS = re.compile(
    r"(?:equation|x?align(?:at)?|flalign|gather|multline|eqnarray|displaymath|dmath|IEEEeqnarray|empheq)\*?$"
)
ROW_NUMBERED = re.compile(r"(?:x?align(?:at)?|flalign|gather|eqnarray|IEEEeqnarray)\*?$")
UNNUMBERED = re.compile(r".*\*$|displaymath$|$")
TAKES_ARGUMENT = re.compile(r"(?:x?alignat|IEEEeqnarray|empheq)\*?$")
TAKES_OPTION = re.compile(r"(?:dmath|IEEEeqnarray|empheq)\*?$")
VERBATIM = re.compile(r"(?:[vV]erbatim|lstlisting|minted|comment|filecontents|code|alltt)\*?$")
CLOSING = {r"\[": r"\]", r"\f[": r"\f]", r"\f{": r"\f}", r"\(": r"\)", "$$": "$$", "$": "$"}
INLINE = {"$": re.compile(r"(?:[^\\$]|\\.)*?\$", re.DOTALL), r"\(": re.compile(r"[^()]*?\\\)")}
UNNAMED = re.compile(r"\\(?:[lc]?dots|text\w*|mathrm|\\)|=|&")
"""What a brace is put under that names nothing, and what names none."""
SPECIAL = re.compile(r"%[^\n]*|\\(?:[A-Za-z@]+|.)|\$\$?", re.DOTALL)


class UnclosedDisplay(BadPage):
    """A display that is not closed before something else begins."""


class TexPage:
    """What has been read of a page so far."""

    special_text = SPECIAL
    counts = True

    def __init__(self, is_inline: bool, included: Included | None) -> None:
        self.is_inline, self.included = is_inline, included
        self.macros = MacroTable()
        self.found: list[PrintedEquation] = []
        self.remarks: list[Remark] = []
        self.numbering = Numbering()
        self.files: list[str] = []
        self.fences: list[str] = []
        self.displays = self.ended = 0
        self.define(ALWAYS)

    def read(self, source: Source) -> None:
        """Reads a file to its end; raises `BadPage` where it is too large or includes itself."""
        if len(source.text) > MOST_CHARACTERS:
            raise BadPage(f"the page has {len(source.text) / 1e6:.1f} MB, of which 5 MB are read: split it")
        if source.file in self.files or len(self.files) > DEEPEST_INPUT:
            raise BadPage(f"{source.file} includes itself: {' -> '.join([*self.files, source.file])}")
        self.files.append(source.file)
        while special := self.special(source):
            source.start_anew()
            if max(self.displays, len(self.found)) > MOST_EQUATIONS:
                raise BadPage(f"more than {MOST_EQUATIONS} equations on a page: split it", special.line)
            self.handle(special, source)
        self.files.pop()

    def special(self, source: Source) -> Token | None:
        """The next piece of prose that is not plain text."""
        if source.waiting:
            token = source.lexeme()
            if token and token.text == "$" and source.peek() == "$":
                source.lexeme()
                return token._replace(text="$$")
            return token
        found = self.special_text.search(source.text, source.at, source.end)
        source.at = found.end() if found else source.end
        return Token(found[0], *source.place(found.start())) if found else None

    def handle(self, token: Token, source: Source) -> None:
        """A command of LaTeX in prose, or a dollar; one that is broken is passed over."""
        is_itself = token.text == r"\noexpand"
        token = (source.lexeme() if is_itself else None) or token
        text, is_input = token.text, token.text in (r"\input", r"\include", r"\subfile")
        try:
            if DEFINING.match(text):
                source.define(token)
                self.take_numbering_format()
            elif text in CLOSING:
                self.open_formula(token, source)
            elif not is_itself and text in self.macros and source.is_structural(text):
                source.expand(token, self.macros[text])
            elif text[1:] in LEVELS:
                is_numbered = source.peek() != "*"
                source.drop_star()
                source.optional(token)
                self.numbering.begin_section(text[1:], source.name(token), is_numbered)
            elif text in (r"\begin", r"\end"):
                self.handle_environment(token, source.name(token), source)
            elif is_input:
                name = source.name(token)
            else:
                self.handle_setting(token, source)
        except BadPage:
            source.waiting.clear()
            return
        if is_input and self.included:
            self.include(name, token)

    def define(self, definitions: str) -> None:
        """Takes in macros that stand nowhere on the page."""
        source = Source(definitions, self.macros)
        while token := source.lexeme():
            if DEFINING.match(token.text):
                source.define(token)

    def include(self, name: str, token: Token) -> None:
        """Reads a file that the page asks for."""
        assert self.included
        try:
            path, text = self.included(name)
        except OSError as missing:
            raise BadPage(f"{token.text}{{{name}}} cannot be read: {missing.strerror}", token.line) from missing
        self.read(Source(text, self.macros, path))

    def handle_setting(self, token: Token, source: Source) -> None:
        """Commands that set counters, or after which text is not prose."""
        match token.text[1:]:
            case "documentclass":
                source.optional(token)
                self.numbering.begin_class(source.name(token))
            case "numberwithin" | "counterwithin" | "@addtoreset":
                names = {source.name(token), source.name(token)}
                self.numbering.count_within((names - {"equation"}).pop() if "equation" in names else "")
            case "setcounter" | "addtocounter":
                counter, value = source.name(token), source.name(token)
                if re.fullmatch(r"-?\d{1,6}", value):
                    self.numbering.set(counter, int(value), token.text == r"\addtocounter")
            case "usepackage" | "RequirePackage":
                source.optional(token)
                for package in source.name(token).split(","):
                    self.define(PACKAGES.get(package.strip(), ""))
            case "appendix":
                self.numbering.begin_appendix()
            case "verb" | "lstinline" if not source.waiting:
                sign = source.text[source.at : source.at + 1]
                end = source.text.find(sign, source.at + 1, source.at + 1000) if sign else -1
                source.at = end + 1 if end > 0 else source.at
            case "iffalse":
                end = source.text.find(r"\fi", source.at)
                source.at = end if end > 0 else source.end

    def take_numbering_format(self) -> None:
        r"""Equations are numbered within what \theequation names."""
        if macro := self.macros.get(r"\theequation"):
            text = spelled(macro.body)
            self.numbering.count_within(next((level for level in LEVELS if rf"\the{level}" in text), ""))

    def handle_environment(self, token: Token, name: str, source: Source) -> None:
        """The begin or end of an environment in prose."""
        is_begin = token.text == r"\begin"
        if macro := self.macros.get(f"{token.text}{{{name}}}"):
            source.expand(token, macro)
        elif name == "subequations":
            (self.numbering.begin_parts if is_begin else self.numbering.end_parts)()
        elif name == "document" and not is_begin:
            source.at = source.end
        elif is_begin and VERBATIM.match(name):
            end = source.text.find(rf"\end{{{name}}}", source.at)
            source.at = end if end >= 0 else source.end
        elif is_begin and DISPLAYS.match(name):
            inner = name
            if TAKES_OPTION.match(name):
                source.optional(token)
            if TAKES_ARGUMENT.match(name):
                argument = source.name(token)
                inner = argument.partition("=")[0] if name.startswith("empheq") else name
            self.display(token, name, inner, source)

    def open_formula(self, token: Token, source: Source) -> None:
        """A sign that opens mathematics."""
        if token.text not in INLINE or self.is_inline:
            self.display(token, token.text, "", source)
        elif not source.waiting:
            end = INLINE[token.text].match(source.text, source.at, source.at + LONGEST_INLINE)
            if end and DEFINITION.search(end[0]):
                self.content(token, token.text, source)
            elif end and "\n\n" not in end[0]:
                self.remark(source, len(token.text), end.end(), len(token.text))

    def remark(self, source: Source, opening: int, end: int, closing: int = 1) -> None:
        """Passes over a formula in prose, whose opening sign has just been read; short ones are noted."""
        text, begin, source.at = source.text, source.at, end
        if end - begin < LONGEST_REMARK and len(self.remarks) < MOST_REMARKS:
            before, after = text[max(0, begin - opening - AROUND) : begin - opening], text[end : end + AROUND]
            between = text[self.ended : begin] if self.ended <= begin else ""
            is_close = 0 < len(between) < AROUND and not SEPARATE.search(between)
            place = source.place(begin)[0], len(self.found), is_close
            self.remarks.append(Remark(before, text[begin : end - closing], after, *place))

    def display(self, opening: Token, opener: str, environment: str, source: Source) -> None:
        """Takes in the equations of a display; for a broken one its fault."""
        raw, fault = self.content(opening, opener, source)
        if fault is None or opener not in INLINE:
            self.take(raw, fault, opening, environment, source)

    def take(
        self, raw: list[Token], fault: BadPage | None, opening: Token, environment: str, source: Source, label: str = ""
    ) -> None:
        """Takes in the equations of a display whose content is known."""
        self.displays, self.ended = self.displays + 1, source.at
        before = source.before(opening, LEADING)
        is_numbered = self.counts and not UNNUMBERED.match(environment)
        rows = rows_of(raw, bool(ROW_NUMBERED.match(environment)))
        for at, row in enumerate(rows):
            if is_numbered and not (row.is_silent or row.number):
                rows[at] = row._replace(number=self.numbering.next())
        equations: list[DisplayedEquation] = []
        try:
            equations = [] if fault else equations_of(environment, rows)
        except BadPage as bad:
            fault = bad
        if fault:
            first = rows[0] if rows else DisplayedEquation(raw)
            equations = [first._replace(raw=raw, fault=str(fault), place=opening)]
        for each in equations:
            if each.fault or states_relation(each.atoms):
                line, column = (fault.line, fault.column) if fault else each.place[1:]
                named = each.label or label or None
                where = self.numbering.name, source.file, each.fault
                inner = self.displays, tuple(each.atoms), before
                beside = tuple(self.named_under_braces(each.raw))
                said = each.latex, line, column, each.number, named
                self.found.append(PrintedEquation(*said, *where, *inner, beside))

    def named_under_braces(self, raw: list[Token]) -> Iterator[PrintedEquation]:
        """What the names under braces stand for."""
        source = Source("", self.macros)
        for at, token in enumerate(raw):
            if token.text in (r"\underbrace", r"\overbrace"):
                source.waiting = raw[at + LONGEST_INLINE : at : -1]
                with suppress(BadPage):
                    inside, script, name = source.argument(token), source.lexeme(), source.argument(token)
                    said = spelled([*name, token._replace(text=r"\equiv"), *inside])
                    if script and script.text in ("_", "^") and not UNNAMED.search(said):
                        yield PrintedEquation(said, token.line, token.column, section=self.numbering.name)

    def content(self, opening: Token, opener: str, source: Source) -> tuple[list[Token], BadPage | None]:
        """The lexemes up to the display's end, macros expanded, and what is wrong with it if anything is."""
        raw: list[Token] = []
        fault: BadPage | None = None
        while True:
            try:
                new = self.next_of_display(opening, opener, source, is_expanded=fault is None)
            except UnclosedDisplay as unclosed:
                return raw, fault or unclosed
            except BadPage as bad:
                fault = fault or bad
                continue
            if new is None:
                return raw, fault
            if len(raw) > MOST_LEXEMES:
                fault = fault or BadPage(f"an equation of more than {MOST_LEXEMES} tokens: split it", *opening[1:])
            else:
                raw += new

    def next_of_display(self, opening: Token, opener: str, source: Source, is_expanded: bool) -> list[Token] | None:
        """The next lexemes of a display, or None at its end; raises `UnclosedDisplay` where something else begins."""
        before, closer = source.at, CLOSING.get(opener, rf"\end{{{opener}}}")
        token = source.next() if is_expanded else source.lexeme()
        if token is None:
            if opener:
                raise UnclosedDisplay(f"{opener} has no {closer}", *opening[1:])
            return None
        text = token.text
        if text == closer:
            return None
        if text == "$" and closer == "$$" and source.peek() == "$":
            source.lexeme()
            return None
        if text == r"\f" and closer in (r"\f]", r"\f}") and source.peek() == closer[-1]:
            source.lexeme()
            return None
        if text == r"\par" and opener in CLOSING:
            raise UnclosedDisplay(f"{opener} has no {closer}", *opening[1:])
        if text not in (r"\begin", r"\end"):
            if text[1:] in LEVELS and opener:
                source.at = before
                raise UnclosedDisplay(f"{opener} has no {closer}", *opening[1:])
            return [token]
        inside = source.argument(token)
        name = spelled(inside)
        if text == r"\end" and name == opener:
            return None
        if opener not in ("", *CLOSING) and (DISPLAYS.match(name) if text == r"\begin" else name == "document"):
            source.at = before
            raise UnclosedDisplay(f"{opener} has no {closer}", *opening[1:])
        if macro := self.macros.get(f"{text}{{{name}}}"):
            source.expand(token, macro)
            return []
        return [token, token._replace(text="{"), *inside, token._replace(text="}")]
