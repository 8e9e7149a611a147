"""What is proved of a kernel's errors? For each result, how many roundoffs, against what, and for which inputs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

AGAINST = {
    "nothing": "exact",
    "itself": "of itself",
    "largest": "of the largest entry",
    "terms": "of the sum of its terms' sizes",
    "conditioned": "of the sum of its terms' sizes, times the condition of its divisor",
}
"""What an entry's error is measured by, and how that is said; a kind's name is what manifests hold."""


@dataclass(frozen=True, slots=True)
class Guarantee:
    """Every entry of a result is within `units` roundoffs of its exact value, in parts of `against`, for `inputs`.

    `units` is a decimal numeral, rounded upwards. Raises ValueError for anything that is not known of `against`.
    """

    result: str
    against: str
    units: str
    inputs: str

    def __post_init__(self) -> None:
        if self.against not in AGAINST:
            raise ValueError(f"an error is measured against one of {', '.join(AGAINST)}, not {self.against!r}")
        if not float(self.units) >= 0:
            raise ValueError(f"{self.result}: an error of {self.units} roundoffs makes no sense")

    @property
    def in_words(self) -> str:
        """A clause: "7.1 u of the largest entry, for every unit e and every phi"."""
        if self.against == "nothing":
            return "exact, for all inputs"
        return f"{self.units} u {AGAINST[self.against]}, for {self.inputs}"


@dataclass(frozen=True, slots=True)
class Bound:
    """What is proved of a program, one guarantee a result; or none, and the `reason`.

    `program` is the hash of all that the proof depends on.
    """

    program: str
    guarantees: tuple[Guarantee, ...] = ()
    reason: str = ""

    @property
    def in_words(self) -> tuple[str, ...]:
        """A line for each result."""
        if self.reason:
            return (f"not proved: {self.reason}",)
        if len(self.guarantees) == 1:
            return (self.guarantees[0].in_words,)
        return tuple(f"{guarantee.result}: {guarantee.in_words}" for guarantee in self.guarantees)

    def as_data(self) -> dict[str, Any]:
        """The bound as plain data."""
        return {"program": self.program, "reason": self.reason, "guarantees": list(map(asdict, self.guarantees))}

    @staticmethod
    def from_data(data: Mapping[str, Any]) -> Bound:
        """The bound that `as_data` made. Raises KeyError, TypeError or ValueError for anything else."""
        guarantees = tuple(Guarantee(**{key: str(x) for key, x in item.items()}) for item in data["guarantees"])
        reason = str(data["reason"])
        if bool(guarantees) == bool(reason):
            raise ValueError("a bound has guarantees or a reason why there are none")
        return Bound(str(data["program"]), guarantees, reason)
