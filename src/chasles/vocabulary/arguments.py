"""Is a declaration given what it takes? Each argument is compared with its declared type, and a mistake is told.

The message says where the author wrote it, what was written, what is expected there and what to write instead.
"""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, wraps
from inspect import Parameter, Signature, isclass, signature
from pathlib import Path
from types import FrameType, UnionType
from typing import Any, ClassVar, ParamSpec, Self, TypeVar, Union, get_args, get_origin, get_type_hints

_P = ParamSpec("_P")
_R = TypeVar("_R")
Parameters = Mapping[str, Parameter]
ROOMS = {Path(__file__).parent, Path(__file__).parents[1] / "statements"}
"""Where words and sentences are made; who declares something is elsewhere."""


class WrongArgument(TypeError):
    """A declaration that is given something which it does not take; `place` is where, as far as that is a file."""

    def __init__(self, message: str) -> None:
        self.place = _place()
        super().__init__(f"{self.place}: {message}" if self.place else message)


class Declared:
    """What an author declares, made of what its fields are declared to hold; raises `WrongArgument` if it is not.

    `declared_in` is the module, and `place` file and line, where its class leaves room for them.
    """

    __slots__ = ()
    declared_in: ClassVar[str] = ""
    place: ClassVar[str] = ""

    def __new__(cls, *args: Any, **named: Any) -> Self:
        # Copies are made without arguments, and filled afterwards.
        if args or named:
            require(cls, args, named)
        made = super().__new__(cls)
        if (args or named) and hasattr(made, "__dict__"):
            vars(made).update(declared_in=declaring_module(), place=_place())
        return made


def declaring(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """The function, which raises `WrongArgument` for what it does not take."""

    @wraps(function)
    def checked(*args: _P.args, **named: _P.kwargs) -> _R:
        require(function, args, named)
        return function(*args, **named)

    return checked


def making(word: Callable[_P, _R], name: str) -> Callable[_P, _R]:
    """The function of this name that makes a word of its parts; what may be left out is named where it is given."""

    def made(*args: _P.args, **named: _P.kwargs) -> _R:
        require(made, args, named)
        return word(*args, **named)

    begin: Any = word.__init__
    own = [each for each in signature(begin).parameters.values() if each.name != "self"]
    kinds = (Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY)
    taken = [each.replace(kind=kinds[each.default is not Parameter.empty]) for each in own]
    made.__name__ = made.__qualname__ = name
    made.__doc__, made.__module__ = word.__doc__, word.__module__
    made.__annotations__ = {each.name: each.annotation for each in taken} | {"return": word}
    vars(made).update(__wrapped__=begin, __signature__=Signature(taken))
    return made


def require(called: Callable[..., Any], args: tuple[Any, ...], named: Mapping[str, Any]) -> None:
    """Raise `WrongArgument` unless each argument is of its declared type, none is unknown and none is missing."""
    taken, row = _taken(called)
    places = [name for name, it in taken.items() if it.kind is not Parameter.KEYWORD_ONLY]
    given = {**dict(zip(places, args, strict=False)), **named}
    if all(_is_right(taken, row, given, args[len(places) :])):
        return
    from chasles.vocabulary.mistakes import reasons  # what is wrong is put into words only where something is

    if reason := next(reasons(taken, row, given, args[len(places) :]), ""):
        number = given.get("number")
        who = f"{called.__name__} {number!r}" if isclass(called) and isinstance(number, str) else called.__name__
        raise WrongArgument(f"{who}{reason}")


def _is_right(
    taken: Parameters, row: Parameter | None, given: Mapping[str, Any], rest: tuple[Any, ...]
) -> Iterator[bool]:
    """Whether each thing that is given is taken, and is of its type, and whether nothing is missing."""
    yield from (name in taken and fits(value, taken[name].annotation) for name, value in given.items())
    yield from (name in given for name, parameter in taken.items() if parameter.default is Parameter.empty)
    yield from (row is not None and fits(value, row.annotation) for value in rest)


@cache
def _taken(called: Callable[..., Any]) -> tuple[Parameters, Parameter | None]:
    """The parameters by name, and the one for things in a row, with the types that they are declared to be of."""
    hints = {name: getattr(hint, "__bound__", hint) for name, hint in get_type_hints(called).items()}
    found = list(signature(called.__init__ if isclass(called) else called).parameters.values())[isclass(called) :]
    found = [parameter.replace(annotation=hints.get(parameter.name, Any)) for parameter in found]
    row = next((parameter for parameter in found if parameter.kind is Parameter.VAR_POSITIONAL), None)
    if row is not None and isclass(called):
        row = row.replace(annotation=every_part(row.annotation))
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
        every = known and every_part(hint)
        hints = (every,) * len(value) if every else parts
        return known and len(value) == len(hints) and all(map(fits, value, hints))
    if origin is not None:
        return isinstance(value, origin)
    if getattr(hint, "_is_protocol", False):
        return not isclass(value) and all(hasattr(value, name) for name in vars(hint) if not name.startswith("_"))
    return isinstance(value, hint) and not (isinstance(value, bool) and hint is not bool)


def every_part(hint: Any) -> Any:
    """What each part of a tuple of any length is, also where something else may stand for the tuple; else None."""
    for one in (hint, *get_args(hint)):
        if get_origin(one) is Sequence or (get_origin(one) is tuple and get_args(one)[1:] == (Ellipsis,)):
            return get_args(one)[0]
    return None


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
    while frame and _makes_words(frame.f_code.co_filename):
        frame = frame.f_back
    return frame


@cache
def _makes_words(file: str) -> bool:
    return file.startswith("<") or file == dataclasses.__file__ or Path(file).parent in ROOMS
