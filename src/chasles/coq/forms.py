"""What each form of a theorem says in Coq, and the steps by which it follows from its equations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from chasles import vocabulary as w
from chasles.coq.expressions import ATOM, LOOSE, PLUS, Spelling, Unsaid
from chasles.coq.names import CoqNames
from chasles.coq.sentences import NOW
from chasles.coq.statement import CoqStatement
from chasles.statements import Goal
from chasles.statements import forms as f
from chasles.vocabulary.letters import zero_of


@dataclass(frozen=True, slots=True)
class SaidForm:
    """A form of a theorem: `said` are its equations, under no more than they need, `whole` is all of the theorem."""

    form: Any
    whole: CoqStatement
    said: CoqStatement
    certificate: Mapping[str, Any]

    @property
    def claim(self) -> str:
        """What the form says."""
        raise NotImplementedError

    def steps(self, equations: str) -> Iterator[str]:
        """The steps by which it follows from the equations, which are known by this name."""
        raise NotImplementedError

    @property
    def goals(self) -> tuple[Goal, ...]:
        """The equations."""
        return self.said.problem.goals

    @property
    def spelling(self) -> Spelling:
        """How expressions are spelled."""
        return self.said.spelling

    def applied(self, equations: str, over: w.Symbol | None = None, value: str = "") -> str:
        """The equations, for the symbols of the theorem; with another value of one of them."""
        arguments = {name: name for name, _ in self.said.binders}
        if over is not None and over in self.said.names.symbols:
            arguments[self.said.names.symbol(over)] = f"(fun _ => {value})" if self.said.moves(over) else value
        now = NOW * self.said.timed
        return f"({equations} {' '.join([*arguments.values(), *(p.name for p in self.said.premises)])}{now})"

    def freed(self, symbol: w.Symbol) -> tuple[str, Spelling]:
        """The name of a symbol, and how expressions are spelled in which it is bound."""
        names = CoqNames()
        names.symbols |= self.said.names.symbols
        names.rates |= self.said.names.rates
        return names.symbol(symbol), Spelling(
            names, lambda node, name: name if node == symbol else self.said.applied(node, name)
        )

    def vanishing(self, node: w.Node) -> str:
        """That an expression is zero."""
        return self.spelling.equation(node, zero_of(node.shape))

    def side(self, node: w.Node, said: CoqStatement | None = None) -> str:
        """An expression in the words of the whole theorem, or of a statement, as an argument."""
        spelling = (said or self.whole).spelling
        return spelling.number(node, ATOM) if node.shape == (1, 1) else f"({spelling.matrix(node)})%M"


class AlwaysSaid(SaidForm):
    """That two sides are equal."""

    @property
    def claim(self) -> str:
        return self.spelling.equation(self.goals[0].left, self.goals[0].right)

    def steps(self, equations: str) -> Iterator[str]:
        yield f"exact {self.applied(equations)}."


class IffSaid(SaidForm):
    """That one expression vanishes if and only if another one does."""

    @property
    def claim(self) -> str:
        return f"({self.vanishing(self.goals[1].left)} <-> {self.vanishing(self.goals[0].left)})"

    def steps(self, equations: str) -> Iterator[str]:
        yield f"destruct {self.applied(equations)} as [forth' back']."
        yield "split; intro zero'; [rewrite forth', zero' | rewrite back', zero']; multiple_of_zero."


class MinimumSaid(SaidForm):
    """That an expression is least at a value of a symbol."""

    @property
    def claim(self) -> str:
        match self.goals[0].left:
            case w.Sum((of, w.Negative(value))):
                name, freed = self.freed(self.form.over)
                least = f"least (fun {name} => {freed.number(of)})"
                return f"{least} {self.spelling.number(value, ATOM)} {self.side(self.form.at, self.said)}"
        raise Unsaid("a minimum that is no difference")

    def steps(self, equations: str) -> Iterator[str]:
        over, there = self.form.over, self.side(self.form.at)
        squares = [f"square'{k}" for k in range(1, len(self.goals))]
        yield "split; [|intro value']."
        yield f"- destruct {self.applied(equations, over, there)} as (excess' & {' & '.join(squares)})."
        yield f"  cbv beta in *. rewrite {', '.join(squares)}, ?dot_zero in excess'. lra."
        anywhere = self.applied(equations, over, "value'")
        yield f"- destruct {anywhere} as [excess' _]."
        yield "  cbv beta in *. apply Rge_le, Rminus_ge, Rle_ge. rewrite excess'. not_negative."


class ExistsSaid(SaidForm):
    """That there is a value of a symbol for which two sides are equal."""

    @property
    def claim(self) -> str:
        symbol = self.form.symbol
        name, freed = self.freed(symbol)
        kind = "R" if symbol.is_scalar else f"M {symbol.shape[0]} {symbol.shape[1]}"
        return f"(exists {name} : {kind}, {freed.equation(self.form.left, self.form.right)})"

    def steps(self, equations: str) -> Iterator[str]:
        yield f"exists {self.side(self.form.witness)}. exact {self.applied(equations)}."


class DefiniteSaid(SaidForm):
    """That an expression is never negative, and where it vanishes, if that is said."""

    @property
    def claim(self) -> str:
        of = self.goals[0].left
        below = f"{'positive_integral integral -> ' * self.is_integral}0 <= {self.spelling.number(of, LOOSE)}"
        if not self.form.over:
            return f"({below})"
        return f"({below} /\\ ({self.vanishing(of)} -> {self.vanishing(self.goals[1].left)}))"

    @property
    def is_integral(self) -> bool:
        """Whether integrals of squares are among what is summed."""
        return any(isinstance(part, w.Integral) for square in self.form.squares for part in w.walk(square))

    def steps(self, equations: str) -> Iterator[str]:
        if not self.form.over:
            yield f"{'intro. ' * self.is_integral}try rewrite {self.applied(equations)}. not_negative."
            return
        yield f"destruct {self.applied(equations)} as [squares' only']. try rewrite squares'."
        yield "split; [not_negative | intro zero'; vanishing zero'; rewrite only'; all_zero; multiple_of_zero]."


class OnlyWhereSaid(SaidForm):
    """That two sides are equal only where some squares vanish."""

    @property
    def claim(self) -> str:
        vanish = " /\\ ".join(f"{self.spelling.number(square, PLUS)} = 0" for square in self.form.squares)
        return f"({self.spelling.equation(self.form.left, self.form.right)} -> {vanish})"

    def steps(self, equations: str) -> Iterator[str]:
        difference = w.Sum((self.form.left, w.Negative(self.form.right)))
        yield f"intro same'. pose proof {self.applied(equations)} as less'."
        none = f"({self.spelling.matrix(difference)} = zero _ _)%M"
        yield f"assert (none' : {none}) by (apply no_difference; exact same')."
        yield "rewrite none', times_zero, zero_times, trace_zero in less'. symmetry in less'."
        yield "apply Ropp_eq_0_compat in less'. rewrite Ropp_involutive in less'. terms_vanish less'."


class UniqueSaid(SaidForm):
    """That no two values of a symbol make an expression vanish."""

    @property
    def claim(self) -> str:
        here, there = self.solutions
        residuals = [self.form.residual, w.replace(self.form.residual, {here: there})]
        both = " -> ".join(map(self.vanishing, residuals))
        return f"({both} -> {self.spelling.equation(here, there)})"

    @property
    def solutions(self) -> tuple[w.Node, w.Node]:
        """The two values."""
        match self.goals[0].left:
            case w.Sum((here, w.Negative(there))):
                return here, there
        raise Unsaid("solutions that are no difference")

    def steps(self, equations: str) -> Iterator[str]:
        equal = "Rminus_diag_uniq" if self.form.symbol.is_scalar else "same_as"
        yield f"intros here' there'. pose proof {self.applied(equations)} as difference'."
        yield f"rewrite here', there', ?minus_itself, ?Rminus_0_r in difference'. apply {equal}. rewrite difference'."
        yield "multiple_of_zero."


SAID: Mapping[type, type[SaidForm]] = {
    f.Always: AlwaysSaid,
    f.Iff: IffSaid,
    f.Minimum: MinimumSaid,
    f.Exists: ExistsSaid,
    f.Definite: DefiniteSaid,
    f.OnlyWhere: OnlyWhereSaid,
    f.Unique: UniqueSaid,
}
"""The forms that theorems have."""
