"""Classes of answers that were once wrong, each with a generator of its variants: all must be answered rightly."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from random import Random
from typing import Any

import sympy as sp
from sympy import Abs, Eq, cos, sin, sqrt

from chasles.prove import prove
from chasles.statements import Claim, Iff, Theorem, nonzero
from chasles.vocabulary import Node, at, number, rate

from . import declared, functions, motions, scalars
from .asking import Answer, answer_of, ask_statement
from .assumed import ASSUMED
from .declared_words import named
from .equations import TIME, Equation
from .forging import needs_forged
from .judging import Alarm, Judged, judge
from .statement_judging import judge_statement
from .statements import Asked

__all__ = ["CLASSES"]

x, y, z, phi = sp.symbols("x y z phi")
p, q = sp.symbols("p q", positive=True)
Judgement = tuple[Any, Judged]


def an_angle_that_is_solved_for(draw: Random) -> Judgement:
    """A function of time under a sine, of which differential equations are given."""
    question = motions.with_a_function(draw)
    return question, judge(question, draw)


def rates_of_what_is_assumed(draw: Random) -> Judgement:
    """Hypotheses on symbols of which rates are named."""
    asked = declared.consequence(draw)
    return asked, judge_statement(asked, draw)


def imaginary_parts(draw: Random) -> Judgement:
    """Expressions with I inside."""
    question = functions.imaginary(draw)
    return question, judge(question, draw)


def nothing_satisfies_it(draw: Random) -> Judgement:
    """Hypotheses, given equations and equations of motion that contradict each other."""
    way = draw.randrange(4)
    if way == 0:
        asked = declared.contradictory(draw)
        return asked, judge_statement(asked, draw)
    if way == 1:
        return _equivalence_of_nothing(draw)
    question = scalars.contradictory(draw) if way == 2 else motions.contradictory(draw)
    return question, judge(question, draw)


def _equivalence_of_nothing(draw: Random) -> Judgement:
    """An equivalence under hypotheses that exclude what it speaks of."""
    one, other = (named("scalar", name) for name in draw.sample("abcdmk", 2))
    n, m = draw.choice((1, 2, -3)), draw.choice((1, 3))
    theorem = Theorem(
        "1", "", (Iff(n * one, m * other, m * other / (n * one), n * one / (m * other)),),
        assuming=(nonzero(one), nonzero(other)),
    )  # fmt: skip
    asked = Asked(theorem, "equivalence of nothing", satisfiable=False)
    answer = ask_statement(theorem)
    wrong = answer.true or answer.name == "fails"
    return asked, Judged(answer, Alarm("verdict on nothing", f"it {answer.name}") if wrong else None)


def given_in_another_form(draw: Random) -> Judgement:
    """Side conditions as a mapping, a set, a generator, a relation or something that says nothing."""
    a, b = draw.sample((x, y, z), 2)
    value = draw.choice((sp.Integer(1), sp.Integer(-2), b, b + 1, cos(b), sp.Rational(1, 3)))
    claim = draw.choice(((a, value), (a**2, value**2), (a, 0), (a + b, b + value), (sin(a), sin(value)), (a, -value)))
    said: dict[str, Any]
    said, given, none = draw.choice((
        ({"given": {a: value}}, (Eq(a, value, evaluate=False),), ()),
        ({"given": {a: value, sp.Symbol("w"): 2}}, (Eq(a, value), Eq(sp.Symbol("w"), 2)), ()),
        ({"given": {a - value}}, (a - value,), ()),
        ({"given": (e for e in [Eq(a, value, evaluate=False)])}, (Eq(a, value, evaluate=False),), ()),
        ({"given": Eq(a, value, evaluate=False)}, (Eq(a, value, evaluate=False),), ()),
        ({"given": [(a, value)]}, (Eq(a, value, evaluate=False),), ()),
        ({"given": [True]}, (), ()),
        ({"given": [sp.S.true, a - value]}, (a - value,), ()),
        ({"given": [a > 0]}, (), ()),
        ({"given": [sp.Ne(a, 0)]}, (), (a,)),
        ({"given": [{a: value}]}, (Eq(a, value, evaluate=False),), ()),
        ({"nonzero": [0]}, (sp.Integer(1),), ()),
        ({"nonzero": [sp.Integer(0)]}, (sp.Integer(1),), ()),
        ({"nonzero": [a - a]}, (sp.Integer(1),), ()),
        ({"nonzero": [(a + 1) ** 2 - a**2 - 2 * a - 1]}, (sp.Integer(1),), ()),
        ({"nonzero": [sin(a) ** 2 + cos(a) ** 2 - 1]}, (sp.Integer(1),), ()),
        ({"nonzero": [a], "given": [a]}, (sp.Integer(1),), ()),
        ({"nonzero": {a: value}}, (), (a,)),
        ({"nonzero": a}, (), (a,)),
        ({"nonzero": [sp.Ne(a, b)]}, (), (a - b,)),
    ))  # fmt: skip
    impossible = given == (sp.Integer(1),)
    meant = Equation(*map(sp.sympify, claim), given, none, "form", None, False if impossible else None, True)
    answer = answer_of(lambda: prove(*claim, **said))
    if answer.name == "crash" and answer.words.startswith("TypeError: "):
        answer = Answer("untreatable", None, answer.words)
    return f"{claim}, {said}", judge(meant, draw, answer)


def said_at_another_time(draw: Random) -> Judgement:
    """A quantity at an instant is not the quantity: at(a, '0') = a is no identity."""
    symbol = named(draw.choice(("scalar", "vector", "square")), draw.choice("abcm"))
    instant = draw.choice(("0", "1", "t_0", "0", "t_1", "s"))
    there: Node = at(symbol, instant)
    k = number(draw.choice((1, 2)))
    left, right = draw.choice(((there, symbol), (symbol, there), (k * there, k * symbol), (rate(there), rate(symbol)),
                               (there + symbol, 2 * symbol), (there - symbol, symbol - symbol)))  # fmt: skip
    answer = ask_statement(Claim("1", left, right))
    return f"{left} = {right}", Judged(answer, Alarm("false holds", answer.name) if answer.true else None)


def needs_left_out(draw: Random) -> Judgement:
    """A proof of what holds in a domain is not accepted as one without it, nor with less."""
    a, b = draw.choice((x, x + y, x * y, x - 1)), draw.choice((y, y + 2, x**2 * y, z))
    factor = draw.choice((sp.Integer(1), z, sp.Integer(-2)))
    left, right = draw.choice((
        (sqrt(a) * sqrt(b), sqrt(a * b)), (1 / a + 1 / b, (a + b) / (a * b)), (a**2 / a / b, a / b),
        (a / sqrt(b), a * sqrt(b) / b),
        (sp.tan(phi) / a, sin(phi) / cos(phi) / a), (Abs(a) / a, a / Abs(a)), (sqrt(a) ** 2 + b, a + b),
    ))  # fmt: skip
    question = Equation(left * factor, sp.sympify(right) * factor, kind="needs", lenient=True)
    judged = judge(question, draw)
    if judged.alarm is None and judged.answer.true:
        said = needs_forged(question, judged.answer.verdict)
        if said is not None:
            return question, replace(judged, alarm=Alarm("forgery", said))
    return question, judged


def pi_in_a_witness(draw: Random) -> Judgement:
    """Roots, sizes and signs of things with pi, or where an angle is given: the checker accepts the proof."""
    a = draw.choice((x + sp.pi, x - sp.pi, p + sp.pi, 2 * x + sp.pi, x * sp.pi, sp.pi - y, x * y + sp.pi))
    b = draw.choice((x, p, a))
    left, right, given = draw.choice((
        (Abs(a) * b, Abs(a) * b, ()), (sqrt(a**2), Abs(a), ()), (sqrt(sp.pi) * sqrt(b), sqrt(sp.pi * b), ()),
        (sp.sign(a) * Abs(a), a, ()), (sp.sign(b), sp.sign(b) ** 3, (Eq(cos(b), 0),)), (sqrt(a) * y, y * sqrt(a), ()),
        (sqrt(a) / sqrt(2), sqrt(a / 2), ()), (Abs(b), sqrt(b**2), (Eq(cos(b), 0),)),
        (Abs(a) ** 2, a**2, (Eq(sin(y), 1),)),
    ))  # fmt: skip
    question = Equation(sp.sympify(left), sp.sympify(right), given, kind="pi", lenient=True)
    return question, judge(question, draw)


def divisors_that_are_seen_not_to_vanish(draw: Random) -> Judgement:
    """What the prover takes to have one sign, or to leave a remainder, the checker sees so, too; else it is said."""
    n, odd = sp.Symbol("n", integer=True), sp.Symbol("odd", odd=True)
    atoms = (x, y, p, q, n, odd, sin(x), Abs(y), sqrt(p), sp.exp(x), sqrt(x**2 + 1))
    parts = [draw.choice((1, 2, sp.Rational(1, 3))) * draw.choice(atoms) ** draw.choice((1, 2, 2, 4)) for _ in "ab"]
    base = parts[0] + draw.choice((parts[1], 1, p)) + draw.choice((0, 1, sp.Rational(4, 3)))
    base = base ** draw.choice((1, 1, 2)) + draw.choice((0, 1, p))
    question = Equation(z / base, (z + 1) / base - 1 / base, kind="divisor", lenient=True)
    judged = judge(question, draw)
    open_ = judged.alarm is None and not judged.answer.true
    return question, replace(judged, alarm=Alarm("lost", judged.answer.words)) if open_ else judged


def derivatives_in_any_order(draw: Random) -> Judgement:
    """Mixed derivatives that SymPy leaves as they are written."""
    field, order = sp.Function("u")(x, y, z), [draw.choice((x, y, z)) for _ in range(draw.randint(2, 4))]
    other = draw.sample(order, len(order))
    answer = answer_of(lambda: prove(sp.Derivative(field, *order) * phi, phi * sp.Derivative(field, *other)))
    wrong = None if answer.true else Alarm("false fails", answer.name)
    return f"{order}, {other}", Judged(answer, wrong)


def sums_up_to_a_letter(draw: Random) -> Judgement:
    """What telescopes to a known value, and a value that is another one from some number on."""
    i, n = sp.symbols("i n", integer=True, positive=True)
    a, b, c = draw.randint(1, 4), draw.randint(-3, 3), draw.choice((1, x, p, z + 1))
    makes: tuple[Callable[[Any], Any], ...] = (
        lambda k: c * k**2 / (2 * k + a),
        lambda k: p**k * (k + b) + c,
        lambda k: 2**k * c / (k + a),
        lambda k: c * sin(k * x),
        lambda k: c * sqrt(k + a) + sp.log(k + a),
        lambda k: sp.factorial(k) * (k + b),
        lambda k: (-1) ** k * c / (k + a),
    )
    value = draw.choice(makes)
    left, right = sp.Sum(value(i) - value(i - 1), (i, 1, n)), value(n) - value(sp.Integer(0))
    more = draw.choice((0, 0, y, (n - 1) * y, (n - 1) * (n - 2), (n - 1) * (n - 2) * (n - 3) * y))
    answer = answer_of(lambda: prove(left, right + more))
    names = ("fails", "undecided", "untreatable") if more else ("holds", "holds-under")
    return f"{left} = {right + more}", Judged(answer, None if answer.name in names else Alarm("wrong", answer.name))


def integers_that_are_put_in(draw: Random) -> Judgement:
    """Whether a number divides an integer that is given, as a greatest integer, a remainder or an angle says it."""
    k, even, odd = sp.Symbol("k", integer=True), sp.Symbol("e", even=True), sp.Symbol("o", odd=True)
    squares, below = ((2 * k + 2) ** 2, even**2, odd**2 - 1), draw.choice((2, 3, 4, 6, 10, 12))
    value = draw.choice((even, 2 * k + 2, (2 * k + 2) ** 3, even * odd, k * (k + 1), 6 * k, 3 * odd, *squares))
    forms = (sp.floor(x / below), x / below), (sp.Mod(x, below), 0), (sin(sp.pi * x / below), 0)
    left, right = draw.choice((*forms, (cos(2 * sp.pi * x / below), 1)))
    divides = all(value.subs({k: n, even: 2 * n, odd: 2 * n + 1}) % below == 0 for n in range(-6, 7))
    answer = answer_of(lambda: prove(left, right, given=[Eq(x, value)]))
    names = ("holds-under" if divides else "fails", "undecided", "untreatable")
    said = f"{left} = {right} where x = {value}"
    return said, Judged(answer, None if answer.name in names else Alarm("wrong", answer.name))


def what_lasts_for_an_instant(draw: Random) -> Judgement:
    """What is not zero only where something vanishes, times a rate: no rate follows of what holds at an instant."""
    one, other = (sp.Function(name, real=True)(TIME) for name in "xy")
    rate_of = draw.choice((one.diff(TIME), one.diff(TIME) * 2 - 1, one.diff(TIME) ** 2, other.diff(TIME)))
    zero = draw.choice((one, one - 1, one - other**3, TIME, one + 2 * TIME, 2 * one * (other - 3)))
    only_there = draw.choice((
        1 - sp.sign(zero) ** 2, sp.Heaviside(-Abs(zero), 1), sp.Piecewise((1, Eq(zero, 0)), (0, True)),
        sp.Piecewise((0, sp.Ne(zero, 0)), (1, True)), 1 - sp.sign(Abs(zero)),
    ))  # fmt: skip
    given = draw.choice(((), (), (Eq(other, one + 5),), (Eq(other, one**3 + one - 7),)))
    true = draw.random() < 0.3
    left = only_there * rate_of * (zero if true else 1) + one
    answer = answer_of(lambda: prove(left, one, given=given))
    apart = any(need.endswith(" != 0") for need in answer.needs)
    right = answer.true is (true or apart) or answer.name in ("undecided", "untreatable")
    return f"{left} = {one} where {given}", Judged(answer, None if right else Alarm("wrong", answer.name))


CLASSES: dict[str, Callable[[Random], Judgement]] = {
    make.__name__.replace("_", " "): make
    for make in (
        an_angle_that_is_solved_for,
        rates_of_what_is_assumed,
        imaginary_parts,
        nothing_satisfies_it,
        given_in_another_form,
        said_at_another_time,
        needs_left_out,
        pi_in_a_witness,
        divisors_that_are_seen_not_to_vanish,
        derivatives_in_any_order,
        sums_up_to_a_letter,
        integers_that_are_put_in,
        what_lasts_for_an_instant,
        *ASSUMED,
    )
}
