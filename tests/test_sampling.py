"""A sample is by place, the same each time, of every sweep; the whole leaves nothing out."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from . import sampling
from .sampling import kept_and_left_out, sample


@pytest.mark.parametrize("whole", [False, True])
def test_one_in_so_many_is_taken(whole: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sampling, "WHOLE", whole)
    assert sample("abcdefg", 3) == (list("abcdefg") if whole else ["a", "d", "g"])
    assert sample(iter("abcdefg"), 3, first=1) == (list("abcdefg") if whole else ["b", "e"])
    assert sample({}, 3) == []


def case(name: str, every: int = 0) -> Any:
    """A collected test, marked `sampled(every)` or not."""
    mark = SimpleNamespace(args=(every,)) if every else None
    return SimpleNamespace(nodeid=name, get_closest_marker=lambda name: mark)


@pytest.mark.parametrize("whole", [False, True])
def test_of_what_is_marked_each_so_manieth_case_is_tried(whole: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sampling, "WHOLE", whole)
    plain = [case(f"a.py::test[{k}]") for k in range(4)]
    swept = [case(f"a.py::sweep[{k}]", 3) for k in range(7)]
    alone = case("b.py::sweep", 3)
    kept, left_out = kept_and_left_out([*plain, *swept, alone])
    assert kept == [*plain, *(swept if whole else swept[::3]), alone]
    assert len(kept) + len(left_out) == 12
