"""The folder for Coq: theories, statements for people to read, proofs for Coq to check, and the list of these."""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass

from chasles.coq.names import THEORIES, theory
from chasles.coq.sentences import Claimed

IN_ONE_FILE, TEXT_IN_ONE_FILE = 20, 200_000
"""So many statements, and characters of proofs, are in one file: more would save time, and take more memory."""
HEAD = "(* SPDX-License-Identifier: BSD-3-Clause *)\n"


@dataclass(frozen=True, slots=True)
class Chunk:
    """Some of the statements, in two files: `Statements_N.v` to be read, and `Proofs_N.v`."""

    number: str
    claims: tuple[Claimed, ...]

    @property
    def statements(self) -> str:
        """The name of the file of statements, without its ending."""
        return f"Statements_{self.number}"

    @property
    def proofs(self) -> str:
        """The name of the file of proofs, without its ending."""
        return f"Proofs_{self.number}"

    def said(self) -> str:
        """The statements."""
        parts = [f"{_comment(claim)}\n{claim.said}" for claim in self.claims if claim.said]
        return f"{HEAD}From Chasles Require Export Hypotheses.\n\n" + "\n".join(parts)

    def proved(self, chosen: Container[str], apart: bool = False) -> str:
        """The proofs of those whose names are chosen, and what they rest on: together, or each if `apart`.

        Coq takes half a second for what one theorem rests on, and no longer for all of a file.
        """
        claims = [claim for claim in self.claims if claim.name in chosen]
        theorems = [claim for claim in claims if not claim.is_misfit]
        parts = [claim.proof if claim.is_misfit else f"{claim.proof}Check {claim.theorem}.\n" for claim in claims]
        if apart:
            parts += [f"Print Assumptions {claim.theorem}.\n" for claim in theorems]
        elif theorems:
            *others, last = [f"({claim.theorem} : {claim.name})" for claim in theorems]
            whole = "".join(f"(conj {each}\n" for each in others) + last + ")" * len(others)
            parts.append(f"Definition all_hold :=\n{whole}.\nPrint Assumptions all_hold.\n")
        return f"{HEAD}From Chasles Require Import {THEORIES[-1]} {self.statements}.\n\n" + "\n".join(parts)


def chunks(claims: Sequence[Claimed], what: str = "") -> list[Chunk]:
    """The statements, in files of a size that Coq takes; `what` they are is in the files' names."""
    said = [claim for claim in claims if claim.said]
    groups: list[list[Claimed]] = []
    for claim in said:
        text = sum(len(each.proof) for each in (*groups[-1], claim)) if groups else 0
        if not groups or len(groups[-1]) == IN_ONE_FILE or text > TEXT_IN_ONE_FILE:
            groups.append([])
        groups[-1].append(claim)
    width = len(str(len(groups)))
    return [Chunk(f"{what}{count:0{width}}", tuple(group)) for count, group in enumerate(groups, 1)]


def files_of(parts: Sequence[Chunk], chosen: Container[str]) -> dict[str, str]:
    """All files by name, with the proofs of those chosen; of the list `coq_makefile` makes a Makefile."""
    texts = {f"{name}.v": theory(name) for name in THEORIES}
    for part in parts:
        texts[f"{part.statements}.v"] = part.said()
        texts[f"{part.proofs}.v"] = part.proved(chosen)
    return {"_CoqProject": "\n".join(("-R . Chasles", *texts, "")), **texts}


def _comment(claim: Claimed) -> str:
    """What a statement is, as a comment, in which Coq would begin strings at quotation marks."""
    part = "" if claim.whole else ", of what it claims the equations"
    what = f"({claim.number}) {claim.form}{part}: {claim.says}"
    for mark in ('"', "(*", "*)"):
        what = what.replace(mark, "")
    return f"(* {what} *)"
