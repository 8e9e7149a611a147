"""The project is extended for real, in a copy: each addition in the files that it needs, and no other one changes."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
pytestmark = pytest.mark.skipif(not (ROOT / "pyproject.toml").exists(), reason="needs the checkout")


class Copy:
    """A copy of the project that Python imports instead of the installed one."""

    def __init__(self, folder: Path) -> None:
        self.site = folder
        skipped = shutil.ignore_patterns("*.so")
        shutil.copytree(ROOT / "src" / "chasles", folder / "chasles", ignore=skipped)
        for part in ("derivations", "generated"):
            shutil.copytree(ROOT / part, folder / "chasles" / part, ignore=skipped)
        self.before = self._files()

    def _files(self) -> dict[str, str]:
        files = (path for path in self.site.rglob("*") if path.suffix in (".py", ".jinja"))
        return {path.relative_to(self.site / "chasles").as_posix(): path.read_text("utf-8") for path in files}

    @property
    def touched(self) -> list[str]:
        """The files that are new or changed."""
        return sorted(name for name, text in self._files().items() if self.before.get(name) != text)

    def add(self, name: str, text: str) -> None:
        path = self.site / "chasles" / name
        path.parent.mkdir(exist_ok=True)
        path.write_text((path.read_text("utf-8") if path.exists() else "") + text, "utf-8")

    def edit(self, name: str, old: str, new: str) -> None:
        path = self.site / "chasles" / name
        text = path.read_text("utf-8")
        assert text.count(old) == 1
        path.write_text(text.replace(old, new), "utf-8")

    def run(self, code: str, status: int = 0) -> str:
        """What a program prints, or complains of. The installed project is not seen: nothing of `site` is loaded."""
        first = f"import sys; sys.path[:0] = {[str(self.site), sysconfig.get_path('purelib')]!r}\n"
        done = subprocess.run([sys.executable, "-S", "-c", first + code], capture_output=True, text=True, check=False)
        assert done.returncode == status, done.stderr
        return done.stderr if status else done.stdout

    def chasles(self, *words: str, status: int = 0) -> str:
        """What a command prints, or complains of."""
        return self.run(f"from chasles.cli import main; sys.argv[1:] = {list(words)!r}; sys.exit(main())", status)


@pytest.fixture
def copy(tmp_path: Path) -> Copy:
    return Copy(tmp_path)


EQUATION = """
square_of_axis = Claim(
    "text 3.2.3 z",
    CPM(e) @ CPM(e), e @ e.T - one,
    says="The square of the cross-product matrix of a unit vector.",
    assuming=(unit(e),),
    kernel=Kernel(of=(e,)),
)
"""


def test_an_equation_is_one_file(copy: Copy) -> None:
    copy.add("derivations/s02_screw.py", EQUATION)
    assert copy.touched == ["derivations/s02_screw.py"]
    (said,) = json.loads(copy.chasles("decide", "text 3.2.3 z", "--json"))["statements"]
    assert (said["verdict"], said["needs"]) == ("holds-under", ["|e| = 1"])


WORD = '''"""Symmetric parts of matrices."""

from typing import ClassVar

from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.fitting import word
from chasles.vocabulary.nodes import Node


@word
class SymmetricPart(Shorthand):
    """The symmetric part of a square matrix."""

    of: Node
    function: ClassVar[str] = "sym"

    @property
    def definition(self) -> Node:
        return (self.of + self.of.T) / 2
'''
USE_OF_WORD = """
from chasles.decisions.session import Session
from chasles.checker.certificate import check
from chasles.lowering.lower import lower
from chasles.numerics.reference import evaluate
from chasles.statements import Claim, Definition, Kernel
from chasles.statements.posing import problem_of
from chasles.vocabulary import latex, plain, square, tr, Rate
from chasles.vocabulary.symmetric_part import SymmetricPart

M, S = square("M", "M", "a matrix"), square("S", "S", "its symmetric part")
print(plain(SymmetricPart(M)), latex(SymmetricPart(M)))
session = Session()
right = Claim("1", tr(SymmetricPart(M)), tr(M))
verdict = session.decide(right).verdict
print(verdict.name)
check(right, "printed", verdict.certificate)
print(session.decide(Claim("2", Rate(SymmetricPart(M)), SymmetricPart(Rate(M)))).verdict.name)
print(session.decide(Claim("3", SymmetricPart(M), M)).verdict.name)
made = Definition("4", S, SymmetricPart(M), kernel=Kernel(of=(M,), name="symmetric_part"))
print(*sorted(op.value for op in lower(made, session.decide).operations))
print(evaluate(SymmetricPart(M), {M: [[0, 1, 2], [3, 4, 5], [6, 7, 8]]})[0])
"""


def test_a_word_is_one_file(copy: Copy) -> None:
    """Printed, decided, checked, differentiated, refuted, lowered and evaluated to 50 digits by its definition."""
    copy.add("vocabulary/symmetric_part.py", WORD)
    assert copy.touched == ["vocabulary/symmetric_part.py"]
    printed = copy.run(USE_OF_WORD).splitlines()
    assert printed[0] == r"sym(M) \text{sym}\left( \mathbf{M} \right)"
    assert printed[1:4] == ["holds", "holds", "fails"]
    assert printed[4] == "add multiply"
    assert printed[5] == "[mpf('0.0'), mpf('2.0'), mpf('4.0')]"


PASS = '''"""Operands of additions change places."""

from dataclasses import replace

from chasles.lowering.program import Op, Program


def swapped(program: Program) -> Program:
    """The same program, each sum with its operands the other way round."""
    steps = (replace(s, operands=s.operands[::-1]) if s.op is Op.ADD else s for s in program.steps)
    return replace(program, steps=tuple(steps))
'''
USE_OF_PASS = """
from chasles import load
from chasles.decisions.session import Session
from chasles.lowering.declaration import requested
from chasles.lowering.lower import program_of
from chasles.lowering.passes import swapped as module
from chasles.lowering.program import Op
import chasles.lowering.lower as lowering

book = load()
[entry] = book.select(["velocity_of_point"])
request = requested(entry, Session(book=book).decide, entry.kernels[0])
program, before = program_of(request), lowering.LAST
lowering.LAST = tuple(each for each in before if each is not module.swapped)
print(program != program_of(request), program == module.swapped(program_of(request)))
"""


def test_a_pass_is_one_file_and_its_place_in_the_list(copy: Copy) -> None:
    copy.add("lowering/passes/swapped.py", PASS)
    copy.edit("lowering/lower.py", "= (guarded,)", "= (guarded, swapped)")
    copy.edit("lowering/lower.py", "\nLAST: ", "from chasles.lowering.passes.swapped import swapped\n\nLAST: ")
    assert copy.touched == ["lowering/lower.py", "lowering/passes/swapped.py"]
    assert copy.run(USE_OF_PASS) == "True True\n"


def test_a_target_is_one_folder(copy: Copy) -> None:
    from .test_toy_target import LANGUAGE, TEMPLATE

    copy.add("targets/julia/__init__.py", LANGUAGE)
    copy.add("targets/julia/Chasles.jl.jinja", TEMPLATE)
    assert copy.touched == ["targets/julia/Chasles.jl.jinja", "targets/julia/__init__.py"]
    assert (
        "julia" in copy.run("from chasles.targets import discover; print(*(each.name for each in discover()))").split()
    )


EXERCISE = '''"""Exercise 3.99: the trace of a matrix."""

from chasles.exercises.draw import Draw
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim
from chasles.statements.exercise import Answer, Datum, Exercise, Scalar, matrix_shape
from chasles.vocabulary import square, tr

A = square("A", "A", "a matrix")
trace_of_transpose = Claim("Ex 3.99", tr(A.T), tr(A), says="A matrix and its transpose have the same trace.")


def solve(sheet: Worksheet) -> str:
    """The trace of the transpose."""
    sheet.state(trace_of_transpose)
    sheet.answer(trace=sheet.value(tr(A.T), {A: sheet["A"]}))
    return "ok"


def instance(draw: Draw) -> dict[str, object]:
    """Any matrix."""
    return {"A": [[draw.integer(-5, 5) for _ in range(3)] for _ in range(3)]}


exercise = Exercise(
    "3.99",
    "The trace of a matrix",
    asked=("Find the trace of the transpose.",),
    data=(Datum("A", matrix_shape(), [[1, 2, 3], [4, 5, 6], [7, 8, 9]], "a matrix"),),
    assumptions=(),
    solve=solve,
    instance=instance,
    answers=(Answer("trace", Scalar(), "its trace"),),
)
'''


def test_an_exercise_is_one_file(copy: Copy) -> None:
    copy.add("derivations/exercises/x3_99.py", EXERCISE)
    assert copy.touched == ["derivations/exercises/x3_99.py"]
    assert "15" in copy.chasles("solve", "3.99")
    assert "The trace of a matrix" in copy.chasles("practice", "3.99")


def test_an_exercise_that_ends_otherwise_than_it_declares_is_named(copy: Copy) -> None:
    copy.add("derivations/exercises/x3_99.py", EXERCISE.replace('return "ok"', 'return "done"'))
    said = copy.chasles("solve", "3.99", status=2)
    assert said == "chasles: `solve` of exercise 3.99 returns 'done', and must return 'ok'\n"


USE_OF_RULE = """
import sympy
from chasles import prove
from chasles.from_sympy.readings import versine
from chasles.prove import recheck

x = sympy.Symbol("x", real=True)
for left, right in ((versine(x) * (1 + sympy.cos(x)), sympy.sin(x) ** 2), (versine(x), sympy.sin(x))):
    verdict = prove(left, right)
    recheck(verdict, left, right)
    print(verdict.name)
"""


def test_a_rule_of_decision_is_two_files(copy: Copy) -> None:
    """What a function means is said to the prover and, apart from that, to the checker."""
    copy.edit(
        "checker/expressions/readings.py",
        "\n\nREADINGS: ",
        "\n\nclass versine(sympy.Function):\n    pass\n\n\nREADINGS: ",
    )
    copy.edit(
        "checker/expressions/readings.py",
        "    sympy.Add: ",
        "    versine: lambda reading, e: ONE - reading(sympy.cos(e.args[0])),\n    sympy.Add: ",
    )
    copy.edit(
        "from_sympy/readings.py",
        "{**ARITHMETIC, **OF_ANGLES}",
        "{**ARITHMETIC, **OF_ANGLES, versine: lambda reader, e: reader(1 - sympy.cos(e.args[0]))}",
    )
    copy.edit(
        "from_sympy/readings.py",
        "\nREADINGS: ",
        "import sympy\nfrom chasles.checker.expressions.readings import versine\n\nREADINGS: ",
    )
    assert copy.touched == ["checker/expressions/readings.py", "from_sympy/readings.py"]
    assert copy.run(USE_OF_RULE).split() == ["holds", "fails"]


def test_what_is_appended_to_the_wrong_section_is_refused(copy: Copy) -> None:
    copy.add("derivations/s02_screw.py", EQUATION.replace("text 3.2.3 z", "3.18z"))
    said = copy.chasles("decide", "3.18z", status=2)
    assert "square_of_axis has the number (3.18z), as in Section 3.2.1, and is declared in Section 3.2.3" in said
