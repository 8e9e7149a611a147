"""Integers as a square times a squarefree number."""

from __future__ import annotations

from math import isqrt

LARGEST_DIVISOR = 10_000


def squarefree(number: int) -> tuple[int, int] | None:
    """A positive integer as s^2 times m, m squarefree; None if it has large factors that cannot be told apart."""
    root, rest, divisor = 1, 1, 2
    while divisor <= LARGEST_DIVISOR and divisor * divisor <= number:
        count = 0
        while number % divisor == 0:
            number, count = number // divisor, count + 1
        root, rest = root * divisor ** (count // 2), rest * divisor ** (count % 2)
        divisor += 1 if divisor == 2 else 2
    whole = isqrt(number)
    if whole * whole == number:
        return root * whole, rest
    return (root, rest * number) if number < LARGEST_DIVISOR**2 else None


def primes_of(number: int) -> list[int]:
    """The prime factors, the smallest first."""
    for divisor in range(2, isqrt(number) + 1):
        if number % divisor == 0:
            return [divisor, *primes_of(number // divisor)]
    return [number] if number > 1 else []
