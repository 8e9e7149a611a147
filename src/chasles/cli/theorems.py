"""The theorems of `decide --coq`: written to a folder, checked by Coq where it is installed, and told of."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

from chasles.cli.failures import failing
from chasles.cli.files import write_files
from chasles.coq.checking import MISSING, CoqVerdict, accepted_before, coq_version, keep_accepted, verdicts_of_coq
from chasles.coq.folder import Chunk, chunks, files_of
from chasles.coq.kernels import kernels_of
from chasles.coq.recorded import RECORD, text_of
from chasles.coq.sentences import Claimed
from chasles.coq.theorems import claims_of
from chasles.decisions.decision import Decision, key_of
from chasles.lowering.declaration import Decide
from chasles.report.findings import Pairs
from chasles.report.waiting import progress
from chasles.report.words import number_of
from chasles.statements import Problem


@dataclass(frozen=True, slots=True)
class Theorems:
    """What was written to a folder, and what Coq says of it, if there is a Coq of some `version`."""

    folder: Path
    claims: tuple[Claimed, ...]
    parts: tuple[Chunk, ...]
    version: str | None
    checked: tuple[CoqVerdict, ...]

    @property
    def in_words(self) -> Iterator[str]:
        """What is not accepted, each with its reason, and how many are."""
        for claim, why_not in self._not_accepted():
            yield f"({claim.number}) {claim.form}: not accepted by Coq: {why_not}"
        if self.version is None:
            yield f"{number_of(sum(bool(claim.proof) for claim in self.claims), 'theorem')} in {self.folder}; {MISSING}"
        else:
            found = [each.claim for each in self.checked if each.accepted]
            accepted = [claim for claim in found if not (claim.is_witness or claim.kernel)]
            of = number_of(sum(not (claim.is_witness or claim.kernel) for claim in self.claims), "statement")
            yield f"Coq {self.version} accepted {len(accepted)} of {of} in {self.folder}"
            if kernels := sum(bool(claim.kernel) for claim in self.claims):
                programs = sum(bool(claim.kernel) for claim in found)
                yield f"of {programs} of {number_of(kernels, 'kernel')} that they compute what their statements say"
            if witnesses := sum(claim.is_witness for claim in found):
                yield f"of {witnesses} of them also that there is what satisfies all that they assume"
            if parts := sum(not claim.whole for claim in accepted):
                yield f"of {parts} of them, theorems, the equations that prove them"

    @property
    def record(self) -> dict[str, Any]:
        """The same for programs: `accepted` is null where there is no Coq."""
        verdicts = {each.claim.name: each.accepted for each in self.checked}
        files = {claim.name: part for part in self.parts for claim in part.claims}
        reasons = {claim.name: why for claim, why in self._not_accepted()}
        return {
            "folder": str(self.folder),
            "version": self.version,
            "theorems": [
                {
                    "number": claim.number,
                    "form": claim.form,
                    "name": claim.name,
                    "whole": claim.whole,
                    "witness": claim.is_witness,
                    "kernel": claim.kernel or None,
                    "accepted": verdicts.get(claim.name, None if self.version is None and claim.proof else False),
                    "reason": reasons.get(claim.name),
                    "file": f"{files[claim.name].statements}.v" if claim.said else None,
                    "sha256": _digest(files[claim.name]) if claim.said else None,
                }
                for claim in self.claims
            ],
        }

    def recorded(self, decisions: Iterable[Decision], problems: Mapping[str, Problem | None]) -> dict[str, str]:
        """The file that says of which sentences and kernels all is accepted; none where there is no Coq.

        The `problems` are those that kernels pose, by name.
        """
        if self.version is None:
            return {}
        accepted = {each.claim.name for each in self.checked if each.accepted}
        files = {claim.name: part for part in self.parts for claim in part.claims}
        hashes = {part.number: _digest(part) for part in self.parts}
        found = {}
        for decision in decisions:
            key = key_of(decision.statement)
            said = [each for each in self.claims if each.number == key and not (each.is_witness or each.kernel)]
            if said and all(each.whole and each.name in accepted for each in said):
                parts = [files[each.name] for each in said]
                found[decision.statement] = {f"{part.statements}.v": hashes[part.number] for part in parts}
        kernels = {}
        for each in self.claims:
            if each.name in accepted and (problem := problems.get(each.kernel)):
                part = files[each.name]
                kernels[each.kernel] = problem, {f"{part.statements}.v": hashes[part.number]}
        return {RECORD: text_of(self.version, found, kernels)}

    def _not_accepted(self) -> Iterator[tuple[Claimed, str]]:
        refused = {each.claim.name: each.why_not for each in self.checked}
        for claim in self.claims:
            if why_not := claim.why_not or refused.get(claim.name, ""):
                yield claim, why_not


def _digest(part: Chunk) -> str:
    return sha256(part.said().encode()).hexdigest()


def written(folder: Path, decided: Pairs, decide: Decide, anew: bool = False) -> Theorems:
    """Write the theorems of decisions and kernels, checked by Coq if it is installed: then only proofs that it accepts.

    Unless all are to be checked `anew`, those that it accepted in an earlier run are not checked again.
    The folder's files are written whole or not at all. Raises Failure where that is not possible.
    """
    decisions = [decision for _, decision in decided]
    kernels = dict(kernels_of((entry for entry, _ in decided), decide))
    parts = (*chunks(said := tuple(claims_of(decisions))), *chunks(tuple(kernels), "of_kernels_"))
    claims = (*said, *kernels)
    version = coq_version()
    proved = [claim for claim in claims if claim.proof]
    chosen = {claim.name for claim in proved}
    checked: tuple[CoqVerdict, ...] = ()
    if version is not None:
        with failing(ChildProcessError):
            before = set() if anew else accepted_before(proved, version)
            checked = tuple(progress(verdicts_of_coq(parts, before, anew), len(proved), "Coq"))
            keep_accepted(checked, version)
        chosen = {each.claim.name for each in checked if each.accepted}
        refused = {each.claim.name: each.claim for each in checked if not each.claim.said}
        claims = tuple(refused.get(claim.name, claim) for claim in claims)
        parts = tuple(replace(p, claims=tuple(refused.get(each.name, each) for each in p.claims)) for p in parts)
    found = Theorems(folder, claims, parts, version, checked)
    problems = {claim.kernel: problem for claim, problem in kernels.items()}
    write_files(folder, files_of(parts, chosen) | found.recorded(decisions, problems))
    return found
