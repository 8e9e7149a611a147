"""Does Coq accept it? Files are compiled two at a time, in a folder of their own, with bounded memory.

What it has accepted is kept: a theorem is checked again if its statement, its proof, a theory or Coq has changed.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Container, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory

from chasles import cache
from chasles.cache import folder, keep
from chasles.coq.folder import Chunk
from chasles.coq.names import THEORIES, hash_of_theories, theory
from chasles.coq.sentences import Claimed
from chasles.decisions.processes import processors

MISSING = "coqc was not found: install the Debian package coq, and Coq checks what is written"
AXIOMS = frozenset({
    "ClassicalDedekindReals.sig_forall_dec", "ClassicalDedekindReals.sig_not_dec",
    "functional_extensionality_dep", "Classical_Prop.classic",
})  # fmt: skip
"""What Coq's real numbers rest on, logarithms on the last. A theorem that rests on anything else does not count."""
PROVED = re.compile(r"^\w+_holds\s+: \w+$", re.MULTILINE)
ANSWER = re.compile(r"^(?=Axioms:|Closed under the global context)", re.MULTILINE)
REFUSED = "while it is expected to have type"
BOUNDED = 'ulimit -v 2097152 2>/dev/null; ulimit -t 300; exec "$@"'
"""What one file may take: kilobytes of memory, where a system bounds it, and seconds of processor time."""
LIGHT = "s=1M,o=40"
"""How Coq clears up its memory: a quarter less than by default, for a tenth more of time."""
AT_ONCE = 2
FORBIDDEN = re.compile(
    r"\b(?:Admitted|admit|give_up)\b|^\s*(?:Axioms?|Parameters?|Conjecture|Hypothes[ie]s|Variables?)\b", re.MULTILINE
)
KEPT = "coq.txt"
MOST = 10**5
"""So many theorems are remembered, 7 MB."""


@dataclass(frozen=True, slots=True)
class CoqVerdict:
    """Whether Coq accepted a theorem, and if not, why."""

    claim: Claimed
    why_not: str = ""

    @property
    def accepted(self) -> bool:
        """Whether Coq accepted it."""
        return not self.why_not


def coq_version() -> str | None:
    """The version of the Coq that is installed, None if there is none."""
    if shutil.which("coqc") is None:
        return None
    said = subprocess.run(["coqc", "--print-version"], capture_output=True, text=True, check=False).stdout.split()
    return said[0] if said else None


def verdicts_of_coq(parts: Sequence[Chunk], known: Container[str] = (), anew: bool = False) -> Iterator[CoqVerdict]:
    """What Coq says of each theorem that has a proof; those `known` by their names have been accepted before.

    Of each statement that it refuses, too: its claim says nothing then.
    """
    todo = []
    for part in parts:
        before = [claim for claim in part.claims if claim.proof and claim.name in known]
        yield from map(CoqVerdict, before)
        waiting = [claim for claim in part.claims if claim.proof and claim.name not in known]
        todo += [(part, waiting)] if waiting else []
    if not todo:
        return
    with TemporaryDirectory(prefix="chasles-coq-") as name:
        folder = Path(name)
        compile_theories(folder, anew)
        with ThreadPoolExecutor(max_workers=min(processors(), AT_ONCE)) as pool:
            for found in pool.map(lambda each: _judged(folder, *each), todo):
                yield from found


def compile_theories(folder: Path, anew: bool = False) -> None:
    """Put the theories into a folder, compiled: unless `anew`, as an earlier run has kept them where there is a cache.

    Raises `ChildProcessError` if Coq refuses one.
    """
    root = cache.folder()
    kept = root and root / f"coq-{hash_of_theories(coq_version() or '')}"
    if kept and kept.is_dir() and not anew:
        shutil.copytree(kept, folder, dirs_exist_ok=True)
        return
    for each in THEORIES:
        done = _compiled(folder, each, theory(each))
        if done.returncode:
            raise ChildProcessError(f"Coq refuses {each}.v: {done.stderr.strip()}")
    if kept:
        with suppress(OSError):  # a cache that cannot be written is none; of two who write it, the second leaves it
            kept.parent.mkdir(parents=True, exist_ok=True)
            with TemporaryDirectory(dir=kept.parent) as draft:
                shutil.copytree(folder, Path(draft) / kept.name).rename(kept)


def _compiled(folder: Path, name: str, text: str) -> subprocess.CompletedProcess[str]:
    (folder / f"{name}.v").write_text(text, "utf-8")
    command = ["coqc", "-q", "-noglob", "-R", ".", "Chasles", f"{name}.v"]
    if os.name == "posix":
        command = ["sh", "-c", BOUNDED, "sh", *command]
    environment = {"OCAMLRUNPARAM": LIGHT} | os.environ
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, env=environment)


def _judged(folder: Path, part: Chunk, claims: list[Claimed]) -> list[CoqVerdict]:
    """Of a file of statements that Coq refuses, each half is judged by itself."""
    done = _compiled(folder, part.statements, part.said())
    if not done.returncode:
        return list(_proved(folder, part, claims))
    if len(part.claims) == 1:
        return [CoqVerdict(replace(part.claims[0], said="", proof=""), _reason(done, "statement"))]
    half = len(part.claims) // 2
    halves = Chunk(f"{part.number}a", part.claims[:half]), Chunk(f"{part.number}b", part.claims[half:])
    return [found for each in halves for found in _judged(folder, each, [c for c in claims if c in each.claims])]


def _proved(folder: Path, part: Chunk, claims: list[Claimed]) -> Iterator[CoqVerdict]:
    """Coq stops at the first theorem that it refuses, and goes on with the next one; what takes too long, it halves."""
    waiting = []
    for claim in claims:
        if found := FORBIDDEN.search(claim.proof):
            yield CoqVerdict(claim, f"its proof says {found[0]}")
        elif claim.is_misfit:
            yield _refused(folder, part, claim)
        else:
            waiting.append(claim)
    while waiting:
        done = _compiled(folder, part.proofs, part.proved({claim.name for claim in waiting}))
        if not done.returncode:
            yield from _resting(folder, part, waiting, done.stdout)
            return
        if done.returncode < 0 and len(waiting) > 1:  # a file takes longer than its theorems do alone
            half = len(waiting) // 2
            yield from (found for each in (waiting[:half], waiting[half:]) for found in _proved(folder, part, each))
            return
        proved = len(PROVED.findall(done.stdout))
        yield CoqVerdict(waiting.pop(min(proved, len(waiting) - 1)), _reason(done))


def _resting(folder: Path, part: Chunk, claims: list[Claimed], said: str) -> Iterator[CoqVerdict]:
    """Whether theorems that Coq has accepted rest on no more than they may: of all at once, then of each."""
    answers = ANSWER.split(said)[1:]
    if len(answers) == 1 and not _objection(answers[0]):
        yield from map(CoqVerdict, claims)
        return
    done = _compiled(folder, part.proofs, part.proved({claim.name for claim in claims}, apart=True))
    for claim, answer in zip(claims, ANSWER.split(done.stdout)[1:], strict=True):
        yield CoqVerdict(claim, _objection(answer))


def _objection(answer: str) -> str:
    """What is wrong with theorems that Coq has accepted, by what it says that they rest on; empty if nothing is."""
    axioms = set(re.findall(r"^([\w.']+)\s*:", answer.removeprefix("Axioms:"), re.MULTILINE))
    return f"it rests on {', '.join(foreign)}" if (foreign := sorted(axioms - AXIOMS)) else ""


def _refused(folder: Path, part: Chunk, claim: Claimed) -> CoqVerdict:
    """Whether Coq refuses an equation because of its sizes, when `Fail` is left away."""
    name = f"Misfits_{part.number}"
    done = _compiled(folder, name, f"From Chasles Require Import Hypotheses.\n{claim.proof.removeprefix('Fail ')}")
    is_refused = done.returncode and REFUSED in re.sub(r"\s+", " ", done.stderr)
    return CoqVerdict(claim, "" if is_refused else "Coq finds no fault with its sizes")


def _reason(done: subprocess.CompletedProcess[str], what: str = "proof") -> str:
    if done.returncode < 0 or "Out of memory" in done.stderr:
        return "it takes more time or memory than one file may"
    said = re.sub(r"\s+", " ", done.stderr.partition("Error:")[2]).strip()
    return f"Coq refuses the {what}: {said[-200:] or done.stderr.strip()[-200:]}"


def accepted_before(claims: Iterable[Claimed], version: str) -> set[str]:
    """The names of those that this version of Coq has accepted as they are."""
    known = set(_kept())
    return {claim.name for claim in claims if _digest(claim, version) in known}


def keep_accepted(verdicts: Iterable[CoqVerdict], version: str) -> None:
    """Remember what was accepted, where there is a cache that can be written."""
    place, before = folder(), _kept()
    found = [_digest(each.claim, version) for each in verdicts if each.accepted]
    if place is not None and not set(before).issuperset(found):
        with suppress(OSError):
            place.mkdir(parents=True, exist_ok=True)
            keep(place / KEPT, "\n".join(list(dict.fromkeys((*before, *found)))[-MOST:]).encode())


def _kept() -> list[str]:
    place = folder()
    with suppress(OSError, UnicodeDecodeError):
        return (place / KEPT).read_text("ascii").split() if place is not None else []
    return []


def _digest(claim: Claimed, version: str) -> str:
    return sha256("\0".join((hash_of_theories(version), claim.said, claim.proof)).encode()).hexdigest()
