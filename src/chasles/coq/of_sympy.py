"""Questions of `prove` as statements in Coq: expressions of SymPy in words, and with these a statement like any other.

Symbols are real numbers; functions of one symbol move, and all is said during an open set of instants. Only this has to
be read to know what is claimed, with what declared statements are written by.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.matrices import MatrixBase, MatrixExpr
from sympy.matrices.expressions.matexpr import MatrixElement

from chasles import vocabulary as w
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.complexes import Parts
from chasles.checker.expressions.unevaluated import explicit, written_out
from chasles.coq.expressions import APPLIED, ATOM, LOOSE, PLUS, Spelled, Spelling, Unsaid
from chasles.coq.names import CoqNames
from chasles.coq.statement import CoqStatement
from chasles.coq.sympy_words import DECIDED, OF_TWO, SympyWords, is_exponential
from chasles.statements import Goal, Hypothesis, Problem
from chasles.vocabulary.functions import FunctionOf

TERM_BY_TERM = {sympy.Sum: sympy.Add, sympy.Product: sympy.Mul}
MOST_TERMS = 50
BY_CASES = (sympy.sign, sympy.Piecewise, sympy.Heaviside, *OF_TWO)
SIGNS = {
    "positive": "0 < {}",
    "negative": "{} < 0",
    "nonnegative": "0 <= {}",
    "nonpositive": "{} <= 0",
    "nonzero": "{} <> 0",
    "less": "{} < {}",
    "at most": "{} <= {}",
}
COMPARED = {"==": "=", "!=": "<>", "<": "<", "<=": "<="}
JOINED = {sympy.And: " /\\ ", sympy.Or: " \\/ ", sympy.Implies: " -> ", sympy.Equivalent: " <-> "}
RELATIONS = {" != 0": "nonzero", " >= 0": "nonnegative", " > 0": "positive"}


def in_entries(value: Any) -> Any:
    """The scalar, matrix, equation or list with matrices, what is made of them, and finite sums in their entries."""
    if isinstance(value, list | tuple):
        return type(value)(map(in_entries, value))
    if isinstance(value, sympy.Equality):
        return sympy.Eq(*map(in_entries, value.args), evaluate=False)
    if isinstance(value, MatrixBase | MatrixExpr):
        return explicit(value)
    return written_out(value) if isinstance(value, sympy.Expr) else value


def term_by_term(value: Any) -> Any:
    """The scalar, or list of conditions, with sums and products of so many terms as SymPy leaves them, unevaluated."""
    if isinstance(value, list | tuple):
        return type(value)(map(term_by_term, value))
    if isinstance(value, MatrixBase | MatrixExpr) or not (isinstance(value, sympy.Basic) and value.has(*TERM_BY_TERM)):
        return value
    if not isinstance(value, sympy.Sum | sympy.Product):
        together = {"evaluate": False} if isinstance(value, sympy.Add | sympy.Mul | sympy.Pow) else {}
        return value.func(*map(term_by_term, value.args), **together)
    *inner, (index, low, high) = value.limits
    if not (high - low).is_Integer or high - low > MOST_TERMS:
        raise Unsaid(f"{value}, with any number of terms or with very many")
    term = value.func(value.function, *inner) if inner else value.function
    terms = [term_by_term(term.subs(index, low + k)) for k in range(high - low + 1)]
    return TERM_BY_TERM[value.func](*terms, evaluate=False) if len(terms) > 1 else terms[0] if terms else value.doit()


def in_parts(asked: Asked) -> Asked:
    """What was asked, of real and imaginary parts: these, if there are any, in further rows."""
    parts = Parts()
    sides = parts.sides(*(list(side.values()) for side in (asked.left, asked.right)))
    asked.left, asked.right = (_placed(asked.left, side) for side in sides)
    given = []
    for item in asked.given:
        said = [parts.pairs(*pair) for pair in item.pairs.values()]
        pairs = [pair[0] for pair in said] + [pair[1] for pair in said if len(pair) > 1]
        given.append(replace(item, pairs=_placed(item.pairs, pairs)))
    asked.given = given
    return asked


def _placed(places: Iterable[tuple[int, int]], parts: Sequence[Any]) -> dict[tuple[int, int], Any]:
    """Parts by their places: imaginary ones as many rows below."""
    places = list(places)
    below = 1 + max((row for row, _ in places), default=0)
    return dict(zip([*places, *((row + below, column) for row, column in places)], parts, strict=False))


class _ScalarSpelling(Spelling):
    def _number(self, node: w.Node) -> Spelled:
        if isinstance(node, FunctionOf) and node.function in DECIDED.values():
            *compared, then, otherwise = node.arguments
            decided = " ".join((node.function, *(self.number(each, ATOM) for each in compared)))
            return f"if {decided} then {self.number(then)} else {self.number(otherwise)}", LOOSE + 1
        if isinstance(node, FunctionOf):
            return f"{node.function} {' '.join(self.number(each, ATOM) for each in node.arguments)}", APPLIED
        return super()._number(node)


class SympyStatement(CoqStatement):
    """A statement in the words of expressions of SymPy, with names as in another one, if any.

    Where an inequality is claimed, or what joins several relations, the goals are their sides.
    """

    def __init__(
        self, words: SympyWords, problem: Problem, like: SympyStatement | None = None, claimed: Any = None
    ) -> None:
        self.words, self.claimed = words, claimed
        names = CoqNames(like.names if like else None)
        self._clock = words.atoms.get(words.time)
        if isinstance(self._clock, w.Symbol):
            names.symbols[self._clock] = "t"
        super().__init__(problem, names)
        self.timed = words.time is not None
        self.spelling = _ScalarSpelling(self.names, self.applied)

    def claiming(self, claimed: Any) -> SympyStatement:
        """The statement that from the same premises something else follows."""
        relations = [part for part in sympy.preorder_traversal(claimed) if isinstance(part, Relational)]
        goals = tuple(Goal("", self.words(each.lhs), self.words(each.rhs)) for each in relations)
        return SympyStatement(self.words, replace(self.problem, goals=goals), self, claimed)

    @property
    def equations(self) -> list[str]:
        """What is claimed."""
        return super().equations if self.claimed is None else [self._relation(self.claimed)]

    def _relation(self, e: Any) -> str:
        """What a relation says, or what joins some."""
        if isinstance(e, sympy.Not):
            return f"~ ({self._relation(e.args[0])})"
        if e.func in JOINED and (len(e.args) == 2 or e.func in (sympy.And, sympy.Or)):
            return JOINED[e.func].join(f"({self._relation(part)})" for part in e.args)
        if not isinstance(e, Relational) or len(e.args) != 2:
            raise Unsaid(f"{e} is no word of the theories")
        e = e.reversed if isinstance(e, sympy.Gt | sympy.Ge) else e
        return f"{self.side(e.lhs)} {COMPARED[e.rel_op]} {self.side(e.rhs)}"

    def _hypothesis(self, hypothesis: Hypothesis) -> str:
        return SIGNS[hypothesis.kind].format(*(self.spelling.number(each, PLUS) for each in hypothesis.subjects))

    def moves(self, node: w.Node) -> bool:
        """Whether a symbol is a function of time, or time itself."""
        return super().moves(node) or (self.timed and node == self._clock)

    def applied(self, node: w.Node, name: str) -> str:
        """A symbol or rate at the instant."""
        return name if node == self._clock else super().applied(node, name)

    @property
    def binders(self) -> list[tuple[str, str]]:
        """What the statement is for all of, with types."""
        return [(name, kind) for name, kind in super().binders if name != "t"]

    def side(self, e: Any, most: int = LOOSE) -> str:
        """An expression, in brackets if it is looser than `most`."""
        return self.spelling.number(self.words(e), most)


class ScalarStatement(SympyStatement):
    """What was asked, under what the verdict needs. Raises `Unsaid` where there are no words for it.

    `values` are what a proof says symbols and functions by: their definitions, or what has their name and a sign.
    """

    def __init__(self, asked: Asked, needs: tuple[str, ...], values: dict[Any, Any], claimed: Any = None) -> None:
        self.asked, self.values = asked, values
        said = sympy.Tuple(*asked.expressions)
        rates = (rate.xreplace(values) for rate in said.atoms(sympy.Derivative))
        self.words = words = SympyWords(
            sympy.Tuple(*said, *values.values(), *rates, *[claimed] * (claimed is not None))
        )
        self.goals = [(left, asked.right[place]) for place, left in asked.left.items()]
        self.given = [
            ((count, *place), pair) for count, item in enumerate(asked.given) for place, pair in item.pairs.items()
        ]
        self.assumed: dict[Hypothesis, Any] = {}
        self.needed: list[Any] = []
        self.positive: list[Any] = []
        goals, conditions = (
            tuple(Goal("", words(left), words(right)) for left, right in pairs)
            for pairs in (self.goals, [pair for _, pair in self.given])
        )
        assumed = tuple(dict.fromkeys((*self._signs(), *self._divisors(), *self._needs(needs))))
        for power in sorted(said.atoms(sympy.Pow), key=str):
            base = power.base.xreplace(values)
            if is_exponential(power) and not (base.is_positive or power.base in self.positive):
                raise Unsaid(f"{power}, whose base is not seen to be positive")
        super().__init__(words, Problem(goals, conditions=conditions, hypotheses=assumed))

    def is_of_cases(self, certificate: Mapping[str, Any]) -> bool:
        """Whether something is spoken of whose value is told by cases, all else being rational and at rest."""
        if all(left.func is sympy.sign and right == 1 for left, right in self.goals):  # an inequality, without cases
            return False
        everything = sympy.Tuple(*self.asked.expressions)
        others = everything.atoms(sympy.Function) - everything.atoms(sympy.Abs, *BY_CASES)
        return (everything.has(*BY_CASES) or "cases" in certificate) and not others

    def _signs(self) -> Iterator[Hypothesis]:
        for atom, node in self.words.atoms.items():
            kind = next((kind for kind in SIGNS if getattr(atom, f"is_{kind}", False)), None)
            if kind and atom != self.words.time:
                yield Hypothesis(kind, (node,))

    def _divisors(self) -> Iterator[Hypothesis]:
        """That the given equations divide by nothing that is zero."""
        sides = sympy.Tuple(*(side for _, pair in self.given for side in pair))
        divisors = {power.base for power in sides.atoms(sympy.Pow) if power.exp.is_negative}
        for divisor in sorted(divisors, key=str):
            yield self._said("nonzero", divisor)

    def _needs(self, needs: tuple[str, ...]) -> Iterator[Hypothesis]:
        atoms = self.words.atoms
        said = {*self.asked.real, *(item.text for item in self.asked.given)}
        names = {str(atom): atom for atom in atoms if str(atom).isidentifier()}
        names |= {str(atom.parent): atom.parent for atom in atoms if isinstance(atom, MatrixElement)}
        names |= {str(atom.func): atom.func for atom in atoms if isinstance(atom, AppliedUndef)}
        for text in (need for need in needs if need not in said):
            ending = next((each for each in RELATIONS if text.endswith(each)), None)
            value = sympy.sympify(text.removesuffix(str(ending)), locals=names) if ending else sympy.nan
            if ending is None or not value.atoms(sympy.Symbol, AppliedUndef) <= atoms.keys():
                raise Unsaid(f"the need {text}")
            self.needed.append(value)
            self.positive += [value] * (ending == " > 0")
            yield self._said(RELATIONS[ending], value)

    def _said(self, kind: str, value: Any) -> Hypothesis:
        hypothesis = Hypothesis(kind, (self.words(value),))
        self.assumed[hypothesis] = value
        return hypothesis
