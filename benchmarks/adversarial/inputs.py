"""What is thrown: for each kernel and precision so many inputs, of nine kinds in turn.

at large     what the kernel is made for, so that a mistake anywhere is found
scales       each argument times a power of ten, from the smallest number to the largest
alike        all arguments times one power of ten
denormal     arguments of denormal numbers, some of them plain
singular     angles, axes, rotations, spins, lines and inertias at a singular set, or nearer to it than a roundoff
huge angles  up to the largest number, and floats that lie as near to a multiple of a quarter turn as any
odd          entries replaced by zeros of both signs, denormal, huge and infinite numbers and NaN
one odd      a single such entry
broken       axes that are no unit vectors, rotations that are none, inertias that are not definite
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from chasles.lowering.program import Argument

__all__ = ["KINDS", "drawn", "towards"]

ODD = {
    np.float64: [0.0, -0.0, 1.0, -1.0, 5e-324, -1e-310, 2.3e-308, 1e-200, -1e-162, 1e-154, 1e154, -1e160, 1e200, 1e300],
    np.float32: [0.0, -0.0, 1.0, -1.0, 1e-45, -1e-40, 1.2e-38, 1e-25, -1e-22, 1e-19, 1e19, -1e20, 1e25, 1e37],
}
NEVER = [np.inf, -np.inf, np.nan]
LARGE = [1.6e6, 1e15, 1e22, 45.553093477052, 5319372648326541.0 * 2.0**-50, 6381956970095103.0 * 2.0**797, 1e300]
LARGE_SINGLE = [1.6e6, 1e15, 1e22, 16367173.0 * 2.0**72, 45.553093, 3.4e38]
SEED = 2026

Generator = np.random.Generator
Array = np.ndarray[Any, Any]


def drawn(name: str, arguments: Sequence[Argument], dtype: type[np.floating[Any]], count: int) -> list[Array]:
    """So many inputs of a kernel, an array for each argument, batch axis first; the same for the same name and type."""
    random = np.random.default_rng([SEED, np.dtype(dtype).itemsize, *name.encode()])
    share = -(-count // len(KINDS))
    with np.errstate(all="ignore"):
        parts = [[x.astype(dtype) for x in kind(random, arguments, share, dtype)] for kind in KINDS.values()]
    return [
        np.stack([part[k] for part in parts], axis=1).reshape(-1, *a.shape)[:count] for k, a in enumerate(arguments)
    ]


def _decades(random: Generator, dtype: type[np.floating[Any]], size: Any) -> Array:
    """Powers of ten from the smallest number to the largest."""
    low, high = np.log10(np.finfo(dtype).smallest_subnormal.astype(float)), np.log10(float(np.finfo(dtype).max))
    return 10.0 ** random.uniform(max(low, -323), high - 0.5, size)


def _tiny(random: Generator, dtype: type[np.floating[Any]], size: Any) -> Array:
    """Numbers of either sign from the smallest to a tenth, now and then zero."""
    low = -323.0 if dtype is np.float64 else -45.0
    found = random.choice([-1.0, 1.0], size) * 10.0 ** random.uniform(low, -1, size)
    near = random.choice([-1.0, 1.0], size) * 10.0 ** random.uniform(-20 if dtype is np.float64 else -10, -1, size)
    return np.where(random.random(size) < 0.5, near, found) * (random.random(size) < 0.9)


def _wide(vector: Array, shape: tuple[int, ...]) -> Array:
    """A number for each item, to be multiplied by an array of so many core axes."""
    return vector.reshape(-1, *[1] * len(shape))


def _unit(random: Generator, count: int) -> Array:
    axis = random.standard_normal((count, 3))
    plain = np.eye(3)[random.integers(3, size=count)] * random.choice([-1.0, 1.0], (count, 1))
    tilted = plain + _tiny(random, np.float64, (count, 3))
    axis = np.where(random.random((count, 1)) < 0.5, axis, np.where(random.random((count, 1)) < 0.3, plain, tilted))
    return axis / np.linalg.norm(axis, axis=1, keepdims=True)


def _turned(axis: Array, angle: Array) -> Array:
    """Rotations, right to a roundoff at every angle: small angles keep their sines."""
    e, half = axis[:, :, None], angle[:, None, None] / 2
    x, y, z = axis.T
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=1).reshape(-1, 3, 3)
    sine, cosine = np.sin(half), np.cos(half)
    return np.eye(3) + 2 * sine * cosine * cross + 2 * sine**2 * (e @ e.transpose(0, 2, 1) - np.eye(3))


def _inertia(random: Generator, count: int) -> Array:
    root = random.standard_normal((count, 3, 3))
    return root @ root.transpose(0, 2, 1)


def _packed(argument: Argument, matrix: Array) -> Array:
    return matrix if argument.shape == (3, 3) else matrix[:, [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]


def _is_angle(argument: Argument) -> bool:
    return argument.name in ("phi", "angles")


def _at_large(random: Generator, arguments: Sequence[Argument], count: int, _: type[np.floating[Any]]) -> list[Array]:
    """Inputs that satisfy what the kernels assume, to a roundoff."""
    found: list[Array] = []
    for argument in arguments:
        match argument.name:
            case "e":
                found.append(_unit(random, count))
            case "Q" | "triad" | "triad_prime":
                found.append(_turned(_unit(random, count), random.uniform(-6.3, 6.3, count)))
            case "I_C":
                found.append(_packed(argument, _inertia(random, count)))
            case "m":
                found.append(abs(random.standard_normal(count)) + 0.1)
            case "q_0":
                length = np.sqrt(np.sum(found[-1] ** 2, axis=1) + 1)
                found[-1] = found[-1] / length[:, None]
                found.append(random.choice([-1.0, 1.0], count) / length)
            case _:
                spread = 6.3 if _is_angle(argument) else 2.0
                found.append(random.uniform(-spread, spread, (count, *argument.shape)))
    return found


def _bound(argument: Argument) -> bool:
    """Whether the argument is bound to be of unit size, so that it cannot be scaled."""
    return argument.name in ("e", "Q", "triad", "triad_prime", "q", "q_0")


def _scales(random: Generator, arguments: Sequence[Argument], count: int, dtype: type[np.floating[Any]]) -> list[Array]:
    found = _at_large(random, arguments, count, dtype)
    for k, argument in enumerate(arguments):
        if not _bound(argument):
            found[k] = found[k] * _wide(_decades(random, dtype, count), argument.shape)
    return found


def _alike(random: Generator, arguments: Sequence[Argument], count: int, dtype: type[np.floating[Any]]) -> list[Array]:
    found, scale = _at_large(random, arguments, count, dtype), _decades(random, dtype, count)
    for k, argument in enumerate(arguments):
        if not _bound(argument) and not _is_angle(argument):
            found[k] = found[k] * _wide(scale, argument.shape)
    return found


def _denormal(
    random: Generator, arguments: Sequence[Argument], count: int, dtype: type[np.floating[Any]]
) -> list[Array]:
    found, tiny = _at_large(random, arguments, count, dtype), float(np.finfo(dtype).smallest_subnormal)
    for k, argument in enumerate(arguments):
        if not _bound(argument):
            scale = tiny * 10.0 ** random.uniform(0, 17 if dtype is np.float64 else 8, count)
            scale = np.where(random.random(count) < 0.7, scale, 1.0)
            found[k] = found[k] * _wide(scale, argument.shape)
    return found


def _singular(
    random: Generator, arguments: Sequence[Argument], count: int, dtype: type[np.floating[Any]]
) -> list[Array]:
    found = _at_large(random, arguments, count, dtype)
    for k, argument in enumerate(arguments):
        if _is_angle(argument):
            size = (count, *argument.shape)
            quarter = random.choice([0.0, 0.0, 1.0, -1.0, 2.0, -2.0, 4.0], size) * np.pi / 2
            found[k] = quarter.astype(dtype) + _tiny(random, dtype, size)
        elif argument.name in ("Q", "triad", "triad_prime"):
            angle = random.choice([0.0, np.pi], count) + _tiny(random, dtype, count)
            found[k] = _turned(_unit(random, count), angle)
        elif argument.name == "q_0":
            half = np.pi / 2 * random.choice([0.0, 1.0, 2.0], count) + _tiny(random, dtype, count)
            found[k - 1], found[k] = _unit(random, count) * np.sin(half)[:, None], np.cos(half)
        elif argument.name == "I_C":
            thin = random.standard_normal((count, 3, 1)) + random.choice([0.0, 1.0], (count, 3, 1))
            found[k] = _packed(argument, np.round(thin * 4) @ np.round(thin * 4).transpose(0, 2, 1))
        elif argument.name == "m":
            found[k] = found[k] * random.choice([0.0, 1.0], count)
        elif argument.shape and argument.name != "e":
            scale = np.where(random.random(count) < 0.3, _tiny(random, dtype, count), 1.0)
            found[k] = found[k] * _wide(scale, argument.shape)
            beside = [found[j] for j in range(k) if arguments[j].shape == argument.shape and not _bound(arguments[j])]
            if beside:
                near = _wide(_tiny(random, dtype, count), argument.shape)
                chosen = _wide(random.random(count) < 0.5, argument.shape)
                found[k] = np.where(chosen, beside[-1] + near * random.standard_normal(found[k].shape), found[k])
    return found


def _huge_angles(
    random: Generator, arguments: Sequence[Argument], count: int, dtype: type[np.floating[Any]]
) -> list[Array]:
    found = _at_large(random, arguments, count, dtype)
    for k, argument in enumerate(arguments):
        if _is_angle(argument):
            size = (count, *argument.shape)
            some = random.choice(LARGE if dtype is np.float64 else LARGE_SINGLE, size)
            turns = np.round(10.0 ** random.uniform(0, 15, size)) * np.pi / 2
            powers = _decades(random, dtype, size)
            found[k] = np.select([random.random(size) < 0.3, random.random(size) < 0.5], [some, turns], powers)
    return found


def _odd(random: Generator, arguments: Sequence[Argument], count: int, dtype: type[np.floating[Any]]) -> list[Array]:
    found = _at_large(random, arguments, count, dtype)
    for k, argument in enumerate(arguments):
        often = _wide(random.choice([0.0, 0.1, 0.6], count), argument.shape)
        odd = random.choice([*ODD[dtype], *ODD[dtype], *NEVER], found[k].shape)
        found[k] = np.where(random.random(found[k].shape) < often, odd, found[k])
    return found


def _one_odd(
    random: Generator, arguments: Sequence[Argument], count: int, dtype: type[np.floating[Any]]
) -> list[Array]:
    found = _at_large(random, arguments, count, dtype)
    sizes = [x[0].size for x in found]
    place = random.integers(sum(sizes), size=count)
    odd = random.choice([*ODD[dtype], *NEVER, *NEVER], count)
    for k, argument in enumerate(arguments):
        here = place[:, None] - sum(sizes[:k]) == np.arange(sizes[k])
        found[k] = np.where(here.reshape(-1, *argument.shape), _wide(odd, argument.shape), found[k])
    return found


def _broken(random: Generator, arguments: Sequence[Argument], count: int, dtype: type[np.floating[Any]]) -> list[Array]:
    found = _at_large(random, arguments, count, dtype)
    for k, argument in enumerate(arguments):
        if _bound(argument):
            noise = np.where(random.random(count) < 0.5, float(np.finfo(dtype).eps) * 4, _tiny(random, dtype, count))
            found[k] = found[k] + _wide(noise, argument.shape) * random.standard_normal(found[k].shape)
            found[k] = found[k] * _wide(random.choice([0.0, 1.0, 1.0, 1.0, 3.0], count), argument.shape)
        elif argument.name in ("I_C", "m"):
            found[k] = random.standard_normal(found[k].shape)
    return found


Kind = Callable[[Generator, Sequence[Argument], int, type[np.floating[Any]]], list[Array]]

KINDS: dict[str, Kind] = {
    "at large": _at_large,
    "scales": _scales,
    "alike": _alike,
    "denormal": _denormal,
    "singular": _singular,
    "huge angles": _huge_angles,
    "odd": _odd,
    "one odd": _one_odd,
    "broken": _broken,
}
"""The kinds by name; input i is of kind i modulo their number."""


OFFSETS = (1e-300, 1e-150, 1e-30, 1e-12, 1e-8, 1e-4, 1e-2)
OFFSETS_SINGLE = (1e-37, 1e-18, 1e-12, 1e-8, 1e-6, 1e-4, 1e-2)


def towards(name: str, arguments: Sequence[Argument], dtype: type[np.floating[Any]], count: int) -> list[Array]:
    """Inputs at large and near to singular sets, in turn; an angle, a vector or a turn is off by a power of ten."""
    random = np.random.default_rng([SEED + 1, np.dtype(dtype).itemsize, *name.encode()])
    found, near = _at_large(random, arguments, count, dtype), np.arange(count) % 2 == 1
    few = random.choice(OFFSETS if dtype is np.float64 else OFFSETS_SINGLE, count)
    many = 10.0 ** random.uniform(-300 if dtype is np.float64 else -37, -1, count)
    offset = random.choice([-1.0, 1.0], count) * np.where(random.random(count) < 0.7, few, many)
    for k, argument in enumerate(arguments):
        value = found[k]
        if _is_angle(argument):
            quarter = random.choice([0.0, 0.0, 2.0, -2.0, 1.0, -1.0, 4.0], (count, *argument.shape)) * np.pi / 2
            value = quarter.astype(dtype) + _wide(offset, argument.shape)
        elif argument.name == "Q":
            value = _turned(_unit(random, count), random.choice([0.0, np.pi], count) + offset)
        elif argument.name == "e":
            value = _unit(random, count)
        elif argument.name in ("omega", "f"):
            value = value * _wide(abs(offset), argument.shape)
        elif k and not _bound(argument) and arguments[k - 1].shape == argument.shape == (3,):
            value = found[k - 1] + value * _wide(offset, argument.shape)
        found[k] = np.where(_wide(near, argument.shape), value, found[k])
    with np.errstate(all="ignore"):
        return [x.astype(dtype) for x in found]
