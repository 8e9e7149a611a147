"""The outcome of `verify`: the errors of the kernels against 50 digits, and which of them are failures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from time import perf_counter
from types import ModuleType
from typing import Any

from chasles.cli.comparison import Asked, backend_of, compared
from chasles.decisions.session import Session
from chasles.numerics.verify import Evidence
from chasles.report.evidence import is_wrong, worst_of
from chasles.report.words import number_of, seconds


@dataclass(frozen=True, slots=True)
class Verification:
    """The evidence on kernels of a backend ("c" or "numpy"), and how long it took to gather it."""

    backend: str
    evidence: tuple[Evidence, ...]
    seconds: float

    @property
    def wrong(self) -> tuple[str, ...]:
        """The kernels that do not compute what their statements say."""
        return tuple(dict.fromkeys(found.kernel for found in self.evidence if is_wrong(found)))

    @property
    def lossy(self) -> tuple[str, ...]:
        """The others that lose digits somewhere."""
        names = dict.fromkeys(found.kernel for found in self.evidence if not found.passed)
        return tuple(name for name in names if name not in self.wrong)

    @property
    def in_words(self) -> Iterator[str]:
        """Totals, the largest errors and the time."""
        count = len({found.kernel for found in self.evidence})
        points = sum(found.samples - found.skipped for found in self.evidence)
        compared = f"{number_of(count, 'kernel')} ({self.backend}) compared with 50 digits"
        yield f"{compared} at {number_of(points, 'point')} in {seconds(self.seconds)}"
        if self.evidence:
            yield worst_of(self.evidence)
        if self.lossy:
            yield f"digits are lost near singular points by {', '.join(self.lossy)}; `chasles verify` shows where"

    def failures(self, strict: bool) -> Iterator[str]:
        """A line for each kind of failure; lost digits are one only if `strict`."""
        if self.wrong:
            yield f"not what the statements say: {', '.join(self.wrong)}"
        if self.lossy and strict:
            yield f"these kernels lose digits: {', '.join(self.lossy)}"

    def as_json(self) -> dict[str, Any]:
        """All of it as plain data."""
        return {
            "backend": self.backend,
            "seconds": round(self.seconds, 3),
            "wrong": list(self.wrong),
            "lossy": list(self.lossy),
            "evidence": [found.as_json() for found in self.evidence],
        }


def verified(
    asked: Sequence[Asked], kernels: ModuleType, strategies: Sequence[str], samples: int, session: Session
) -> Verification:
    """Compare the kernels asked for at so many points of each kind, in each precision."""
    started = perf_counter()
    evidence = tuple(compared(asked, kernels, strategies, samples, session))
    return Verification(backend_of(kernels), evidence, perf_counter() - started)
