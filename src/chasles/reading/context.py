"""What reading one equation needs: the notation, how words are printed again, and what could not be read.

Does an expression print the tokens of the page again? Typefaces, braces, alignment and spaces are layout.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from chasles.reading.fits import Fit, Said, Shape, made, own_quantity
from chasles.reading.grammar import Atom, Terms
from chasles.reading.grouping import Unread
from chasles.reading.page_notation import PageNotation
from chasles.vocabulary import NO_DIMENSION, Group, Node, uniform
from chasles.vocabulary.dimension import has_units
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.spelling import Piece, Precedence, spell
from chasles.vocabulary.typesetting import BRACKETS, Latex

KINDS = {"()": "()", "[]": "[]", r"\{\}": "{}"}

LAYOUT = {r"\left", r"\right", r"\quad", r"\,", r"\ ", r"\\", r"\mathbf", r"\boldsymbol", r"\overrightarrow", r"\text",
          r"\mathsf", r"\mathrm", r"\operatorname", "&", ",", "{", "}"}  # fmt: skip
MATRIX = re.compile(r"\\(begin|end)\{[bp]matrix\}")
MARK = re.compile(r"\\[a-zA-Z]+|\\.|[A-Za-z]|\d+|\S")


def tokens_of(text: str) -> tuple[str, ...]:
    """The text as tokens without layout: a matrix is what stands in square brackets."""
    text = MATRIX.sub(lambda found: " [ " if found[1] == "begin" else " ] ", text)
    return tuple(token for token in MARK.findall(text) if token not in LAYOUT)


class FittingContext:
    """Reads in one notation; at `level` 1 also matrices without marks between blocks, at 2 also what is ill-formed.

    `where` is the place of the equation.
    """

    def __init__(self, notation: PageNotation, level: int = 0, where: str = "") -> None:
        self.notation, self.where = notation, where
        self.level = level
        self.tolerant = level == 2
        self.problems: list[Unread] = []
        self.work = 0
        self.terms: Callable[[Terms], list[Fit]] = lambda terms: []
        self.product: Callable[[tuple[Atom, ...]], list[Fit]] = lambda items: []
        self._style = Latex(notation.forms)
        self._pieces: dict[Node, Piece] = {}
        self._said: dict[Node, Said] = {}

    def piece(self, node: Node) -> Piece:
        """How the node is printed, and how tightly that holds together; raises `Unread` after too many nodes."""
        self.work += 1
        if self.work > self.notation.most_work:
            raise Unread("it can be read in too many ways: say more of its letters in the notation")
        if node not in self._pieces:
            self._pieces[node] = spell(node, self._style)
        return self._pieces[node]

    def said(self, node: Node) -> Said:
        """The tokens that the node is printed as."""
        if node not in self._said:
            self._said[node] = tokens_of(self.piece(node).text)
        return self._said[node]

    def inside(self, fit: Fit, least: Precedence) -> tuple[Node, Said]:
        """The word, and its tokens, where one that holds less tightly gets brackets in print."""
        node = fit.node
        assert node is not None
        piece = self.piece(node)
        opening, shut = BRACKETS[min(piece.depth, 2)]
        if not fit.brackets:
            return node, fit.said if piece.level >= least else (opening, *fit.said, shut)
        if piece.level >= least or fit.brackets != opening + shut:
            node = Group(node, KINDS[fit.brackets])
        half = len(fit.brackets) // 2
        return node, (fit.brackets[:half], *fit.said, fit.brackets[half:])

    def of_open_size(self, make: Callable[..., Node], least: Precedence, left: Fit, right: Fit, sign: str = "") -> Fit:
        """What is made of two, of which at least one has an open size."""
        pair = left, right
        says = [self.inside(fit, least)[1] if fit.node is not None else fit.printed for fit in pair]

        def sized(shape: Shape) -> Node | None:
            at = [fit if fit.node is not None else fit.at(shape) for fit in pair]
            parts = [self.inside(fit, least)[0] for fit in at if fit is not None]
            return made(make, *parts) if len(parts) == 2 else None

        said = (*says[0], *((sign,) * bool(sign)), *says[1])
        usual = left.usual if left.node is None else right.usual
        return Fit(None, said, left.cost + right.cost, sized=sized, usual=usual)

    def of_its_own(self, text: str, like: Sequence[Node] = (), here: bool = False) -> list[Fit]:
        """What no word says: a quantity of its own, of any shape, another one elsewhere if that is `here` alone.

        Where units are checked it has those of what it is `like`.
        """
        home, name = self.notation.home, f"{text} in {self.where}" if here else text
        if has_units(home):
            return [Fit(own_quantity(text, measured(each), home, name), tokens_of(text)) for each in like]
        sized = lambda shape: own_quantity(text, uniform(shape, NO_DIMENSION), home, name)  # noqa: E731
        return [Fit(None, tokens_of(text), sized=sized)]

    def is_as_printed(self, fit: Fit) -> bool:
        """Whether the word prints the tokens that it was read from."""
        return fit.node is None or fit.said == self.said(fit.node)

    def sizes_of(self, fits: Sequence[Fit]) -> list[Shape]:
        """The shapes that those of open size may have where nothing else says it, the usual ones first."""
        if all(fit.node is not None for fit in fits):
            return [(1, 1)]
        known = sorted(n for n in self.notation.sizes if n > 1)
        usual = [fit.usual for fit in fits if fit.node is None]
        return list(dict.fromkeys((*usual, (1, 1), *((n, n) for n in known), *((n, 1) for n in known))))

    def mixes(self, one: Fit, other: Fit) -> bool:
        """Whether scalars, vectors and quaternions meet as if all were quaternions, which words do not say; noted."""
        shapes = {one.shape, other.shape}
        mixed = self.notation.quaternions and len(shapes) == 2 and shapes <= {(1, 1), (3, 1), (4, 1)}
        if mixed:
            self.note("a scalar, a vector or a quaternion stands for another of them: write columns of four", None)
        return mixed

    def note(self, why: str, place: object) -> None:
        """Keep why something cannot be read, for the case that nothing else explains the equation."""
        from chasles.reading.lexemes import Token

        self.problems.append(Unread(why, place if isinstance(place, Token) else None))
