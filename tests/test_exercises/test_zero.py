"""Whether a number is zero is decided exactly: identities of inverse functions, and numbers that are only small."""

from __future__ import annotations

from contextlib import suppress
from random import Random

import mpmath
import pytest
import sympy as sp

from chasles.exact.grammar import NotANumber, read_number
from chasles.exact.numbers import NotDecided, angle, is_zero, sign

from ..counted import at_most
from ..sampling import sample

MILLION = 1_000_000

IDENTITIES = [
    ("acos(-1/5)", "pi-acos(1/5)"),
    ("acos(-1/5)", "2*atan(sqrt(3/2))"),
    ("acos(-1/5)", "pi/2+asin(1/5)"),
    ("acos(1/3)", "asin(sqrt(8)/3)"),
    ("acos(1/3)", "atan(2*sqrt(2))"),
    ("acos(1/3)", "acot(1/(2*sqrt(2)))"),
    ("acos(1/3)", "asec(3)"),
    ("asin(1/3)", "acsc(3)"),
    ("acos(-7/9)", "2*acos(1/3)"),
    ("4*atan(1/5)-atan(1/239)", "pi/4"),
    ("atan(1/2)+atan(1/3)", "pi/4"),
    ("atan(1)+atan(2)+atan(3)", "pi"),
    ("asin(3/5)+asin(4/5)", "pi/2"),
    ("atan(1/2)+atan(1/5)+atan(1/8)", "pi/4"),
    ("12*atan(1/18)+8*atan(1/57)-5*atan(1/239)", "pi/4"),
    ("sqrt(3)/acos(-1/5)", "sqrt(3)/(pi-acos(1/5))"),
    ("1/acos(1/3)+1/pi", "(pi+acos(1/3))/(pi*asec(3))"),
    ("sqrt(2)*acos(1/3)/sqrt(8)", "pi/4-asin(1/3)/2"),
    ("(1+sqrt(2))*acos(1/4)", "acos(1/4)+2*acos(1/4)/sqrt(2)"),
    ("cos(acos(1/3)/2)", "sqrt(2/3)"),
    ("cos(3*acos(1/3))", "4/27-1"),
    ("4*cos(acos(1/3)/3)^3-3*cos(acos(1/3)/3)", "1/3"),
    ("sin(acos(1/3)/5)^2", "1-cos(acos(1/3)/5)^2"),
    ("tan(atan(2)/2)", "(sqrt(5)-1)/2"),
    ("sin(1+acos(1/3))", "sin(1)/3+cos(1)*sqrt(8)/3"),
    ("cos(2+asin(1/4))^2+sin(2+asin(1/4))^2", "1"),
    ("cos(sqrt(2))^2+sin(sqrt(2))^2", "1"),
    ("cos(pi/7)-cos(2*pi/7)+cos(3*pi/7)", "1/2"),
    ("sin(pi/5)*sin(2*pi/5)", "sqrt(5)/4"),
    ("2*cos(2*pi/9)", "2*cos(acos(-1/2)/3)"),
    ("asin(sin(acos(1/3)))", "acos(1/3)"),
    ("(pi/2-asin(1/3))^2", "acos(1/3)^2"),
    ("sqrt(5+2*sqrt(6))", "sqrt(2)+sqrt(3)"),
]
NEAR = ["+1/2^60", "-1/2^60", "+1/10^50", "-1/10^50", "*(1+1/2^60)", "+pi/10^40", "+sqrt(2)/10^45"]
TINIER = ["+1/10^60/10^60", "-1/2^64/2^64/2^64/2^64/2^64", "*(1+1/10^60/10^50)", "+sqrt(3)/10^64/10^64/10^64/10^64"]
"""Below what the first enclosures tell from zero."""


@pytest.mark.parametrize(("one", "other"), IDENTITIES)
def test_identities_are_decided(one: str, other: str) -> None:
    assert is_zero(read_number(one) - read_number(other))
    assert sign(read_number(other) - read_number(one)) == 0


@pytest.mark.parametrize(
    ("one", "other", "near"), sample([(*pair, near) for pair in IDENTITIES for near in (*NEAR, *TINIER)], 5)
)
def test_what_is_near_is_not_equal(one: str, other: str, near: str) -> None:
    assert not is_zero(read_number(one) - read_number(f"({other}){near}"))


MINUTE = [
    "*".join(["(sqrt(2)-1)^64"] * 5),
    "*".join(["(2*cos(2*pi/7)-1)^64"] * 4),
    "*".join(["tan(pi/8)^64"] * 5),
    "*".join(["(sqrt(2)+sqrt(3)-3)^64"] * 4),
    "*".join(["(2*cos(pi/5)-8/5)^64"] * 5),
    "*".join(["(2*cos(acos(1/2)/3)-15/8)^64"] * 3),
    "sqrt(10^64*10^64*10^64*10^64+1)-10^64*10^64",
    "sqrt(10^64*10^64*10^64*10^64+1)+sqrt(10^64*10^64*10^64*10^64-1)-2*10^64*10^64",
    "sqrt(10^64*10^64*10^64*10^64+1)/10^64/10^64-1",
    "sqrt(10^60*10^60*10^60*10^60+7)/10^60/10^60-sqrt(2)/sqrt(2+1/10^60/10^60/10^60/10^60)",
    "cos(1/10^64/10^64)-1",
    "atan(1+1/10^64/10^64/10^64)-pi/4",
    "atan(1/2)+atan(1/3+1/10^64/10^64/10^64)-pi/4",
    "acos(1/3+1/10^64/10^64)+asin(1/3)-pi/2",
    "2*atan(sqrt(3/2)+1/10^60/10^60)-acos(-1/5)",
]
"""Numbers that are minute though their denominators are not large, and sums of angles that are nearly related."""


@pytest.mark.parametrize("text", MINUTE)
def test_minute_numbers_are_not_zero(text: str) -> None:
    value = read_number(text, 1000)
    with mpmath.workdps(800):
        near = sp.lambdify((), value, "mpmath")()
        assert 0 < abs(near) < mpmath.mpf(2) ** -256
    assert not is_zero(value)
    assert sign(value) == mpmath.sign(near)


def pythagorean(draw: Random) -> sp.Rational:
    """A number between -1 and 1."""
    below = draw.randint(2, 40)
    return sp.Rational(draw.randint(1 - below, below - 1), below)


@pytest.mark.sampled(5)
@pytest.mark.parametrize("seed", sample(range(200), 10))
def test_angles_written_in_other_ways(seed: int) -> None:
    draw = Random(seed)
    x, y = pythagorean(draw), pythagorean(draw)
    first = sp.acos(x)
    forms = [
        sp.pi / 2 - sp.asin(x),
        sp.pi - sp.acos(-x),
        2 * sp.atan(sp.sqrt((1 - x) / (1 + x))),
        sp.acos(x) + sp.acos(y) + sp.asin(y) - sp.pi / 2,
        2 * sp.acos(sp.sqrt((1 + x) / 2)),
    ]
    for form in forms:
        assert is_zero(first - form), form
        assert not is_zero(first - form + sp.Rational(1, 2**60)), form
        assert not is_zero(first + form + 1)


@pytest.mark.parametrize("seed", range(6))
def test_differences_of_square_roots_are_zero_only_where_they_are(seed: int) -> None:
    draw = Random(seed)
    for _ in range(20):
        a, b = draw.randint(1, 60), draw.randint(1, 60)
        rest = a + b + 2 * int(sp.sqrt(a * b))
        assert is_zero(sp.sqrt(a) + sp.sqrt(b) - sp.sqrt(rest)) == bool(sp.sqrt(a * b).is_Integer)


TINY = ["2e-9", "1e-4", "1e-7", "1e-12", "1e-20", "1e-31", "1e-50"]


@pytest.mark.parametrize("size", TINY)
@pytest.mark.parametrize("near", ["0", "1/7", "1/2", "2/3", "1", "355/999", "1/1000"])
def test_angles_near_multiples_of_pi_are_found_at_once(size: str, near: str) -> None:
    turned = sp.pi * sp.Rational(near) + sp.Rational(size) * (-1 if near == "1" else 1)
    # A cosine that square roots express, within such a distance of the angle's.
    cosine = sp.Rational(str(sp.cos(turned).evalf(120)))
    with at_most(calls=MILLION):
        found = angle(cosine, 1)
    assert found == sp.acos(cosine)


@pytest.mark.parametrize("text", ["٣", "१/2", "sqrt(２)", "1.٥", "𝟙", "²", "1²"])
def test_digits_are_those_of_ascii(text: str) -> None:
    with pytest.raises(NotANumber, match="has no meaning in a number"):
        read_number(text)


@pytest.mark.parametrize("seed", sample(range(120), 6))
def test_any_number_is_read_and_decided_soon(seed: int) -> None:
    draw = Random(f"soon {seed}")
    leaves = ["2e0", "1/3", "10^60", "1/10^60", "355/113", "pi", "sqrt(2)", "0.000000002", "99999999999/7", "1/1000003"]

    def written(depth: int) -> str:
        if not depth:
            return draw.choice(leaves).replace("e0", "")
        name = draw.choice(["sin", "cos", "tan", "atan", "acos", "asin", "sqrt", "", "", ""])
        whole = f"({written(depth - 1)}){draw.choice('+-*/')}({written(draw.randint(0, depth - 1))})"
        return f"{name}({whole})"

    text = written(3)
    with at_most(calls=MILLION), suppress(NotANumber, NotDecided):
        assert sign(read_number(text)) in (-1, 0, 1)
