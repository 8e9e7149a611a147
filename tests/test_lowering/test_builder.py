"""A builder's steps mean what was asked for, however they are folded; passes keep what a program means."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chasles.lowering.arithmetic import Arithmetic, decimals
from chasles.lowering.builder import Builder
from chasles.lowering.cost import WEIGHTS, cost
from chasles.lowering.passes.guard import guarded
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import ARITY, FREE_OF_CHARGE, Argument, Op, Program, Result, Step
from chasles.lowering.refusal import LoweringError
from chasles.lowering.rounding import RunningErrors

from ..programs import FLOATS, fractions, run, shared
from ..sampling import WHOLE

ARGUMENTS = (Argument("x", (4,), "numbers"),)
BINARY = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "multiply": lambda a, b: a * b,
    "divide": lambda a, b: a / b,
}
INPUTS = (Fraction(2, 3), Fraction(-5), Fraction(7, 4), Fraction(1, 9))
plans = st.lists(
    st.tuples(st.sampled_from([*BINARY, "negate", "select", "constant"]), *(st.integers(0, 60) for _ in range(3))),
    min_size=1,
    max_size=25,
)


def built(plan):
    """The steps of a plan as the builder makes them, as they are written, and what they must give."""
    build, plain, values = Builder(), [Step(Op.INPUT, entry=k) for k in range(4)], list(INPUTS)
    numbers = [build.input(0, k) for k in range(4)]
    for word, *places in plan:
        i, j, k = (place % len(values) for place in places)
        if word == "constant":
            value = Fraction(places[0] - 30, 1 + places[1] % 4)
            numbers.append(build.constant(value))
            plain.append(Step(Op.CONSTANT, value=value))
        elif word == "negate":
            numbers.append(build.negate(numbers[i]))
            plain.append(Step(Op.NEGATE, (plain_place(plain, i),)))
            value = -values[i]
        elif word == "select":
            numbers.append(build.select(build.less(numbers[i], numbers[j]), numbers[k], numbers[j]))
            plain.append(Step(Op.LESS, (plain_place(plain, i), plain_place(plain, j))))
            plain.append(Step(Op.SELECT, (len(plain) - 1, plain_place(plain, k), plain_place(plain, j))))
            value = values[k] if values[i] < values[j] else values[j]
        elif word == "divide" and values[j] == 0:
            continue
        else:
            numbers.append(getattr(build, word)(numbers[i], numbers[j]))
            plain.append(Step(Op(word), (plain_place(plain, i), plain_place(plain, j))))
            value = BINARY[word](values[i], values[j])
        values.append(value)
    one = Program("one", ARGUMENTS, build.steps, (Result("y", (len(numbers),), "", tuple(numbers)),))
    entries = tuple(plain_place(plain, k) for k in range(len(values)))
    return one, Program("other", ARGUMENTS, tuple(plain), (Result("y", (len(entries),), "", entries),)), tuple(values)


def plain_place(plain, index):
    """Where the index-th number stands among steps of which some are truth values."""
    return [place for place, step in enumerate(plain) if step.op is not Op.LESS][index]


@settings(max_examples=150 if WHOLE else 50, deadline=None)
@given(plans)
def test_folding_keeps_the_value(plan):
    folded, plain, values = built(plan)
    for program in (folded, plain, shared(plain), pruned(folded), pruned(shared(plain)), guarded(plain)):
        assert run(program, [INPUTS], fractions()) == (values,)


@settings(max_examples=60 if WHOLE else 20, deadline=None)
@given(plans)
def test_sharing_a_program_that_was_built_changes_nothing(plan):
    program = pruned(built(plan)[0])
    assert pruned(shared(program)).operations == program.operations


def made(*steps, result=-1, arguments=ARGUMENTS):
    numbers = range(len(steps))
    return Program("made", arguments, steps, (Result("y", (), "", (numbers[result],)),))


def test_equal_steps_are_one():
    build = Builder()
    x, y = build.input(0, 0), build.input(0, 1)
    assert build.add(x, y) == build.add(y, x)
    assert build.multiply(x, y) == build.multiply(y, x)
    assert build.subtract(x, y) == build.negate(build.subtract(y, x))
    assert build.sine(build.negate(x)) == build.negate(build.sine(x))
    assert build.cosine(build.negate(x)) == build.cosine(x)
    assert build.equal(x, y) == build.equal(y, x)
    assert build.less(x, y) != build.less(y, x)


def test_zeros_and_ones_are_absorbed():
    build = Builder()
    x, zero, one = build.input(0, 0), build.zero, build.one
    assert [build.add(x, zero), build.subtract(x, zero), build.multiply(one, x), build.divide(x, one)] == [x] * 4
    assert [build.multiply(x, zero), build.divide(zero, x), build.negate(zero), build.sine(zero)] == [zero] * 4
    assert build.cosine(zero) == one
    assert build.subtract(zero, x) == build.negate(x) == build.multiply(build.constant(-1), x)


def test_what_a_machine_must_see_is_left_to_it():
    build = Builder()
    x = build.input(0, 0)
    assert build.subtract(x, x) != build.zero
    assert build.divide(x, x) != build.one
    with pytest.raises(LoweringError, match="zero by construction"):
        build.divide(x, build.zero)


def test_only_a_power_of_two_turns_a_division_into_a_product():
    build = Builder()
    x = build.input(0, 0)
    quarter, third = build.divide(x, build.constant(4)), build.divide(x, build.constant(3))
    assert (build.steps[quarter].op, build.steps[third].op) == (Op.MULTIPLY, Op.DIVIDE)


def test_of_two_quotients_one_is_made():
    build = Builder()
    a, b, c, d = (build.input(0, k) for k in range(4))
    chosen = build.select(build.less(a, b), build.divide(a, c), build.divide(b, d))
    program = pruned(Program("f", ARGUMENTS, build.steps, (Result("y", (), "", (chosen,)),)))
    assert program.operations == {Op.DIVIDE: 1}
    assert run(program, [INPUTS], fractions()) == ((Fraction(-5) / Fraction(1, 9),),) or INPUTS[0] < INPUTS[1]


def test_dead_steps_are_left_out():
    program = made(Step(Op.INPUT), Step(Op.SINE, (0,)), Step(Op.INPUT, entry=1), Step(Op.ADD, (0, 2)))
    assert [step.op for step in pruned(program).steps] == [Op.INPUT, Op.INPUT, Op.ADD]
    assert run(pruned(program), [INPUTS]) == run(program, [INPUTS])


def test_shared_steps_are_made_once():
    twice = made(
        Step(Op.INPUT),
        Step(Op.INPUT, entry=1),
        Step(Op.MULTIPLY, (0, 1)),
        Step(Op.MULTIPLY, (1, 0)),
        Step(Op.ADD, (2, 3)),
    )
    assert pruned(shared(twice)).operations == {Op.MULTIPLY: 1, Op.ADD: 1}


QUOTIENT = (Step(Op.INPUT), Step(Op.INPUT, entry=1), Step(Op.DIVIDE, (0, 1)))


@pytest.mark.parametrize("above", [0.0, 1.0, -2.0, math.nan])
def test_a_guarded_quotient_by_zero_is_not_a_number(above):
    program = guarded(made(*QUOTIENT))
    for zero in (0.0, -0.0):
        assert math.isnan(run(program, [(above, zero, 0.0, 0.0)])[0][0])


def test_a_guard_keeps_infinities_from_coming_back():
    steps = (*QUOTIENT, Step(Op.DIVIDE, (0, 2)))
    assert run(made(*steps), [(1.0, 0.0, 0.0, 0.0)]) == ((0.0,),)
    assert math.isnan(run(guarded(made(*steps)), [(1.0, 0.0, 0.0, 0.0)])[0][0])


@given(st.floats(-1e9, 1e9), st.floats(min_value=1e-9, max_value=1e9))
def test_a_guard_changes_no_other_quotient(above, below):
    assert run(guarded(made(*QUOTIENT)), [(above, below, 0.0, 0.0)]) == ((above / below,),)


def test_guards_cost_nothing_and_spare_constants():
    program = guarded(made(Step(Op.INPUT), Step(Op.CONSTANT, value=Fraction(3)), Step(Op.DIVIDE, (0, 1))))
    assert [step.op for step in program.steps] == [Op.INPUT, Op.CONSTANT, Op.DIVIDE]
    assert guarded(made(*QUOTIENT)).operations == made(*QUOTIENT).operations


def test_cost_weighs_every_operation_that_counts():
    assert set(WEIGHTS) == set(Op) - FREE_OF_CHARGE
    assert set(ARITY) == set(Op) - {Op.FUNCTION}
    assert cost(made(*QUOTIENT)) == WEIGHTS[Op.DIVIDE]


def angle_of(steps=()):
    arguments = (Argument("phi", (), "angle"),)
    return made(Step(Op.INPUT), *steps, arguments=arguments)


def test_run_on_every_kind_of_number():
    program = angle_of((Step(Op.COSINE, (0,)), Step(Op.SINE, (0,)), Step(Op.MULTIPLY, (1, 2))))
    exact = fractions({Fraction(1): (Fraction(3, 5), Fraction(4, 5))}.__getitem__)
    assert run(program, [Fraction(1)], exact) == ((Fraction(12, 25),),)
    assert run(program, [1.0], FLOATS) == ((math.cos(1.0) * math.sin(1.0),),)
    fine = run(program, [decimals(50).constant(Fraction(1))], decimals(50))[0][0]
    assert str(fine).startswith("0.4546487134128408476980099329558724213511274857")


def test_run_says_what_it_cannot_do():
    with pytest.raises(ValueError, match="the square root of 2 is not rational"):
        run(angle_of((Step(Op.SQUARE_ROOT, (0,)),)), [Fraction(2)], fractions())
    with pytest.raises(ValueError, match="pass `circle`"):
        run(angle_of((Step(Op.SINE, (0,)),)), [Fraction(2)], fractions())
    with pytest.raises(ValueError, match="takes arguments of 1 entries, not 3"):
        run(angle_of(), [(1, 2, 3)])
    assert math.isnan(run(angle_of((Step(Op.SQUARE_ROOT, (0,)),)), [-1.0])[0][0])


def test_run_takes_nested_and_flat_arrays():
    steps = (Step(Op.INPUT, entry=2),)
    arguments = (Argument("M", (2, 2), ""),)
    program = made(*steps, arguments=arguments)
    assert run(program, [((1, 2), (3, 4))]) == run(program, [(1, 2, 3, 4)]) == ((3,),)


def test_an_arithmetic_has_every_operation_under_its_name():
    asked = {name for name in vars(Arithmetic) if not name.startswith("_")}
    assert asked == {op.value for op in Op} - {"input"}
    for arithmetic in (Builder(), decimals(20), RunningErrors(), FLOATS, fractions()):
        assert [name for name in asked if not callable(getattr(arithmetic, name, None))] == []
