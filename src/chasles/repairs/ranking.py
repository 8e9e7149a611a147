"""Which of the changes that make an equation true undoes the slip most likely?"""

from __future__ import annotations

from collections.abc import Container, Iterable
from itertools import pairwise
from re import findall

from chasles import vocabulary as w
from chasles.repairs.one_term import Change
from chasles.rewriting.coefficients import negated, split
from chasles.statements.statement import bare
from chasles.vocabulary import Node, Symbol, plain, symbols_of, undotted, walk
from chasles.vocabulary.functions import FunctionOf

IDLE = 2
"""What each part that has no effect adds to the effort of a change."""
ORTHOGONAL = ("rotation", "half_turn", "orthogonal")
"""The hypotheses that say of a matrix that its transpose is its inverse."""


class Ranking:
    """The rank of a change to `sides`: the fewest changes first, then the smallest.

    A change that leaves parts without effect is larger: it is none that undoes a slip; so is one that puts something
    else for a letter that stands alone on the left. Where either of two parts may be
    wrong, the one is that is written so nowhere in the `others`. What is put for a letter by mistake makes the equation
    say less; so one with more letters is the likelier original, then a shorter one, and a change on the right.
    """

    def __init__(self, sides: tuple[Node, Node], others: Iterable[Node], orthogonal: Container[Node]) -> None:
        self.sides, self.orthogonal = sides, orthogonal
        self.known = {part for side in sides for part in walk(side)}
        self.elsewhere = {part for side in others for part in walk(side)}
        self._own = self._idle(*sides)

    def is_in_vain(self, change: Change) -> bool:
        """Whether more is without effect after a change than before: nobody prints what cancels."""
        return self._idle(change.left, change.right) > self._own

    def _idle(self, *sides: Node) -> int:
        """How many parts of both sides have no effect."""
        return sum(idle_parts(side, self.orthogonal) for side in sides)

    def __call__(self, change: Change) -> tuple[int | str, ...]:
        new = change.left, change.right
        parts = [part for side in new for part in walk(side)]
        effort = change.effort + IDLE * self._idle(*new)
        effort += _is_letter(self.sides[0]) and not _is_letter(change.left)
        unseen = len({part for part in parts if part not in self.elsewhere}) if self.elsewhere else 0
        marks = sum(_changed_marks(plain(one), plain(other)) for one, other in zip(self.sides, new, strict=True))
        letters = len({*symbols_of(change.left), *symbols_of(change.right)})
        strange = sum(part not in self.known for part in parts)
        left, right = map(plain, new)
        written = change.left != self.sides[0], strange, len(right), right, left
        return len(change.words), effort, unseen, marks, -letters, len(parts), *written


def _is_letter(side: Node) -> bool:
    """Whether a side is a letter, or the rate of one: what is said of it stands on the other side."""
    return isinstance(undotted(bare(side))[0], Symbol)


def _changed_marks(one: str, other: str) -> int:
    """How many letters, numbers and signs stand between what two texts begin and what they end with alike."""
    old, new = (findall(r"\w+|\S", text) for text in (one, other))
    while old and new and old[-1] == new[-1]:
        old.pop(), new.pop()
    before = next((k for k, (a, b) in enumerate(zip(old, new, strict=False)) if a != b), min(len(old), len(new)))
    return max(len(old), len(new)) - before


def idle_parts(node: Node, orthogonal: Container[Node]) -> int:
    """How many parts have no effect: a x a, t - 2 t, -(-t), c (1/c), and R R^T of what is `orthogonal`."""
    return sum(1 for part in w.walk(node) if not part.fault and _is_idle(part, orthogonal))


def _is_idle(part: Node, orthogonal: Container[Node]) -> bool:
    match part:
        case w.Cross(one, other):
            return one == other
        case w.Sum():
            cores = [split(term, lambda scalar: isinstance(scalar, w.Number)).core for term in _terms(part)]
            return len(set(cores)) < len(cores)
        case w.Quotient(w.Scale(w.Number(), _), w.Number()) | w.Negative(w.Negative() | w.Group(w.Negative())):
            return True
        case w.Scale(w.Number(), w.Scale(w.Number()) | w.Number()) | FunctionOf("sqrt", (w.Number(),)):
            return True
        case w.Scale(factor, w.Quotient(_, divisor)):
            return _base(factor) == _base(divisor)
        case w.Contract(factors):
            return any(_vanish(one, other, orthogonal) for one, other in pairwise(factors))
        case _:
            return False


def _terms(node: Node) -> list[Node]:
    """The terms of a sum, those in brackets one by one."""
    match node:
        case w.Sum(terms):
            return [inner for term in terms for inner in _terms(term)]
        case w.Group(of):
            return _terms(of)
        case w.Negative(of):
            return [negated(inner) for inner in _terms(of)]
        case _:
            return [node]


def _base(node: Node) -> Node:
    return node.base if isinstance(node, w.Power) else node


def _vanish(one: Node, other: Node, orthogonal: Container[Node]) -> bool:
    """Whether the product of two factors is seen to be zero, or the identity."""
    pairs = ((one, other), (other, one))
    if any(a == w.Transpose(b) and b in orthogonal for a, b in pairs) or (isinstance(one, w.Skew) and one.of == other):
        return True
    return any(isinstance(a, w.Inverse) and a.of == b for a, b in pairs)
