"""What was made of an expression before: its program and its texts, kept by all that they depend on."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeVar

import sympy

from chasles import __version__
from chasles.compiling.store import kept

_VERSIONED = ("sympy.", "chasles.")
"""Where classes are from whose versions are in the key."""
_ROOMS = ("algebra", "compiling", "lowering", "targets")
Made = TypeVar("Made")


@dataclass(frozen=True, slots=True)
class Sources:
    """The C and NumPy functions as text, the core shapes, those of packed operands; files for a compiler, their hash.

    Where a function of SciPy is called there is no C, and there are no files.
    """

    c: str
    numpy: str
    signature: str
    packed: str
    paths: tuple[str, ...]
    digest: str


def recalled(key: str, make: Callable[[], Made]) -> Made:
    """What was made for this key, from the cache; or else, or without a key, made now. Raises what `make` raises."""
    found: Made = pickle.loads(kept(key, lambda: pickle.dumps(make()), ".pickle")) if key else make()
    return found


def key_of(expressions: Iterable[sympy.Basic], *others: object) -> str:
    """The hash of some expressions, of what is said besides, and of the code that reads them.

    Empty where a class of the user's own is among the parts: what that comes to may have changed, and not its name.
    Takes time with the number of different parts of the expressions.
    """
    known: dict[Any, bytes] = {}
    digests = [_digest(expression, known) for expression in expressions]
    if not all(str(type(part).__module__).startswith(_VERSIONED) for part in known):
        return ""
    return sha256(repr((digests, others, __version__, sympy.__version__, _code())).encode()).hexdigest()


def _digest(expression: Any, known: dict[Any, bytes]) -> bytes:
    waiting = [expression]
    while waiting:
        part = waiting[-1]
        missing = [] if part in known else [argument for argument in part.args if argument not in known]
        if missing:
            waiting += missing
            continue
        waiting.pop()
        if part not in known:
            of: object = [known[argument] for argument in part.args] or sympy.srepr(part)
            known[part] = sha256(repr((type(part).__module__, type(part).__qualname__, of)).encode()).digest()
    return known[expression]


@cache
def _code() -> str:
    """What tells this code from another."""
    root = Path(__file__).parent.parent
    found = sorted(path for room in _ROOMS for path in (root / room).rglob("*") if path.suffix in (".py", ".jinja"))
    return repr([(str(path.relative_to(root)), path.stat().st_size, path.stat().st_mtime_ns) for path in found])
