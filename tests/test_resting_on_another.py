"""A chapter that rests on another: it cites its statements, and is decided, reported, derived and emitted like any."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

SECTION = '''\
"""One section."""

from chasles.derivations.notation import B_N, Q, a, a_, d_P, e, one, p, phi
from chasles.derivations.s02_screw import *
from chasles.derivations.s05_acceleration import upper_block_of_natural_rate_matrix_rate
from chasles.statements import Claim, Definition, Kernel, Section, rotation, unit
from chasles.vocabulary import cos, scalar, tr

consequences = Section("3.2", "Consequences")

tau = scalar("tau", r"\\tau", "trace of the rotation")

trace = Definition("2.49", tau, tr(Q), says="The trace.")

trace_of_rotation = Claim(
    "3.1",
    tau, 1 + 2 * cos(phi),
    says="The trace of a rotation.",
    given=(rotation_from_axis_angle, trace),
    assuming=(unit(e),),
)

wrong_trace = Claim(
    "3.2",
    tr(Q), 1 - 2 * cos(phi),
    says="The trace of a rotation, misprinted.",
    given=(rotation_from_axis_angle,),
    assuming=(unit(e),),
)

displacement_of_point = Claim(
    "3.3",
    d_P, a_ + Q @ (p - a) - p,
    says="How far a point is moved.",
    given=(displacement, point_after_displacement),
    kernel=Kernel(of=(Q, a, a_, p), expected=(rotation(Q),)),
)

block_once_more = Claim(
    "3.4",
    B_N @ one, B_N,
    says="Rests on what is misprinted elsewhere.",
    given=(upper_block_of_natural_rate_matrix_rate,),
)
'''
ROAD = """\
from chasles.derivations.s02_screw import displacement, point_after_displacement
from chasles.statements.derivation import Compare, Derivation, Substitute, Take

from ..s1 import displacement_of_point

displacement_by_substitution = Derivation(
    "3.3",
    to=displacement_of_point,
    says="Put in where the point lies.",
    given=(displacement, point_after_displacement),
    steps=(
        Take(displacement),
        Substitute(point_after_displacement),
        Compare(displacement_of_point),
    ),
)
"""


@pytest.fixture(scope="module")
def upper(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that holds the chapter `upper`."""
    here = tmp_path_factory.mktemp("shelf")
    (here / "upper" / "roads").mkdir(parents=True)
    (here / "upper" / "__init__.py").write_text('TITLE = "Consequences"\nSECTIONS = ("s1",)\n', "utf-8")
    (here / "upper" / "s1.py").write_text(SECTION, "utf-8")
    (here / "upper" / "roads" / "__init__.py").write_text('ROADS = ("r1",)\n', "utf-8")
    (here / "upper" / "roads" / "r1.py").write_text(ROAD, "utf-8")
    return here


def run(*words: str, cwd: Path, status: int = 0) -> str:
    command = [sys.executable, "-m", "chasles", "--chapter", "./upper", *words]
    done = subprocess.run(command, cwd=cwd, env=os.environ, capture_output=True, text=True, check=False)
    assert done.returncode == status, f"{done.stdout}\n{done.stderr}"
    assert "Traceback" not in done.stderr
    return done.stdout + done.stderr


def test_only_its_own_statements_are_its_own(upper: Path) -> None:
    listed = json.loads(run("list", "--json", cwd=upper))["statements"]
    assert [record["number"] for record in listed] == ["2.49", "3.1", "3.2", "3.3", "3.4"]


def test_they_are_decided_with_what_the_other_chapter_proved(upper: Path) -> None:
    records = {r["name"]: r for r in json.loads(run("decide", "--json", cwd=upper))["statements"]}
    assert {name: (record["verdict"], record["needs"]) for name, record in records.items()} == {
        "trace": ("defined", []),
        "trace_of_rotation": ("holds-under", ["|e| = 1"]),
        "wrong_trace": ("fails", []),
        "displacement_of_point": ("holds", []),
        "block_once_more": ("holds", []),
    }
    assert records["wrong_trace"]["corrected"]["text"] == "tr(Q) = 1 + 2 cos(phi)"


def test_what_is_cited_says_of_which_chapter_it_is_and_in_which_form_it_is_used(upper: Path) -> None:
    said = " ".join(run("show", "3.1", "3.4", cwd=upper).split())
    assert "(2.49) of chasles.derivations The rotation about" in said
    assert "(2.49) The trace." in said
    assert "(3.96e) of chasles.derivations The block B" in said
    assert "(as repaired)" in said
    [record] = json.loads(run("show", "--json", "3.1", cwd=upper))["statements"]
    own = {"number": "2.49", "part": 1}
    assert record["given"] == [own | {"chapter": "chasles.derivations"}, own]


def test_a_derivation_takes_what_the_other_chapter_states(upper: Path) -> None:
    said = run("derive", "3.3", cwd=upper)
    assert "take (3.3) part 2 of chasles.derivations" in said
    assert "complete" in said


def test_it_is_reported_and_emitted(upper: Path) -> None:
    said = run("report", "--out", "pages", cwd=upper)
    assert "1 of 1 derivations complete" in said
    page = (upper / "pages" / "index.html").read_text("utf-8")
    assert "(2.49) of chasles.derivations: The rotation about" in page
    assert page.count('href="#n-2-49"') < 10
    assert 'href="#n-3-96e"' not in page
    run("emit", cwd=upper)
    found = json.loads(run("verify", "--json", "--samples", "3", cwd=upper))
    assert (found["wrong"], {e["kernel"] for e in found["evidence"]}) == ([], {"displacement_of_point"})


HEAD = """\
from chasles.statements import Claim, Definition, Section
from chasles.vocabulary import scalar
{before}
first_section = Section("1", "First")
x, y = scalar("x", "x", "a number"), scalar("y", "y", "another")
one_thing = Definition("1.1", x, 2 * y)
{after}
"""
MISTAKES = [
    ("", 'again = Claim("1.1", x, 2 * y, given=(one_thing,))', 7, "give the second another `part`"),
    (
        "",
        'again = Claim("1.1", x, 2 * y,\n    given=(one_thing,))',
        7,
        "one_thing and again are both declared as (1.1)",
    ),
    (
        "",
        'hidden = [Definition("1.3", y, x)]\nearly = Claim("1.2", x, 2 * y, given=(hidden[0],))\nlate = hidden[0]',
        8,
        "(1.3), which does not",
    ),
    ("early = Claim('0.1', scalar('z', 'z', 'z'), scalar('z', 'z', 'z'))", "", 3, "is declared before any Section"),
    (
        "",
        'second = Section("2", "S")\nfar = Claim("2.1", x, 2 * y)\nfarther = Claim("2.2", x, 2 * y)\n'
        'beyond = Claim("1.5", x, 2 * y)\nlast = Section("3", "T")\nstray = Claim("2.1", x, 2 * y, part=2)\n'
        'own = Claim("3.1", x, 2 * y)\nowner = Claim("3.2", x, 2 * y)',
        12,
        "has the number (2.1), as in Section 2",
    ),
    ("", 'again = {"one_thing": Claim("1.2", x, 2 * y)}', 7, "are both called one_thing"),
]


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("before", "after", "line", "said"), MISTAKES)
def test_wrong_numbers_are_told_by_file_and_line(tmp_path: Path, before: str, after: str, line: int, said: str) -> None:
    (tmp_path / "upper").mkdir()
    (tmp_path / "upper" / "__init__.py").write_text('SECTIONS = ("s1",)\n', "utf-8")
    (tmp_path / "upper" / "s1.py").write_text(HEAD.format(before=before, after=after), "utf-8")
    told = run("decide", cwd=tmp_path, status=2)
    assert f"{tmp_path}/upper/s1.py, line {line}: " in told
    assert said in told
    assert told.count("\n") == 1
