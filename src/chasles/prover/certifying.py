"""Certificates: the cofactors that prove an equation, as text for the checker, and the hypotheses that they use."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from chasles.algebra.groebner import Combination, stated
from chasles.algebra.localization import Ratio
from chasles.algebra.rings import Polynomial, factors_text, written
from chasles.points.evaluation import measured
from chasles.problems.context import Context
from chasles.problems.generators import Generator
from chasles.prover.conditions import Solved
from chasles.statements import Goal, Hypothesis
from chasles.statements.conditions import ASSUMED
from chasles.verdict import Holds, HoldsUnder, Verdict

UNSAID = ("given", *ASSUMED, "direction", "evident")
"""Hypotheses that are no conditions: they say again what is given, or hold whatever symbols stand for."""


@dataclass(slots=True)
class ProvedEntry:
    """One entry of one goal: what must vanish, and how it was found to.

    `by_division` says that the stated hypotheses, each divided by in turn, leave nothing of it: a checker can divide,
    unless it was `multiplied` by what does not vanish before.
    """

    goal: Goal
    label: str
    place: tuple[int, int]
    ratio: Ratio
    cofactors: Combination | None = None
    by_division: bool = False
    multiplied: bool = False


def proved(
    needs: tuple[str, ...], certificate: Mapping[str, Any], witness: Mapping[str, Any], unused: tuple[str, ...] = ()
) -> Holds | HoldsUnder:
    """The verdict on what is proved, from the hypotheses that it needs if it needs any."""
    return HoldsUnder(needs, certificate, witness, unused) if needs else Holds(certificate, witness, unused)


def certified(
    context: Context,
    conditions: tuple[Generator, ...],
    solved: tuple[Solved, ...],
    done: list[ProvedEntry],
    own: tuple[Hypothesis, ...],
    witness: Mapping[str, Any],
    write: Callable[[Context, list[ProvedEntry], Mapping[str, Any]], dict[str, Any]] | None = None,
) -> Verdict:
    """The verdict on a problem all of whose entries were found to vanish; of its `own` hypotheses, those not needed.

    `write` says how its certificate is written, where that is not as for what is declared.
    """
    unused = _drop_unneeded(context, solved, done, own)
    used = _used_hypotheses(context, solved, done)
    said = (h.text for h in context.problem.hypotheses if h in used and h.kind not in UNSAID)
    needs = tuple(dict.fromkeys(said))
    if write is not None:
        certificate = write(context, done, witness)
    else:
        certificate = _certificate(context, conditions, solved, done, witness)
    return proved(needs, certificate, measured(context, witness), unused)


def _used_hypotheses(context: Context, solved: tuple[Solved, ...], done: list[ProvedEntry]) -> set[Hypothesis]:
    places = _used_generators(solved, done)
    used = {h for k in places if (h := context.generators[k].hypothesis) is not None}
    used |= set(context.problem.presupposed)
    denominators = [e.ratio.denominator for e in done] + [s.value.denominator for s in solved]
    for place, (hypothesis, _) in enumerate(context.nonzero):
        if hypothesis is not None and any(len(d) > place and d[place] for d in denominators):
            used.add(hypothesis)
    return used


def _used_generators(solved: tuple[Solved, ...], done: list[ProvedEntry]) -> set[int]:
    return {k for entry in done for k in (entry.cofactors or {})} | {k for s in solved for k in s.cofactors}


def _drop_unneeded(
    context: Context, solved: tuple[Solved, ...], done: list[ProvedEntry], own: tuple[Hypothesis, ...]
) -> tuple[str, ...]:
    """Do without each hypothesis in turn where that is possible; the statement's own that are not needed, by name."""
    ring = context.field.ring
    dropped: set[Hypothesis] = set()
    in_solved = {h for s in solved for k in s.cofactors if (h := context.generators[k].hypothesis) is not None}
    for hypothesis in context.active:
        if not hypothesis.equations or hypothesis in in_solved:
            continue
        kept = [
            k
            for k, g in enumerate(context.generators)
            if g.hypothesis is None or g.hypothesis not in dropped | {hypothesis}
        ]
        explicit = {k for k, _, _ in context.basis.explicit}
        values = [place for place, k in enumerate(kept) if k in explicit]
        basis = stated(ring, tuple(context.generators[k].polynomial for k in kept), complete=False, values=values)
        attempts = [basis.reduce(entry.ratio.numerator) for entry in done]
        if all(remainder == 0 for _, remainder in attempts):
            dropped.add(hypothesis)
            for entry, (cofactors, _) in zip(done, attempts, strict=True):
                entry.cofactors = {kept[k]: c for k, c in cofactors.items()}
                entry.by_division = not (values or entry.multiplied)
    used = {h.text for h in _used_hypotheses(context, solved, done)}
    return tuple(h.text for h in own if h.text not in used)


def _certificate(
    context: Context,
    conditions: tuple[Generator, ...],
    solved: tuple[Solved, ...],
    done: list[ProvedEntry],
    witness: Mapping[str, Any],
) -> dict[str, Any]:
    """What a checker needs, as text.

    `division` is by which hypotheses to divide, in this order, and for which of its terms each is solved. Cofactors,
    on the stated hypotheses and conditions by name, are there only for what division alone does not show. What is
    divided by, and the conditions, are numbered in the order in which the problem declares them.
    """
    ring = context.field.ring
    nonzero = _factor_labels(context)

    def said(denominator: tuple[int, ...], cofactors: Mapping[str, Polynomial]) -> dict[str, Any]:
        powers = {label: power for label, power in zip(nonzero, denominator, strict=False) if power}
        texts = {label: written(ring, cofactor) for label, cofactor in cofactors.items()}
        return ({"denominator": powers} if powers else {}) | ({"cofactors": texts} if texts else {})

    divisors = [context.generators[k] for k in sorted(_used_generators(solved, [e for e in done if e.by_division]))]
    certificate: dict[str, Any] = {
        "division": [[g.label, factors_text(ring, ring.leading(g.polynomial)[0])] for g in divisors],
        "solved": {
            s.variable: {"numerator": written(ring, s.value.numerator)}
            | said(s.value.denominator, {f"{k + 1}. {conditions[k].label}": c for k, c in s.conditions.items()})
            for s in solved
        },
        "entries": {
            e.label: said(e.ratio.denominator, {context.generators[k].label: c for k, c in (e.cofactors or {}).items()})
            for e in done
            if not e.by_division
        },
    }
    shown = {part: content for part, content in certificate.items() if content}
    return shown | {"witness": {name: str(value) for name, value in sorted(witness.items())}}


def _factor_labels(context: Context) -> list[str]:
    divisors = [h for h in context.problem.hypotheses for _ in h.nonvanishing]
    labels = []
    for hypothesis, _ in context.nonzero:
        assert hypothesis is not None
        labels.append(f"{divisors.index(hypothesis) + 1}. {hypothesis.text}")
    return labels
