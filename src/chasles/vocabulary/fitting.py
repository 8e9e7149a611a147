"""What every word has: the shape and dimensions found when it is made, or the reason why it does not fit."""

from __future__ import annotations

from collections.abc import Callable
from contextvars import ContextVar
from dataclasses import dataclass, field, fields
from typing import Any, TypeVar, dataclass_transform

from chasles.vocabulary.arguments import require
from chasles.vocabulary.measure import Extent, Measure, Misfit

SCALAR = (1, 1)
_tolerant: ContextVar[bool] = ContextVar("tolerant", default=False)
_N = TypeVar("_N", bound="Fitted")


class Fitted:
    """A frozen word of the vocabulary, measured when it is made.

    `below` are the words that it is made of. `measure` has the shape and the dimension of each entry; it is None, and
    `fault` says why, for an expression that does not fit and was made under `printed`.
    """

    __slots__ = ("_hash", "below", "fault", "measure")
    below: tuple[Any, ...]
    measure: Measure | None
    fault: str | None
    _hash: int

    def __post_init__(self) -> None:
        measure = fault = None
        try:
            object.__setattr__(self, "below", self._parts())
            fault = next((part.fault for part in self.below if part.fault), None)
            measure = None if fault else self._measured()
        except Misfit as misfit:
            if not _tolerant.get():
                raise
            fault = str(misfit)
        except (AttributeError, TypeError):
            # Types are looked at only where something went wrong: words are made by the hundred thousand.
            require(type(self), tuple(getattr(self, each.name) for each in fields(self)), {})  # type: ignore[arg-type]
            raise
        object.__setattr__(self, "measure", measure)
        object.__setattr__(self, "fault", fault)

    def _measured(self) -> Measure:
        raise NotImplementedError(type(self).__name__)

    def _parts(self) -> tuple[Fitted, ...]:
        return ()

    @property
    def shape(self) -> tuple[Extent, Extent]:
        """Rows and columns; a scalar is 1 x 1. Raises `Misfit` for an expression that does not fit."""
        return measured(self).shape

    @property
    def is_scalar(self) -> bool:
        """Whether it is 1 x 1; false for an expression that does not fit."""
        return self.measure is not None and self.measure.shape == SCALAR

    def __bool__(self) -> bool:
        raise TypeError("an expression has no truth value; `==` compares spelling, `chasles.prove` decides equality")

    def __reduce__(self) -> tuple[Callable[..., Fitted], tuple[Any, ...]]:
        return _copied, (type(self), *(getattr(self, field.name) for field in fields(self)))  # type: ignore[arg-type]


def measured(node: Fitted) -> Measure:
    """The node's measure; raises `Misfit` with the reason if it has none."""
    if node.measure is None:
        raise Misfit(node.fault or "this expression does not fit")
    return node.measure


def printed(write: Callable[[], _N]) -> _N:
    """The expression as `write` spells it, even if its parts do not fit together; then its `fault` says why."""
    token = _tolerant.set(True)
    try:
        return write()
    finally:
        _tolerant.reset(token)


def _copied(cls: type[_N], *values: Any) -> _N:
    """A node with the given fields, as copies and pickles make it; one that does not fit stays so."""
    return printed(lambda: cls(*values))


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def word(cls: type[_N]) -> type[_N]:
    """A frozen node whose hash is computed once: proofs look the same nodes up again and again."""
    made = dataclass(frozen=True, slots=True)(cls)
    by_fields: Any = made.__hash__

    def hash_once(self: _N) -> int:
        try:
            return self._hash
        except AttributeError:
            object.__setattr__(self, "_hash", by_fields(self))
            return self._hash

    made.__hash__ = hash_once  # type: ignore[assignment]
    return made


def square_measure(of: Fitted, rule: str) -> Measure:
    """The measure of a square matrix; `rule` names what asks for one."""
    measure = measured(of)
    if measure.shape[0] != measure.shape[1]:
        raise Misfit(f"{rule} takes a square matrix, and {of} is {measure.shape[0]} x {measure.shape[1]}")
    return measure
