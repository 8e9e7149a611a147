"""Is the answer to an equation right? By values at points of our own, and at the point that the answer shows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from random import Random
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from .asking import Answer, ask, rejection
from .equations import Equation, Point, entries, points
from .series import Undefined, mp, mpf
from .sympy_values import Values, atoms_of

__all__ = ["Alarm", "Judged", "judge", "violations"]

FAR, NEAR = mpf(10) ** -20, mpf(10) ** -30
POINTS = 4
OF_ZERO = re.compile("multiplied by zero|assumed to be zero")
"""Why a question on what is zero may be declined."""


@dataclass(frozen=True)
class Alarm:
    """What is wrong with an answer."""

    kind: str
    detail: str


@dataclass(frozen=True)
class Judged:
    """An answer and what is wrong with it, if anything is."""

    answer: Answer
    alarm: Alarm | None
    found: int = 0


def judge(question: Equation, draw: Random, answer: Answer | None = None) -> Judged:
    """Ask, unless there is an answer, and hold it against the values of both sides."""
    answer = answer or ask(question)
    if answer.name == "crash":
        return Judged(answer, Alarm("crash", answer.words))
    if answer.name == "untreatable":
        alarm = None if question.lenient or OF_ZERO.search(answer.words) else Alarm("declined", answer.words)
        return Judged(answer, alarm)
    if answer.name == "undecided":
        return Judged(answer, None)
    seen = list(islice(points(question, draw, 3 * POINTS), POINTS))
    ends = [item.args for item in question.where if isinstance(item, sp.Ge | sp.Le)]
    seen += points(question, draw, 3, extra=(draw.choice(ends),)) if ends else ()
    alarm = next(_alarms(question, answer, seen, draw), None)
    return Judged(answer, alarm, len(seen))


def _alarms(question: Equation, answer: Answer, seen: list[Point], draw: Random) -> Iterator[Alarm]:
    if question.where and answer.true:
        seen = [point for point in seen if _all_met(question, answer.needs, point)]
    violated = next(violations(question, seen), None)
    if answer.name == "contradictory":
        sides = [e for side in (question.lhs, question.rhs) for e in entries(side)]
        defined = [point for point in seen if all(_both(e, sp.Integer(0), point) for e in sides)]
        if defined:
            yield Alarm("false contradictory", f"satisfied at {shown(defined[0])}")
        return
    if answer.name == "ill-formed":
        yield Alarm("ill-formed", answer.verdict.reason)
        return
    if question.satisfiable is False and not seen:
        yield Alarm("verdict on nothing", f"nothing satisfies what is given, and the verdict is {answer.name}")
    if answer.true:
        if violated:
            yield Alarm("false holds", violated)
        yield from _incomplete_needs(question, answer, draw)
    elif answer.name == "fails":
        yield from _false_fails(question, answer, len(seen), violated, draw)
    reason = rejection(question, answer.verdict)
    if reason is not None and not (answer.name == "fails" and "only what holds has a certificate" in reason):
        yield Alarm("own certificate rejected", reason)


def violations(question: Equation, seen: list[Point]) -> Iterator[str]:
    """Where the sides differ."""
    for point in seen:
        for place, (left, right) in enumerate(zip(entries(question.lhs), entries(question.rhs), strict=True)):
            values = _both(left, right, point)
            if values and _differ(*values):
                yield f"entry {place}: {_number(values[0])} and {_number(values[1])} at {shown(point)}"


def _both(left: Any, right: Any, point: Point) -> tuple[Any, Any] | None:
    evaluate = Values(point, mpf(0))
    try:
        return evaluate(left)[0], evaluate(right)[0]
    except Undefined:
        return None


def _differ(one: Any, other: Any) -> bool:
    return bool(abs(one - other) > FAR * (1 + abs(one) + abs(other)))


def _false_fails(question: Equation, answer: Answer, seen: int, violated: str | None, draw: Random) -> Iterator[Alarm]:
    shown_point = answer.verdict.counterexample
    if question.truth is True and not violated:
        yield Alarm("false fails", f"it is true by construction; said to fail at {dict(shown_point.at)}")
    found = 0
    if question.where and any(str(name).startswith("d_") for name in shown_point.at):
        # Where functions are compared, the point may tell by how much they differ rather than one of them.
        return
    for point in islice(completions(question, shown_point.at, draw), 2):
        found += 1
        row, column = shown_point.entry
        columns = question.lhs.shape[1] if isinstance(question.lhs, sp.MatrixBase) else 1
        place = (row - 1) * columns + column - 1
        values = _both(entries(question.lhs)[place], entries(question.rhs)[place], point)
        if values is None:
            yield Alarm("bad counterexample", f"a side is undefined at {dict(shown_point.at)}")
        elif not _differ(*values):
            yield Alarm("bad counterexample", f"the sides are equal at {dict(shown_point.at)}")
    if not found:
        kind = "bad counterexample" if violated or not seen else "false fails"
        yield Alarm(kind, f"what is given is not satisfied at {dict(shown_point.at)}")


def completions(question: Equation, at: Mapping[str, Any], draw: Random) -> Iterator[Point]:
    """Points that satisfy all that is given and have the coordinates that a counterexample shows."""
    fixed, extra = _read(question, at)
    angles = [atom for atom in question.atoms if (atom, 0) not in fixed]
    held = dict(fixed)
    for cosine, value in extra:
        unit, angle = cosine.args[0].as_coeff_Mul()
        if angle in angles and isinstance(cosine, sp.cos):
            sine = next((v for e, v in extra if e == sp.sin(cosine.args[0])), mp.sqrt(abs(1 - value**2)))
            turned = mp.atan2(sine, value)
            below, above = turned <= 0 and bool(angle.is_nonnegative), turned >= 0 and bool(angle.is_nonpositive)
            turned += 2 * mp.pi * (int(below) - int(above))
            held[angle, 0] = turned / (mpf(int(unit.p)) / int(unit.q))
        elif angle in angles and (angle, 0) not in held:
            held[angle, 0] = mp.asin(value) / (mpf(int(unit.p)) / int(unit.q))
    yield from points(question, draw, 4, held, extra)
    for turns in (1, -1, 2) if question.where else ():
        turned_on = {place: value + 2 * mp.pi * turns for place, value in held.items() if place not in fixed}
        yield from points(question, draw, 4, held | turned_on, extra)
    for item in question.where:
        for more in (0, 1):
            yield from points(question, draw, 2, held, (*extra, (item.gts, item.lts + more)))
    if held != fixed:
        near = {angle: float(held[angle, 0]) + draw.choice((0, 6.283185307)) for angle in angles if (angle, 0) in held}
        yield from points(question, draw, 4, fixed, extra, near=near)


def _read(question: Equation, at: Mapping[str, Any]) -> tuple[dict[Any, Any], tuple[tuple[Any, Any], ...]]:
    names = {str(atom): (atom, 0) for atom in question.atoms}
    for f in question.atoms:
        if isinstance(f, AppliedUndef):
            names |= {str(sp.Derivative(f, (f.args[0], k))): (f, k) for k in range(1, 12)}
    numbers = Values({}, mpf(0))
    fixed: dict[Any, Any] = {}
    extra: list[tuple[Any, Any]] = []
    for name, value in at.items():
        number = numbers(sp.Rational(value.numerator, value.denominator) if not isinstance(value, sp.Basic) else value)[
            0
        ]
        if name in names:
            fixed[names[name]] = number
        elif {*atoms_of(spoken := _expression(question, name))} <= {*question.atoms}:
            extra.append((spoken, number))
    return fixed, tuple((e, _exact(v)) for e, v in extra)


def _expression(question: Equation, text: str) -> Any:
    known = {str(a): a for a in question.atoms if isinstance(a, sp.Symbol)}
    known |= {a.func.__name__: a.func for a in question.atoms if isinstance(a, AppliedUndef)}
    return sp.sympify(text, locals=known)


def _exact(value: Any) -> Any:
    """The number so that its tree has 50 digits."""
    return sp.Rational(str(mp.nstr(value, 60))) if not mp.isint(value) else sp.Integer(int(value))


def _incomplete_needs(question: Equation, answer: Answer, draw: Random) -> Iterator[Alarm]:
    """Where a side has no value, one of the needs is not met."""
    for point in _troubled(question, draw):
        if _all_met(question, answer.needs, point):
            yield Alarm("needs incomplete", f"{answer.needs} allow {shown(point)}, where a side is undefined")


def _troubled(question: Equation, draw: Random) -> Iterator[Point]:
    """Points that satisfy what is given and at which a side is undefined: a divisor vanishes, or by chance."""
    sides = [e for side in (question.lhs, question.rhs) for e in entries(side)]
    if any(e.has(sp.I) for e in sides):
        return
    below = {p.base for e in sides for p in e.atoms(sp.Pow) if p.exp.is_Rational and p.exp < 0 and p.base.free_symbols}
    bare = question if not question.nonzero else Equation(question.lhs, question.rhs, question.given)
    ways: list[tuple[tuple[Any, Any], ...]] = [(), *(((base, sp.Integer(0)),) for base in sorted(below, key=str)[:2])]
    for extra in ways:
        for point in points(bare, draw, 2 if extra else 8, extra=extra, spare=1):
            if any(_both(e, sp.Integer(0), point) is None for e in sides):
                yield point


def _all_met(question: Equation, needs: tuple[str, ...], point: Point) -> bool:
    """Whether all needs hold at a point; what they alone speak of has the value that an equation among them tells."""
    evaluate = Values(point, mpf(0))
    try:
        for need in needs * 2:
            sides = [_expression(question, side) for side in need.split(" = ")]
            unknown = set(atoms_of(*sides)) - evaluate.atoms.keys()
            if len(sides) == 2 and len(unknown) == 1:
                (told,) = unknown
                value = sp.solve(sides[0] - sides[1], told)[0]
                evaluate = Values({**evaluate.atoms, told: [evaluate(value)[0]]}, evaluate.like)
        return all(_met(question, need, evaluate) for need in needs)
    except (Undefined, NotImplementedError, SyntaxError, TypeError, ValueError, AttributeError, LookupError):
        return False


def _met(question: Equation, need: str, evaluate: Values) -> bool:
    found = re.fullmatch(r"(.*\S) (!=|>=|<=|>|<) (\S.*)", need)
    if not found:
        return True
    one, relation, other = found.groups()
    kinds = {"!=": sp.Ne, ">=": sp.Ge, "<=": sp.Le, ">": sp.Gt, "<": sp.Lt}
    sides = [_expression(question, side) for side in (one, other)]
    unspoken = set(atoms_of(*sides)) - evaluate.atoms.keys()
    if not all(isinstance(atom, sp.Symbol) for atom in unspoken):
        # It is said not to vanish, and the point does not speak of it.
        return True
    evaluate = Values({**evaluate.atoms, **{atom: [mpf(7) / 8] for atom in unspoken}}, evaluate.like)
    return evaluate.truth(kinds[relation](*sides, evaluate=False))


def shown(point: Point) -> str:
    """The point in a few digits."""
    return ", ".join(f"{atom}: [{', '.join(map(_number, values[:4]))}]" for atom, values in point.items())


def _number(value: Any) -> str:
    return str(mp.nstr(value, 8))
