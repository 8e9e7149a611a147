"""Programs that differ in order and grouping alone are told to be the same; what else differs is not."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

import pytest

import chasles.lowering.equivalence.sums as module
from chasles.lowering.arithmetic import decimals, run
from chasles.lowering.builder import Builder
from chasles.lowering.equivalence.sums import same_but_for_order
from chasles.lowering.program import Argument, Op, Program, Result

INPUTS = 4
SLIPS = {
    Op.ADD: Op.SUBTRACT,
    Op.SUBTRACT: Op.ADD,
    Op.MULTIPLY: Op.DIVIDE,
    Op.DIVIDE: Op.MULTIPLY,
    Op.SINE: Op.COSINE,
    Op.COSINE: Op.SINE,
}


def tree(draw, depth):
    """A random expression: sums and products of several, quotients, functions, choices, inputs and numbers."""
    if depth == 0 or draw.random() < 0.1:
        return draw.choice(
            [("input", draw.randrange(INPUTS)), ("input", draw.randrange(INPUTS)), ("number", number(draw))]
        )
    kind = draw.choice(["sum", "sum", "product", "product", "quotient", "function", "choice"])
    count = {"sum": draw.randint(2, 5), "product": draw.randint(2, 3), "quotient": 2, "function": 1, "choice": 4}[kind]
    what = draw.choice(["sine", "cosine", "square_root"]) if kind == "function" else None
    return (kind, what, *(tree(draw, depth - 1) for _ in range(count)))


def number(draw):
    return Fraction(draw.choice([-3, -1, 1, 2, 5]), draw.choice([1, 1, 2, 3]))


def step_of(build, node, draw):
    """A step for an expression, in a random order and grouping, with signs at random places."""
    kind = node[0]
    if kind == "input":
        return build.input(0, node[1])
    if kind == "number":
        return build.constant(node[1])
    if draw.random() < 0.2:
        inner = step_of(build, node, draw)
        return build.negate(build.multiply(build.constant(-1), inner))
    parts = [step_of(build, part, draw) for part in node[2:]]
    if kind == "function":
        return getattr(build, node[1])(parts[0])
    if kind == "quotient":
        return build.divide(*parts) if build.value(parts[1]) != 0 else parts[0]
    if kind == "choice":
        return build.select(build.less(parts[0], parts[1]), parts[2], parts[3])
    draw.shuffle(parts)
    while len(parts) > 1:
        a, b = parts.pop(), parts.pop(draw.randrange(len(parts)))
        if kind == "product":
            parts.append(build.multiply(a, b))
        else:
            parts.append(build.subtract(a, build.negate(b)) if draw.random() < 0.3 else build.add(a, b))
    return parts[0]


def program(node, seed):
    build = Builder()
    end = step_of(build, node, random.Random(seed))
    argument = Argument("x", (INPUTS,), "numbers")
    return Program("k", (argument,), build.steps, (Result("y", (), "a number", (end,)),))


def value(made, point):
    numbers = decimals(50)
    return run(made, [[numbers.constant(x) for x in point]], numbers)[0][0]


def close(one, other):
    both = one != one and other != other
    return both or one == other or abs(one - other) <= decimals(50).constant(Fraction(1, 10**35)) * (abs(one) + 1)


@pytest.mark.parametrize("seed", range(40))
def test_order_and_grouping_make_no_difference(seed):
    node = tree(random.Random(seed), 4)
    stated = program(node, 0)
    for turn in range(1, 4):
        assert same_but_for_order(stated, program(node, turn)), turn


@pytest.mark.sampled(4)
@pytest.mark.parametrize("seed", range(60))
def test_what_is_told_to_be_the_same_is_equal_in_numbers(seed):
    draw = random.Random(seed)
    stated = program(tree(draw, 4), 0)
    places = [k for k, step in enumerate(stated.steps) if step.op in SLIPS or step.op in (Op.CONSTANT, Op.INPUT)]
    points = [[Fraction(draw.randint(-400, 400), 97) for _ in range(INPUTS)] for _ in range(4)]
    for k in draw.sample(places, min(8, len(places))):
        steps = list(stated.steps)
        step = steps[k]
        if step.op is Op.CONSTANT:
            steps[k] = replace(step, value=step.value + 1)
        elif step.op is Op.INPUT:
            steps[k] = replace(step, entry=(step.entry + 1) % INPUTS)
        else:
            steps[k] = replace(step, op=SLIPS[step.op])
        changed = replace(stated, steps=tuple(steps))
        if same_but_for_order(stated, changed):
            assert all(close(value(stated, point), value(changed, point)) for point in points), k


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (lambda b, x, y: b.divide(x, x), lambda b, x, y: b.one),
        (lambda b, x, y: b.multiply(x, b.add(y, b.one)), lambda b, x, y: b.add(b.multiply(x, y), x)),
        (lambda b, x, y: b.square_root(b.multiply(x, x)), lambda b, x, y: x),
        (lambda b, x, y: b.divide(x, y), lambda b, x, y: b.divide(y, x)),
        (lambda b, x, y: b.less(x, y), lambda b, x, y: b.less(y, x)),
        (lambda b, x, y: b.sine(x), lambda b, x, y: b.sine(b.negate(x))),
        (lambda b, x, y: b.divide(x, b.subtract(y, y)), lambda b, x, y: b.divide(y, b.subtract(x, x))),
    ],
)
def test_what_is_not_seen_or_not_so_is_left_open(one, other):
    def made(make):
        build = Builder()
        x, y = build.input(0, 0), build.input(0, 1)
        end = make(build, x, y)
        end = build.select(end, x, y) if build.steps[end].op is Op.LESS else end
        return Program("k", (Argument("x", (2,), ""),), build.steps, (Result("y", (), "", (end,)),))

    assert same_but_for_order(made(one), made(one))
    assert not same_but_for_order(made(one), made(other))


def test_what_would_take_long_is_left_open(monkeypatch):
    stated = program(tree(random.Random(3), 4), 0)
    assert same_but_for_order(stated, stated)
    monkeypatch.setattr(module, "MOST_TERMS", 5)
    assert not same_but_for_order(stated, stated)
