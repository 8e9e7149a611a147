"""Slips planted one at a time in the claims of a chapter, and what the search for repairs makes of them.

`python -m tests.planted tests/arms/ --each 2` says, kind by kind, how many of the mutants that are false are repaired,
for how many the original comes first, and what that takes. The sample is fixed: of each kind so many mutants, spread
over all claims and places.
"""

from __future__ import annotations

import sys
from argparse import ArgumentParser
from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from random import Random
from statistics import median
from time import process_time

from chasles.deciding import decided
from chasles.decisions.session import Session
from chasles.repairs.repair import Repair, repair
from chasles.statements import Chapter, Claim, Statement, load, problem_of
from chasles.statements.premises import with_all_premises
from chasles.verdict import Fails
from chasles.vocabulary import Block, Misfit, Negative, Node, Number, Scale, Sum, children, plain
from chasles.vocabulary.sizes import sizes_of

from .meaning import Meaning
from .mutation import Mutant, mutants_of

__all__ = ["Outcome", "outcome_of", "planted", "table"]


@dataclass(frozen=True)
class Planted:
    """A false mutant of a true claim, and where the slip is: `inside` an entry of a matrix or elsewhere."""

    original: Claim
    mutant: Mutant
    session: Session

    @cached_property
    def meaning(self) -> Meaning:
        """What the words of the original mean."""
        return Meaning.of(problem_of(self.original, "printed", self.session.accepted))

    @property
    def kind(self) -> str:
        return self.mutant.change.slip

    @property
    def inside(self) -> bool:
        """Whether the slip is inside an entry of a matrix or column."""
        place = 0 if self.mutant.where == "left side" else 1
        return _in_block(self.original.printed[place], self.mutant.statement.printed[place])


def _in_block(old: Node, new: Node, within: bool = False) -> bool:
    """Whether all in which two expressions differ is inside one entry of a block."""
    one, other = children(old), children(new)
    differing = [(a, b) for a, b in zip(one, other, strict=False) if a != b]
    if type(old) is not type(new) or len(one) != len(other) or len(differing) != 1:
        return within
    return _in_block(*differing[0], within or isinstance(old, Block))


@dataclass(frozen=True, slots=True)
class Outcome:
    """What was found for a mutant: the place of the original among the repairs, if it is there, and seconds spent."""

    planted: Planted
    repairs: tuple[Repair, ...]
    place: int | None
    seconds: float

    def __str__(self) -> str:
        said = "; ".join(self.repairs[0].changes) if self.repairs else "no repair"
        place = "-" if self.place is None else str(self.place + 1)
        return f"{self.seconds:6.2f} s  {place:>2} of {len(self.repairs)}  {self.planted.mutant}  ==> {said}"


def planted(chapter: Chapter, session: Session, each: int, seed: int = 1) -> Iterator[Planted]:
    """Of each kind of slip, inside entries and elsewhere, so many mutants that are false, from all claims in turn."""
    draw = Random(seed)
    found: dict[tuple[str, bool], dict[str, list[Planted]]] = defaultdict(lambda: defaultdict(list))
    for entry in chapter:
        claim = entry.statement
        if isinstance(claim, Claim) and claim.solves is None and session.decide(claim).verdict.true:
            for mutant in mutants_of(claim, "printed", []):
                case = Planted(claim, mutant, session)
                found[case.kind, case.inside][entry.name].append(case)
    for _, of_claims in sorted(found.items()):
        for mutants in of_claims.values():
            draw.shuffle(mutants)
        names = list(of_claims)
        draw.shuffle(names)
        turns = max(map(len, of_claims.values()))
        in_turn = (of_claims[name][k] for k in range(turns) for name in names if k < len(of_claims[name]))
        yield from _first(in_turn, each, session)


def _first(mutants: Iterable[Planted], count: int, session: Session) -> Iterator[Planted]:
    """So many of the mutants that are false."""
    for each in mutants:
        if count and _is_false(each.mutant.statement, session):
            count -= 1
            yield each
        if not count:
            return


def _is_false(mutant: Statement, session: Session) -> bool:
    try:
        verdict = decided(problem_of(mutant, "printed", session.accepted), mutant.assuming)
    except (Misfit, TypeError):
        return False
    return isinstance(verdict, Fails)


def outcome_of(case: Planted, chapter: Chapter, session: Session) -> Outcome:
    """What the search makes of a mutant, told nothing but what comes before its original in the chapter."""
    statements = [entry.statement for entry in chapter]
    before = [s for s in statements[: statements.index(case.original)] if isinstance(s, Statement)]
    started = process_time()
    posed = case.mutant.statement, with_all_premises(case.mutant.statement, session.accepted)  # as a session searches
    found = (repair(said, session.accepted, context=before) for said in dict.fromkeys(posed) if isinstance(said, Claim))
    repairs: tuple[Repair, ...] = next(filter(None, found), ())
    seconds = process_time() - started
    same = (k for k, each in enumerate(repairs) if _says(each, case))
    return Outcome(case, repairs, next(same, None), seconds)


def _says(found: Repair, case: Planted) -> bool:
    """Whether a repair says what the original says, or a multiple of it, whatever its letters are."""
    sides = case.original.printed
    shown, sized = (found.left, found.right), bool(sizes_of(sides))
    meaning = plain if sized else case.meaning.of_words
    if all(meaning(a) == meaning(b) for a, b in zip(shown, sides, strict=True)):
        return True
    if sized or not all(isinstance(meaning(side), tuple) for side in sides):
        multiples = ([Scale(Number(times), side) for side in sides] for times in map(Fraction, ("1", "-1", "2", "1/2")))
        return any(all(_same_in_words(a, b, case) for a, b in zip(shown, said, strict=True)) for said in multiples)
    try:
        one, other = (Sum((left, Negative(right))) for left, right in ((found.left, found.right), sides))
    except Misfit:
        return False
    return _multiples([(meaning(one), meaning(other))]) or _multiples(
        [(meaning(found.left), meaning(sides[0])), (meaning(found.right), meaning(sides[1]))]
    )


def _same_in_words(one: Node, other: Node, case: Planted) -> bool:
    """Whether two expressions are proved equal by what the claim assumes, where they have no values at free points."""
    try:
        return (
            plain(one) == plain(other)
            or decided(problem_of(Claim("0", one, other, assuming=case.original.assuming))).true
        )
    except (Misfit, TypeError):
        return False


def _multiples(pairs: list[tuple[Hashable, Hashable]]) -> bool:
    """Whether each entry of the first expressions is a number times that of the second, at all points the same one."""
    if not all(isinstance(one, tuple) and isinstance(other, tuple) for one, other in pairs):
        return False
    entries: dict[tuple[int, int], list[tuple[Fraction, Fraction]]] = defaultdict(list)
    for one, other in pairs:
        for here, there in zip(one, other, strict=True):  # type: ignore[call-overload]
            for i, row in enumerate(here):
                for j, entry in enumerate(row):
                    entries[i, j].append((entry, there[i][j]))
    wanted = [values for values in entries.values() if any(there for _, there in values)]
    return bool(wanted) and all(_ratio(values) for values in entries.values())


def _ratio(values: list[tuple[Fraction, Fraction]]) -> bool:
    """Whether the first are one number times the second, or both zero."""
    ratios = {here / there for here, there in values if there}
    return all(not here for here, there in values if not there) and len(ratios) <= 1 and 0 not in ratios


def table(outcomes: list[Outcome]) -> Iterator[str]:
    """How many are repaired, and how many with the original first, by kind and in all; the median time."""
    kinds: dict[str, list[Outcome]] = defaultdict(list)
    for each in outcomes:
        kinds[each.planted.kind + (", in an entry" if each.planted.inside else "")].append(each)
    yield f"{'kind of slip':42} {'false':>5} {'repaired':>9} {'first':>9} {'among':>9} {'median':>8} {'worst':>8}"
    for name, found in chain(sorted(kinds.items()), [("in all", outcomes)]):
        repaired = sum(bool(each.repairs) for each in found)
        first = sum(each.place == 0 for each in found)
        among = sum(each.place is not None for each in found)
        shares = " ".join(f"{100 * n / len(found):7.1f} %" for n in (repaired, first, among))
        times = [each.seconds for each in found]
        yield f"{name:42} {len(found):5} {shares} {median(times):6.2f} s {max(times):6.2f} s"


def main(arguments: list[str]) -> None:
    parser = ArgumentParser(prog="python -m tests.planted", description=__doc__)
    parser.add_argument("chapter", help="the package of a chapter, or its folder with a slash")
    parser.add_argument("--each", type=int, default=3, help="so many mutants of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", default="", help="only kinds whose name begins so")
    asked = parser.parse_args(arguments)
    chapter = load(asked.chapter)
    session = Session()
    outcomes = []
    for case in planted(chapter, session, asked.each, asked.seed):
        if case.kind.startswith(asked.kind):
            outcomes.append(outcome_of(case, chapter, session))
            sys.stdout.write(f"{outcomes[-1]}\n")
            sys.stdout.flush()
    sys.stdout.write("\n".join(table(outcomes)) + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])
