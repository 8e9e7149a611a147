"""How much has to be trusted: the lines of all modules that are loaded with the checker."""

from __future__ import annotations

import subprocess
import sys

import pytest

from chasles.report.closure import CHECKERS, closure, lines

MOST = {"declared": 6_189, "prove": 5_392, "all": 15_364}
"""It may become less."""


@pytest.mark.parametrize("checker", CHECKERS)
def test_what_is_counted_is_what_is_loaded(checker: str) -> None:
    code = (
        f"import sys, {', '.join(CHECKERS[checker])}\nprint(*(m for m in sys.modules if m.split('.')[0] == 'chasles'))"
    )
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert set(closure(*CHECKERS[checker])) == set(loaded)


@pytest.mark.parametrize("checker", CHECKERS)
def test_the_checker_and_all_that_it_loads_do_not_grow(checker: str) -> None:
    assert lines(checker) <= MOST[checker]


@pytest.mark.parametrize("checker", CHECKERS)
def test_nothing_of_the_prover_is_loaded(checker: str) -> None:
    rooms = {name.split(".")[1] for name in closure(*CHECKERS[checker]) if "." in name}
    assert rooms <= {"display", "vocabulary", "statements", "verdict", "checker"}
