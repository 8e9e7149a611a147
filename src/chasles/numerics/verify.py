"""Are a kernel's digits right? Its results beside 50-digit values, over sampled inputs.

An error is measured against the size of the result, in units of the roundoff (2^-53 or 2^-24). How large it may be is
not chosen but computed: each rounding in a row can cost one unit, and as much as moving every input by one unit in its
last place moves the exact result. A kernel that loses digits which its inputs determine fails.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice
from math import inf
from typing import Any
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from chasles.numerics.draws import CONTEXT
from chasles.numerics.enclosures import exactly
from chasles.numerics.reference import Singular
from chasles.numerics.request import Output, Request
from chasles.numerics.sampling import STRATEGIES, Sample, draw
from chasles.numerics.small_matrices import Matrix

__all__ = ["Evidence", "Finding", "verify", "verify_all"]

Function = Callable[..., Any]
SHOWN = 3
"""How many failures are kept."""


@dataclass(frozen=True, slots=True)
class Finding:
    """One result at one input: its error and what was allowed, in units of the roundoff.

    `allowed` is None where it was not needed: the error is within the roundings alone.
    """

    strategy: str
    output: str
    error: float
    allowed: float | None
    at: dict[str, Any] = field(hash=False)


@dataclass(frozen=True, slots=True)
class Evidence:
    """What was found out about one kernel in one precision; `worst` has the largest error of each strategy."""

    kernel: str
    dtype: str
    samples: int
    skipped: int
    worst: tuple[Finding, ...]
    failures: tuple[Finding, ...]
    failed: int

    @property
    def passed(self) -> bool:
        """Whether every result was as good as its inputs allow."""
        return self.failed == 0

    @property
    def error(self) -> float:
        """The largest error, in units of the roundoff."""
        return max((finding.error for finding in self.worst), default=0.0)

    def as_json(self) -> dict[str, Any]:
        """The evidence as plain data, the same for the same seed and kernel."""
        ...
