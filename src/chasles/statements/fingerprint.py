"""Is this still the declaration from which a file was made? A hash of what a sentence declares and rests on."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import Field, fields, is_dataclass
from fractions import Fraction
from hashlib import sha256
from typing import Any

from chasles.statements.inversion import Inverse
from chasles.statements.statement import Statement, Theorem

__all__ = ["fingerprint"]

Sentence = Statement | Theorem | Inverse
PROSE = ("says", "meaning")
DERIVED = ("fault",)
"""Fields that are computed from the others."""


def fingerprint(sentence: Sentence) -> str:
    """The sha256, in hexadecimal, of all that is declared of a sentence and of those it rests on, prose left out.

    Equal declarations have equal hashes in every process; a sign, a hypothesis or a `given` that changes changes it.
    """
    return _Serialiser().hash_of(sentence)


class _Serialiser:
    """Each sentence is hashed once and stands in others by its hash, each node is serialised once."""

    def __init__(self) -> None:
        self._known: dict[int, Any] = {}

    def hash_of(self, sentence: Sentence) -> str:
        """The hash of one sentence."""
        return str(self._once(sentence, self._hashed))

    def _hashed(self, sentence: Any) -> str:
        text = json.dumps(self._declared(sentence), separators=(",", ":"), ensure_ascii=False)
        return sha256(text.encode()).hexdigest()

    def _declared(self, value: Any) -> list[Any]:
        """The class and, in the order of their declaration, what is said in its fields: a default says nothing."""
        said = [each.name for each in fields(value) if each.name not in (*PROSE, *DERIVED) and _is_said(value, each)]
        return [type(value).__name__, *([name, self._plain(getattr(value, name))] for name in said)]

    def _plain(self, value: Any) -> Any:
        """The value as JSON; raises TypeError for what no declaration holds."""
        match value:
            case None | bool() | int() | str():
                return value
            case Fraction():
                return ["Fraction", str(value)]
            case tuple():
                return [self._plain(part) for part in value]
            case Statement() | Theorem() | Inverse():
                return ["rests on", self.hash_of(value)]
            case _ if is_dataclass(value):
                return self._once(value, self._declared)
            case _:
                raise TypeError(f"a declaration cannot hold {value!r}")

    def _once(self, value: Any, make: Callable[[Any], Any]) -> Any:
        """What `make` makes of the value, made once: its identity is enough, the declarations outlive this object."""
        if id(value) not in self._known:
            self._known[id(value)] = make(value)
        return self._known[id(value)]


def _is_said(value: Any, each: Field[Any]) -> bool:
    held = getattr(value, each.name)
    return type(held) is not type(each.default) or held != each.default
