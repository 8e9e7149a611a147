"""Polynomials that are sums of others with rational numbers as cofactors."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import assume, given
from hypothesis import strategies as st

from chasles.algebra.groebner import combined
from chasles.algebra.modular import MODULUS
from chasles.algebra.rings import Polynomial, make_ring

RING = make_ring(["x", "y", "z"])
X, Y, Z = RING.generators
GENERATORS = [X * Y - Z, Y * Z - 2 * X, X * X - 1, X * Y - Z + X * X - 1]
RATIONALS = st.fractions(min_value=-50, max_value=50, max_denominator=12)


def total(cofactors: dict[int, Polynomial]) -> Polynomial:
    return sum((cofactor * GENERATORS[k] for k, cofactor in cofactors.items()), RING.constant(Fraction(0)))


@given(st.lists(RATIONALS, min_size=4, max_size=4))
def test_what_adds_up_is_found(numbers: list[Fraction]) -> None:
    wanted = total({k: RING.constant(c) for k, c in enumerate(numbers)})
    found = combined(RING, wanted, GENERATORS)
    assert found is not None
    assert total(found) == wanted


def test_what_does_not_add_up_is_not() -> None:
    assert combined(RING, X, GENERATORS) is None
    assert combined(RING, X * GENERATORS[0], GENERATORS) is None
    assert combined(RING, X, []) is None


@given(st.lists(st.integers(-3, 3), min_size=12, max_size=12), st.lists(RATIONALS, min_size=3, max_size=3))
def test_what_alone_has_a_term_has_no_part_in_it(made: list[int], numbers: list[Fraction]) -> None:
    terms = [X, Y, Z, X * X]
    bearing = [sum((c * t for c, t in zip(made[k : k + 4], terms, strict=True)), 0 * X) for k in (0, 4, 8)]
    alone = [X + X * Y + Y * Y, X * Y, Y + Z * Z]
    wanted = sum((RING.constant(c) * each for c, each in zip(numbers, bearing, strict=True)), 0 * X)
    assume(wanted != 0)
    found = combined(RING, wanted, [alone[0], bearing[0], alone[1], *bearing[1:], alone[2]])
    assert found is not None
    assert not {0, 2, 5}.intersection(found)
    assert combined(RING, wanted + Z * Y, [*bearing, *alone]) is None


def test_what_adds_up_only_modulo_the_prime_is_not() -> None:
    assert combined(RING, X + Y + MODULUS * Z, [X + Y]) is None
    assert combined(RING, X, [X + RING.constant(Fraction(1, MODULUS)) * Y]) is None
