"""What Coq has checked of a chapter: a record that lies beside its declarations, by number and part.

It is told of a sentence only as long as neither its declaration nor the words of the theories have changed since.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from importlib.resources import files
from typing import Any

from chasles.coq.names import theory
from chasles.decisions.decision import Sentence, key_of
from chasles.statements import Problem
from chasles.statements.elsewhere import chapter_of
from chasles.statements.fingerprint import Fingerprints

RECORD = "COQ.json"
MEANING = ("Words", "Hypotheses")
"""The theories that say what statements mean."""


@dataclass(frozen=True, slots=True)
class CoqCheck:
    """That Coq of some version has accepted all that is claimed of a sentence; the hashes of files of statements."""

    version: str
    files: Mapping[str, str]

    @property
    def in_words(self) -> str:
        """For a page: Coq 8.16.1 checked, and of which files."""
        said = ", ".join(f"{name} sha256:{digest}" for name, digest in self.files.items())
        return f"Coq {self.version} checked: {said}"


def text_of(
    version: str,
    checked: Mapping[Sentence, Mapping[str, str]],
    kernels: Mapping[str, tuple[Problem, Mapping[str, str]]],
) -> str:
    """The record as text: of each sentence, and of each kernel by its name, the files of statements and their hashes.

    Of a kernel it is the problem that has a fingerprint: the declaration and all steps of the program.
    """
    pairs = {key_of(sentence): (sentence, where) for sentence, where in checked.items()}
    found, programs = (
        {key: {"declared": _fingerprints().of(said), "files": dict(where)} for key, (said, where) in each.items()}
        for each in (pairs, kernels)
    )
    return json.dumps({"version": version, "words": _words(), "checked": found, "kernels": programs}, indent=1) + "\n"


def checked_by_coq(sentence: Sentence) -> CoqCheck | None:
    """What the record of its chapter says of a sentence; None if nothing, or if something has changed since."""
    try:
        record = _record(chapter_of(sentence))
        if record["words"] != _words():
            return None
        found = record["checked"][key_of(sentence)]
        if found["declared"] != _fingerprints().of(sentence):
            return None
        return CoqCheck(str(record["version"]), {str(name): str(digest) for name, digest in found["files"].items()})
    except (AttributeError, KeyError, TypeError):
        return None


@cache
def _record(package: str) -> Any:
    try:
        return json.loads(files(package).joinpath(RECORD).read_text("utf-8"))
    except (ModuleNotFoundError, OSError, TypeError, ValueError):
        return {}


@cache
def _words() -> str:
    return sha256("\0".join(map(theory, MEANING)).encode()).hexdigest()


@cache
def _fingerprints() -> Fingerprints:
    return Fingerprints()
