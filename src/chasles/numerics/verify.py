"""Are a kernel's digits right? Its results beside 50-digit values, over sampled inputs.

An error is measured against the size of the result, in units of the roundoff (2^-53 or 2^-24). How large it may be is
not chosen but computed: each rounding in a row can cost one unit, and as much as moving every input by one unit in its
last place moves the exact result. A kernel that loses digits which its inputs determine fails.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice
from math import inf, isfinite
from typing import Any
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from chasles.numerics.draws import CONTEXT
from chasles.numerics.enclosures import exactly
from chasles.numerics.reference import Singular
from chasles.numerics.sampling import STRATEGIES, Sample, draw, moves
from chasles.numerics.specification import Specification
from chasles.vocabulary import Node

Function = Callable[..., Any]
SHOWN = 3
"""How many failures are kept."""


@dataclass(frozen=True, slots=True)
class Finding:
    """One result at one input: its error and what was allowed, in units of the roundoff.

    Where the error is within the roundings alone, `allowed` is just these: the condition was not needed.
    """

    strategy: str
    output: str
    error: float
    allowed: float
    at: dict[str, Any] = field(hash=False)

    @property
    def failed(self) -> bool:
        """Whether more digits are lost than the inputs leave open."""
        return not self.error <= self.allowed

    @property
    def share(self) -> float:
        """The error over what was allowed: above one where more digits are lost than the inputs leave open."""
        return self.error / self.allowed if self.allowed else inf if self.failed else 0.0

    def as_json(self) -> dict[str, Any]:
        """The finding as plain data; errors with four digits, an infinite one as null."""
        shown = {"error": self.error, "allowed": self.allowed}
        numbers = {key: float(f"{x:.4g}") if isfinite(x) else None for key, x in shown.items()}
        return {"strategy": self.strategy, "output": self.output, **numbers, "at": self.at}


@dataclass(frozen=True, slots=True)
class Evidence:
    """What was found out about one kernel in one precision; `worst` has the largest error of each strategy.

    `share` is the largest error over what was allowed for it, which need not be that of the largest error.
    """

    kernel: str
    dtype: str
    samples: int
    skipped: int
    worst: tuple[Finding, ...]
    failures: tuple[Finding, ...]
    failed: int
    share: float = 0.0

    @property
    def passed(self) -> bool:
        """Whether every result was as good as its inputs allow."""
        return self.failed == 0

    @property
    def error(self) -> float:
        """The largest error, in units of the roundoff."""
        return max((finding.error for finding in self.worst), default=0.0)

    def as_json(self) -> dict[str, Any]:
        """The evidence as plain data; the same for the same kernel, seed and machine."""
        return {
            "kernel": self.kernel,
            "dtype": self.dtype,
            "samples": self.samples,
            "skipped": self.skipped,
            "passed": self.passed,
            "failed": self.failed,
            "share": float(f"{self.share:.4g}") if isfinite(self.share) else None,
            "worst": [finding.as_json() for finding in self.worst],
            "failures": [finding.as_json() for finding in self.failures],
        }


def verify(
    asked: Specification,
    function: Function,
    *,
    dtype: type[np.floating] = np.float64,
    strategies: Sequence[str] = tuple(STRATEGIES),
    samples: int = 100,
    seed: int = 0,
    batched: bool = False,
) -> Evidence:
    """How the function's results differ from the reference, over so many inputs from each strategy.

    The function takes the inputs in their order and returns its outputs, an array or a tuple of arrays; with
    `batched` it gets all inputs of a strategy at once, the batch axis first. Inputs at which the reference is singular
    or beyond the type's range are skipped. Raises TypeError for results of another shape or type.
    """
    worst: list[Finding] = []
    failures: list[Finding] = []
    skipped, share = 0, 0.0
    for strategy in strategies:
        generator = np.random.default_rng([seed, crc32(f"{asked.name} {strategy}".encode())])
        inputs = list(islice(draw(asked, strategy, generator, dtype), samples))
        findings: list[Finding] = []
        for sample, results in zip(inputs, _results(asked, function, inputs, dtype, batched), strict=True):
            comparison = _Comparison(asked, strategy, sample, dtype)
            found = list(comparison.findings(results))
            skipped += not found
            findings += found
        failures += [finding for finding in findings if finding.failed]
        if findings:
            worst.append(max(findings, key=lambda finding: finding.error))
            share = max(share, *(finding.share for finding in findings))
    failures.sort(key=lambda finding: -finding.error)
    total = samples * len(strategies)
    kept = tuple(failures[:SHOWN])
    return Evidence(asked.name, np.dtype(dtype).name, total, skipped, tuple(worst), kept, len(failures), share)


def _results(
    asked: Specification, function: Function, inputs: list[Sample], dtype: type[np.floating], batched: bool
) -> list[list[NDArray[Any]]]:
    """The function's outputs for each input, flat."""
    columns = [[given.gathered(sample.arrays) for sample in inputs] for given in asked.inputs]
    with np.errstate(all="ignore"):
        if batched:
            together = _outputs(asked, function(*map(np.stack, columns)), dtype, (len(inputs),))
            return [[output[k] for output in together] for k in range(len(inputs))]
        return [
            _outputs(asked, function(*(x[()] for x in arguments)), dtype, ())
            for arguments in zip(*columns, strict=True)
        ]


def _outputs(
    asked: Specification, returned: Any, dtype: type[np.floating], batch: tuple[int, ...]
) -> list[NDArray[Any]]:
    parts = returned if isinstance(returned, tuple) else (returned,)
    if len(parts) != len(asked.outputs):
        raise TypeError(f"{asked.name} returned {len(parts)} results, and {len(asked.outputs)} are expected")
    flat = []
    for output, part in zip(asked.outputs, map(np.asarray, parts), strict=True):
        if part.shape != (*batch, *output.shape) or part.dtype != dtype:
            raise TypeError(
                f"{asked.name} returned {output.name} as {part.dtype} of shape {part.shape}: "
                f"{np.dtype(dtype)} of shape {(*batch, *output.shape)} is expected"
            )
        flat.append(part.reshape(*batch, -1))
    return flat


class _Comparison:
    """Results beside the reference at one input."""

    def __init__(self, asked: Specification, strategy: str, sample: Sample, dtype: type[np.floating]) -> None:
        self.asked = asked
        self.strategy = strategy
        self.arrays = sample.arrays
        self.values: dict[Node, Any] = dict(sample.exact if asked.exact_inputs else sample.arrays)
        self.limits = np.finfo(dtype)
        self.unit = exactly(float(self.limits.eps) / 2, CONTEXT)
        self._conditions: list[list[Any]] | None = None

    def findings(self, results: list[NDArray[Any]]) -> Iterator[Finding]:
        """One finding for each output and each group of its entries.

        None where there is no reference, or where the rounding of an exact input leaves no digit of it.
        """
        try:
            self.expected = self._exact(self.values, 50)
        except Singular:
            return
        if any(abs(x) > float(self.limits.max) for entries in self.expected for x in entries):
            return
        for k, (output, result) in enumerate(zip(self.asked.outputs, results, strict=True)):
            for g, places in enumerate(output.alike):
                error = self._error(k, places, [float(result[place]) for place in places])
                allowed = float(self.asked.roundings)
                if error > allowed:
                    allowed *= 1 + float(self._condition(k, g))
                if self.asked.exact_inputs and allowed * float(self.unit) >= 1:
                    continue
                yield Finding(self.strategy, output.name, error, allowed, self._at())

    def _exact(self, values: dict[Node, Any], digits: int) -> list[list[Any]]:
        return [[x for row in matrix for x in row] for matrix in self.asked.reference(values, digits)]

    def _size(self, k: int, places: tuple[int, ...]) -> Any:
        """The size of a group of entries; below the smallest normal number, floats have no digits to lose."""
        return max(*(abs(self.expected[k][place]) for place in places), exactly(float(self.limits.tiny), CONTEXT))

    def _error(self, k: int, places: tuple[int, ...], got: list[float]) -> float:
        if not all(map(isfinite, got)):
            return inf
        gaps = [abs(exactly(x, CONTEXT) - self.expected[k][place]) for x, place in zip(got, places, strict=True)]
        return float(max(gaps) / self._size(k, places) / self.unit)

    def _condition(self, k: int, g: int) -> Any:
        """How far the exact group moves, in units, if every input entry moves by one unit in its last place."""
        if self._conditions is None:
            self._conditions = [[CONTEXT.mpf(0) for _ in output.alike] for output in self.asked.outputs]
            for node, value in self.arrays.items():
                for moved in moves(self.asked, node, value, self.values[node]):
                    self._add_moves(node, moved)
        return self._conditions[k][g]

    def _add_moves(self, node: Node, neighbours: tuple[Any, Any]) -> None:
        """Add the larger of the two changes that a move of one input, forth or back, causes."""
        assert self._conditions is not None
        moved = [exact for value in neighbours if (exact := self._beside(node, value)) is not None]
        for k, output in enumerate(self.asked.outputs):
            for g, places in enumerate(output.alike):
                changes = [max(abs(exact[k][p] - self.expected[k][p]) for p in places) for exact in moved]
                self._conditions[k][g] += max(changes, default=0) / self._size(k, places) / self.unit

    def _beside(self, node: Node, value: Any) -> list[list[Any]] | None:
        try:
            return self._exact({**self.values, node: value}, 20)
        except Singular:
            return None

    def _at(self) -> dict[str, Any]:
        return {given.name: given.gathered(self.arrays).tolist() for given in self.asked.inputs}
