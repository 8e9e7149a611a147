"""What reading one equation needs: the notation, where print puts brackets, and what could not be read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from chasles.reading.atoms import Atoms, Terms, Unread
from chasles.reading.fits import Fit, Shape, made, own_quantity
from chasles.reading.lexemes import Token
from chasles.reading.page_notation import PageNotation
from chasles.vocabulary import NO_DIMENSION, Group, Node, uniform
from chasles.vocabulary.dimension import has_units
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.pieces import Piece, Precedence
from chasles.vocabulary.spelling import spell
from chasles.vocabulary.typesetting import BRACKETS, Latex

KINDS = {"()": "()", "[]": "[]", r"\{\}": "{}"}


class FittingContext:
    """Reads in one notation; at `level` 1 also matrices without marks between blocks, at 2 also what is ill-formed.

    `where` is the place of the equation; over indices that are `summed` a term runs that has them twice.
    """

    def __init__(self, notation: PageNotation, level: int = 0, where: str = "") -> None:
        self.notation, self.where = notation, where
        self.level = level
        self.tolerant = level == 2
        self.problems: list[Unread] = []
        self.work = 0
        self.summed: frozenset[str] = frozenset()
        self.terms: Callable[[Terms], list[Fit]] = lambda terms: []
        self.product: Callable[[Atoms], list[Fit]] = lambda items: []
        self._style = Latex(notation.forms)
        self._pieces: dict[Node, Piece] = {}

    def piece(self, node: Node) -> Piece:
        """How the node is printed, and how tightly that holds together; raises `Unread` after too many nodes."""
        self.work += 1
        if self.work > self.notation.most_work:
            raise Unread("it can be read in too many ways: say more of its letters in the notation")
        if node not in self._pieces:
            self._pieces[node] = spell(node, self._style)
        return self._pieces[node]

    def inside(self, fit: Fit, least: Precedence) -> Node:
        """The word as part of one of this precedence: its brackets count where print does not put them by itself."""
        assert fit.node is not None
        piece = self.piece(fit.node)
        if not fit.brackets or (piece.level < least and fit.brackets == "".join(BRACKETS[min(piece.depth, 2)])):
            return fit.node
        return Group(fit.node, KINDS[fit.brackets])

    def made(self, make: Callable[..., Node], *parts: Any, cost: int = 0) -> list[Fit]:
        """The reading as what is made of the parts, if they fit."""
        node = made(make, *parts, tolerant=self.tolerant)
        return [] if node is None else [Fit(node, cost)]

    def of_open_size(self, make: Callable[..., Node], least: Precedence, *pair: Fit) -> Fit:
        """What is made of two, of which at least one has an open size."""

        def sized(shape: Shape) -> Node | None:
            parts = [self.inside(fit, least) for each in pair if (fit := each.sized_as(shape)) is not None]
            return made(make, *parts) if len(parts) == 2 else None

        usual = next(fit.usual for fit in pair if fit.node is None)
        return Fit(None, sum(fit.cost for fit in pair), sized=sized, usual=usual)

    def of_its_own(self, text: str, like: Sequence[Node] = (), here: str = "") -> list[Fit]:
        """What no word says: a quantity of its own, of any shape, another one elsewhere if that is `here` alone.

        Where units are checked it has those of what it is `like`.
        """
        home, name = self.notation.home, f"{text} in {here}" if here else text
        if has_units(home):
            return [Fit(own_quantity(text, measured(each), home, name)) for each in like]
        sized = lambda shape: own_quantity(text, uniform(shape, NO_DIMENSION), home, name)  # noqa: E731
        return [Fit(None, sized=sized)]

    def sizes_of(self, fits: Sequence[Fit]) -> list[Shape]:
        """The shapes that those of open size may have where nothing else says it, the usual ones first."""
        if all(fit.node is not None for fit in fits):
            return [(1, 1)]
        known = sorted(n for n in self.notation.sizes if n > 1)
        usual = [fit.usual for fit in fits if fit.node is None]
        return list(dict.fromkeys((*usual, (1, 1), *((n, n) for n in known), *((n, 1) for n in known))))

    def mixes(self, one: Fit, other: Fit) -> bool:
        """Whether scalars, vectors and quaternions meet as if all were quaternions, which words do not say; noted.

        As long as the letters are proposed they may be something else: then it is read as printed, and ill-formed.
        """
        shapes = {one.shape, other.shape}
        mixed = (
            self.notation.quaternions
            and not self.notation.proposed
            and len(shapes) == 2
            and shapes <= {(1, 1), (3, 1), (4, 1)}
        )
        if mixed:
            self.note("a scalar, a vector or a quaternion stands for another of them: write columns of four", None)
        return mixed

    def note(self, why: str, place: Token | None) -> None:
        """Keep why something cannot be read, for the case that nothing else explains the equation."""
        self.problems.append(Unread(why, place))
