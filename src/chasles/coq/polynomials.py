"""Polynomials of a certificate in Coq: their variables are entries of symbols, cosines, norms and moments."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from chasles import vocabulary as w
from chasles.checker.reading import PolynomialProblem
from chasles.checker.sparse import Polynomial, exponents
from chasles.coq.expressions import Unsaid
from chasles.coq.sources import ProofReading
from chasles.coq.statement import CoqStatement
from chasles.statements.rules import rated


class Polynomials:
    """How polynomials are spelled in a proof, once every matrix is taken apart into its entries."""

    def __init__(self, said: CoqStatement, reading: ProofReading) -> None:
        self.said, self.reading = said, reading
        self.norms: dict[w.Node, str] = {}
        self.spins: dict[w.Symbol, tuple[str, str]] = {}

    def __call__(self, polynomial: Polynomial) -> str:
        """A polynomial, in brackets."""
        return spelled(polynomial, self.variable)

    def product(self, powers: int) -> str:
        """A product of nonzero factors, which are packed as in a monomial; empty for none."""
        nonzero = self.reading.nonzero
        return " * ".join(f"{self(nonzero[k])}" + (f"^{e}" if e > 1 else "") for k, e in exponents(powers))

    def variable(self, place: int) -> str:
        """A variable of the checker's polynomials."""
        match self.reading.variables[place]:
            case ("entry", w.Symbol() as symbol, 0, 0, 0) if symbol == w.PI:
                return "PI"
            case ("entry", w.Symbol() as symbol, int() as order, int() as i, int() as j):
                return self._entry(symbol, order, i, j)
            case ("cos" | "sin" as function, w.Symbol() as angle, Fraction() as unit):
                return f"{function} {self.angle(angle, unit)}".join("()")
            case ("norm", w.Node() as of):
                return self.norms[of]
            case ("moment", int() as inside, *_):
                return f"(integral (fun b => {self(Polynomial({inside: 1}))}))"
            case ("inverse", int() as k):
                return f"(/ {self(self.reading.nonzero[k])})"
        raise Unsaid(f"the variable {self.reading.variables[place]}")

    def angle(self, angle: w.Symbol, unit: Fraction) -> str:
        """A multiple of an angle."""
        return multiple(self._entry(angle, 0, 0, 0), unit)

    def _entry(self, symbol: w.Symbol, order: int, i: int, j: int) -> str:
        node = rated(symbol, order)
        if symbol in self.spins:
            name = self.spins[symbol][order]
        elif isinstance(node, w.Rate):
            if node not in self.said.names.rates:
                raise Unsaid(f"the proof needs the rate of {node.of}, and the statement has none")
            name = self.said.names.rates[node]
        else:
            name = self.said.names.symbol(symbol)
        if self.said.runs(symbol):
            return f"({name} b)" if symbol.shape == (1, 1) else f"({name}_ b {i}%nat {j}%nat)"
        return name if symbol.shape == (1, 1) else entry_name(name, symbol.shape, i, j)


def spelled(polynomial: Polynomial, variable: Callable[[int], str]) -> str:
    """A polynomial, in brackets, with variables that are spelled as told."""
    text = ""
    for monomial, coefficient in polynomial.terms.items():
        factors = [variable(k) + (f"^{e}" if e > 1 else "") for k, e in exponents(monomial)]
        if abs(coefficient) != 1 or not factors:
            factors.insert(0, str(abs(coefficient)))
        sign = "- " if coefficient < 0 else "+ " if text else ""
        text += f" {sign}{'*'.join(factors)}"
    text = text.strip() or "0"
    return f"({text})" if polynomial.below == 1 else f"(({text}) / {polynomial.below})"


def multiple(name: str, unit: Fraction) -> str:
    """A multiple of an angle."""
    if unit == 1:
        return name
    return f"({f'{unit.numerator} * ' * (unit.numerator > 1)}{name} / {unit.denominator})"


def in_units(reading: PolynomialProblem, argument: w.Node, name: Callable[[w.Symbol], str]) -> str:
    """An angle as a sum of those of which the cosine and the sine are variables, and of right angles."""
    units = {what[1]: what[2] for what in reading.variables if what[0] == "cos"}
    parts = []
    for monomial, coefficient in (entry := reading(argument)[0][0]).terms.items():
        ((place, _),) = exponents(monomial)
        symbol = reading.variables[place][1]
        unit = units.get(symbol, Fraction(1, 2))
        times = Fraction(coefficient, entry.below) / unit
        angle = multiple("PI" if symbol == w.PI else name(symbol), unit)
        parts += [f"{'-' if times < 0 else '+'} {angle}"] * abs(int(times))
    return f"({' '.join(parts).removeprefix('+ ') or '0'})"


def entry_name(name: str, shape: tuple[int, int], i: int, j: int) -> str:
    """The name of an entry: e'1, Q'12, Q'1'12."""
    apart = "'" if max(i, j) > 8 else ""
    return f"{name}'{i + 1}" if shape[1] == 1 else f"{name}'{i + 1}{apart}{j + 1}"


def taken_apart(name: str, shape: tuple[int, int]) -> str:
    """The step by which a matrix is replaced by its entries."""
    pattern = "[]"
    for i in reversed(range(shape[0])):
        line = "[]"
        for j in reversed(range(shape[1])):
            line = f"[{entry_name(name, shape, i, j)} {line}]"
        pattern = f"[{line} {pattern}]"
    return f"destruct {name} as {pattern}."


def literal(rows: list[list[str]]) -> str:
    """A matrix with these entries, as it is once words are opened."""
    lines = ["(" + ", (".join(row) + ", tt" + ")" * len(row) for row in rows]
    return f"(({', ('.join(lines)}, tt{')' * len(lines)} : M {len(rows)} {len(rows[0])})"
