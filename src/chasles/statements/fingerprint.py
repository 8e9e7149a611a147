"""Fingerprints: a hash of what a statement declares and rests on, which tells whether a file was made from it."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import Field, fields, is_dataclass
from fractions import Fraction
from hashlib import sha256
from typing import Any

from chasles.statements.hypotheses import Hypothesis
from chasles.statements.inversion import Inverse
from chasles.statements.problem import Problem
from chasles.statements.statement import Statement, Theorem
from chasles.vocabulary import Node

Sentence = Statement | Theorem | Inverse
Known = dict[int, tuple[Any, Any]]
PROSE = ("says", "meaning", "home")
DERIVED = ("fault",)
"""Fields that are computed from the others."""


def fingerprint(sentence: Sentence) -> str:
    """The sha256, in hexadecimal, of all that is declared of a sentence and of those it rests on, prose left out.

    Equal declarations have equal hashes in every process; a sign, a hypothesis or a `given` that changes changes it.
    """
    return Fingerprints().of(sentence)


class Fingerprints:
    """The hashes of many declarations: each sentence is hashed once, each node is serialised once."""

    def __init__(self) -> None:
        self._known: Known = {}
        self._hashes: Known = {}

    def of(self, declared: Sentence | Problem | Hypothesis | Node) -> str:
        """The hash of one sentence, as `fingerprint` gives it, or of a problem, a hypothesis or an expression."""
        return str(self._once(declared, self._hashed, self._hashes))

    def _hashed(self, sentence: Any) -> str:
        text = json.dumps(self._declared(sentence), separators=(",", ":"), ensure_ascii=False)
        return sha256(text.encode()).hexdigest()

    def _declared(self, value: Any) -> list[Any]:
        """The class and, in the order of their declaration, what is said in its fields: a default says nothing."""
        said = [each.name for each in fields(value) if each.name not in (*PROSE, *DERIVED) and is_said(value, each)]
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
                return ["rests on", self.of(value)]
            case Node() if value.is_field:
                # It says what it depends on, each of its derivatives again.
                return ["field", self.of(value)]
            case _ if is_dataclass(value):
                return self._once(value, self._declared, self._known)
            case _:
                raise TypeError(f"a declaration cannot hold {value!r}")

    def _once(self, value: Any, make: Callable[[Any], Any], known: Known) -> Any:
        """What `make` makes of the value, made once: its identity is enough, as the value is kept."""
        if id(value) not in known:
            known[id(value)] = value, make(value)
        return known[id(value)][1]


def is_said(value: Any, each: Field[Any]) -> bool:
    """Whether a field of a declaration holds anything else than its default."""
    held = getattr(value, each.name)
    return type(held) is not type(each.default) or held != each.default
