"""Records for programs: one for each statement, its keys and their order fixed."""

from __future__ import annotations

import json
from collections.abc import Mapping
from hashlib import sha256
from typing import Any

from chasles.coq.recorded import checked_by_coq
from chasles.decisions.session import Decision
from chasles.report.equations import in_both, in_latex, in_words, signature_in_words
from chasles.statements import Entry, Statement
from chasles.statements.elsewhere import chapter_of, other_chapter
from chasles.verdict import Counterexample

ROLES = {"inverse": "theorem"}
"""An inverse with cases is proved from the claims that it generates, as a theorem is, and is recorded as one."""


def record(entry: Entry, decision: Decision) -> dict[str, Any]:
    """The decision on one statement, as `chasles decide --json` prints it."""
    verdict = decision.verdict
    return {
        **_identity(entry),
        "verdict": verdict.name,
        "needs": list(verdict.needs),
        "contradictory": list(getattr(verdict, "hypotheses", ())),
        "counterexample": _counterexample(getattr(verdict, "counterexample", None)),
        "corrected": _corrected(decision),
        "latex": r" \qquad ".join(in_latex(entry.statement)),
        "certificate": certificate_hash(decision.certificate),
        "coq": _checked_by_coq(decision),
        "milliseconds": round(decision.milliseconds, 3),
    }


def _cited(given: Statement, here: str) -> dict[str, Any]:
    """A statement that is given, with its chapter where that is another."""
    home = other_chapter(given, here)
    return {"number": given.number, "part": given.part} | ({"chapter": home} if home else {})


def described(entry: Entry, emitted: Mapping[str, Mapping[str, Any]] | None = None) -> dict[str, Any]:
    """What a statement says and what it rests on, nothing decided, and the records of kernels `emitted`."""
    statement = entry.statement
    return {
        **_identity(entry),
        "says": statement.says,
        "text": list(in_words(statement)),
        "given": [_cited(given, chapter_of(statement)) for given in statement.given],
        "assuming": [hypothesis.text for hypothesis in statement.assuming],
        "kernel": signature_in_words(entry),
        "kernels": [
            {"name": kernel.name, "form": emitted[kernel.name]["form"], "bound": emitted[kernel.name]["bound"]}
            for kernel in entry.kernels
            if emitted and kernel.name in emitted
        ],
    }


def certificate_hash(certificate: Mapping[str, Any] | None) -> str | None:
    """The sha256 of the certificate's canonical JSON (sorted keys, no blanks, UTF-8); None without a certificate."""
    if certificate is None:
        return None
    canonical = json.dumps(certificate, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return f"sha256:{sha256(canonical.encode()).hexdigest()}"


def _identity(entry: Entry) -> dict[str, Any]:
    role = entry.statement.role
    return {
        "number": entry.number,
        "part": entry.statement.part,
        "name": entry.name,
        "section": entry.section.number,
        "role": ROLES.get(role, role),
    }


def _checked_by_coq(decision: Decision) -> dict[str, Any] | None:
    """The version of Coq that has accepted all that is claimed of a statement, and the hashes of the files of it."""
    found = checked_by_coq(decision.statement)
    return None if found is None else {"version": found.version, "files": dict(found.files)}


def _counterexample(found: Counterexample | None) -> dict[str, Any] | None:
    if found is None:
        return None
    return {
        "at": {name: str(value) for name, value in found.at.items()},
        "entry": list(found.entry),
        "lhs": found.left,
        "rhs": found.right,
    }


def _corrected(decision: Decision) -> dict[str, Any] | None:
    if decision.correction is None or not isinstance(decision.statement, Statement):
        return None
    text, latex = in_both(decision.correction.sides, decision.statement.sign)
    return {
        "latex": latex,
        "text": text,
        "found": decision.correction.found,
        "form": decision.correction.form,
        "verdict": decision.correction.verdict.name,
    }
