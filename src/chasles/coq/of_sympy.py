"""Expressions of SymPy in Coq: the statement of an identity of `prove`, as the question says it.

Symbols are real numbers; functions of one symbol move, as in declared statements: all is said during an open set of
instants. Only this has to be read to know what is claimed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.asked import Asked
from chasles.coq.expressions import APPLIED, ATOM, LOOSE, MINUS, PLUS, POWER, TIMES, Spelled, Unsaid, held
from chasles.coq.names import identifier

FUNCTIONS = {
    sympy.sin: "sin", sympy.cos: "cos", sympy.tan: "tan", sympy.Abs: "Rabs", sympy.sign: "sign", sympy.exp: "exp",
    sympy.log: "ln", sympy.sinh: "sinh", sympy.cosh: "cosh", sympy.tanh: "tanh",
}  # fmt: skip
CIRCULAR = {
    sympy.tan: lambda x: (sympy.sin(x), sympy.cos(x)), sympy.cot: lambda x: (sympy.cos(x), sympy.sin(x)),
    sympy.sec: lambda x: (sympy.Integer(1), sympy.cos(x)), sympy.csc: lambda x: (sympy.Integer(1), sympy.sin(x)),
}  # fmt: skip
"""Functions of an angle as quotients; but for the tangent, Coq has no words for them."""
OF_TWO = {sympy.Max: "Rmax", sympy.Min: "Rmin"}
BY_CASES = (sympy.sign, *OF_TWO)
SIGNS = {
    "positive": "0 < {}",
    "negative": "{} < 0",
    "nonnegative": "0 <= {}",
    "nonpositive": "{} <= 0",
    "nonzero": "{} <> 0",
}
RELATIONS = {" != 0": "{} <> 0", " >= 0": "0 <= {}", " > 0": "0 < {}"}


@dataclass(frozen=True, slots=True)
class ScalarPremise:
    """Something assumed, and the equation if it is one; it `moves` if it holds at each instant."""

    name: str
    says: str
    moves: bool = False
    pair: tuple[Any, Any] | None = None


class ScalarStatement:
    """What was asked, under what the verdict needs. Raises `Unsaid` where there are no words for it."""

    def __init__(self, asked: Asked, needs: tuple[str, ...]) -> None:
        self.asked = asked
        everything = sympy.Tuple(*asked.expressions)
        functions = sorted(everything.atoms(AppliedUndef), key=str)
        times = {each.args[0] for each in functions if len(each.args) == 1}
        if len(times) > 1 or any(len(each.args) > 1 or not each.args[0].is_Symbol for each in functions):
            raise Unsaid("functions of something else than one symbol")
        self.time = next(iter(times), None)
        self.names: dict[Any, str] = {self.time: "t"} if times else {}
        self.orders = dict.fromkeys(functions, 0)
        for each in everything.atoms(sympy.Derivative):
            if each.expr not in self.orders:
                raise Unsaid(f"the rate of {each.expr}")
            self.orders[each.expr] = max(self.orders[each.expr], each.derivative_count)
        for atom in sorted(everything.free_symbols - times, key=str):
            self._name(atom, atom.name)
        for each, order in self.orders.items():
            for k in range(order + 1):
                self._name(
                    each.diff((self.time, k)) if k else each,
                    f"{each.func.__name__}_{'d' * k}ot" if k else each.func.__name__,
                )
        self.goals = [(left, asked.right[place]) for place, left in asked.left.items()]
        self.positive: list[Any] = []
        self.premises = [*self._rates(), *self._signs(), *self._given(), *self._needs(needs)]

    def _name(self, atom: Any, text: str) -> None:
        name = identifier(text)
        while name in self.names.values():
            name += "_"
        self.names[atom] = name

    @property
    def moves(self) -> bool:
        """Whether there are functions of time."""
        return self.time is not None

    @property
    def has_cases(self) -> bool:
        """Whether something is spoken of whose value is told by cases, all else being rational and at rest."""
        everything = sympy.Tuple(*self.asked.expressions)
        others = everything.atoms(sympy.Function) - everything.atoms(sympy.Abs, *BY_CASES)
        return everything.has(*BY_CASES) and not others

    def _rates(self) -> Iterator[ScalarPremise]:
        if self.moves:
            yield ScalarPremise("open'T", "open_set T")
        for each, order in self.orders.items():
            for k in range(order):
                of, rate = (self.names[each.diff((self.time, n)) if n else each] for n in (k, k + 1))
                yield ScalarPremise(f"rate'{rate}", f"scalar_rate T {of} {rate}")

    def _signs(self) -> Iterator[ScalarPremise]:
        for atom, name in self.names.items():
            moves = isinstance(atom, AppliedUndef)
            kind = next((kind for kind in SIGNS if getattr(atom, f"is_{kind}")), None)
            if kind and atom != self.time:
                yield self._premise(f"sign'{name}", SIGNS[kind].format(f"{name} t" if moves else name), atom)

    def _given(self) -> Iterator[ScalarPremise]:
        """The equations that are given, and that they divide by nothing that is zero."""
        sides = sympy.Tuple(*(side for item in self.asked.given for pair in item.pairs.values() for side in pair))
        divisors = {power.base for power in sides.atoms(sympy.Pow) if power.exp.is_negative}
        for count, divisor in enumerate(sorted(divisors, key=str)):
            yield self._premise(f"divisor'{count}", f"{self.side(divisor, PLUS)} <> 0", divisor)
        for count, item in enumerate(self.asked.given):
            for (i, j), pair in item.pairs.items():
                yield self._premise(f"given'{count}_{i + 1}_{j + 1}", self.equation(*pair), sympy.Tuple(*pair), pair)

    def _needs(self, needs: tuple[str, ...]) -> Iterator[ScalarPremise]:
        spelled = {str(atom): atom for atom in self.names}
        said = {*self.asked.real, *(item.text for item in self.asked.given)}
        for count, text in enumerate(need for need in needs if need not in said):
            ending = next((each for each in RELATIONS if text.endswith(each)), None)
            if ending is None:
                raise Unsaid(f"the need {text}")
            local = {str(atom.func): atom.func for atom in self.orders} | {
                k: v for k, v in spelled.items() if k.isidentifier()
            }
            value = sympy.sympify(text.removesuffix(ending), locals=local)
            if not value.atoms(sympy.Symbol, AppliedUndef) <= self.names.keys():
                raise Unsaid(f"the need {text}")
            self.positive += [value] * (ending == " > 0")
            yield self._premise(f"need'{count}", RELATIONS[ending].format(self.side(value, PLUS)), value)

    def _premise(self, name: str, says: str, about: Any, pair: Any = None) -> ScalarPremise:
        moves = bool(about.atoms(AppliedUndef, sympy.Derivative)) or self.time in about.free_symbols
        return ScalarPremise(name, says, moves, pair)

    def holding(self, name: str) -> str:
        """The definition of the statement, under its name."""
        bound = [("T", "R -> Prop")] * self.moves
        bound += [
            (n, "R -> R" if isinstance(a, AppliedUndef | sympy.Derivative) else "R")
            for a, n in self.names.items()
            if n != "t"
        ]
        lines = [f"  forall {' '.join(f'({each} : {kind})' for each, kind in bound)},"] if bound else []
        lines += [f"  {f'during T (fun t => {p.says})' if p.moves else p.says} ->" for p in self.premises]
        goal = " /\\\n  ".join(self.equation(*pair) for pair in self.goals)
        lines.append(f"  during T (fun t =>\n  {goal})" if self.moves else f"  {goal}")
        return f"Definition {name} : Prop :=\n" + "\n".join(lines) + ".\n"

    def equation(self, left: Any, right: Any) -> str:
        """Two sides that are said to be equal."""
        return f"{self.side(left)} = {self.side(right)}"

    def side(self, e: Any, most: int = LOOSE) -> str:
        """An expression, in brackets if it is looser than `most`."""
        return held(self._spelled(e), most)

    def _spelled(self, e: Any) -> Spelled:
        if e in self.names:
            moves = isinstance(e, AppliedUndef | sympy.Derivative)
            return (f"{self.names[e]} t", APPLIED) if moves else (self.names[e], ATOM)
        if e is sympy.pi:
            return "PI", ATOM
        if e.is_Rational:
            text = f"{abs(e.p)}" + f" / {e.q}" * (e.q > 1)
            level = TIMES if e.q > 1 else ATOM
            return (f"- {text}", max(level, MINUS)) if e < 0 else (text, level)
        if e.func in FUNCTIONS:
            return f"{FUNCTIONS[e.func]} {self.side(e.args[0], ATOM)}", APPLIED
        if e.func in CIRCULAR:
            above, below = CIRCULAR[e.func](e.args[0])
            return f"{self.side(above, TIMES)} / {self.side(below, TIMES - 1)}", TIMES
        if e is sympy.E:
            return "exp 1", APPLIED
        if e.func in OF_TWO:
            *others, text = [self.side(each, ATOM) for each in e.args]
            for each in reversed(others):
                text = f"({OF_TWO[e.func]} {each} {text})"
            return text, ATOM
        if e.is_Add:
            first, *others = e.as_ordered_terms()
            text = self.side(first, PLUS)
            for term in others:
                minus = term.could_extract_minus_sign()
                text += f" {'-' if minus else '+'} {self.side(-term if minus else term, PLUS - 1)}"
            return text, PLUS
        if e.is_Mul:
            return self._product(e)
        if e.is_Pow and (2 * e.exp).is_Integer:
            if e.exp < 0:
                return f"1 / {self.side(1 / e, TIMES - 1)}", TIMES
            if e.exp.is_Integer:
                return f"{self.side(e.base, POWER - 1)} ^ {e.exp}", POWER
            root = f"sqrt {self.side(e.base, ATOM)}"
            return (root, APPLIED) if e.exp == sympy.Rational(1, 2) else (f"({root}) ^ {2 * e.exp}", POWER)
        if e.is_Pow and not e.exp.is_Rational:
            return f"Rpower {self.side(e.base, ATOM)} {self.side(e.exp, ATOM)}", APPLIED
        raise Unsaid(f"{e.func if e.is_Function else e} is no word of the theories")

    def _product(self, e: Any) -> Spelled:
        if e.could_extract_minus_sign():
            return f"- {self.side(-e, TIMES)}", PLUS
        above, below = [], []
        for factor in e.as_ordered_factors():
            if factor.is_Rational and not factor.is_Integer:
                above += [sympy.Integer(factor.p)] * (factor.p != 1)
                below.append(sympy.Integer(factor.q))
            elif factor.is_Pow and factor.exp.is_Rational and factor.exp < 0:
                below.append(1 / factor)
            else:
                above.append(factor)
        text = " * ".join(self.side(each, TIMES - 1) for each in above) or "1"
        for each in below:
            text += f" / {self.side(each, TIMES - 1)}"
        return text, TIMES
