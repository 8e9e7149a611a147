"""What comes out of a statement: how many operations, in what shape, always the same; and what is refused, and why."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from mpmath import fp

from chasles.decisions.session import Decision
from chasles.lowering.arithmetic import Decimals, evaluated
from chasles.lowering.declaration import requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import lower, program_of
from chasles.lowering.program import Op
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Output, composed
from chasles.statements import Claim, Definition, Entry, Kernel, Section, Theorem, rotation, unit
from chasles.verdict import Undecided
from chasles.vocabulary import (
    FREQUENCY,
    Rate,
    cos,
    cross,
    dot,
    inverse,
    number,
    printed,
    rate,
    row,
    scalar,
    sin,
    square,
    vector,
)
from chasles.vocabulary.functions import sign

from ..sampling import WHOLE

# Additions, subtractions, multiplications, divisions and roots; beside them each angle costs one sine and one cosine.
MOST = {
    "rotation_from_axis_angle": 22,
    "normal_matrix_inverse": 16,
    "screw_axis_point": 37,
    "plucker_transfer": 15,
    "velocity_of_point": 15,
    "instant_screw_point": 35,
    "instant_screw": 55,
    "natural_rate_matrix": 24,
    "linear_rate_matrix": 28,
    "euler_rodrigues_rate_matrix": 6,
    "linear_velocity_matrix": 5,
    "pose_rate_natural": 32,
    "twist_transfer": 15,
    "axial_velocity_leaves": 30,
    "squared_spin": 9,
}
CIRCULAR = (Op.SINE, Op.COSINE)


def test_no_more_operations_than_recorded(book, name):
    counts = book.program(name).operations
    assert sum(count for op, count in counts.items() if op not in CIRCULAR) <= MOST[name]
    assert counts[Op.SINE] <= 1
    assert counts[Op.COSINE] <= 1
    assert counts[Op.SQUARE_ROOT] <= 1


def test_symmetric_entries_are_one_step(book):
    entries = book.program("normal_matrix_inverse").results[0].entries
    assert all(entries[3 * i + j] == entries[3 * j + i] for i in range(3) for j in range(i))


def test_blocks_of_zeros_and_ones_cost_nothing(book):
    program = book.program("pose_rate_natural")
    assert program.results[0].shape == (7,)
    moved = [program.steps[entry] for entry in program.results[0].entries[4:]]
    assert [(step.op, step.argument, step.entry) for step in moved] == [(Op.INPUT, 2, k) for k in (3, 4, 5)]
    zeros = {k for k, step in enumerate(program.steps) if step.op is Op.CONSTANT and step.value == 0}
    assert not [step for step in program.steps if step.op in (Op.MULTIPLY, Op.ADD) and zeros & set(step.operands)]


def test_a_root_is_shared(book):
    program = book.program("instant_screw")
    assert program.operations[Op.SQUARE_ROOT] == 1
    assert [(result.name, result.shape) for result in program.results] == [("axis", (6,)), ("pitch", ())]


def test_arguments_and_results_are_named_and_explained(book):
    program = book.program("velocity_of_point")
    assert [(a.name, a.shape) for a in program.arguments] == [
        ("omega", (3,)),
        ("a_dot", (3,)),
        ("a", (3,)),
        ("p", (3,)),
    ]
    assert program.arguments[1].meaning == "time derivative of: position a"
    assert (program.results[0].name, program.results[0].meaning) == ("p_dot", "time derivative of: position p")
    assert [a.name for a in book.program("screw_axis_point").arguments] == ["e", "phi", "a", "a_prime"]


@pytest.mark.slow
@pytest.mark.skipif(not WHOLE, reason="test_cli_emit compares what is emitted: set CHASLES_TEST_WHOLE=1")
def test_the_same_whatever_the_hash_seed(tmp_path):
    script = tmp_path / "print_programs.py"
    here = Path(__file__).parent
    script.write_text(
        "import importlib.util, sys\n"
        f"spec = importlib.util.spec_from_file_location('own', {str(here / 'conftest.py')!r})\n"
        "own = importlib.util.module_from_spec(spec)\n"
        "spec.loader.exec_module(own)\n"
        "book = own.Book()\n"
        "for name in book.statements:\n"
        "    print(book.program(name))\n",
        "utf-8",
    )
    texts = []
    for seed in ("0", "1"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        done = subprocess.run([sys.executable, script], env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        texts.append(done.stdout)
    assert texts[0] == texts[1]
    assert texts[0].count("Program(") == len(MOST)


x, y, phi = scalar("x", "x", "a number"), scalar("y", "y", "another"), scalar("phi", r"\phi", "an angle")
u, w = vector("u", "u", "a vector"), vector("w", "w", "another vector")
M = square("M", "M", "a matrix")
omega = vector("omega", r"\omega", "angular velocity", FREQUENCY)


def refusal(book, sentence, *arguments, **options):
    with pytest.raises(LoweringError) as caught:
        lower(sentence, book.judge.decide, *arguments, **options)
    return str(caught.value)


def test_undecided_is_refused(book):
    claim = Claim("9.1", y, x + 0, kernel=Kernel(of=(x,), name="f"))

    def decide(sentence):
        return Decision(sentence, Undecided("a remainder is left"))

    with pytest.raises(LoweringError, match=r"f: \(9\.1\) is undecided as printed \(a remainder is left\); no"):
        lower(claim, decide)


def test_a_false_claim_is_refused(book):
    claim = Claim("9.2", sin(2 * phi), 2 * sin(phi), kernel=Kernel(of=(phi,), name="f"))
    assert refusal(book, claim) == "f: (9.2) fails as printed; no correction is declared or found"


def test_what_stands_in_for_a_slip_is_lowered(book):
    right = 2 * sin(phi) * cos(phi)
    claim = Claim("9.3", sin(2 * phi), 2 * sin(phi), corrected=right, kernel=Kernel(of=(phi,), name="f"))
    request = requested(claim, book.judge.decide)
    assert request.outputs[0].value == right
    assert program_of(request).operations[Op.COSINE] == 1


def test_a_correction_that_is_wrong_is_refused(book):
    claim = Claim(
        "9.4", sin(2 * phi), 2 * sin(phi), corrected=3 * sin(phi) * cos(phi), kernel=Kernel(of=(phi,), name="f")
    )
    assert refusal(book, claim) == "f: (9.4) fails as printed; its corrected form fails"


def test_a_reading_stands_in_for_what_does_not_fit(book):
    definition = Definition(
        "9.5", M, printed(lambda: row(u, w)), reading=row(u, w, cross(u, w)), kernel=Kernel(of=(u, w), name="f")
    )
    assert lower(definition, book.judge.decide).results[0].shape == (3, 3)


def test_a_false_statement_may_not_be_used(book):
    false = Claim("9.6", y, 2 * x, given=(Definition("9.5", y, x + 0),))
    claim = Definition("9.7", phi, y + 1, given=(false,), kernel=Kernel(of=(x,), name="f"))
    why = "(9.6) fails as printed; no correction is declared or found"
    assert refusal(book, claim) == f"f rests on a statement that is not accepted: {why}"


def test_a_false_statement_that_is_not_needed_does_no_harm(book):
    false = Claim("9.6", y, 2 * x, given=(Definition("9.5", y, x + 0),))
    claim = Definition("9.7", phi, x + 1, given=(false,), kernel=Kernel(of=(x,), name="f"))
    assert lower(claim, book.judge.decide).operations.total() == 1


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        (
            Definition("9.8", y, x * phi, kernel=Kernel(of=(x,), name="f")),
            "f: phi is free: it is not among the arguments (x), and nothing given says what it is",
        ),
        (
            Definition("9.8", rate(y), dot(u, rate(u)), kernel=Kernel(of=(u,), name="f")),
            "f: u_dot is free: it is not among the arguments (u), and nothing given says what it is",
        ),
        (
            Definition("9.8", y, x + 1, kernel=Kernel(of=(x, u), name="f")),
            "f: no result depends on the argument u: leave it out",
        ),
        (
            Definition("9.8", y, x + 1, kernel=Kernel(of=(x,))),
            "the kernel of (9.8) has no name: give it one, or lower a chapter's entry",
        ),
        (Definition("9.8", y, x + 1), "(9.8) asks for no kernel: give it `kernel=Kernel(of=...)`"),
        (
            Definition("9.8", y, dot(u, u), kernel=Kernel(of=(cross(u, u),), name="f")),
            "f: the argument u x u is an expression; it must be a symbol or its rate",
        ),
        (
            Definition("9.8", w, u + u, kernel=Kernel(of=(u,), name="f", results=("s", "t"))),
            "f: 2 results are named, and the right side has 1 blocks",
        ),
        (
            Definition("9.8", w, u + u, kernel=Kernel(of=(u,), name="f", results=("u",))),
            "f: u is an argument and a result: give the result another name in `results`",
        ),
        (
            Definition("9.8", w, u + u, kernel=Kernel(of=(u,), name="not a name")),
            "not a name: 'not a name' cannot be a name in a program: use letters, digits and underscores",
        ),
        (
            Definition("9.8", y, sign(x), kernel=Kernel(of=(x,), name="f")),
            "sign(x) (FunctionOf) has no program: write it out in the formula",
        ),
        (
            Definition("9.8", y, x / (2 - 2 * number(1)), kernel=Kernel(of=(x,), name="f")),
            "a formula divides by an expression that is zero by construction",
        ),
    ],
)
def test_what_no_program_can_be_made_of(book, statement, said):
    assert refusal(book, statement) == said


@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_an_inverse_has_a_program(book, size):
    """Its cofactors over the determinant, which is not zero by hypothesis."""
    of, found = (square(name, name, "a matrix", size=size) for name in "AB")
    statement = Definition("9.8", found, inverse(of + of @ of), kernel=Kernel(of=(of,), name="f"))
    request = requested(statement, book.judge.decide)
    program = program_of(request)
    assert differences(request, program) == ()
    given = np.random.default_rng(size).random(size * size)
    values = evaluated(program.steps, Decimals(fp), lambda _, entry: given[entry])
    matrix = given.reshape(size, size)
    made = np.array([values[number] for number in program.results[0].entries]).reshape(size, size)
    assert np.allclose(made @ (matrix + matrix @ matrix), np.eye(size))


def test_the_inverse_of_a_rotation_is_its_transpose(book):
    statement = Definition("9.8", w, inverse(M) @ u, assuming=(rotation(M),), kernel=Kernel(of=(M, u), name="f"))
    assert Op.DIVIDE not in lower(statement, book.judge.decide).operations


def test_a_definition_in_a_circle_is_refused(book):
    circle = (Definition("9.8", y, x + phi), Definition("9.9", phi, y + 1))
    claim = Definition("9.10", scalar("z", "z", ""), y + 1, given=circle, kernel=Kernel(of=(x,), name="f"))
    assert "f: (9.10) is undecided as printed" in refusal(book, claim)
    with pytest.raises(LoweringError, match="f: y is defined by itself"):
        composed("f", (x,), (Output("z", "", y + 1),), rules={y: x + phi, phi: y + 1})


def test_two_definitions_of_one_symbol_are_refused(book):
    both = (Definition("9.8", y, x + 1), Definition("9.9", y, x + 2))
    claim = Definition("9.10", phi, y + 1, given=both, kernel=Kernel(of=(x,), name="f"))
    assert "is given two statements that say what y is" in refusal(book, claim)


def test_a_theorem_has_no_kernel(book):
    assert "asks for no kernel" in refusal(book, Theorem("Thm 9", "says nothing", ()))


def test_an_entry_gives_its_name(book):
    entry = Entry("shifted", Section("9", "Tests"), Definition("9.8", y, x + 1, kernel=Kernel(of=(x,))))
    assert lower(entry, book.judge.decide).name == "shifted"


def test_an_argument_comes_before_any_definition(book):
    given = (Definition("9.8", y, 2 * x),)
    both = Definition("9.9", phi, y + x, given=given, kernel=Kernel(of=(x, y), name="f"))
    program = lower(both, book.judge.decide)
    assert [argument.name for argument in program.arguments] == ["x", "y"]
    assert program.operations.total() == 1


def test_rates_are_taken_by_their_rules(book):
    spin = Definition("9.8", rate(u), cross(omega, u))
    moving = Definition("9.9", M, x * (u @ u.T))
    asked = Kernel(of=(u, omega, x, rate(x)), name="f")
    turned = Definition(
        "9.10",
        square("W", "W", "", FREQUENCY),
        Rate(M),
        given=(spin, moving),
        kernel=asked,
    )
    program = lower(turned, book.judge.decide)
    assert program.results[0].shape == (3, 3)
    assert differences(requested(turned, book.judge.decide), program) == ()


def test_hypotheses_of_all_that_is_used_come_along(book):
    given = (Definition("9.8", w, 2 * u, assuming=(unit(u),)),)
    claim = Definition("9.9", y, dot(w, w), given=given, kernel=Kernel(of=(u,), name="f"))
    assert [h.text for h in requested(claim, book.judge.decide).hypotheses] == ["|u| = 1"]
