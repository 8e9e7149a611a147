"""What is wrong with what a declaration is given: what was written, what is expected, what to write instead."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from fractions import Fraction
from inspect import Parameter, isclass, isroutine
from types import UnionType
from typing import Any, Union, get_args, get_origin

from chasles.vocabulary.arguments import Parameters, every_part, fits

LONGEST = 60
"""Characters of what was written that a message repeats."""
NAMES: dict[Any, str] = {
    str: "a text",
    int: "a whole number",
    bool: "True or False",
    "Node": "an expression",
    "Callable": "a function",
    "Any": "given",
}


def reasons(taken: Parameters, row: Parameter | None, given: Mapping[str, Any], rest: tuple[Any, ...]) -> Iterator[str]:
    """What is wrong with what is given, by name and in a row."""
    for name, value in given.items():
        if name not in taken:
            near = get_close_matches(name, taken, n=1)
            yield f" takes no `{name}`{f'; near it: `{near[0]}`' if near else ''}"
        elif not fits(value, hint := taken[name].annotation):
            others = {other: parameter for other, parameter in taken.items() if other not in given}
            yield f": {_mistake(f'`{name}`', value, hint, others)}"
    for name, parameter in taken.items():
        if parameter.default is Parameter.empty and name not in given:
            yield f": `{name}` is missing, and must be {_said(parameter.annotation)}"
    if rest and row is None:
        yield f" takes {', '.join(taken)}, and is given {len(rest)} more"
    for place, value in enumerate(rest if row is not None else ()):
        if row is not None and not fits(value, row.annotation):
            brackets = isinstance(value, tuple | list) and all(fits(part, row.annotation) for part in value)
            mistake = _mistake(f"{row.name}[{place}]", value, row.annotation, {})
            yield f": {mistake}{': leave the brackets around them out' if brackets else ''}"


def _mistake(name: str, value: Any, hint: Any, others: Parameters) -> str:
    """What an argument is, what it must be, and what to do."""
    part = every_part(hint)
    wrong = [k for k, one in enumerate(value) if not fits(one, part)] if part and isinstance(value, tuple) else []
    if wrong:
        return _mistake(f"part {wrong[0] + 1} of {name}", value[wrong[0]], part, others)
    remedy = next(_remedies(name, value, hint, others), "")
    return f"{name} is {_shown(value)}, and must be {_said(hint)}{f': {remedy}' if remedy else ''}"


def _remedies(name: str, value: Any, hint: Any, others: Parameters) -> Iterator[str]:
    """What the author may have meant, the likeliest first."""
    part = every_part(hint)
    if part is not None and fits(value, part):
        yield f"write {name.strip('`')}=(…,), for brackets make a tuple of one thing only by a comma"
    if _said(hint).find("a tuple") >= 0 and isinstance(value, Iterable) and not isinstance(value, str | tuple):
        yield "write a tuple, in round brackets"
    if isclass(value) or isroutine(value):
        yield f"call it, as {value.__name__}(…)"
    if fits("", hint) and isinstance(value, int | float | Fraction):
        yield f'write "{value}"'
    if _said(hint) == "a Hypothesis" and type(value).__name__ == "Relation":
        yield f"write inequality({value}), of chasles.statements.inequalities"
    if _said(hint) == "a Statement" and isinstance(value, str):
        yield "write the Python name of the statement, without quotes"
    if "an expression" in _said(hint):
        yield from _expressions(value)
    for other, parameter in others.items() if _shown(value).startswith(("a ", "an ")) else ():
        takes = parameter.annotation, every_part(parameter.annotation)
        if any(one not in (None, Any) and fits(value, one) for one in takes):
            yield f"`{other}` takes that"


def _expressions(value: Any) -> Iterator[str]:
    """What to write for an expression."""
    match value:
        case bool():
            yield "`==` compares how expressions are spelled: write the two sides with a comma between them"
        case int() | Fraction():
            yield f"write number({value})"
        case float():
            yield "write an exact number, as number(Fraction(1, 2))"
        case _ if type(value).__name__ == "Relation":
            yield f"write *says_that({value}), of chasles.statements.inequalities, for both sides"
        case str():
            yield "declare what it names, with `scalar`, `vector` or `square`, and write that"


def _said(hint: Any) -> str:
    """A type in words."""
    origin, parts = get_origin(hint), get_args(hint)
    if origin in (Union, UnionType):
        return " or ".join(_said(part) for part in parts if part is not type(None))
    if origin in (tuple, Sequence):
        every = every_part(hint)
        return f"a tuple with {_said(every)} in each place" if every else f"a tuple ({', '.join(map(_said, parts))})"
    name = getattr(origin or hint, "__name__", str(hint))
    return NAMES.get(hint, NAMES.get(name, _one(name)))


def _one(name: str) -> str:
    return f"{'an' if name[:1] in 'AEIOU' else 'a'} {name}"


def _shown(value: Any) -> str:
    """A value as a message repeats it."""
    if isclass(value) or isroutine(value):
        return f"{value.__name__} itself"
    match value:
        case None | str() | int() | float():
            text = repr(value)
        case tuple() | list() | set():
            text = f"a {type(value).__name__} ({', '.join(map(_shown, value))})"
        case _ if "Node" in (kind.__name__ for kind in type(value).__mro__):
            text = f"the expression {value}"
        case _:
            text = _one(type(value).__name__)
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}…"
