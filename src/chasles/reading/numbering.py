"""Numbers of sections and equations, counted as LaTeX counts them."""

from __future__ import annotations

import re

LEVELS = {"chapter": 0, "section": 1, "subsection": 2, "subsubsection": 3}
HEADING = re.compile(r"(?:(?:Chapter|Section|Appendix)\s+)?((?:\d+|[A-Z])(?:\.\d+)*)(?:[.:]?(?:\s|$))|(.*)", re.DOTALL)


class Numbering:
    """The counters of a page: `name` is the number of the section that is being read, or its title."""

    def __init__(self) -> None:
        self.name: str | None = None
        self.sections = [0, 0, 0, 0]
        self.equations = 0
        self.within: int | None = None
        self.has_chapters = self.is_appendix = False
        self._outer: tuple[str, int] | None = None

    def begin_section(self, command: str, title: str, is_numbered: bool) -> None:
        """Counts a section of this level, and begins to count equations anew where they are numbered within it."""
        level = LEVELS[command]
        if not is_numbered:
            self.name = title
            return
        self.has_chapters |= level == 0
        self.sections[level] += 1
        self.sections[level + 1 :] = [0] * (3 - level)
        if self.within is not None and level <= self.within:
            self.equations = 0
        self.name = self._prefix(level)

    def begin_heading(self, title: str) -> None:
        """Takes a section's number from its printed title, where that begins with one."""
        found = HEADING.match(title.strip())
        self.name = (found[1] or found[2].strip() or None) if found else None

    def begin_class(self, name: str) -> None:
        """Takes note of the class of the document: in books equations are counted within chapters."""
        if name in ("book", "report", "scrbook", "scrreprt", "memoir", "amsbook", "svmono"):
            self.within, self.has_chapters = 0, True

    def count_within(self, command: str) -> None:
        """From here equations are counted within sections of this level."""
        self.within = LEVELS.get(command, self.within)

    def begin_appendix(self) -> None:
        """From here sections have letters."""
        self.is_appendix = True
        self.sections[:] = [0] * 4

    def set(self, counter: str, value: int, is_added: bool = False) -> None:
        """Sets a counter, as the page says it."""
        if counter == "equation":
            self.equations = value + is_added * self.equations
        elif counter in LEVELS:
            self.sections[LEVELS[counter]] = value + is_added * self.sections[LEVELS[counter]]

    def begin_parts(self) -> None:
        """From here equations have letters after one number."""
        self._outer = self.next(), self.equations
        self.equations = 0

    def end_parts(self) -> None:
        """Counts on after the number whose parts had letters."""
        if self._outer:
            self.equations, self._outer = self._outer[1], None

    def next(self) -> str:
        """The number of one more equation."""
        self.equations += 1
        if self._outer:
            return self._outer[0] + _letter(self.equations).lower()
        prefix = "" if self.within is None else self._prefix(self.within)
        return f"{prefix}.{self.equations}" if prefix else str(self.equations)

    def _prefix(self, level: int) -> str:
        numbers = self.sections[0 if self.has_chapters else 1 : level + 1]
        first = [_letter(number) if self.is_appendix else str(number) for number in numbers[:1]]
        return ".".join([*first, *map(str, numbers[1:])])


def _letter(number: int) -> str:
    return chr(ord("A") + number - 1) if 0 < number < 27 else str(number)
