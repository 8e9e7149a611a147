"""Is a declaration given what it takes? Each argument is compared with its declared type, and a mistake is told.

The message says where the author wrote it, what was written, what is expected there and what to write instead.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from fractions import Fraction
from functools import cache, wraps
from inspect import Parameter, isclass, isroutine, signature
from pathlib import Path
from types import FrameType, UnionType
from typing import Any, ParamSpec, Self, TypeVar, Union, get_args, get_origin, get_type_hints

__all__ = ["Declared", "WrongArgument", "declaring", "declaring_module", "fits", "require"]

_P = ParamSpec("_P")
_R = TypeVar("_R")
Parameters = Mapping[str, Parameter]
LONGEST = 60
"""Characters of what was written that a message repeats."""
ROOMS = {Path(__file__).parent, Path(__file__).parents[1] / "statements"}
"""Where words and sentences are made; who declares something is elsewhere."""
NAMES: dict[Any, str] = {
    str: "a text",
    int: "a whole number",
    bool: "True or False",
    "Node": "an expression",
    "Callable": "a function",
}


class WrongArgument(TypeError):
    """A declaration that is given something which it does not take; `place` is where, as far as that is a file."""

    def __init__(self, message: str) -> None:
        self.place = _place()
        super().__init__(f"{self.place}: {message}" if self.place else message)


class Declared:
    """What an author declares, made of what its fields are declared to hold; raises `WrongArgument` if it is not."""

    __slots__ = ()

    def __new__(cls, *args: Any, **named: Any) -> Self:
        # Copies are made without arguments, and filled afterwards.
        if args or named:
            require(cls, args, named)
        return super().__new__(cls)


def declaring(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """The function, which raises `WrongArgument` for what it does not take."""

    @wraps(function)
    def checked(*args: _P.args, **named: _P.kwargs) -> _R:
        require(function, args, named)
        return function(*args, **named)

    return checked


def require(called: Callable[..., Any], args: tuple[Any, ...], named: Mapping[str, Any]) -> None:
    """Raise `WrongArgument` unless each argument is of its declared type, none is unknown and none is missing."""
    taken, row = _taken(called)
    places = [name for name, it in taken.items() if it.kind is not Parameter.KEYWORD_ONLY]
    given = {**dict(zip(places, args, strict=False)), **named}
    reason = next(_reasons(taken, row, given, args[len(places) :]), "")
    if reason:
        number = given.get("number")
        who = f"{called.__name__} {number!r}" if isclass(called) and isinstance(number, str) else called.__name__
        raise WrongArgument(f"{who}{reason}")


def _reasons(
    taken: Parameters, row: Parameter | None, given: Mapping[str, Any], rest: tuple[Any, ...]
) -> Iterator[str]:
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


@cache
def _taken(called: Callable[..., Any]) -> tuple[Parameters, Parameter | None]:
    """The parameters by name, and the one for things in a row, with the types that they are declared to be of."""
    hints = get_type_hints(called)
    found = list(signature(called.__init__ if isclass(called) else called).parameters.values())[isclass(called) :]
    found = [parameter.replace(annotation=hints.get(parameter.name, Any)) for parameter in found]
    row = next((parameter for parameter in found if parameter.kind is Parameter.VAR_POSITIONAL), None)
    if row is not None and isclass(called):
        row = row.replace(annotation=_part(row.annotation))
    return {p.name: p for p in found if p.kind is not Parameter.VAR_POSITIONAL}, row


def fits(value: Any, hint: Any) -> bool:
    """Whether a value is of a declared type; a truth value is no number."""
    origin, parts = get_origin(hint), get_args(hint)
    if hint is Any:
        return True
    if origin in (Union, UnionType):
        return any(fits(value, one) for one in parts)
    if origin in (tuple, Sequence):
        known = isinstance(value, tuple if origin is tuple else tuple | list)
        every = known and _part(hint)
        return all(fits(one, every) for one in value) if every else known and _all_fit(value, parts)
    if origin is not None:
        return isinstance(value, origin)
    if getattr(hint, "_is_protocol", False):
        return not isclass(value) and all(hasattr(value, name) for name in vars(hint) if not name.startswith("_"))
    return isinstance(value, hint) and not (isinstance(value, bool) and hint is not bool)


def _all_fit(values: tuple[Any, ...], hints: tuple[Any, ...]) -> bool:
    return len(values) == len(hints) and all(map(fits, values, hints))


def _part(hint: Any) -> Any:
    """What each part of a tuple of any length is, also where something else may stand for the tuple; else None."""
    for one in (hint, *get_args(hint)):
        if get_origin(one) is Sequence or (get_origin(one) is tuple and get_args(one)[1:] == (Ellipsis,)):
            return get_args(one)[0]
    return None


def _mistake(name: str, value: Any, hint: Any, others: Parameters) -> str:
    """What an argument is, what it must be, and what to do."""
    part = _part(hint)
    wrong = [k for k, one in enumerate(value) if not fits(one, part)] if part and isinstance(value, tuple) else []
    if wrong:
        return _mistake(f"part {wrong[0] + 1} of {name}", value[wrong[0]], part, others)
    remedy = next(_remedies(name, value, hint, others), "")
    return f"{name} is {_shown(value)}, and must be {_said(hint)}{f': {remedy}' if remedy else ''}"


def _remedies(name: str, value: Any, hint: Any, others: Parameters) -> Iterator[str]:
    """What the author may have meant, the likeliest first."""
    part = _part(hint)
    if part is not None and fits(value, part):
        yield f"write {name.strip('`')}=(…,), for brackets make a tuple of one thing only by a comma"
    if _said(hint).find("a tuple") >= 0 and isinstance(value, Iterable) and not isinstance(value, str | tuple):
        yield "write a tuple, in round brackets"
    if isclass(value) or isroutine(value):
        yield f"call it, as {value.__name__}(…)"
    if fits("", hint) and isinstance(value, int | float | Fraction):
        yield f'write "{value}"'
    if "an expression" in _said(hint):
        yield from _expressions(value)
    for other, parameter in others.items() if _shown(value).startswith(("a ", "an ")) else ():
        takes = parameter.annotation, _part(parameter.annotation)
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
        case str():
            yield "declare what it names, with `scalar`, `vector` or `square`, and write that"


def _said(hint: Any) -> str:
    """A type in words."""
    origin, parts = get_origin(hint), get_args(hint)
    if origin in (Union, UnionType):
        return " or ".join(_said(part) for part in parts if part is not type(None))
    if origin in (tuple, Sequence):
        every = _part(hint)
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


def _place() -> str:
    """File and line from where words or sentences were called; empty where that is no file."""
    frame = _caller()
    return f"{frame.f_code.co_filename}, line {frame.f_lineno}" if frame else ""


def declaring_module() -> str:
    """The name of the module from which words or sentences were called."""
    frame = _caller()
    return str(frame.f_globals.get("__name__", "")) if frame else ""


def _caller() -> FrameType | None:
    frame: FrameType | None = sys._getframe(1)
    while frame and (frame.f_code.co_filename.startswith("<") or Path(frame.f_code.co_filename).parent in ROOMS):
        frame = frame.f_back
    return frame
