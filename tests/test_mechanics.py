"""Some 150 equations of textbook mechanics under their equations of motion: each is decided, and rightly."""

from __future__ import annotations

import pytest

from chasles.prove import prove, recheck
from chasles.verdict import Fails, Holds, HoldsUnder

COUNT = 148


def test_all_of_them_are_tried() -> None:
    from .mechanics import CASES

    assert len(CASES) == COUNT


@pytest.mark.sampled(3)
@pytest.mark.parametrize("place", range(COUNT))
def test_mechanics_is_decided_rightly(place: int) -> None:
    from .mechanics import CASES

    name, (lhs, rhs, given, truth) = list(CASES.items())[place]
    verdict = prove(lhs, rhs, given=given)
    assert isinstance(verdict, (Holds | HoldsUnder) if truth else Fails), f"{name}: {verdict}"
    recheck(verdict, lhs, rhs, given=given)
