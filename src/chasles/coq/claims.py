"""What is claimed in Coq: a statement with its proof."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Claimed:
    """One statement in Coq and its proof: `said` is empty where it cannot be said, `proof` where there is none yet.

    `number` and `form` tell what it is of, `kernel` of which kernel, if of one; `whole` says whether the statement is
    all that the verdict claims. Of a misfit the proof is a command that succeeds because Coq refuses the equation; a
    witness says that there is what satisfies the premises of another statement.
    """

    number: str
    form: str
    name: str
    says: str
    said: str = ""
    proof: str = ""
    why_not: str = ""
    whole: bool = True
    is_misfit: bool = False
    is_witness: bool = False
    kernel: str = ""

    @property
    def theorem(self) -> str:
        """The name of the theorem."""
        return f"{self.name}_holds"
