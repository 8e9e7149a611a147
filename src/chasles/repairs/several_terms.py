"""Several changes at once: the fewest terms that must be changed, left out or added, block by block.

Where all angles are fixed, coefficients are numbers, and linear algebra tells which sets of terms can make the residual
zero; for these few sets, the coefficients are then found as functions of the angles.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, combinations, product
from math import comb

from chasles.algebra.modular import Column, Span, multiple, plus, rational
from chasles.algebra.work_limit import check
from chasles.repairs.modular_testing import REFUSED, ModularTest
from chasles.repairs.one_term import (
    LEFT_OUT,
    Change,
    Coefficient,
    distinct_terms,
    fitted,
    instead,
    missing,
    new_term,
    other_coefficient,
    other_number,
    rescaled,
)
from chasles.repairs.residues import Sampled
from chasles.repairs.single_edits import in_letters, single_edits
from chasles.rewriting.coefficients import ONE, added, spelled, times
from chasles.rewriting.places import Place, put, separate_sums
from chasles.rewriting.term_basis import TermBasis, fit
from chasles.vocabulary import Node, Symbol, plain

MOST_CHANGES = 6
MOST_SETS, MOST_IN_ALL = 5000, 60000
"""So many sets of new terms are looked at for one choice of terms to change, and so many in all."""
MOST_FORMS = 6
"""So many forms of one block are given, those of the least effort."""
_Set = tuple[tuple[int, ...], tuple[int, ...]]
_Term = tuple[Node | None, str | None, int]
"""A term in the place of a printed one, None for none; the change in words, and its effort."""


@dataclass(slots=True)
class _Sum:
    """A sum of the right side that no other block depends on: its terms, their cores, and what could be added to it.

    The `letters` are those that its terms can have been meant to have.
    """

    place: Place
    terms: tuple[Place, ...]
    cores: tuple[Node, ...]
    new: tuple[Node, ...]
    letters: tuple[Symbol, ...]

    def columns(self, test: ModularTest, at: Sampled) -> tuple[list[Column], list[Column], list[Column]]:
        """What the terms, their cores and the new terms contribute."""
        contributions = [test.contribution(at, term) for term in self.terms]
        cores = [test.contribution(at, term, core) for term, core in zip(self.terms, self.cores, strict=True)]
        return contributions, cores, [test.contribution(at, self.place, term) for term in self.new]


def combined_changes(test: ModularTest, basis: TermBasis) -> Iterator[Change]:
    """The right sides that are true after the least number of changes to terms, if it is not large."""
    sums = [_sum(test, place, terms, basis) for place, terms in separate_sums(test.right)]
    choices: list[list[_Edits]] = []
    for each in sums:
        found = _fewest(test, each)
        if found is None:
            return
        choices.append(found)
    for edits in product(*choices):
        right = test.right
        for each, edit in zip(sums, edits, strict=True):
            right = put(right, each.place.path, edit.node)
        words = tuple(word for edit in edits for word in edit.words)
        if words:
            yield Change(test.left, right, words, sum(edit.effort for edit in edits))


@dataclass(frozen=True, slots=True)
class _Edits:
    node: Node
    words: tuple[str, ...] = ()
    effort: int = 0


def _sum(test: ModularTest, place: Place, terms: tuple[Place, ...], basis: TermBasis) -> _Sum:
    cores = tuple(ONE if (core := test.split(term.node).core) is None else core for term in terms)
    letters = tuple(node for node in basis.nodes if isinstance(node, Symbol))
    return _Sum(place, terms, cores, distinct_terms(test, basis.terms(place.node), cores), letters)


def _fewest(test: ModularTest, each: _Sum) -> list[_Edits] | None:
    """The edits that make the residual zero where the sum contributes, as few as possible; None if there are none."""
    contributions, cores, new = each.columns(test, test.fixed)
    inside = [any(entries) for entries in zip(*contributions, *cores, *new, strict=True)]
    residual = _within(test.residual(test.fixed), inside)
    if not any(residual):
        return [_Edits(each.place.node)]
    whole = Span([*cores, *new])
    if any(whole.reduced(residual)):
        return None

    def brief(*columns: Column) -> list[Column]:
        return [[column[pivot] for pivot in whole.pivots] for column in columns]

    for sets in _sets(brief(residual)[0], brief(*contributions), brief(*cores), brief(*new)):
        forms = [form for chosen, extra in sets if (form := _edited(test, each, chosen, extra)) is not None]
        if forms:
            return sorted(forms, key=lambda form: form.effort)[:MOST_FORMS]
    return None


def _within(column: Column, inside: Sequence[bool]) -> Column:
    return [entry if here else 0 for entry, here in zip(column, inside, strict=True)]


def _sets(
    residual: Column, contributions: list[Column], cores: list[Column], new: list[Column]
) -> Iterator[list[_Set]]:
    """For each number of changes in turn: which terms to change and which to add so that the residual can be zero."""
    looked_at = 0
    for total in range(1, MOST_CHANGES + 1):
        sets: list[_Set] = []
        for size in range(min(total, len(cores)), -1, -1):
            ways = comb(len(new), total - size)
            if ways > MOST_SETS:
                break
            for chosen in combinations(range(len(cores)), size):
                looked_at += ways
                if looked_at > MOST_IN_ALL:
                    return
                span = Span(cores[k] for k in chosen)
                if not span.independent:
                    continue
                rest = residual
                for k in chosen:
                    rest = plus(rest, contributions[k])
                reduced = [span.reduced(column) for column in new]
                sets += [(chosen, extra) for extra in _covers(span.reduced(rest), reduced, total - size)]
        yield sets


def _covers(residual: Column, columns: list[Column], size: int) -> Iterator[tuple[int, ...]]:
    """The sets of so many columns of which every one is needed to make up the residual."""
    if size == 0:
        if not any(residual):
            yield ()
        return
    check()
    if not any(residual):
        return
    for k, column in enumerate(columns):
        if not any(column):
            continue
        if size == 1:
            if multiple(residual, column) is not None:
                yield (k,)
            continue
        span = Span([column])
        rest = [span.reduced(column) for column in columns[k + 1 :]]
        yield from ((k, *(k + 1 + j for j in more)) for more in _covers(span.reduced(residual), rest, size - 1))


def _edited(test: ModularTest, each: _Sum, chosen: tuple[int, ...], extra: tuple[int, ...]) -> _Edits | None:
    """The sum with the coefficients that make the residual zero; None if these are no functions that occur.

    None too if nothing that is printed stays: then nothing was repaired.
    """
    at = test.varied
    cores = [test.contribution(at, each.terms[k], each.cores[k]) for k in chosen]
    columns = [*cores, *(test.contribution(at, each.place, each.new[k]) for k in extra)]
    wanted = test.residual(at)
    for k in chosen:
        wanted = plus(wanted, test.contribution(at, each.terms[k]))
    found = fitted(test, columns, _within(wanted, [any(entries) for entries in zip(*columns, strict=True)]))
    if found is None:
        return None
    changed = dict(zip(chosen, found, strict=False))
    stays = len(changed) < len(each.terms) or any(value for parts in changed.values() for value, _ in parts)
    if not stays:
        return None
    terms = {k: _changed(test, each, k, coefficient) for k, coefficient in changed.items()}
    return _written(each, terms, dict(zip(extra, found[len(chosen) :], strict=True)))


def _changed(test: ModularTest, each: _Sum, k: int, coefficient: Coefficient) -> _Term:
    """A term with another coefficient: a number times what is printed, or that with one slip undone, if it is that."""
    place, spelling = each.terms[k], spelled(coefficient)
    if spelling is None:
        return None, f"the term {plain(place.node)} is left out", LEFT_OUT
    new = times(spelling, each.cores[k])
    wanted = test.contribution(test.varied, place, new)
    ratio = multiple(wanted, test.contribution(test.varied, place))
    number = None if ratio is None else rational(ratio)
    if number is not None:
        return *rescaled(place.node, number), other_number(number)
    for edit in chain(in_letters(place.node, each.letters), single_edits(place.node)):
        if fit(edit.node, new) and _contributes(test, place, edit.node, wanted):
            return edit
    return new, instead(new, place.node), other_coefficient(coefficient)


def _contributes(test: ModularTest, place: Place, term: Node, wanted: Column) -> bool:
    """Whether a term contributes what is wanted."""
    try:
        return test.contribution(test.varied, place, term) == wanted
    except REFUSED:
        return False


def _written(each: _Sum, changed: dict[int, _Term], new: dict[int, Coefficient]) -> _Edits | None:
    """The sum with other coefficients of some terms and with new terms; None if one of these turns out to be zero."""
    nodes: list[Node] = []
    words: list[str] = []
    effort = sum(map(new_term, new.values()))
    for k, place in enumerate(each.terms):
        term, said, small = changed.get(k, (place.node, None, 0))
        nodes += [] if term is None else [term]
        words += [] if said is None else [said]
        effort += small
    for k, parts in new.items():
        coefficient = spelled(parts)
        if coefficient is None:
            return None
        nodes.append(times(coefficient, each.new[k]))
        words.append(missing(nodes[-1]))
    return _Edits(added(nodes), tuple(words), effort)
