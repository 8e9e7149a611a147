"""Derivations as data: a step says what is done; its result is computed, and decided.

Each step takes the equations reached so far and makes others of them. A comparison ends a part of a derivation: from
there on, the statement compared with is used as it was found, not as it is printed.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import ClassVar

from chasles.display import Displayed
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.packages import DeclarationError
from chasles.statements.statement import Condition, Statement
from chasles.vocabulary import Node, Symbol
from chasles.vocabulary.arguments import Declared


class DerivationStep(Declared):
    """One thing that is done; `kind` says it in a word or two."""

    __slots__ = ()
    kind: ClassVar[str] = "step"

    def _hold(self, **values: object) -> None:
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @property
    def cited(self) -> tuple[Statement, ...]:
        """The statements that the step names."""
        named: list[Statement] = []
        for each in fields(self):  # type: ignore[arg-type]
            value = getattr(self, each.name)
            named += [part for part in (value if isinstance(value, tuple) else (value,)) if isinstance(part, Statement)]
        return tuple(named)


@dataclass(frozen=True, slots=True)
class Take(DerivationStep):
    """The derivation goes on from these statements; a claim among them must itself be proved."""

    kind: ClassVar[str] = "take"
    statements: tuple[Statement, ...]

    def __init__(self, *statements: Statement) -> None:
        self._hold(statements=statements)


@dataclass(frozen=True, slots=True)
class Consider(DerivationStep):
    """The derivation goes on from an expression, which is equal to itself."""

    kind: ClassVar[str] = "consider"
    expression: Node


@dataclass(frozen=True, slots=True)
class Substitute(DerivationStep):
    """Left sides of these statements are replaced by their right sides: on the right side, or on `both`.

    Without statements, what was solved for is put in the ansatz, or in the equations reached. A replacement may be
    `using` definitions to be true.
    """

    kind: ClassVar[str] = "substitute"
    statements: tuple[Statement, ...]
    both: bool
    using: tuple[Statement, ...]

    def __init__(self, *statements: Statement, both: bool = False, using: tuple[Statement, ...] = ()) -> None:
        self._hold(statements=statements, both=both, using=using)


@dataclass(frozen=True, slots=True)
class Expand(DerivationStep):
    """Products, transposes and rates are carried out, equal terms put together: on the right side, or on `both`."""

    kind: ClassVar[str] = "expand"
    both: bool = False


@dataclass(frozen=True, slots=True)
class Factor(DerivationStep):
    """The right side is written as a sum of these terms; coefficients are found, numbers or functions of angles.

    Without terms, it is found to be zero. What it is written with may be `using` definitions to be the same.
    """

    kind: ClassVar[str] = "factor"
    terms: tuple[Node, ...]
    using: tuple[Statement, ...]

    def __init__(self, *terms: Node, using: tuple[Statement, ...] = ()) -> None:
        self._hold(terms=terms, using=using)


@dataclass(frozen=True, slots=True)
class FactorOut(DerivationStep):
    """The right side as something times `factor`; if that is `named`, it is what was found."""

    kind: ClassVar[str] = "factor"
    factor: Node
    named: Symbol | None = None


@dataclass(frozen=True, slots=True)
class Ansatz(DerivationStep):
    """`unknown` is sought in the given form, whose coefficients are to be solved for, so that the two sides are equal.

    Of an inverse it is asked that its product with the matrix is the identity.
    """

    kind: ClassVar[str] = "ansatz"
    unknown: Node
    form: Node
    such_that: tuple[Node, Node] | None = None


@dataclass(frozen=True, slots=True)
class Solve(DerivationStep):
    """The equations reached are solved for the unknowns, symbols or rates of symbols; the engine finds their values.

    With `terms`, each is found as a combination of those that fit it. A `by` multiplies an equation so that the unknown
    stands alone.
    """

    kind: ClassVar[str] = "solve"
    unknowns: tuple[Node, ...]
    terms: tuple[Node, ...]
    by: Statement | None
    using: tuple[Statement, ...]

    def __init__(
        self,
        *unknowns: Node,
        terms: tuple[Node, ...] = (),
        by: Statement | None = None,
        using: tuple[Statement, ...] = (),
    ) -> None:
        self._hold(unknowns=unknowns, terms=terms, by=by, using=using)


@dataclass(frozen=True, slots=True)
class Differentiate(DerivationStep):
    """Both sides are differentiated with respect to time."""

    kind: ClassVar[str] = "differentiate"


@dataclass(frozen=True, slots=True)
class Multiply(DerivationStep):
    """Both sides are multiplied from the left, or from the `right`."""

    kind: ClassVar[str] = "multiply"
    factor: Node
    right: bool = False


@dataclass(frozen=True, slots=True)
class TakeVector(DerivationStep):
    """The axial vector of both sides is taken."""

    kind: ClassVar[str] = "take the vector of"


@dataclass(frozen=True, slots=True)
class Compare(DerivationStep):
    """What was found is compared with a statement as printed; `free` symbols are chosen so that they agree.

    What the two sides are written with may be `using` definitions to be the same.
    """

    kind: ClassVar[str] = "compare"
    statement: Statement
    free: tuple[Symbol, ...] = ()
    using: tuple[Statement, ...] = ()


@dataclass(frozen=True, eq=False)
class Derivation(Declared, Displayed):
    """The derivation of the statement `to`, with which it ends; None where the book does not print the result.

    `given` may be used at every step; what is `assuming` holds all along. Raises `DeclarationError` for a derivation
    that begins with a step that has nothing to work on, is not compared with `to` last, uses `to` before it comes
    there, makes an ansatz and does not solve for it, or uses a condition as if it were a definition.
    """

    number: str
    to: Statement | None
    says: str
    steps: tuple[DerivationStep, ...]
    given: tuple[Statement, ...] = ()
    assuming: tuple[Hypothesis, ...] = ()

    def __post_init__(self) -> None:
        if not self.steps or not isinstance(self.steps[0], Take | Consider | Ansatz):
            raise DeclarationError(f"the derivation of ({self.number}) must begin with Take, Consider or Ansatz")
        if self.to is not None and (not self.stops or self.stops[-1] is not self.to):
            raise DeclarationError(
                f"the last comparison of the derivation of ({self.number}) must be with ({self.to.number})"
            )
        kinds = [type(step) for step in self.steps]
        if Ansatz in kinds and Solve not in kinds[len(kinds) - kinds[::-1].index(Ansatz) :]:
            raise DeclarationError(f"the derivation of ({self.number}) makes an ansatz that no later Solve justifies")
        for step in self.steps[: self._arrival]:
            if self.to is not None and any(statement is self.to for statement in step.cited):
                raise DeclarationError(
                    f"the derivation of ({self.number}) uses ({self.to.number}) before it comes there"
                )
        for given in self.given:
            if isinstance(given, Condition):
                raise DeclarationError(
                    f"the derivation of ({self.number}) is given ({given.number}), a condition: Take it, and solve it"
                )

    @property
    def _arrival(self) -> int:
        """The place of the first comparison with the end; past all steps if the end is not printed."""
        ends = (k for k, step in enumerate(self.steps) if isinstance(step, Compare) and step.statement is self.to)
        return next(ends, len(self.steps))

    @property
    def stops(self) -> tuple[Statement, ...]:
        """The statements that the derivation is compared with, each once, where it is compared last."""
        compared = [step.statement for step in self.steps if isinstance(step, Compare)]
        return tuple(dict.fromkeys(reversed(compared)))[::-1]
