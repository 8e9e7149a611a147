"""What Coq has accepted before: a theorem is checked again if its statement, its proof, a theory or Coq has changed."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from hashlib import sha256

from chasles.cache import folder, keep
from chasles.coq.checking import CoqVerdict
from chasles.coq.claims import Claimed
from chasles.coq.names import hash_of_theories

KEPT = "coq.txt"
MOST = 10**5
"""So many theorems are remembered, 7 MB."""


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
