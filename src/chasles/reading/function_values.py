"""Values of functions that a page defines: where it says what w(x) is, w(L) is the same of L."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from chasles.reading.commands import SAYS
from chasles.reading.printed import PrintedEquation
from chasles.reading.radicands import LETTER

DEFINED = re.compile(
    rf"(?:^|\\q?quad |, )(?P<function>{LETTER}) \( (?P<letter>{LETTER}) \) {SAYS} "
    r"(?P<value>(?:(?!\\q?quad\b|\\Rightarrow\b)[^=<>,;:])+)"
)
VALUE = re.compile(rf"(?P<function>{LETTER}) \( (?P<argument>[^()=]+) \)")
BINDING = re.compile(
    r"\\i*int\b|\\sum\b|\\prod\b|\\lim\b|\\partial\b|\\d*dot\b|\bd \w|'|\\begin|\\min\b|\\max\b|\\dots|\\text"
)
"""Where what the letter stands for is not put in its place."""
MOST_VALUES = 200


def with_values(found: Sequence[PrintedEquation]) -> Iterator[PrintedEquation]:
    """The equations of a page, each with the values in it of functions that the page defines once."""
    texts = [each.text for each in found]
    rules: dict[str, tuple[str, str, PrintedEquation] | None] = {}
    for text, each in zip(texts, found, strict=True):
        for match in DEFINED.finditer(text):
            function, letter, value = match.groups()
            before = rules.setdefault(function, (letter, value, each))
            if before and before[0] == letter and before[1] != value:
                rules[function] = None
    left = MOST_VALUES
    for text, each in zip(texts, found, strict=True):
        values = dict.fromkeys(VALUE.findall(text) if rules else ())
        beside = [said for function, argument in values if (said := _value(function, argument, rules.get(function)))]
        yield replace(each, beside=(*each.beside, *beside[:left])) if beside[:left] else each
        left -= len(beside[:left])


def _value(function: str, argument: str, rule: tuple[str, str, PrintedEquation] | None) -> PrintedEquation | None:
    """What a function is at an argument; None if it is said for that one, or where that is not as simple."""
    letter, value, where = rule or ("", "", None)
    whole = re.escape(letter)
    if (
        where is None
        or argument == letter
        or BINDING.search(value)
        or re.search(rf"_ (?:\{{[^{{}}]*)?{whole}\b", value)
    ):
        return None
    group = argument if re.fullmatch(LETTER, argument) else f"{{ ( {argument} ) }}"  # no brackets behind a letter
    put = re.sub(rf"(?<!\S){whole}(?! _)(?!\S)", lambda _: group, value)
    name = f"{where.number or f'line {where.line}'} at {argument.replace(' ', '')}"
    latex = f"{function} ( {argument} ) \\equiv {put}"
    return PrintedEquation(latex, where.line, label=name, section=where.section, file=where.file)
