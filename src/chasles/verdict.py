"""The verdicts that a decision can have, and counterexamples."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, ClassVar

from chasles.display import Displayed, theorems

Point = Mapping[str, Fraction]


@dataclass(frozen=True, slots=True)
class Counterexample(Displayed):
    """An exact point that satisfies every hypothesis and at which one entry of the two sides differs.

    `left` and `right` are exact: rational numbers, or polynomials in pi where the angle itself occurs.
    """

    at: Point
    entry: tuple[int, int]
    left: str
    right: str
    goal: str = ""


@dataclass(frozen=True, slots=True)
class Verdict(Displayed):
    """The outcome of a decision; `name` is its one word."""

    name: ClassVar[str] = "verdict"
    true: ClassVar[bool] = True
    """Whether the statement may stand as printed."""
    wrong: ClassVar[bool] = False
    """Whether the statement is wrong as printed: what is undecided, or said under contradictory hypotheses, is not."""

    @property
    def needs(self) -> tuple[str, ...]:
        """The hypotheses that the proof uses; none of a verdict without a proof, or with one that uses none."""
        return ()

    @property
    def unused(self) -> tuple[str, ...]:
        """The hypotheses that are declared and not needed, where that is known."""
        return ()

    @property
    def reason(self) -> str:
        """Why there is nothing to decide, or why nothing was decided; empty for other verdicts."""
        return ""


@dataclass(frozen=True, slots=True)
class Defined(Verdict):
    """A definition that fits together; nothing to decide."""

    name: ClassVar[str] = "defined"


@dataclass(frozen=True, slots=True)
class Posed(Verdict):
    """A condition, with a point that satisfies it."""

    name: ClassVar[str] = "posed"
    witness: Point


@dataclass(frozen=True, slots=True)
class Assumed(Verdict):
    """A postulate."""

    name: ClassVar[str] = "assumed"


@dataclass(frozen=True, slots=True)
class _Asked(Verdict):
    def coq(self, name: str = "identity") -> str:
        """What `prove` was asked, or that it fails, and its proof, for Coq, with the theories of `decide --coq`.

        Raises ValueError with the reason where there is none: no question was kept, or there are no words for it.
        """
        asked: tuple[Any, ...] = self.asked  # type: ignore[attr-defined]
        if not asked:
            raise ValueError("only a verdict of chasles.prove is told to Coq; for a chapter: `chasles decide --coq`")
        claim = theorems().as_theorem(self, *asked, name=name)
        if not claim.proof:
            raise ValueError(f"there is no theorem for Coq: {claim.why_not}")
        return f"From Chasles Require Import Scalars.\n\n{claim.said}{claim.proof}"


@dataclass(frozen=True, slots=True)
class Holds(_Asked):
    """Proved without any hypothesis. `certificate` is re-checked by `chasles.checker.certificate`."""

    name: ClassVar[str] = "holds"
    certificate: Mapping[str, Any] = field(repr=False)
    witness: Point = field(repr=False)
    unused: tuple[str, ...] = ()
    asked: tuple[Any, ...] = field(default=(), compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class HoldsUnder(_Asked):
    """Proved from the hypotheses `needs`; those in `unused` are declared and not needed."""

    name: ClassVar[str] = "holds-under"
    needs: tuple[str, ...] = field()
    certificate: Mapping[str, Any] = field(repr=False)
    witness: Point = field(repr=False)
    unused: tuple[str, ...] = ()
    asked: tuple[Any, ...] = field(default=(), compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class Fails(_Asked):
    """Refuted by an exact counterexample."""

    name: ClassVar[str] = "fails"
    true: ClassVar[bool] = False
    wrong: ClassVar[bool] = True
    counterexample: Counterexample
    asked: tuple[Any, ...] = field(default=(), compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class IllFormed(Verdict):
    """The two sides, or the parts of one, do not fit together: there is nothing to decide as printed."""

    name: ClassVar[str] = "ill-formed"
    true: ClassVar[bool] = False
    wrong: ClassVar[bool] = True
    reason: str = field()


@dataclass(frozen=True, slots=True)
class Contradictory(Verdict):
    """Nothing satisfies `hypotheses`, of which none can be spared: what is said under them is said of nothing.

    `certificate` says why, where there is one, and is re-checked by `chasles.checker.certificate`.
    """

    name: ClassVar[str] = "contradictory"
    true: ClassVar[bool] = False
    hypotheses: tuple[str, ...]
    certificate: Mapping[str, Any] | None = None

    @property
    def reason(self) -> str:
        """What contradicts what, in one clause."""
        return f"nothing satisfies {' and '.join(self.hypotheses)}"


@dataclass(frozen=True, slots=True)
class Undecided(Verdict):
    """Neither proved nor refuted: a gap of the procedure, which makes the build red.

    What is `without_form` has no polynomial form; another procedure may decide it.
    """

    name: ClassVar[str] = "undecided"
    true: ClassVar[bool] = False
    reason: str = field()
    without_form: bool = field(default=False, compare=False, repr=False)
