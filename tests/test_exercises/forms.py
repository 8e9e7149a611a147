"""Answers in other forms, right and wrong ones: made from text alone, and told apart by decimals of mpmath alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from copy import deepcopy
from decimal import Decimal
from itertools import permutations
from random import Random
from typing import Any

import mpmath
import sympy as sp

from chasles.statements.exercise import Exercise

DIGITS = 80
Place = tuple[Any, ...]
ZEROS = (
    "1/7-1/7", "sqrt(5+2*sqrt(6))-sqrt(2)-sqrt(3)", "sqrt(8)-2*sqrt(2)", "acos(1/3)+asin(1/3)-pi/2",
    "4*atan(1/5)-atan(1/239)-pi/4", "sin(1)^2+cos(1)^2-1", "sqrt(3)*sqrt(5)-sqrt(15)", "cos(pi/5)-cos(2*pi/5)-1/2",
    "1/(sqrt(2)-1)-sqrt(2)-1", "atan(1/2)+atan(1/3)-pi/4", "tan(pi/8)-sqrt(2)+1", "sqrt(7-4*sqrt(3))+sqrt(3)-2",
    "asin(3/5)-acos(4/5)", "cos(2*acos(1/4))+7/8", "sin(pi/7)-cos(5*pi/14)",
)  # fmt: skip
ONES = (
    "sqrt(2)/sqrt(2)", "tan(pi/4)", "(1+sqrt(2))*(sqrt(2)-1)", "(3/7)*(7/3)", "sqrt(6)/(sqrt(2)*sqrt(3))",
    "2*sin(pi/6)", "(2+sqrt(3))*(2-sqrt(3))", "sqrt(3/2)*sqrt(2/3)", "(sqrt(5)+2)^3*(sqrt(5)-2)^3",
)  # fmt: skip
SLIPS = (
    "2*({0})", "({0})/2", "({0})*sqrt(2)", "({0})*180/pi", "({0})^2", "pi-({0})", "sqrt(({0})^2+1)", "({0})*355/113/pi",
    "({0})+acos(1/3)-1.2309594173407747", "({0})+sqrt(2)+sqrt(3)-sqrt(9.898979486)",
)  # fmt: skip
"""What people take one number for, and numbers near it."""


def leaves(value: Any, at: Place = ()) -> Iterator[Place]:
    """The places of all numbers."""
    if isinstance(value, list):
        for k, part in enumerate(value):
            yield from leaves(part, (*at, k))
    elif isinstance(value, dict) and "root_of" not in value:
        for key, part in value.items():
            yield from leaves(part, (*at, key))
    elif (isinstance(value, dict | int) and not isinstance(value, bool)) or (
        isinstance(value, str) and near(value) is not None
    ):
        yield at


def near(number: Any) -> mpmath.mpf | None:
    """The number in decimals; None for a word."""
    with mpmath.workdps(DIGITS):
        if isinstance(number, dict):
            roots = mpmath.polyroots(number["root_of"], maxsteps=500, extraprec=400)
            return sorted(mpmath.re(x) for x in roots if abs(mpmath.im(x)) < 1e-40)[number["index"]]
        known = {name: getattr(mpmath, name) for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "pi")}
        if not set("".join(c if c.isalpha() else " " for c in str(number)).split()) <= set(known):
            return None
        text = str(number).replace("^", "**")
        # Text of this module alone; integers become mpmath's, so that nothing is divided in floating point.
        exact = "".join(f"mpf('{t}')" if t[:1].isdigit() else t for t in _tokens(text))
        with suppress(ZeroDivisionError, SyntaxError):
            value = eval(exact, {"__builtins__": {}, "mpf": mpmath.mpf, **known})
            return None if isinstance(value, mpmath.mpc) else value
    return None


def _tokens(text: str) -> Iterator[str]:
    found = ""
    for c in text:
        if found and not ((c.isdigit() or c == ".") and (found[0].isdigit() or found[0] == ".")):
            yield found
            found = ""
        found += c
    yield found


def at_place(value: Any, place: Place) -> Any:
    for key in place:
        value = value[key]
    return value


def put(answers: dict[str, Any], place: Place, value: Any) -> dict[str, Any]:
    changed = deepcopy(answers)
    at_place(changed, place[:-1])[place[-1]] = value
    return changed


def other_form(draw: Random, number: Any, is_angle: bool, with_angles: bool = True) -> Any:
    """The same number, written otherwise; `with_angles` also by what angles add up to."""
    if isinstance(number, dict):
        factor = draw.choice((1, -1, 2, -3))
        return {"root_of": [factor * c for c in number["root_of"]], "index": number["index"]}
    text, value = str(number), near(number)
    zeros = [zero for zero in ZEROS if with_angles or not {"a", "i"} & set(zero)]
    ways: list[Callable[[], Any]] = [
        lambda: f"({text})+({draw.choice(zeros)})",
        lambda: f"({text})-({draw.choice(zeros)})",
        lambda: f"({text})*({draw.choice(ONES)})",
        lambda: f"({text})/({draw.choice(ONES)})",
        lambda: f"-(-({text}))",
    ]
    if abs(value) > 1e-20:
        ways.append(lambda: f"1/(1/({text}))")
        ways.append(lambda: f"{'-' if value < 0 else ''}sqrt(({text})^2)")
    if "pi" not in text and "a" not in text:
        exact = sp.sympify(text, rational=True)
        if exact.is_Rational:
            ways.append(lambda: {"root_of": [int(exact.q), -int(exact.p)], "index": 0})
            ways.append(lambda: f"({exact.p * 6})/({exact.q * 6})")
            ways.append(lambda: f"{exact.p}*sqrt({exact.q**2 * 4})/({2 * exact.q**2})")
            if exact.q in (1, 2, 4, 5, 8, 10, 16, 20, 25, 50, 100, 125):
                ways.append(lambda: f"{Decimal(int(exact.p)) / int(exact.q):f}")
        elif (exact**2).is_Rational:
            square = exact**2
            ways.append(lambda: {"root_of": [int(square.q), 0, -int(square.p)], "index": int(value > 0)})
            ways.append(lambda: f"{'-' if value < 0 else ''}sqrt({square.p})/sqrt({square.q})")
    if is_angle:
        ways.append(lambda: f"({text})+{2 * draw.randint(1, 5)}*pi")
        ways.append(lambda: f"({text})-{2 * draw.randint(1, 5)}*pi")
        ways.append(lambda: f"pi-(pi-({text}))")
        if text.startswith("acos(") and text.endswith(")") and "(" not in text[5:]:
            cosine = text[5:-1]
            ways = [
                lambda: f"pi-acos(-({cosine}))",
                lambda: f"pi/2-asin({cosine})",
                lambda: f"2*atan(sqrt((1-({cosine}))/(1+({cosine}))))",
                lambda: f"2*acos(sqrt((1+({cosine}))/2))",
                lambda: f"acos({cosine})/2+pi/4-asin({cosine})/2",
                *ways[1:],
            ]
    return draw.choice(ways)()


def right_forms(draw: Random, exercise: Exercise, answers: dict[str, Any]) -> dict[str, Any]:
    """The same answers, each number written otherwise, with signs and orders changed as the exercise allows."""
    found = deepcopy(answers)
    for group in exercise.signs:
        if draw.randint(0, 1):
            for name in group:
                for place in list(leaves(found.get(name), (name,))):
                    number = at_place(found, place)
                    found = put(found, place, _negative(number))
    for group in exercise.orders:
        lists = [name for name in group if isinstance(found.get(name), list)]
        size = len(found[lists[0]]) if lists else 0
        order = draw.sample(range(size), size)
        for name in lists:
            found[name] = [found[name][k] for k in order]
    for name in exercise.axes:
        for k, row in enumerate(found[name]):
            if all(isinstance(entry, str) for entry in row):
                factor = draw.choice(("2", "-1", "-3/2", "sqrt(2)"))
                found[name][k] = [f"({factor})*({entry})" for entry in row]
    for place in list(leaves(found)):
        if draw.randint(0, 2):
            is_angle, in_rows = place[0] in exercise.turns, place[0] in exercise.axes
            found = put(found, place, other_form(draw, at_place(found, place), is_angle, not in_rows))
    return found


def _negative(number: Any) -> Any:
    if isinstance(number, dict):
        degree = len(number["root_of"]) - 1
        count = len([1 for x in sp.Poly(number["root_of"], sp.Symbol("x")).real_roots()])
        turned = [c * (-1) ** (degree - k) for k, c in enumerate(number["root_of"])]
        return {"root_of": turned, "index": count - 1 - number["index"]}
    return f"-({number})"


def spoiled(draw: Random, exercise: Exercise, answers: dict[str, Any]) -> tuple[dict[str, Any], str] | None:
    """The answers with one part made wrong, and its name; None where what was tried changes nothing."""
    name = draw.choice(list(answers))
    if isinstance(answers[name], bool):
        return {**answers, name: not answers[name]}, name
    places = list(leaves(answers[name], (name,)))
    if not places:
        return None
    place = draw.choice(places)
    number = at_place(answers, place)
    if isinstance(number, dict):
        ways = [lambda: {**number, "index": (number["index"] + 1) % 3}, lambda: _negative(number)]
    else:
        text = str(number)
        ways = [
            lambda: f"({text})+1/2^{draw.choice((40, 60, 64))}",
            lambda: f"({text})-1/10^{draw.choice((12, 18, 30))}",
            lambda: f"-({text})",
            lambda: text.replace("sqrt", "-1*sqrt", 1),
            lambda: _other_digit(draw, text),
            lambda: f"({text})+({draw.choice(ZEROS)})+1/2^60",
            lambda: str(at_place(answers, draw.choice(places))),
            lambda: mpmath.nstr(near(text), 25),
            lambda: draw.choice(SLIPS).format(text),
            lambda: draw.choice(SLIPS).format(text),
        ]
    changed = put(answers, place, draw.choice(ways)())
    if len(places) > 1 and name not in exercise.axes and not draw.randint(0, 5):
        one, other = draw.sample(places, 2)
        changed = put(put(answers, one, at_place(answers, other)), other, at_place(answers, one))
    if near(at_place(changed, place)) is None:
        return None
    return None if same_to_many_digits(exercise, answers, changed, name) else (changed, name)


def _other_digit(draw: Random, text: str) -> str:
    digits = [k for k, c in enumerate(text) if c.isdigit()]
    if not digits:
        return f"{text}+1"
    k = draw.choice(digits)
    return text[:k] + str((int(text[k]) + draw.randint(1, 9)) % 10) + text[k + 1 :]


def same_to_many_digits(exercise: Exercise, answers: dict[str, Any], changed: dict[str, Any], name: str) -> bool:
    """Whether by decimals a choice of signs and of orders makes both the same, or the exercise leaves it open."""
    if changed == answers:
        return True
    if name in exercise.axes:
        row = next(k for k, (one, other) in enumerate(zip(answers[name], changed[name], strict=True)) if one != other)
        one, other = ([near(x) for x in rows[name][row]] for rows in (answers, changed))
        cross = [one[i] * other[j] - one[j] * other[i] for i, j in ((0, 1), (1, 2), (2, 0))]
        return max(map(abs, cross)) < mpmath.mpf(10) ** -50 and max(map(abs, other)) > 0
    numbers = {
        key: [(place, near(at_place(answers, place))) for place in leaves(answers[key], (key,))] for key in answers
    }
    group = next((group for group in (*exercise.signs, *exercise.orders) if name in group), (name,))
    members = [key for key in group if key in answers]
    if any(group == signs for signs in exercise.signs):
        return any(
            all(
                _close(near(at_place(changed, place)), value, key in exercise.turns, turn)
                for key in members
                for place, value in numbers[key]
            )
            for turn in (1, -1)
        )
    size = len(answers[name]) if any(group == orders for orders in exercise.orders) else 0
    return any(
        all(
            _close(near(at_place(changed, _moved(place, order))), value, False)
            for key in members if isinstance(answers[key], list) or not size
            for place, value in numbers[key]
        )
        for order in (permutations(range(size)) if size else [()])
    )  # fmt: skip


def _moved(place: Place, order: tuple[int, ...]) -> Place:
    return (place[0], order[place[1]], *place[2:]) if order else place


def _close(one: mpmath.mpf | None, other: mpmath.mpf, is_angle: bool, turn: int = 1) -> bool:
    with mpmath.workdps(DIGITS):
        if one is None:
            return False
        difference = one - turn * other
        if is_angle:
            difference -= 2 * mpmath.pi * mpmath.nint(difference / (2 * mpmath.pi))
        return bool(abs(difference) < mpmath.mpf(10) ** -45)
