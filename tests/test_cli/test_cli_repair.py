"""`chasles repair`: the nearest true equations, for people and for programs."""

from __future__ import annotations

import json

from chasles.statements import Claim, Definition
from chasles.vocabulary import cross, dot, norm, vector

a, b, c = (vector(name, name, name) for name in "abc")


def test_what_does_not_stand_is_repaired(run) -> None:
    done = run("repair", "--json")
    assert done.exit_code == 0
    found = json.loads(done.stdout)["statements"]
    assert len(found) >= 12
    for statement in found:
        assert statement["verdict"] in ("fails", "ill-formed")
        assert statement["repairs"], statement["number"]
        for repair in statement["repairs"]:
            assert repair["changes"]
            assert repair["verdict"] in ("holds", "holds-under")


def test_each_change_is_said(run) -> None:
    page = run("repair", "3.57/1", "--latex").stdout
    assert page.startswith("(3.57)  ⊘ ill-formed\n")
    assert "repair   a_dot_par = [a_dot . (omega / |omega|^2)] omega\n" in page
    assert "change   the vector factor omega is added\n" in page
    assert "then     it holds under omega != 0\n" in page
    assert page.count("LaTeX") == 2
    assert "freedom  (3.77a) says the same of" in run("repair", "3.97b").stdout
    assert "then     (3.77a), (3.80a), text 3.5 g, text 3.5 i hold" in run("repair", "3.77c").stdout


def test_what_stands_and_what_cannot_be_repaired_is_said(run, chapter_is) -> None:
    chapter_is(
        product=Definition("9.1", c, cross(a, b)),
        right=Claim("9.2", cross(a, b), -cross(b, a), says="Turned."),
        far=Claim("9.3", dot(a, b), norm(a) * norm(b), says="Far from it."),
    )
    assert "repair   it is right as printed\n" in run("repair", "9.2").stdout
    assert "repair   nothing was found\n" in run("repair").stdout
    assert "(9.2)" not in run("repair").stdout
    assert run("repair", "9.9").exit_code == 2
