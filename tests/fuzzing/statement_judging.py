"""Is the decision on a declared statement right? By values at motions of our own, and at the point that it shows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import islice
from random import Random
from typing import Any

from chasles import vocabulary as w
from chasles.statements import Definite, Iff, Minimum, Theorem

from .asking import Answer, ask_statement, statement_rejection
from .judging import FAR, POINTS, Alarm, Judged
from .node_values import Words
from .series import Undefined, mp, mpf
from .statements import Asked, Motion, goals, motions, symbols_in

__all__ = ["judge_statement", "violations_of"]


def judge_statement(asked: Asked, draw: Random) -> Judged:
    """Decide it, and hold the verdict against the values of all sides."""
    answer = ask_statement(asked.statement)
    if answer.name == "crash":
        return Judged(answer, Alarm("crash", answer.words))
    if answer.name in ("undecided", "untreatable"):
        return Judged(answer, None)
    seen = list(islice(motions(asked, draw, 2 * POINTS), POINTS))
    return Judged(answer, next(_alarms(asked, answer, seen, draw), None), len(seen))


def _alarms(asked: Asked, answer: Answer, seen: list[Motion], draw: Random) -> Iterator[Alarm]:
    violated = next(violations_of(asked, seen), None)
    if answer.name == "contradictory":
        if seen and not any(isinstance(form, Iff) for form in getattr(asked.statement, "forms", ())):
            # An equivalence needs points where what it speaks of vanishes, not just any.
            yield Alarm("false contradictory", f"satisfied at {_shown(seen[0])}")
        return
    if answer.name == "ill-formed":
        if "divides by" not in answer.verdict.reason:
            yield Alarm("ill-formed", answer.verdict.reason)
        return
    if asked.satisfiable is False and not seen:
        yield Alarm("verdict on nothing", f"nothing satisfies what is assumed, and the verdict is {answer.name}")
    if answer.true and violated:
        yield Alarm("false holds", violated)
    if answer.name == "fails":
        if asked.truth is True and not violated:
            at = dict(answer.verdict.counterexample.at)
            yield Alarm("false fails", f"it is true by construction; said to fail at {_plain(at)}")
        yield from _false_fails(asked, answer, len(seen), violated, draw)
    reason = statement_rejection(asked.statement, answer.verdict)
    if reason is not None:
        yield Alarm("own certificate rejected", reason)


def violations_of(asked: Asked, seen: list[Motion]) -> Iterator[str]:
    """Where an equation, or what a minimum or a sum of squares says, is not so."""
    for motion in seen:
        for label, left, right in goals(asked.statement):
            values = _both(motion, left, right)
            for a, b in values or ():
                if abs(a - b) > FAR * (1 + abs(a) + abs(b)):
                    yield f"{label}: {mp.nstr(a, 8)} and {mp.nstr(b, 8)} at {_shown(motion)}"
        for form in asked.statement.forms if isinstance(asked.statement, Theorem) else ():
            low = form.of - form.value if isinstance(form, Minimum) else form.of if isinstance(form, Definite) else None
            if low is not None and motion.scalar(low) < -FAR:
                yield f"{low} is negative at {_shown(motion)}"


def _both(words: Words, left: w.Node, right: w.Node) -> list[tuple[Any, Any]] | None:
    try:
        sides = words(left), words(right)
    except Undefined:
        return None
    return [(a[0], b[0]) for r, s in zip(*sides, strict=True) for a, b in zip(r, s, strict=True)]


def _false_fails(asked: Asked, answer: Answer, seen: int, violated: str | None, draw: Random) -> Iterator[Alarm]:
    shown = answer.verdict.counterexample
    found = 0
    fixed, extra = _read(asked, shown.at)
    for motion in islice(motions(asked, draw, 4, fixed, extra), 2):
        found += 1
        row, column = shown.entry
        sides = [(left, right) for label, left, right in goals(asked.statement) if label == shown.goal]
        try:
            pairs = [(motion(one)[row - 1][column - 1][0], motion(two)[row - 1][column - 1][0]) for one, two in sides]
        except Undefined:
            yield Alarm("bad counterexample", f"a side is undefined at {_plain(shown.at)}")
            continue
        if all(abs(a - b) < FAR * (1 + abs(a)) for a, b in pairs):
            yield Alarm("bad counterexample", f"the sides are equal at {_plain(shown.at)}")
    if not found:
        kind = "bad counterexample" if violated or not seen else "false fails"
        yield Alarm(kind, f"what is given and assumed is not satisfied at {_plain(shown.at)}")


def _read(asked: Asked, at: Mapping[str, Any]) -> tuple[dict[Any, Any], tuple[tuple[w.Node, Any], ...]]:
    """Coordinates by the names that a counterexample has for them."""
    symbols = {s.name: s for s in symbols_in(asked)}
    sides = [side for _, *pair in goals(asked.statement) for side in pair]
    sides += [side for pair in asked.equations for side in pair]
    norms = {str(node): node for side in sides for node in w.walk(side) if isinstance(node, w.Norm)}
    norms |= {f"|{s.name}|": w.norm(s) for s in symbols.values() if s.shape == (3, 1)}
    fixed: dict[Any, Any] = {}
    extra: list[tuple[w.Node, Any]] = []
    angles: dict[str, dict[str, Any]] = {}
    for name, value in at.items():
        number = mpf(value.numerator) / value.denominator
        if match := re.fullmatch(r"(cos|sin)\((\d*)(\w+?)(?:/(\d+))?\)", name):
            function, above, symbol, below = match.groups()
            unit = mpf(int(above or 1)) / int(below or 1)
            angles.setdefault(symbol, {"unit": unit})[function] = number
        elif name in norms:
            extra.append((norms[name], number))
        else:
            fixed[_place(symbols, name)] = number
    for symbol, known in angles.items():
        cosine, sine = known.get("cos"), known.get("sin")
        cosine = mp.sqrt(abs(1 - sine**2)) if cosine is None else cosine
        sine = mp.sqrt(abs(1 - cosine**2)) if sine is None else sine
        fixed.setdefault((symbols[symbol], 0, 0, 0), mp.atan2(sine, cosine) / known["unit"])
    return fixed, tuple(extra)


def _place(symbols: Mapping[str, w.Symbol], name: str) -> tuple[w.Symbol, int, int, int]:
    for stem, symbol in symbols.items():
        match = re.fullmatch(rf"{re.escape(stem)}(?:_(d+)ot)?(?:_(\d)(\d)?)?", name)
        if match and (symbol.is_scalar or match[2]):
            dots, i, j = match.groups()
            return symbol, len(dots or ""), int(i or 1) - 1, int(j or 1) - 1
    raise KeyError(f"the counterexample names {name}, which is no coordinate of {sorted(symbols)}")


def _plain(at: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in at.items())


def _shown(motion: Motion) -> str:
    return "; ".join(
        f"{s.name}: {[[mp.nstr(x, 5) for x in entry[:3]] for row in entries for entry in row]}"
        for s, entries in motion.symbols.items()
    )
