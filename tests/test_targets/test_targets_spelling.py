"""A spelled program computes what its steps say, rounding for rounding, and reads well."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chasles.lowering.program import Argument, Op, Program, Result, Step
from chasles.targets import EmissionError, Heading, TargetKernel, signature
from chasles.targets.constants import DOUBLE, SINGLE, literal, literals, rounded
from chasles.targets.dialect import ARITHMETIC, Dialect, call
from chasles.targets.gufunc import c_string
from chasles.targets.spelling import spelled

from ..sampling import WHOLE

PYTHON = Dialect(
    spell={
        **ARITHMETIC,
        Op.SQUARE_ROOT: call("root"),
        Op.SINE: call("sin"),
        Op.COSINE: call("cos"),
        Op.ARCTANGENT2: call("atan2", 2),
        Op.SELECT: call("select", 3),
    },
    constant=literals(DOUBLE),
    component=lambda name, shape, entry: f"{name}[{entry}]" if shape else name,
    declare=lambda name, text, truth: f"{name} = {text}",
    reserved=frozenset({"root", "sin", "cos", "atan2", "select"}),
    name_entries=False,
)
DIRECT = {
    Op.ADD: lambda x, y: x + y,
    Op.SUBTRACT: lambda x, y: x - y,
    Op.MULTIPLY: lambda x, y: x * y,
    Op.NEGATE: lambda x: -x,
    Op.SINE: math.sin,
    Op.COSINE: math.cos,
    Op.ARCTANGENT2: math.atan2,
    Op.SQUARE_ROOT: lambda x: math.sqrt(abs(x)),
    Op.LESS: lambda x, y: x < y,
    Op.EQUAL: lambda x, y: x == y,
    Op.SELECT: lambda c, x, y: x if c else y,
}
NUMBERS = (Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.NEGATE, Op.SINE, Op.COSINE, Op.ARCTANGENT2, Op.SQUARE_ROOT)


@st.composite
def programs(draw):
    """Programs of numbers and selects over x[0], x[1], y, with constants in between."""
    steps = [Step(Op.INPUT, argument=0), Step(Op.INPUT, argument=0, entry=1), Step(Op.INPUT, argument=1)]
    values = [0, 1, 2]
    for _ in range(draw(st.integers(1, 25))):
        pick = st.sampled_from(values)
        kind = draw(st.sampled_from([*NUMBERS, Op.CONSTANT, Op.SELECT]))
        if kind is Op.CONSTANT:
            steps.append(Step(kind, value=draw(st.fractions(-9, 9, max_denominator=12))))
        elif kind is Op.SELECT:
            steps.append(Step(draw(st.sampled_from([Op.LESS, Op.EQUAL])), (draw(pick), draw(pick))))
            steps.append(Step(kind, (len(steps) - 1, draw(pick), draw(pick))))
        else:
            arity = 1 if kind in (Op.NEGATE, Op.SINE, Op.COSINE, Op.SQUARE_ROOT) else 2
            steps.append(Step(kind, tuple(draw(pick) for _ in range(arity))))
        values.append(len(steps) - 1)
    entries = tuple(draw(st.lists(st.sampled_from(values), min_size=1, max_size=4)))
    arguments = Argument("x", (2,), "x"), Argument("y", (), "y")
    return Program("random", arguments, tuple(steps), (Result("r", (len(entries),), "r", entries),))


def by_steps(program, x, y):
    """The results, one step after the other."""
    found = []
    for step in program.steps:
        if step.op is Op.INPUT:
            found.append(x[step.entry] if step.argument == 0 else y)
        elif step.op is Op.CONSTANT:
            found.append(step.value.numerator / step.value.denominator)
        else:
            found.append(DIRECT[step.op](*(found[operand] for operand in step.operands)))
    return [found[entry] for entry in program.results[0].entries]


def by_text(program, x, y, dialect):
    text = spelled(program, dialect)
    scope = {"x": x, "y": y, "sin": math.sin, "cos": math.cos, "atan2": math.atan2}
    scope |= {"root": DIRECT[Op.SQUARE_ROOT], "select": DIRECT[Op.SELECT]}
    exec("\n".join(text.lines), scope)
    return [eval(entry, scope) for entry in text.entries[0]]


@settings(max_examples=300 if WHOLE else 100, deadline=None)
@given(programs(), st.lists(st.floats(-10, 10), min_size=3, max_size=3), st.sampled_from([20, 72]), st.booleans())
def test_text_computes_the_same_bits_as_the_steps(program, inputs, width, name_entries):
    dialect = Dialect(
        **{name: getattr(PYTHON, name) for name in PYTHON.__slots__} | {"width": width, "name_entries": name_entries}
    )
    x, y = inputs[:2], inputs[2]
    assert list(map(repr, by_text(program, x, y, dialect))) == list(map(repr, by_steps(program, x, y)))


def entry(line, dialect=PYTHON, **results):
    """The lines and the one entry of a program."""
    text = spelled(line.program(**results), dialect)
    return [*text.lines, *(entry for entries in text.entries for entry in entries)]


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda a, b, c: a + b + c, "a + b + c"),
        (lambda a, b, c: a + (b + c), "a + (b + c)"),
        (lambda a, b, c: a - (b - c), "a - (b - c)"),
        (lambda a, b, c: a - b * c, "a - b * c"),
        (lambda a, b, c: (a - b) * c, "(a - b) * c"),
        (lambda a, b, c: a * (b * c), "a * (b * c)"),
        (lambda a, b, c: a * (b / c), "a * (b / c)"),
        (lambda a, b, c: a / (b * c), "a / (b * c)"),
        (lambda a, b, c: -(a + b) * c, "-(a + b) * c"),
        (lambda a, b, c: a - -b * c, "a - (-b * c)"),
        (lambda a, b, c: a + -b - c, "a + (-b) - c"),
        (lambda a, b, c: a.line.step(Op.NEGATE, -a) + b * c, "-(-a) + b * c"),
        (lambda a, b, c: a * Fraction(1, 3) + b - c, "a * (1.0 / 3.0) + b - c"),
        (lambda a, b, c: Fraction(-1, 3) * a * Fraction(-1, 2) + b - c, "(-1.0 / 3.0) * a * (-0.5) + b - c"),
        (lambda a, b, c: a.line.step(Op.SINE, a + b) / c, "sin(a + b) / c"),
    ],
)
def test_parentheses_are_few_and_keep_the_order_of_rounding(builder, make, text):
    line = builder("few", a=(), b=(), c=())
    assert entry(line, r=make(*line.inputs())) == [text]


def test_a_step_used_twice_has_a_name_and_sines_a_telling_one(builder):
    line = builder("named", phi=(), a=())
    phi, a = line.inputs()
    s, half = line.step(Op.SINE, phi), phi * Fraction(1, 2)
    c = line.step(Op.COSINE, half)
    lines = entry(line, r=((3,), [s * s, (a + 1) * (a + 1), (half + c) * c]))
    assert lines == [
        "sin_phi = sin(phi)",
        "half_phi = phi * 0.5",
        "cos_half_phi = cos(half_phi)",
        "t1 = a + 1.0",
        "sin_phi * sin_phi",
        "t1 * t1",
        "(half_phi + cos_half_phi) * cos_half_phi",
    ]


def test_a_long_expression_is_broken_at_its_longest_part(builder):
    line = builder("long", x=(9,))
    (x,) = line.inputs()
    total = x[0]
    for wire in x[1:]:
        total = total + wire * wire
    *named, last = entry(line, r=total * total.line.step(Op.SINE, x[0]))
    assert named
    assert all(len(text) <= 72 + len("t1 = ") for text in (*named, last))


def test_steps_that_nothing_reads_are_left_out(builder):
    line = builder("dead", a=(), b=())
    a, b = line.inputs()
    line.step(Op.SINE, b)
    assert entry(line, r=a + 1) == ["a + 1.0"]


def test_names_keep_clear_of_each_other_and_of_the_language(builder):
    line = builder("names", sin=(), t1=(2,))
    s, t = line.inputs()
    text = spelled(line.program(sin_=(s + t[0]) * (s + t[0]), t1_=t[1]), PYTHON)
    assert (text.arguments, text.results) == (("sin_", "t1"), ("sin__", "t1_"))
    assert text.lines == ("t2 = sin_ + t1[0]",)


def test_an_operation_without_a_phrase_is_refused(builder):
    line = builder("refused", a=())
    (a,) = line.inputs()
    poor = Dialect(ARITHMETIC, PYTHON.constant, PYTHON.component, PYTHON.declare)
    with pytest.raises(EmissionError, match=r"refused.*does not spell 'sine'"):
        spelled(line.program(r=line.step(Op.SINE, a)), poor)


@pytest.mark.parametrize(
    ("value", "double", "single"),
    [
        ("2", "2.0", "2.0f"),
        ("1/2", "0.5", "0.5f"),
        ("-1/10", "-0.1", "-0.1f"),
        ("1/3", "1.0 / 3.0", "1.0f / 3.0f"),
        ("-7/16777216", "-7.0 / 16777216.0", "-7.0f / 16777216.0f"),
        ("16777217/3", "16777217.0 / 3.0", "5592405.5f"),
        ("1e30", "1e+30", "1e+30f"),
        ("123456789012345678/7", "17636684144620812.0", "1.76366841e+16f"),
    ],
)
def test_constants_are_divisions_of_exact_numbers_or_decimals(value, double, single):
    value = Fraction(value)
    assert (literal(value, DOUBLE)[0], literal(value, SINGLE)[0]) == (double, single)


@given(st.fractions(-(10**20), 10**20, max_denominator=10**20), st.integers(-40, 40))
def test_constants_come_out_correctly_rounded(fraction, exponent):
    value = fraction * Fraction(2) ** exponent
    assert eval(literal(value, DOUBLE)[0]) == float(value)
    terms = [np.float32(term) for term in literal(value, SINGLE)[0].replace("f", "").split(" / ")]
    found = terms[0] / terms[1] if len(terms) == 2 else terms[0]
    apart = [abs(Fraction(float(near)) - value) for near in np.nextafter(found, np.float32([-np.inf, np.inf]))]
    assert abs(Fraction(float(found)) - value) <= min(apart)


@given(st.fractions(), st.integers(-40, 40))
def test_rounding_to_double_is_pythons(fraction, exponent):
    value = fraction * Fraction(2) ** exponent
    assert rounded(value, 53) == Fraction(float(value))


def test_a_constant_that_a_precision_cannot_hold_is_refused():
    with pytest.raises(EmissionError, match="normal range of float"):
        literal(Fraction(1, 10**40), SINGLE)


def test_signature_and_what_a_kernel_refuses(builder):
    line = builder("refusals", Q=(3, 3), phi=())
    Q, phi = line.inputs()
    good = line.program(u=((3,), Q[:3]), w=phi)
    assert signature(good) == "(3,3),()->(3),()"
    heading = Heading("3.1", "says", "holds", (), "0" * 64)
    assert TargetKernel(good, heading).name == "refusals"
    truth = line.step(Op.LESS, phi, 0)
    for bad in (
        line.program(u=((3,), Q[:2])),
        line.program(u=truth),
        line.program(u=line.step(Op.SELECT, phi, phi, phi)),
        line.program(u=phi + truth),
        Program("refusals", good.arguments, (Step(Op.INPUT, argument=1, entry=1),), (Result("u", (), "u", (0,)),)),
        Program("refusals", good.arguments, (), ()),
    ):
        with pytest.raises(ValueError, match="refusals"):
            TargetKernel(bad, heading)


@pytest.mark.parametrize("bad", [{"says": r"\phi"}, {"says": "two\nlines"}, {"derivation": "12"}, {"section": "../x"}])
def test_headings_are_plain(bad):
    good = {"number": "3.1", "says": "s", "verdict": "holds", "hypotheses": (), "derivation": "0" * 64}
    with pytest.raises(ValueError, match=r"3\.1"):
        Heading(**good | bad)


def test_a_c_string_is_the_text_for_every_compiler():
    assert c_string('a "b"??/ \\ é\n') == r'"a \"b\"\?\?/ \\ \303\251\n"'
