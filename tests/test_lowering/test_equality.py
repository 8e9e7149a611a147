"""Every program is proved equal to its statement, and a program with one wrong step is not."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from chasles.lowering.cases import Case, Choice, Comparison
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import program_of
from chasles.lowering.passes.guard import guarded
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Argument, Op, Program, Result, Step
from chasles.lowering.request import Output, composed
from chasles.vocabulary import Zero, cos, norm, scalar, sin, vector

from ..programs import shared
from ..sampling import sample

SLIPS = {
    Op.ADD: Op.SUBTRACT,
    Op.SUBTRACT: Op.ADD,
    Op.MULTIPLY: Op.ADD,
    Op.DIVIDE: Op.MULTIPLY,
    Op.SINE: Op.COSINE,
    Op.COSINE: Op.SINE,
}


def mutants(program):
    """The program with one step changed: another operation, another constant, another entry of an argument."""
    for number, step in enumerate(program.steps):
        if step.op in SLIPS:
            yield number, replace(step, op=SLIPS[step.op])
        if step.op is Op.CONSTANT and step.value:
            yield number, replace(step, value=step.value + 1)
        if step.op is Op.INPUT and program.arguments[step.argument].shape:
            yield number, replace(step, entry=(step.entry + 1) % 3)
        if step.op is Op.NEGATE:
            yield number, Step(Op.ADD, (step.operands[0], 0))


def changed(program, number, step):
    return replace(program, steps=(*program.steps[:number], step, *program.steps[number + 1 :]))


def test_program_is_its_statement(book, name):
    request, program = book.request(name), book.program(name)
    assert differences(request, program) == ()
    assert differences(request, pruned(shared(program))) == ()


def test_one_wrong_step_is_found(book, name):
    request, program = book.request(name), book.program(name)
    tried = sample(list(mutants(program)), 3)
    assert len(tried) > 3
    survivors = [(n, step) for n, step in tried if not differences(request, changed(program, n, step))]
    assert survivors == []


def test_results_in_another_order_are_found(book, name):
    program = book.program(name)
    result = program.results[0]
    turned = replace(result, entries=(*result.entries[1:], result.entries[0]))
    assert differences(book.request(name), replace(program, results=(turned, *program.results[1:])))


def test_other_results_are_found(book):
    request, program = book.request("instant_screw"), book.program("instant_screw")
    assert differences(request, replace(program, results=program.results[:1])) == (
        "its results are [('axis', 6)], and [('axis', 6), ('pitch', 1)] were asked for",
    )


x, y = scalar("x", "x", "a number"), scalar("y", "y", "another")
phi, alpha = scalar("phi", r"\phi", "an angle"), scalar("alpha", r"\alpha", "another angle")
w = vector("w", "w", "a vector")


def program(arguments, *steps):
    """The value of the last step, as a program of the arguments."""
    names = tuple(Argument(name, shape, "") for name, shape in arguments.items())
    return Program("made", names, steps, (Result("z", (), "", (len(steps) - 1,)),))


def request(of, value, **rest):
    return composed("made", of, (Output("z", "", value),), **rest)


def test_other_angles_are_read_by_their_sum():
    wanted = request((phi, alpha), cos(phi + alpha))
    made = program(
        {"phi": (), "alpha": ()},
        Step(Op.INPUT, argument=0),
        Step(Op.INPUT, argument=1),
        *(Step(op, (k,)) for op in (Op.COSINE, Op.SINE) for k in (0, 1)),
        Step(Op.MULTIPLY, (2, 3)),
        Step(Op.MULTIPLY, (4, 5)),
        Step(Op.SUBTRACT, (6, 7)),
    )
    assert differences(wanted, made) == ()


def half_angle(*, sine_below):
    """cot(phi/2), or tan(phi/2)."""
    return program(
        {"phi": ()},
        Step(Op.INPUT),
        Step(Op.CONSTANT, value=Fraction(1, 2)),
        Step(Op.MULTIPLY, (0, 1)),
        Step(Op.COSINE, (2,)),
        Step(Op.SINE, (2,)),
        Step(Op.DIVIDE, (3, 4) if sine_below else (4, 3)),
    )


def test_a_half_angle_form_is_equal_where_it_divides_by_no_more():
    assert differences(request((phi,), sin(phi) / (1 - cos(phi))), half_angle(sine_below=True)) == ()
    assert differences(request((phi,), sin(phi) / (1 + cos(phi))), half_angle(sine_below=False)) == ()


def test_a_division_by_what_the_formula_does_not_divide_by_is_found():
    # sin(phi) = 2 cot(phi/2) / (1 + cot(phi/2)^2) has no value at phi = 0.
    made = program(
        {"phi": ()},
        *half_angle(sine_below=True).steps,
        Step(Op.MULTIPLY, (5, 5)),
        Step(Op.CONSTANT, value=Fraction(1)),
        Step(Op.ADD, (6, 7)),
        Step(Op.ADD, (5, 5)),
        Step(Op.DIVIDE, (9, 8)),
    )
    assert differences(request((phi,), sin(phi)), made) == (
        "step 5 divides by what can be zero where the formula has a value",
    )


def test_a_root_that_is_no_norm_is_not_believed():
    made = program({"x": ()}, Step(Op.INPUT), Step(Op.SQUARE_ROOT, (0,)), Step(Op.MULTIPLY, (1, 1)))
    assert differences(request((x,), x + 0), made) == ("step 1 takes a root that is no norm of the formula",)


def test_a_root_of_something_else_is_found():
    steps = (Step(Op.INPUT), Step(Op.INPUT, entry=1), Step(Op.MULTIPLY, (0, 1)), Step(Op.SQUARE_ROOT, (2,)))
    said = ("step 3 takes a root that is no norm of the formula",)
    assert differences(request((w,), norm(w) + 0), program({"w": (3,)}, *steps)) == said


def test_a_guard_is_seen_through():
    wanted = request((x, w), x / norm(w))
    bare = program(
        {"x": (), "w": (3,)},
        *(Step(Op.INPUT, argument=1, entry=k) for k in range(3)),
        *(Step(Op.MULTIPLY, (k, k)) for k in range(3)),
        Step(Op.ADD, (3, 4)),
        Step(Op.ADD, (5, 6)),
        Step(Op.SQUARE_ROOT, (7,)),
        Step(Op.INPUT),
        Step(Op.DIVIDE, (9, 8)),
    )
    assert differences(wanted, bare) == ()
    assert differences(wanted, guarded(bare)) == ()


def absolute(*cases):
    return request((x,), y + 0, choices=(Choice((y,), cases),))


BELOW = Comparison("less", x, Zero(1, 1))
MAGNITUDE = absolute(Case((BELOW,), (-x,)), Case((), (x,)))
SELECTED = (
    Step(Op.INPUT),
    Step(Op.CONSTANT),
    Step(Op.LESS, (0, 1)),
    Step(Op.NEGATE, (0,)),
    Step(Op.SELECT, (2, 3, 0)),
)


def test_a_selection_is_compared_on_both_ways():
    assert differences(MAGNITUDE, program({"x": ()}, *SELECTED)) == ()
    assert not differences(MAGNITUDE, program_of(MAGNITUDE))
    assert differences(MAGNITUDE, program({"x": ()}, *SELECTED[:4], Step(Op.SELECT, (2, 0, 3))))
    assert differences(MAGNITUDE, program({"x": ()}, *SELECTED[:4]))


def test_the_same_selection_by_the_opposite_comparison_is_equal():
    steps = (*SELECTED[:2], Step(Op.LESS, (1, 0)), SELECTED[3], Step(Op.SELECT, (2, 0, 3)))
    assert differences(MAGNITUDE, program({"x": ()}, *steps)) == ()


def test_zero_is_not_less_than_zero():
    is_negative = absolute(Case((BELOW,), (Zero(1, 1),)), Case((), (x,)))
    steps = (
        Step(Op.INPUT),
        Step(Op.CONSTANT),
        Step(Op.LESS, (0, 1)),
        Step(Op.EQUAL, (0, 1)),
        Step(Op.CONSTANT, value=Fraction(1)),
        Step(Op.ADD, (0, 4)),
        Step(Op.SELECT, (2, 1, 0)),
    )
    one_at_zero = (*steps, Step(Op.SELECT, (3, 5, 6)))
    assert differences(is_negative, program({"x": ()}, *steps)) == ()
    assert differences(is_negative, program({"x": ()}, *one_at_zero)) == (
        "z, entry 1, 1: it is not what the formula says",
    )
    shifted = absolute(Case((BELOW,), (Zero(1, 1),)), Case((), (x + 1,)))
    never_below = (*steps[:6], Step(Op.SELECT, (2, 1, 5)), Step(Op.SELECT, (3, 5, 6)))
    assert differences(shifted, program({"x": ()}, *never_below)) == ()


def test_what_no_case_covers_is_not_a_number():
    partial = absolute(Case((BELOW,), (-x,)))
    nowhere = (*SELECTED[:4], Step(Op.NOT_A_NUMBER), Step(Op.SELECT, (2, 3, 4)))
    assert differences(partial, program({"x": ()}, *nowhere)) == ()
    assert differences(partial, program({"x": ()}, *SELECTED)) == (
        "z, entry 1, 1: it has no value where the formula has one, or the other way round",
    )


@pytest.mark.parametrize("backend", ["sympy"])
def test_without_flint(backend, tmp_path):
    import os
    import subprocess
    import sys

    script = (
        "from chasles.algebra.rings import backend; from chasles.vocabulary import *; assert backend() == 'sympy'\n"
        "from chasles.lowering.request import Output, composed; from chasles.lowering.lower import program_of\n"
        "from chasles.lowering.equivalence.requests import differences\n"
        "v = vector('v', 'v', 'v'); r = composed('f', (v,), (Output('z', '', CPM(v) @ CPM(v) @ v / norm(v)),))\n"
        "assert differences(r, program_of(r)) == ()\n"
        "s = composed('f', (v,), (Output('z', '', CPM(v) @ v / norm(v) + v),))\n"
        "assert differences(s, program_of(r))\n"
    )
    environment = {**os.environ, "CHASLES_POLYNOMIALS": backend}
    done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
