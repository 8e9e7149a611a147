"""The hash of a declaration: the same in every process, another for every other declaration."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace

import pytest

from chasles.statements import Claim, Definition, Kernel, Theorem, load, nonzero, unit
from chasles.statements.fingerprint import fingerprint
from chasles.vocabulary import cross, dot, scalar, vector

a, b, c = (vector(name, name, "a vector") for name in "abc")
x, y = (scalar(name, name, "a number") for name in "xy")
defined = Definition("9.1", c, cross(a, b), says="A product.")
claim = Claim("9.2", dot(a, c), 0 * x, says="It is normal to a.", given=(defined,), assuming=(unit(a),))

OTHERS = [
    replace(claim, number="9.3"),
    replace(claim, part=2),
    replace(claim, left=dot(b, c)),
    replace(claim, left=dot(c, a)),
    replace(claim, right=0 * y),
    replace(claim, right=-(0 * x)),
    replace(claim, assuming=()),
    replace(claim, assuming=(unit(b),)),
    replace(claim, assuming=(unit(a), nonzero(x))),
    replace(claim, given=()),
    replace(claim, given=(replace(defined, right=cross(b, a)),)),
    replace(claim, corrected=0 * y),
    replace(claim, reading=0 * y),
    replace(claim, kernel=Kernel(of=(a, b))),
]


def test_prose_does_not_matter() -> None:
    spoken = replace(claim, says="The same, said otherwise.", given=(replace(defined, says="The vector product."),))
    assert fingerprint(spoken) == fingerprint(claim)
    meant = vector("a", "a", "another meaning")
    assert fingerprint(Definition("9.1", c, cross(meant, b))) == fingerprint(defined)


@pytest.mark.parametrize("other", OTHERS, ids=range(len(OTHERS)))
def test_everything_else_does(other: Claim) -> None:
    assert fingerprint(other) != fingerprint(claim)


def test_all_statements_of_the_book_differ() -> None:
    entries = load().entries
    assert any(isinstance(entry.statement, Theorem) for entry in entries)
    assert len({fingerprint(entry.statement) for entry in entries}) == len(entries)


def test_it_is_the_same_in_every_process() -> None:
    code = (
        "from chasles.statements import load; from chasles.statements.fingerprint import fingerprint\n"
        "print(*(fingerprint(entry.statement) for entry in load().entries))"
    )
    printed = [
        subprocess.run(
            [sys.executable, "-c", code], env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, check=True
        ).stdout
        for seed in ("1", "2")
    ]
    assert printed[0] == printed[1]
    assert len(printed[0].split()) == len(load().entries)
