"""Which claims rest on a statement, and what do they say with another one in its place?"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace as with_fields

from chasles.statements import Claim, Statement
from chasles.statements.posing import default_sides


def users_of(statement: Statement, claims: Iterable[Claim]) -> list[Claim]:
    """The claims that rest on a definition."""
    return [claim for claim in claims if any(_equivalent(statement, given) for given in claim.given)]


def resting_on(meant: Statement, user: Claim) -> Statement:
    """A claim, resting on what was meant."""
    given = tuple(meant if _equivalent(meant, other) else other for other in user.given)
    return with_fields(user.saying(*default_sides(user)), given=given)


def says_something(claim: Claim) -> bool:
    """Whether a claim fits together in one of its forms."""
    return not claim.fault or claim.form_exists("reading") or claim.form_exists("corrected")


def not_resting_on(statement: Statement, claims: tuple[Claim, ...]) -> tuple[Claim, ...]:
    """The claims that say something of their own: the standing of the others cannot be asked for yet."""
    known: dict[int, bool] = {}

    def rests(one: Statement) -> bool:
        if id(one) not in known:
            known[id(one)] = _equivalent(one, statement) or any(map(rests, one.given))
        return known[id(one)]

    return tuple(claim for claim in claims if not rests(claim))


def _equivalent(one: Statement, other: Statement) -> bool:
    return (one.number, one.part) == (other.number, other.part)
