"""Which derivatives come after the results, by what, and in which shape? Each kind adds results to a program.

Columns are the variables of differentiation, in the order asked for, rows the entries of a result.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from dataclasses import replace as with_fields
from typing import Any

from chasles.compiling.derivatives import Sums, derivatives, pulled_back, pushed_forward
from chasles.compiling.inputs import Input, require_order, require_room, variables_in
from chasles.compiling.results import ResultEntries
from chasles.lowering.builder import Builder
from chasles.lowering.names import Names
from chasles.lowering.program import Argument, Pattern, Program, Result
from chasles.lowering.refusal import LoweringError

MATRICES = ("jacobian", "hessian")


@dataclass(frozen=True, slots=True)
class DerivedResults:
    """The kinds of derivatives, the variables as places among the inputs, and the inputs added after these.

    `patterns` are those of sparse results, by name, where they are known before.
    """

    kinds: tuple[str, ...]
    by: tuple[tuple[int, int], ...]
    coo: bool
    inputs: int
    more: tuple[Argument, ...]
    said: str
    patterns: Mapping[str, Pattern] = field(default_factory=dict)

    @property
    def columns(self) -> tuple[int, ...]:
        """The axis of columns; there is none for one variable."""
        return (len(self.by),) if len(self.by) > 1 else ()

    def patterned(self, program: Program) -> DerivedResults:
        """The same derivatives, sparse where those of the program are."""
        return with_fields(self, patterns={r.name: r.pattern for r in program.results if r.pattern is not None})

    def results(self, build: Builder, results: Sequence[Result]) -> list[Result]:
        """The results and their derivatives, one kind after the other. Raises `LoweringError` where there are none."""
        variables = [build.input(*place) for place in self.by]
        made = {"jacobian": self._jacobians, "hessian": self._hessians, "jvp": self._jvps, "vjp": self._vjp}
        found = [*results, *(each for kind in self.kinds for each in made[kind](build, results, variables))]
        twice = {a.name for k, a in enumerate(found) for b in found[:k] if a.name == b.name}
        if twice:
            raise LoweringError(f"two results would be called {min(twice)}: give other names in outputs")
        return found

    def _jacobians(self, build: Builder, results: Sequence[Result], variables: Sequence[int]) -> Iterator[Result]:
        entries = list(dict.fromkeys(entry for result in results for entry in result.entries))
        rows = dict(zip(entries, derivatives(build, entries, variables), strict=True))
        for result in results:
            shape = (*((math.prod(result.shape),) if result.shape else ()), *self.columns)
            said = f"the derivatives of {result.name}"
            matrix = Result(f"{result.name}_jacobian", shape, said, ())
            yield self._matrix(build, matrix, [rows[entry] for entry in result.entries])

    def _hessians(self, build: Builder, results: Sequence[Result], variables: Sequence[int]) -> Iterator[Result]:
        for result in results:
            if result.shape:
                extents = " x ".join(map(str, result.shape))
                raise LoweringError(f"hessian=True asks for scalars, and {result.name} has {extents} entries")
            [slopes] = derivatives(build, result.entries, variables)
            second = derivatives(build, list(slopes.values()), variables)
            rows: list[Sums[int]] = [{} for _ in variables]
            for row, rates in zip(slopes, second, strict=True):
                for column in (column for column in rates if column >= row):
                    rows[row][column] = rows[column][row] = rates[column]
            said = f"the second derivatives of {result.name}"
            yield self._matrix(build, Result(f"{result.name}_hessian", 2 * self.columns, said, ()), rows)

    def _matrix(self, build: Builder, matrix: Result, rows: Sequence[Sums[int]]) -> Result:
        """The matrix of the rows, or what is not zero in it."""
        said = f"{matrix.meaning} by {self.said}, in their order"
        places = [(row, column) for row in range(len(rows)) for column in range(len(self.by))]
        pattern = tuple(place for place in places if place[1] in rows[place[0]])
        if self.coo:
            pattern = self.patterns.get(matrix.name, pattern)
            if not pattern:
                raise LoweringError(f"coo=True: all entries of {matrix.name} are zero, and none is left")
            places, said = list(pattern), f"{said}: the entries that are not zero by construction"
            matrix = with_fields(matrix, shape=(len(pattern),) if len(pattern) > 1 else ())
        entries = tuple(rows[row].get(column, build.zero) for row, column in places)
        return with_fields(matrix, meaning=said, entries=entries, pattern=pattern)

    def _jvps(self, build: Builder, results: Sequence[Result], variables: Sequence[int]) -> Iterator[Result]:
        tangents = {variable: build.input(self.inputs, entry) for entry, variable in enumerate(variables)}
        for result in results:
            entries = tuple(pushed_forward(build, result.entries, tangents))
            said = f"the Jacobian of {result.name} times the tangent"
            yield with_fields(result, name=f"{result.name}_jvp", meaning=said, entries=entries)

    def _vjp(self, build: Builder, results: Sequence[Result], variables: Sequence[int]) -> Iterator[Result]:
        seeds: dict[int, Sums[int]] = {}
        for place, result in enumerate(results, self.inputs + ("jvp" in self.kinds)):
            for number, entry in enumerate(result.entries):
                cotangent = build.input(place, number)
                seeds[entry] = {0: build.add(seeds[entry][0], cotangent) if entry in seeds else cotangent}
        entries = tuple(sums.get(0, build.zero) for sums in pulled_back(build, seeds, variables))
        name = f"{results[0].name}_vjp" if len(results) == 1 else "vjp"
        yield Result(name, self.columns, "the sum of cotangents times Jacobians", entries)


def derived_from(
    given: Sequence[Input],
    results: Sequence[ResultEntries | Result],
    kinds: Iterable[str] = (),
    wrt: Any = None,
    *,
    coo: bool = False,
) -> DerivedResults:
    """The derivatives of some results, of the kinds asked for, by what `wrt` names among the inputs, else by all.

    Raises `LoweringError` for what is no input, for what comes twice, and where nothing is derived by it.
    """
    kinds = tuple(kinds)
    if wrt is not None and not kinds:
        raise LoweringError("wrt is for derivatives: ask for jacobian=True, hessian=True, jvp=True or vjp=True")
    if coo and not set(kinds) & set(MATRICES):
        raise LoweringError("coo=True is for matrices: ask for jacobian=True or hessian=True, too")
    places = {entry: (k, n) for k, item in enumerate(given) for n, entry in enumerate(item.entries)}
    by = tuple(places.values()) if wrt is None else tuple(_chosen(given, places, wrt))
    if len(set(by)) < len(by):
        twice = next(entry for entry, place in places.items() if by.count(place) > 1)
        raise LoweringError(f"wrt names {twice} twice")
    rows = sum(len(result.entries) for result in results)
    dense = 0 if coo else len(by) * (rows * ("jacobian" in kinds) + len(by) * ("hessian" in kinds))
    require_room(len(places) + rows + dense)
    said = "all numbers that go in" if wrt is None else "the inputs that wrt names"
    names, more = Names(item.argument.name for item in given), []
    if "jvp" in kinds:
        shape = (len(by),) if len(by) > 1 else ()
        more.append(Argument(names.take("tangent"), shape, f"the rates of {said}, in their order"))
    if "vjp" in kinds:
        more += [Argument(names.take(f"{r.name}_cotangent"), r.shape, f"what {r.name} counts for") for r in results]
    return DerivedResults(kinds, by, coo, len(given), tuple(more), said)


def _chosen(given: Sequence[Input], places: Mapping[Any, tuple[int, int]], wrt: Any) -> Iterator[tuple[int, int]]:
    """The places of inputs, by their names or as they are; of symbols by name, whatever is assumed of them."""
    named: dict[str, list[tuple[int, int]]] = {}
    for entry, place in places.items():
        named.setdefault(str(entry), []).append(place)
    whole = {item.argument.name: [(k, n) for n in range(len(item.entries))] for k, item in enumerate(given)}
    several = isinstance(wrt, list | tuple)
    require_order(wrt, "wrt")
    if several and not wrt:
        raise LoweringError("wrt is empty: name what to differentiate by, or leave it out for all inputs")
    for item in wrt if several else (wrt,):
        if isinstance(item, str) and item in whole:
            yield from whole[item]
            continue
        for part in (item,) if isinstance(item, str) else variables_in(item):
            found = [places[part]] if part in places else named.get(str(part), [])
            if len(found) != 1:
                said = "which is among the inputs more than once" if found else "which is not among the inputs"
                raise LoweringError(f"wrt names {part}, {said}: {', '.join(whole)}")
            yield from found
