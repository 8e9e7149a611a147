"""What the letters of a page are: the most likely kinds with which the most equations fit together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache, partial
from itertools import combinations, islice, pairwise, product

from chasles.reading.atoms import Atoms, Terms
from chasles.reading.glyphs import ARROWS, Glyph, letter_of, spelled
from chasles.reading.grammar import Chain
from chasles.reading.letter_names import NameMarks, is_declared, parted, stem_of
from chasles.reading.letter_shapes import SCALAR, Misshapen, Shape, shape_of_chain
from chasles.reading.letter_uses import SKEW, LetterUse, letter_uses, looks
from chasles.reading.marks import SIZE
from chasles.reading.notation_file import usual_names
from chasles.reading.printed import PrintedEquation
from chasles.reading.segments import chains_of
from chasles.vocabulary.measure import Extent

Kind = tuple[str, tuple[Extent, ...]]
SHAPES = {
    "scalar": (1, 1),
    "angle": (1, 1),
    "vector": (3, 1),
    "matrix": (3, 3),
    "rotation": (3, 3),
    "quaternion": (4, 1),
    "imaginary unit": (1, 1),
}
USUAL = {(True, True): ("matrix", "vector"), (True, False): ("vector", "matrix"),
         (False, True): ("matrix", "scalar", "vector"), (False, False): ("scalar", "vector")}  # fmt: skip
"""What a letter may be, by whether it is bold and whether it is a capital."""
ROUNDS, MOST_TOGETHER, MOST_TRIED, MOST_AFFECTED, MOST_WORK = 2, 2, 300, 40, 300_000
"""How often all is gone through, how many letters are changed at once, in how many ways, and what that may cost."""
UNLIKELY = 0.3
"""What another kind than that which its looks suggest costs, in equations that do not fit together."""


def shaped_letters(
    equations: Sequence[PrintedEquation], texts: Sequence[str], marks: NameMarks, said: Mapping[Glyph, str]
) -> tuple[dict[Glyph, LetterUse], dict[int, int]]:
    """The letters with what they are, and by their places the equations that do not fit together even so.

    A letter is at first what is `said` of it in words. Capitals that may be matrices are so at first, then numbers
    where more fits together with that; letters that have only the base in common are of different kinds where else
    something does not fit.
    """
    chains = [chains_of(equation) for equation in equations]
    searches: list[_KindSearch] = []
    for changed in ((), ("matrix", "scalar"), ("scalar", "vector")):
        uses = letter_uses(equations, texts, marks, said)
        for use in uses.values():
            if (use.kind, use.other) == changed:
                use.kind, use.other = use.other, use.kind
        searches.append(_KindSearch(chains, uses, marks))
        searches[-1].go_through()
        if not searches[0].all_faults():
            break
    best = min(searches, key=lambda each: sum(each.all_faults().values()))
    if faults := best.all_faults():
        best.part({stem for place in faults for stem in best.stems[place]})
        best.go_through()
    return dict(sorted(best.uses.items(), key=lambda each: spelled(each[0]))), best.all_faults()


class _KindSearch:
    """Changes the kinds of letters, a few at a time, where an equation does not fit together."""

    def __init__(self, chains: Sequence[Sequence[Chain]], uses: dict[Glyph, LetterUse], marks: NameMarks) -> None:
        self.weighted = [[(chain, 3 if _has_grid(chain) else 1) for chain in each] for each in chains]
        self.chains, self.uses = chains, uses
        self.names = usual_names()
        self.stems: dict[int, list[Glyph]] = {}
        self.kinds: dict[Glyph, list[Kind]] = {stem: _kinds(stem, use) for stem, use in uses.items()}
        self.known: dict[tuple[int, tuple[Kind, ...]], Glyph | bool] = {}
        self.asked: dict[Glyph, None] = {}
        self.sizes: set[int] = set()
        self.work = 0
        self.known_by = lru_cache(maxsize=None)(partial(_known_by, uses=uses, marks=marks))
        self.part(set())

    def all_faults(self) -> dict[int, int]:
        """How many relations of each equation do not fit together, those with a matrix counted more."""
        return {place: faults for place in self.stems if (faults := self.faults(place))}

    def go_through(self) -> None:
        """Mend each equation that does not fit together, and again what others made of it."""
        for _ in range(ROUNDS):
            for place in [place for place in self.stems if self.faults(place)]:
                self.mend(place)

    def part(self, stems: set[Glyph]) -> None:
        """Let each letter of these families be of a kind of its own."""
        for stem in sorted(stems, key=spelled):
            if len(self.uses[stem].letters) > 1:
                use, kinds = self.uses.pop(stem), self.kinds.pop(stem)
                for own, places in use.letters.items():
                    self.uses[own] = replace(use, letters={own: places}, places=places, signs=use.signs)
                    self.kinds[own] = [*kinds]
        self.stems = {}
        for stem, use in self.uses.items():
            for place in use.places:
                self.stems.setdefault(place, []).append(stem)
        self.known.clear()
        self.known_by.cache_clear()

    def shape_of(self, letter: Glyph) -> tuple[Shape | None, tuple[str, ...]]:
        stem, marks = self.known_by(letter)
        use = self.uses.get(stem) if stem else None
        if use is None or stem is None:
            size = SIZE.fullmatch(letter.loose.sub) if letter.loose.base in ("I", "1", "0") else None
            known = (int(size[1]), int(size[2] or size[1])) if size and (size[2] or letter.loose.base != "0") else None
            return (1, 1) if letter.base == r"\pi" else known, marks
        self.asked[stem] = None
        return (use.shape[0], use.shape[1]) if use.shape else SHAPES[use.kind], marks

    def faults(self, place: int) -> int:
        """How many relations of the equation do not fit together; those with a matrix count more."""
        self.work += 1
        return sum(self._is_misshapen(chain) * weight for chain, weight in self.weighted[place])

    def has_fewer(self, chains: Sequence[tuple[Chain, int]], faults: int) -> bool:
        """Whether fewer relations than that do not fit together; those that did not before are best asked first."""
        self.work += 1
        for chain, weight in chains:
            faults -= self._is_misshapen(chain) * weight
            if faults <= 0:
                return False
        return True

    def _is_misshapen(self, chain: Chain) -> bool:
        """Whether it does not fit together, which only the letters asked for say: the next one follows from those."""
        kinds: tuple[Kind, ...] = ()
        while (known := self.known.get((id(chain), kinds))) is not None:
            if isinstance(known, bool):
                return known
            kinds = (*kinds, self.uses[known].meant)
        self.asked.clear()
        try:
            shape_of_chain(chain, self.shape_of, self.names)
            found = False
        except Misshapen:
            found = True
        kinds = ()
        for stem in self.asked:
            self.known[id(chain), kinds] = stem
            kinds = (*kinds, self.uses[stem].meant)
        self.known[id(chain), kinds] = found
        return found

    def mend(self, place: int) -> None:
        """Let few letters of the equation be something else, if more equations fit together then."""
        wanted = list(self._wanted(place))
        self.sizes |= {rows for _, (rows, columns) in wanted if columns == 1 < rows != 3}
        for size, stem in product(sorted(self.sizes), self.stems[place]):
            wanted += [(stem, (size, size))] if ("matrix", ()) in self.kinds[stem] else []
            wanted += [(stem, (size, 1))] if ("vector", ()) in self.kinds[stem] else []
        for stem, shape in wanted:
            kind: Kind = next(((name, ()) for name, each in SHAPES.items() if each == shape), ("matrix", shape))
            self.kinds[stem] += [kind] if kind not in self.kinds[stem] else []
        best = 0.0
        found: tuple[tuple[Glyph, Kind], ...] = ()
        here = self.faults(place)
        chains = sorted(self.weighted[place], key=lambda each: not self._is_misshapen(each[0]))
        for change in islice(self._changes(place), MOST_TRIED):
            if self.work > MOST_WORK:
                break
            old = self._let(change)
            if self.has_fewer(chains, here):
                places = dict.fromkeys(each for stem, _ in change for each in self.uses[stem].places)
                affected = [*places][:MOST_AFFECTED]
                after = sum(map(self.faults, affected)) + UNLIKELY * sum(map(self._cost, change))
                self._let(old)
                before = sum(map(self.faults, affected)) + UNLIKELY * sum(map(self._cost, old))
                best, found = (before - after, change) if before - after > best else (best, found)
            self._let(old)
            if found and len(change) == 1 and best >= here:
                break
        self._let(found)

    def _cost(self, chosen: tuple[Glyph, Kind]) -> int:
        return self.kinds[chosen[0]].index(chosen[1]) > 0

    def _let(self, change: Sequence[tuple[Glyph, Kind]]) -> tuple[tuple[Glyph, Kind], ...]:
        """Let the letters be so; what they were before."""
        old = tuple((stem, self.uses[stem].meant) for stem, _ in change)
        for stem, (kind, shape) in change:
            self.uses[stem].kind, self.uses[stem].shape = kind, shape
        return old

    def _changes(self, place: int) -> Iterator[tuple[tuple[Glyph, Kind], ...]]:
        stems = [stem for stem in self.stems[place] if len(self.kinds[stem]) > 1]
        for count in range(1, MOST_TOGETHER + 1):
            for chosen in combinations(stems, count):
                others = ([kind for kind in self.kinds[stem] if kind != self.uses[stem].meant] for stem in chosen)
                for kinds in product(*others):
                    yield tuple(zip(chosen, kinds, strict=True))

    def _wanted(self, place: int) -> Iterator[tuple[Glyph, Shape]]:
        """The shapes of what letters are set equal to, of columns that they are added to, and that a matrix takes."""
        for chain in self.chains[place]:
            sides = [side.rows for side in chain.sides if side is not None]
            shapes = dict.fromkeys(self._shape(row) for rows in sides for row in rows)
            for count, row in ((len(rows), _without_arguments(row)) for rows in sides for row in rows):
                is_letter = row[-1].kind != "INFIX" and all(each.kind == "NUMBER" for each in row[:-1])
                stem = self.known_by(letter_of(row[-1]))[0] if is_letter else None
                wanted = [each for each in shapes if each and (count == 1 or each[0] != 1 == each[1])]
                yield from ((stem, shape) for shape in wanted if stem in self.uses)
                grids = ((one, other) for one, other in pairwise(row) if one.kind == "GRID" and other.kind != "INFIX")
                for taken, shape in ((self.known_by(letter_of(of))[0], self._shape((grid,))) for grid, of in grids):
                    if taken in self.uses and shape and SCALAR not in (shape, (shape[1], 1)):
                        yield taken, (shape[1], 1)

    def _shape(self, row: Atoms) -> Shape | None:
        try:
            return shape_of_chain(Chain((Terms(("",), (row,)),), ()), self.shape_of, self.names)[0]
        except Misshapen:
            return None


def _without_arguments(row: Atoms) -> Atoms:
    """A row of pieces without what stands in round brackets at its end: R of R(t), and of R (t + 1)."""
    return row[:-1] if len(row) > 1 and row[-1].text == "()" and row[-2].kind not in ("INFIX", "NUMBER") else row


def _known_by(letter: Glyph, uses: Mapping[Glyph, LetterUse], marks: NameMarks) -> tuple[Glyph | None, tuple[str, ...]]:
    """What a letter of the page has in common with those of its kind, and its marks that are no part of its name."""
    own, others = parted(letter, marks)
    stem = own if own in uses else stem_of(own)
    return stem if is_declared(letter, marks.bare) else None, others


def _has_grid(chain: Chain) -> bool:
    rows = (row for side in chain.sides if side is not None for row in side.rows)
    return any(piece.kind != "INFIX" and piece.kind == "GRID" for row in rows for piece in row)


def _kinds(stem: Glyph, use: LetterUse) -> list[Kind]:
    """What the letter may be, the most likely first."""
    if use.kind == "imaginary unit":
        return [(use.kind, ())]
    is_open = not (use.is_matrix or use.signs & SKEW or r"\mathbf" in stem.base or ARROWS & {*stem.accents})
    usual = [each for each in (*USUAL[looks(stem)], "scalar") if each != "scalar" or is_open]
    quaternion = ["quaternion"] if {r"\otimes", r"\circ"} & use.signs else []
    matrix = ["matrix"] if use.is_matrix else []
    usual = [use.kind] if use.signs & SKEW else usual
    return list(dict.fromkeys([use.meant, *((kind, ()) for kind in (use.kind, *usual, *quaternion, *matrix))]))
