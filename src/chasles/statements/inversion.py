"""Inverses with cases: the way back from a formula's value to its arguments, branch by branch.

On each branch the formula, fed with the values found, returns what it was given; the values are such as the formula
asks for; cosine and sine of an angle lie on the unit circle; and the branches leave no case out. Each of these is an
equation made from the branches themselves, and is decided.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from operator import mul
from typing import ClassVar

from chasles import vocabulary as w
from chasles.display import Displayed
from chasles.statements.forms import total
from chasles.statements.goals import AcceptedSides
from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.statements.kernel import Kernel
from chasles.statements.posing import default_sides, hypotheses_of
from chasles.statements.problem import Goal, Problem
from chasles.statements.statement import Statement
from chasles.vocabulary import Node
from chasles.vocabulary.arguments import Declared
from chasles.vocabulary.fitting import measured

COVER = "no case is left out"
EITHER_SIGN = "either sign"
NOTHING, ONE = w.Number(Fraction(0)), w.Number(Fraction(1))


@dataclass(frozen=True, slots=True)
class Branch(Declared):
    """One case, taken where `where` is not zero: `values` stand for the formula's arguments.

    An angle is given by its cosine and sine, as the values of cos(phi) and sin(phi). What the branch is `assuming`
    beyond what the inverse assumes is proved to hold wherever the branch is taken; `inverses` says of quantities that
    must not vanish there what one over them is, where the quotient itself does not say it. The branches cover the
    domain because the sum of `by` times `where` over all of them is one: somewhere a `where` is not zero.
    """

    says: str
    where: Node
    values: tuple[tuple[Node, Node], ...]
    by: Node = NOTHING
    assuming: tuple[Hypothesis, ...] = ()
    inverses: tuple[tuple[Node, Node], ...] = ()


@dataclass(frozen=True, eq=False)
class Inverse(Declared, Displayed):
    """The inverse of the formula `of`, case by case; the first branch that applies is taken.

    Its domain is all that satisfies what it is `assuming`. `gives` are the results of its kernel, in terms of the
    formula's arguments and of symbols that `given` defines. The values of `sign` may change their sign together, and
    the first of their entries that is not zero is made positive. With `largest` a machine takes the branch where
    `where` is largest, for accuracy. `satisfying` are equations that the formula's arguments obey and that the values
    must obey too. Raises TypeError, or `Misfit` for shapes, for branches that cannot be what this says.
    """

    role: ClassVar[str] = "inverse"

    number: str
    of: Statement
    branches: tuple[Branch, ...]
    gives: tuple[Node, ...]
    says: str = ""
    assuming: tuple[Hypothesis, ...] = ()
    given: tuple[Statement, ...] = ()
    part: int = 1
    kernel: Kernel | None = None
    largest: bool = False
    sign: tuple[Node, ...] = ()
    satisfying: tuple[Statement, ...] = ()
    fault: None = None

    @property
    def relied_on(self) -> tuple[Statement, ...]:
        """The statements whose sides it uses: those given, the formula, and what its values must satisfy."""
        return (*self.given, self.of, *self.satisfying)

    def __post_init__(self) -> None:
        names = [COVER, EITHER_SIGN]
        for branch in self.branches:
            if branch.says in names:
                raise TypeError(f"({self.number}) has two cases called {branch.says!r}: give each a name of its own")
            names.append(branch.says)
            self._refuse_values(branch)

    def _refuse_values(self, branch: Branch) -> None:
        keys = dict(branch.values)
        for key, value in branch.values:
            if key.shape != value.shape:
                raise w.Misfit(f"({self.number}), {branch.says}: {w.plain(key)} cannot have the value {w.plain(value)}")
            if isinstance(key, w.Call) and w.Call("sin" if key.function == "cos" else "cos", key.argument) not in keys:
                raise TypeError(f"({self.number}), {branch.says}: an angle is given by both its cosine and its sine")
        if missing := [key for key in self.sign if key not in keys]:
            raise TypeError(
                f"({self.number}), {branch.says}: it gives no value to {w.plain(missing[0])}, whose sign turns"
            )
        if not branch.where.is_scalar or not branch.by.is_scalar:
            raise w.Misfit(f"({self.number}), {branch.says}: `where` and `by` are scalars")
        angles = {key.argument for key in keys if isinstance(key, w.Call)}
        for hypothesis in (*_asked(self, keys), *branch.assuming):
            if hypothesis.kind in ("positive", "definite"):
                raise TypeError(f"({self.number}), {branch.says}: that {hypothesis.text} cannot be shown of its values")
            if any(subject in angles for subject in hypothesis.subjects):
                raise TypeError(f"({self.number}): {hypothesis.text} is asked of an angle given by cosine and sine")


def problems_of_inverse(sentence: Inverse, accepted: AcceptedSides = default_sides) -> Iterator[tuple[str, Problem]]:
    """What makes the branches an inverse: problems for each branch, for its sign and for the cover, by name.

    Raises `Misfit` if the values do not fit into an equation, and TypeError if a given statement cannot be used.
    """
    left, right = accepted(sentence.of)
    earlier: list[Hypothesis] = []
    for branch in sentence.branches:
        values = dict(branch.values)
        here = (*sentence.assuming, nonzero(branch.where), *earlier)
        goals = [Goal("the formula returns its input", w.replace(right, values), left), *_circles(values)]
        goals += _fitting(sentence, branch, values, accepted)
        yield branch.says, Problem(tuple(goals), hypotheses=tuple(dict.fromkeys((*branch.assuming, *here))))
        if branch.assuming:
            goals = [goal for hypothesis in branch.assuming for goal in _following(sentence, branch, hypothesis)]
            yield f"{branch.says}: what it assumes", Problem(tuple(goals), hypotheses=here)
        if not sentence.largest:
            earlier.append(_vanishing(branch.where))
    if sentence.sign:
        yield EITHER_SIGN, _turned(sentence, right)
    terms = tuple(w.Scale(branch.by, branch.where) for branch in sentence.branches)
    covered = Goal(COVER, total(terms) if terms else NOTHING, ONE)  # where all `where` vanished, zero would be one
    yield COVER, Problem((covered,), hypotheses=sentence.assuming)


def _circles(values: dict[Node, Node]) -> Iterator[Goal]:
    for key, cosine in values.items():
        if isinstance(key, w.Call) and key.function == "cos":
            sine = values[w.Call("sin", key.argument)]
            yield Goal("cosine and sine lie on the unit circle", w.Sum((w.Power(cosine, 2), w.Power(sine, 2))), ONE)


def _fitting(sentence: Inverse, branch: Branch, values: dict[Node, Node], accepted: AcceptedSides) -> Iterator[Goal]:
    """The values are such as the formula asks for."""
    for hypothesis in _asked(sentence, values):
        for one, other in hypothesis.equations:
            yield Goal(f"the values satisfy {hypothesis.text}", w.replace(one, values), w.replace(other, values))
        for quantity in hypothesis.nonvanishing:
            yield _invertible(branch, w.replace(quantity, values), f"the values satisfy {hypothesis.text}")
    for statement in sentence.satisfying:
        one, other = accepted(statement)
        yield Goal(f"the values satisfy ({statement.number})", w.replace(one, values), w.replace(other, values))


def _asked(sentence: Inverse, values: dict[Node, Node]) -> Iterator[Hypothesis]:
    """What the formula, and all it rests on, assumes of the symbols that occur in it or that the values stand for."""
    symbols = {symbol for node in (sentence.of.right, *values) for symbol in w.symbols_of(node)}
    for hypothesis in dict.fromkeys(hypotheses_of(sentence.of)):
        concerned = {symbol for node in hypothesis.subjects for symbol in w.symbols_of(node)}
        if concerned & symbols and hypothesis not in sentence.assuming:
            yield hypothesis


def _following(sentence: Inverse, branch: Branch, hypothesis: Hypothesis) -> Iterator[Goal]:
    """What a branch assumes holds where it is taken; an equation may need to be divided by what the domain excludes."""
    atoms = [node for assumed in sentence.assuming for node in assumed.nonvanishing]
    for one, other in hypothesis.equations:
        shown = w.Quotient(w.Scale(reduce(mul, atoms), one), reduce(mul, atoms)) if atoms else one
        yield Goal(f"it follows that {hypothesis.text}", shown, other)
    for quantity in hypothesis.nonvanishing:
        yield _invertible(branch, quantity, f"it follows that {hypothesis.text}")


def _invertible(branch: Branch, quantity: Node, label: str) -> Goal:
    """What has an inverse is not zero; zero itself has none."""
    if measured(quantity).grid[0][0] is None:
        return Goal(label, quantity, ONE)
    return Goal(label, w.Scale(quantity, dict(branch.inverses).get(quantity, w.Quotient(ONE, quantity))), ONE)


def _vanishing(where: Node) -> Hypothesis:
    """An earlier branch is not taken: a norm vanishes only with all entries of its vector."""
    equation = (where.of, w.Zero(*where.of.shape)) if isinstance(where, w.Norm) else (where, NOTHING)
    return Hypothesis("untaken", (equation[0],), (equation,), (), "", f"{w.plain(where)} = 0", free=True)


def _turned(sentence: Inverse, right: Node) -> Problem:
    """The formula, and what it asks for, are the same when the values in `sign` change their sign together."""
    turn: dict[Node, Node] = {key: w.Negative(key) for key in sentence.sign}
    hypotheses = tuple(dict.fromkeys(hypotheses_of(sentence.of)))
    goals = [Goal("the formula returns the same", w.replace(right, turn), right)]
    for hypothesis in hypotheses:
        goals += [
            Goal(f"still {hypothesis.text}", w.replace(a, turn), w.replace(b, turn)) for a, b in hypothesis.equations
        ]
    return Problem(tuple(goals), hypotheses=hypotheses)
