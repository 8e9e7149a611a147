"""Several changes at once: the fewest terms that must be changed, left out or added, block by block.

Where all angles are fixed, coefficients are mere numbers. There it is seen quickly which sets of terms can close the gap
between the sides; for these few, the coefficients are then found as functions of the angles.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, product

from chasles.proof.ansatz import Palette
from chasles.proof.coefficients import added as added_up
from chasles.proof.coefficients import spelled, times
from chasles.proof.deadline import check
from chasles.proof.linear import Column, Span, multiple, plus
from chasles.proof.places import Place, put, separate_sums, with_term
from chasles.proof.residues import Sampled
from chasles.proof.single import (
    LEFT_OUT,
    Change,
    Coefficient,
    distinct_terms,
    fitted,
    instead,
    missing,
    new_term,
    other_coefficient,
)
from chasles.proof.trial import Trial
from chasles.vocabulary import Node, plain

__all__ = ["combined_changes"]

MOST_CHANGES = 6
MOST_SETS, MOST_IN_ALL = 3000, 60000
"""So many sets of new terms are looked at for one choice of terms to change, and so many in all."""


@dataclass(slots=True)
class _Sum:
    """A sum of the right side that no other block depends on: its terms, their cores, and what could be added to it."""

    place: Place
    terms: tuple[Place, ...]
    cores: tuple[Node | None, ...]
    new: tuple[Node, ...]

    def columns(self, trial: Trial, at: Sampled) -> tuple[list[Column], list[Column], list[Column]]:
        """What the terms, their cores and the new terms contribute."""
        shares = [trial.share(at, term) for term in self.terms]
        cores = [
            share if core is None else trial.share(at, term, core)
            for term, core, share in zip(self.terms, self.cores, shares, strict=True)
        ]
        return shares, cores, [trial.share(at, self.place, term) for term in self.new]


def combined_changes(trial: Trial, palette: Palette) -> Iterator[Change]:
    """The right sides that are true after the least number of changes to terms, if it is not large."""
    sums = [_sum(trial, place, terms, palette) for place, terms in separate_sums(trial.right)]
    choices: list[list[_Edits]] = []
    for each in sums:
        found = _fewest(trial, each)
        if found is None:
            return
        choices.append(found)
    for edits in product(*choices):
        right, words = trial.right, []
        for each, edit in sorted(zip(sums, edits, strict=True), key=lambda pair: pair[0].place.path, reverse=True):
            right = put(right, each.place.path, edit.node)
            words[:0] = edit.words
        if words:
            yield Change(trial.left, right, tuple(words), sum(edit.effort for edit in edits))


@dataclass(frozen=True, slots=True)
class _Edits:
    node: Node
    words: tuple[str, ...] = ()
    effort: int = 0


def _sum(trial: Trial, place: Place, terms: tuple[Place, ...], palette: Palette) -> _Sum:
    cores = tuple(trial.split(term.node).core for term in terms)
    return _Sum(place, terms, cores, distinct_terms(trial, palette.terms(place.node), cores))


def _fewest(trial: Trial, each: _Sum) -> list[_Edits] | None:
    """The edits that close the gap where the sum contributes, all of the least number; None if there are none."""
    shares, cores, new = each.columns(trial, trial.fixed)
    inside = [any(entries) for entries in zip(*shares, *cores, *new, strict=True)]
    gap = _within(trial.gap(trial.fixed), inside)
    if not any(gap):
        return [_Edits(each.place.node)]
    whole = Span([*cores, *new])
    if any(whole.reduced(gap)):
        return None
    brief = lambda column: [column[pivot] for pivot in whole.pivots]  # noqa: E731
    found: list[_Edits] = []
    for sets in _sets(brief(gap), [*map(brief, shares)], [*map(brief, cores)], [*map(brief, new)]):
        for kept, added in sets:
            edits = _edited(trial, each, kept, added)
            if edits is not None:
                found.append(edits)
        if found:
            return found
    return None


def _within(column: Column, inside: Sequence[bool]) -> Column:
    return [entry if here else 0 for entry, here in zip(column, inside, strict=True)]


_Set = tuple[tuple[int, ...], tuple[int, ...]]


def _sets(gap: Column, shares: list[Column], cores: list[Column], new: list[Column]) -> Iterator[list[_Set]]:
    """For each number of changes in turn: which terms to change and which to add so that the gap can be closed."""
    looked_at = 0
    for total in range(1, MOST_CHANGES + 1):
        sets: list[_Set] = []
        for size in range(min(total, len(cores)), -1, -1):
            if len(new) ** (total - size) > MOST_SETS:
                break
            for chosen in combinations(range(len(cores)), size):
                looked_at += len(new) ** (total - size)
                if looked_at > MOST_IN_ALL:
                    return
                span = Span(cores[k] for k in chosen)
                if not span.independent:
                    continue
                rest = gap
                for k in chosen:
                    rest = plus(rest, shares[k])
                reduced = [span.reduced(column) for column in new]
                sets += [(chosen, added) for added in _covers(span.reduced(rest), reduced, total - size)]
        yield sets


def _covers(gap: Column, columns: list[Column], size: int, first: int = 0) -> Iterator[tuple[int, ...]]:
    """The sets of so many columns of which every one is needed to make up the gap."""
    if size == 0:
        if not any(gap):
            yield ()
        return
    check()
    if not any(gap):
        return
    for k in range(first, len(columns)):
        if not any(columns[k]):
            continue
        if size == 1:
            if multiple(gap, columns[k]) is not None:
                yield (k,)
            continue
        span = Span([columns[k]])
        rest = [span.reduced(column) for column in columns[k + 1 :]]
        yield from ((k, *(k + 1 + j for j in more)) for more in _covers(span.reduced(gap), rest, size - 1))


def _kept(found: list[Coefficient], chosen: tuple[int, ...], term: int) -> Iterator[bool]:
    """Whether a printed term stays: with everything printed left out there is nothing that was repaired."""
    if term not in chosen:
        yield True
    else:
        yield from (value != 0 for value, _ in found[chosen.index(term)])


def _edited(trial: Trial, each: _Sum, chosen: tuple[int, ...], added: tuple[int, ...]) -> _Edits | None:
    """The sum with the coefficients that close the gap; None if these are no functions that occur."""
    at = trial.varied
    places = [each.terms[k] for k in chosen]
    cores = [trial.share(at, place, each.cores[k]) for k, place in zip(chosen, places, strict=True)]
    new = [trial.share(at, each.place, each.new[k]) for k in added]
    columns = [*cores, *new]
    wanted = trial.gap(at)
    for place in places:
        wanted = plus(wanted, trial.share(at, place))
    found = fitted(trial, columns, _within(wanted, [any(entries) for entries in zip(*columns, strict=True)]))
    if found is None or not any(value for k in range(len(each.terms)) for value in _kept(found, chosen, k)):
        return None
    return _written(each, dict(zip(chosen, found, strict=False)), dict(zip(added, found[len(chosen) :], strict=True)))


def _written(each: _Sum, changed: dict[int, Coefficient], new: dict[int, Coefficient]) -> _Edits | None:
    """The sum with other coefficients of some terms and with new terms; None if one of these turns out to be zero."""
    nodes: list[Node] = []
    words: list[str] = []
    for k, place in enumerate(each.terms):
        coefficient = spelled(changed[k]) if k in changed else None
        if coefficient is not None:
            nodes.append(times(coefficient, each.cores[k]))
            words.append(instead(nodes[-1], place.node))
        elif k in changed:
            words.append(f"the term {plain(place.node)} is left out")
        else:
            nodes.append(place.node)
    for k, parts in new.items():
        coefficient = spelled(parts)
        if coefficient is None:
            return None
        nodes.append(times(coefficient, each.new[k]))
        words.append(missing(nodes[-1]))
    left_out = sum(LEFT_OUT for parts in changed.values() if not any(value for value, _ in parts))
    effort = sum(map(other_coefficient, changed.values())) + sum(map(new_term, new.values())) + left_out
    return _Edits(added_up(nodes), tuple(words), effort)
