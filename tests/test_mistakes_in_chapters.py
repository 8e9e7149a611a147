"""Mistakes in a chapter: one line with the declaration's file and line, and an exit status that is not zero."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from chasles.cli import main

HEAD = """\
from chasles.statements import Claim, Condition, Definition, Kernel, Section, nonzero, unit
from chasles.statements.matrices import with_sizes
from chasles.vocabulary import *
s = Section("1", "S")
x, v, a = vector("x", "x", "x", LENGTH), vector("v", "v", "v", VELOCITY), scalar("a", "a", "a")
A, t = square("A", "A", "A"), scalar("t", "t", "t", TIME)
known = Definition("1.1", v, a * rate(x))
"""
GIVEN = [
    ('Claim("1.2", x, x, given=("1.1",))', "part 1 of `given` is '1.1', and must be a Statement"),
    ('Claim("1.2", x, x, given=known)', "`given` is a Definition, and must be a tuple"),
    ('Claim("1.2", x, x, given=[known])', "write a tuple, in round brackets"),
    ('Claim("1.2", x, x, given=(knwn,))', "name 'knwn' is not defined"),
    ('Claim("1.2", x, x, given=(s,))', "part 1 of `given` is a Section"),
    ('Claim("1.2", x, x, given=(known, x))', "part 2 of `given` is the expression x"),
    ('Claim("1.2", x, x, given=((known,),))', "part 1 of `given` is a tuple (a Definition)"),
    ('Claim("1.2", x, x, given=(Definition,))', "Definition itself"),
    ('Claim("1.2", x, x, assuming=(a,))', "part 1 of `assuming` is the expression a, and must be a Hypothesis"),
    ('Claim("1.2", x, x, assuming=(nonzero,))', "call it, as nonzero(…)"),
]
FIT = [
    ('Claim("1.2", x + a, x)', "cannot add x (3 x 1) and a (a scalar) (if the book prints it so, write printed(lambda"),
    ('Claim("1.2", x, a)', "cannot equate x (3 x 1) and a (a scalar). If the book prints it so, say `sic=True`"),
    ('Claim("1.2", x @ x, a)', "cannot multiply x (3 x 1) by x (3 x 1)"),
    ('Claim("1.2", x + v, x)', "cannot add x [m] and v [m s^-1]"),
    ('Claim("1.2", x + v, x, sic=True)', "cannot add x [m] and v [m s^-1]"),
    ('Claim("1.2", x, v)', "cannot equate x [m] and v [m s^-1]"),
    ('Claim("1.2", cos(x), a)', "cos takes an angle in radians, and x is not one"),
    ('Claim("1.2", sin(t), a)', "sin takes an angle in radians, and t is not one"),
    ('Claim("1.2", printed(lambda: x + v), x)', "(1.2) does not fit: cannot add x [m] and v [m s^-1]"),
    ('Claim("1.2", x + printed(lambda: x + v), x)', "(1.2) does not fit: cannot add x [m] and v [m s^-1]"),
    ('Claim("1.2", A @ (x + printed(lambda: x + v)), x)', "(1.2) does not fit: cannot add x [m] and v [m s^-1]"),
    ('Claim("1.2", 0.5 * x, x)', "expected an expression, an integer or a Fraction, got 0.5"),
    ('Claim("1.2", 0.5 * x, x)', "got 0.5: write Fraction(1, 2)"),
    ('Claim("1.2", a**a, a)', "the exponent of a is a; it must be a whole number"),
    ('Claim("1.2", a, a, assuming=(a > 0,))', "write inequality(a > 0), of chasles.statements.inequalities"),
    ('Claim("1.2", a, a, given=("1.1",))', "write the Python name of the statement, without quotes"),
    ('Claim("1.2", a > 0, a)', "`left` is a Relation, and must be an expression: write *says_that(a > 0), of"),
    ('Claim("1.2", __import__("math").sin(a), a)', "a is no number: functions of it are those of chasles.vocabulary"),
    ('Claim("1.2", __import__("numpy").ones(3) + x, x)', "expected an expression, an integer or a Fraction"),
    ('Claim("1.2", x + 1, x)', "cannot add x (3 x 1) and 1 (a scalar)"),
    ('Claim("1.2", x[4], x[1])', "has no row 4"),
    ('with_sizes(x, {"n": 2})', "`statement` is the expression x, and must be a Statement"),
    ('vector("w", "w", "w", "m")', "`dimension` is 'm', and must be a Dimension"),
    ('Claim("1.2", x, x, kernel=Kernel(of=x))', "`of` is the expression x, and must be a tuple"),
    ('Claim("1.2", x, x', "'(' was never closed"),
]
LOST = [
    ('one = Claim("1.2", x, x)\none = Claim("1.3", v, v)', "line 9: one is what line 8 declares already"),
    ('one = Claim("1.2", a, 2 * a, sign="<")', "printed with <: say *says_that(left < right)"),
    ('one = Condition("1.2", x, v * t, on=(A,))', "is posed on A, which does not occur in it"),
    (
        'one = Claim("1.2", A @ v, A @ v, restates=known, by=x)',
        "does not restate what it says it does: cannot mul",
    ),
    ('one = Claim("1.2", x, x, restates=known)', "does not restate what it says it does: cannot equate"),
    (
        'one = Definition("1.2", a, a + 1)',
        "one (1.2) defines a by itself: state it as a Condition on what it determines",
    ),
    (
        'y = vector("x", "y", "y", LENGTH)\none = Claim("1.2", x + y, x)',
        "two different quantities that are both named 'x_1'",
    ),
    (
        'y = scalar("x_1", "y", "y", LENGTH)\none = Claim("1.2", x.x, y)',
        "two different quantities that are both named 'x_1'",
    ),
    ('one = Claim("1.2", x, x)\nother = Section("1", "T")\ntwo = Claim("1.3", v, v)', "1 is called 'S' and 'T'"),
]
WHEN_EMITTED = [
    ('Claim("1.2", x, x, kernel=Kernel(of=(a,)))', "x is free: it is not among the arguments (a)"),
    ('Definition("1.2", a, tr(A), kernel=Kernel(of=(A,), form=2 * tr(A)))', "the offered form is not equal to (1.2)"),
]
FREE_STILL = 'before = Condition("1.0", A @ x, A @ x, on=(x,), solution=x)\n'


@pytest.fixture
def told(tmp_path: Path):
    """What a command says of a chapter with this declaration, and with what exit status."""
    name = re.sub(r"\W", "_", f"of_{tmp_path.name}")

    def says(declaration: str, command: str) -> tuple[str, int]:
        folder = tmp_path / name
        folder.mkdir()
        (folder / "__init__.py").write_text('SECTIONS = ("s1",)\n', "utf-8")
        (folder / "s1.py").write_text(f"{HEAD}{declaration}\n", "utf-8")
        done = CliRunner().invoke(main, ["--chapter", str(folder), command], prog_name="chasles")
        return done.stderr.replace(str(folder), "CHAPTER"), done.exit_code

    path = list(sys.path)
    yield says
    sys.path[:] = path
    for module in [module for module in sys.modules if module.split(".")[0] == name]:
        del sys.modules[module]


@pytest.mark.parametrize(("declaration", "said"), GIVEN + FIT)
@pytest.mark.parametrize("command", ["decide", "list"])
def test_what_does_not_fit_is_told_by_file_and_line(told, declaration: str, said: str, command: str) -> None:
    text, status = told(f"made = {declaration}", command)
    assert text.startswith("chasles: CHAPTER/s1.py, line 8: ")
    assert said in text
    assert (text.count("\n"), status) == (1, 2)


@pytest.mark.parametrize(("declarations", "said"), LOST)
def test_what_would_be_lost_or_has_two_titles_is_told(told, declarations: str, said: str) -> None:
    text, status = told(declarations, "list")
    assert text.startswith("chasles: CHAPTER/s1.py, line ")
    assert said in text
    assert (text.count("\n"), status) == (1, 2)


@pytest.mark.parametrize(
    "part", ["x + a", "x + v", "x @ x", "cos(t)", "A @ (v + x)", "0.5 * x", "x[4]", "column(x, A)"]
)
def test_the_line_is_that_of_the_part_that_does_not_fit(told, part: str) -> None:
    text, status = told(f'made = Claim(\n    "1.2",\n    x,\n    2 * x\n    + ({part}),\n)', "decide")
    assert text.startswith("chasles: CHAPTER/s1.py, line 12: ")
    assert status == 2


@pytest.mark.parametrize(("declaration", "said"), WHEN_EMITTED)
def test_a_kernel_that_is_refused_is_told_by_file_and_line(told, declaration: str, said: str) -> None:
    text, status = told(f"made = {declaration}", "emit")
    assert "refused: CHAPTER/s1.py, line 8: made: " in text
    assert said in text
    assert (text.count("\n"), status) == (1, 1)


def test_derivations_that_are_not_listed_are_told(told, tmp_path: Path) -> None:
    text, status = told("", "list")
    assert (text, status) == ("", 0)
    (folder,) = tmp_path.iterdir()
    (folder / "roads").mkdir()
    done = CliRunner().invoke(main, ["--chapter", str(folder), "derive"], prog_name="chasles")
    assert "roads lists no modules: give its __init__.py ROADS" in done.stderr
    assert (done.stderr.count("\n"), done.exit_code) == (1, 2)


@pytest.mark.parametrize("given", ["(before,)", "(known, before)"])
def test_what_cannot_be_given_leaves_undecided_where(told, given: str) -> None:
    text, status = told(f'{FREE_STILL}made = Claim("1.2",\n    x, x, given={given})', "decide")
    assert (text, status) == ("chasles: undecided: (1.2) (CHAPTER/s1.py, line 9)\n", 1)
