"""Measurements of the kernels: times next to those of other generators, and errors; read from the checkout."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import inf, isfinite
from typing import Any

from chasles.report.html.citing import Link

TIMES, ERRORS = "kernels.json", "errors.json"
"""The files of the evidence."""
OURS, PRINTED = "chasles_kernels", "numpy_by_hand"
NOT_GENERATED = (OURS, PRINTED, "one", "sympy_lambdify", "sympy_ufuncify", "numba_jit", "scipy_rotation")
PRECISIONS = ("float64", "float32")
NEAR_PI = "pi - phi"
TEN_THOUSAND, A_MILLION = "10000", "1000000 out="


class DamagedEvidence(ValueError):
    """A file of the evidence is not what it should be; the message names it."""


@dataclass(frozen=True, slots=True)
class ErrorAtAngle:
    """The errors of a kernel and of its formula as typed, at an angle that is as `small` as that or as near to pi.

    They are in units of roundoff, and infinite where there is no finite result.
    """

    near_pi: bool
    small: float
    ours: float
    typed: float


@dataclass(frozen=True, slots=True)
class ErrorCurve:
    """The errors over the angle of one kernel."""

    kernel: str
    title: str
    places: tuple[ErrorAtAngle, ...]


@dataclass(frozen=True, slots=True)
class Measured:
    """Times and errors; none where nothing was measured. `where` says on what machine the times were.

    `speeds` are rows of a table; `found` has the largest errors of a kernel, by its name, a line for each result.
    """

    where: tuple[str, ...]
    speeds: tuple[tuple[Link, tuple[str, ...]], ...]
    found: Mapping[str, tuple[str, ...]]
    curves: tuple[ErrorCurve, ...]


def measured(evidence: Mapping[str, str], places: Mapping[str, str]) -> Measured:
    """What the texts of the evidence, by the names of their files, say of the kernels that have a place on the page.

    Raises DamagedEvidence, naming the file, for a text that is not what was expected.
    """
    times, errors = _read(evidence, TIMES), _read(evidence, ERRORS)
    try:
        where = (_where(times["machine"]),) if times else ()
        peers: Mapping[str, str] = times.get("peers", {})
        listed = times.get("kernels", {}).items()
        speeds = tuple(_speed(kernel, peers, places[name]) for name, kernel in listed if name in places)
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise DamagedEvidence(f"{TIMES}: {type(error).__name__}: {error}") from error
    try:
        found = {name: tuple(_found(each)) for name, each in errors.get("kernels", {}).items() if name in places}
        curves = tuple(_curve(name, each) for name, each in errors.get("curves", {}).items() if name in places)
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise DamagedEvidence(f"{ERRORS}: {type(error).__name__}: {error}") from error
    return Measured(where, speeds, found, curves)


def _read(evidence: Mapping[str, str], name: str) -> Mapping[str, Any]:
    try:
        found: Mapping[str, Any] = json.loads(evidence.get(name, "{}"))
    except ValueError as error:
        raise DamagedEvidence(f"{name}: {error}") from error
    if not isinstance(found, dict):
        raise DamagedEvidence(f"{name}: it holds no table")
    return found


def _where(machine: Mapping[str, Any]) -> str:
    """The machine and the day, in a line."""
    versions: Mapping[str, str] = machine["versions"]
    loops = machine["instructions"] or machine["backend"]
    return (
        f"{machine['date']}; {machine['processor']}, {machine['cores']} cores; {machine['compiler']}; "
        f"NumPy {versions['numpy']}; loops for {loops}"
    )


def _speed(kernel: Mapping[str, Any], peers: Mapping[str, str], place: str) -> tuple[Link, tuple[str, ...]]:
    """A kernel compared with what one would use instead: times in ns per element, ratios and errors as text."""
    times: Mapping[str, float] = kernel["ns"].get(TEN_THOUSAND, {})
    generated = {peer: ns for peer, ns in times.items() if peer not in NOT_GENERATED}
    best = min(generated, key=lambda peer: generated[peer], default="")
    return Link(f"#{place}", kernel["title"]), (
        _number(times.get(OURS)),
        f"{_number(generated[best])} {peers[best]}" if best else "",
        _number(times.get(PRINTED)),
        _faster(kernel, TEN_THOUSAND),
        _faster(kernel, A_MILLION),
        _worst(kernel["errors"], OURS),
        _worst(kernel["errors"], PRINTED),
    )


def _faster(kernel: Mapping[str, Any], size: str) -> str:
    found = kernel["times_faster"].get(size)
    return f"{found['ratio']:.2f}" if found else ""


def _worst(regions: Mapping[str, Mapping[str, float | None]], name: str) -> str:
    """The largest error over all regions, in units of roundoff."""
    found = [region[name] for region in regions.values() if name in region]
    if not found:
        return ""
    return _number(max(inf if error is None else error for error in found))


def _number(value: float | None) -> str:
    if value is None:
        return ""
    if not isfinite(value) or value >= 2**53:
        return "lost"
    return f"{value:.0f}" if 100 <= value < 1e5 else f"{value:.3g}"


def _found(kernel: Mapping[str, Any]) -> Iterator[str]:
    """The largest error of each result, in the measure of what is proved of it, in both precisions."""
    for result in kernel["proved"]:
        units = [kernel[precision].get(result, {}).get("proved", {}).get("units") for precision in PRECISIONS]
        if None not in units:
            lead = f"{result}: " if len(kernel["proved"]) > 1 else ""
            yield f"{lead}found {_number(units[0])} u, in single precision {_number(units[1])} u"


def _curve(name: str, data: Mapping[str, Any]) -> ErrorCurve:
    places = tuple(_place(point) for point in data["points"] if (point["ours"], point["as_typed"]) != (None, None))
    if not places:
        raise ValueError(f"there are no errors of {name}")
    return ErrorCurve(name, str(data["title"]), places)


def _place(point: Mapping[str, Any]) -> ErrorAtAngle:
    near_pi = NEAR_PI in point
    ours, typed = (inf if point[key] is None else float(point[key]) for key in ("ours", "as_typed"))
    return ErrorAtAngle(near_pi, float(point[NEAR_PI if near_pi else "phi"]), ours, typed)
