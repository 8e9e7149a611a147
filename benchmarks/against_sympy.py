"""The same equations, asked of chasles and of SymPy: how long each takes, and how often it is right.

Run it as `python benchmarks/against_sympy.py [--budget SECONDS] [--every N]` from the root of a checkout, in an
environment with the tests' requirements. What is asked: every claim of the chapter that SymPy can be given in
components, as it stands, and one slip of the pen in it. SymPy is asked as its users ask it, whether the difference of
the two sides comes out as zero:

- `simplify` and `trigsimp`, with unit vectors written by two angles, rotations by three;
- `polys.reduced`, the numerators divided by the side conditions.

An answer is wrong if something true does not come out as zero, or something false does; there is none when the budget
is spent. SymPy works in components of time-dependent functions, as the chapter's rates demand.
"""

from __future__ import annotations

import argparse
import signal
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from statistics import median
from time import perf_counter

import sympy
from sympy.physics.vector import dynamicsymbols

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.mutation import mutants_of
from tests.sympy_words import in_sympy

from chasles.decisions.session import Session
from chasles.prover.decide import decide_problem
from chasles.statements import Claim, Hypothesis, Problem, load, problem_of
from chasles.vocabulary import Call, Integral, Misfit, Node, Symbol, walk

TREATED = ("unit", "nonzero", "positive", "rotation")
"""The hypotheses that a user of SymPy can put in."""
Values = dict[Node, sympy.Matrix]
Solver = Callable[[sympy.Matrix, list[sympy.Expr]], bool]


class NotPosed(Exception):
    """The question cannot be put to SymPy in components."""


class OutOfBudget(Exception):
    """The time is over."""


@dataclass
class Tally:
    """How often a solver was right, wrong, or without an answer, and how long it took each time."""

    answers: Counter[str] = field(default_factory=Counter)
    seconds: list[float] = field(default_factory=list)

    def row(self, name: str) -> str:
        """A line of the table."""
        said = (f"{self.answers[answer]:6}" for answer in ("right", "wrong", "none"))
        return f"{name:28}{''.join(said)}{1000 * median(self.seconds):12.1f}{sum(self.seconds):10.1f}"


def questions(every: int) -> Iterator[tuple[Problem, Claim, bool]]:
    """Claims that stand, and of each one mutant that chasles refutes, with whether it is true."""
    book = load()
    judge = Session(book=book)
    standing = [d.repaired for _, d in judge.decide_all(book) if isinstance(d.statement, Claim) and d.stands]
    for claim in islice(standing, 0, None, every):
        assert isinstance(claim, Claim)
        if claim.restates is not None or claim.solves is not None:
            continue
        yield problem_of(claim, standing=judge.accepted), claim, True
        for mutant in mutants_of(claim, "printed", []):
            assert isinstance(mutant.statement, Claim)
            try:
                problem = problem_of(mutant.statement, standing=judge.accepted)
            except (Misfit, TypeError):
                continue
            if decide_problem(problem).name == "fails":
                yield problem, mutant.statement, False
                break


class InComponents:
    """A problem in SymPy's components: `angular` writes unit vectors and rotations by free parameters."""

    def __init__(self, problem: Problem, angular: bool) -> None:
        if problem.unknowns or any(h.kind not in TREATED for h in problem.hypotheses):
            raise NotPosed
        self.values: Values = {}
        self.conditions: list[sympy.Expr] = []
        self._angular = angular
        self._rules = dict(problem.rules)
        self._kinds = {subject: h for h in problem.hypotheses for subject in h.subjects}
        differences = [self.read(goal.left) - self.read(goal.right) for goal in problem.goals]
        self.difference = sympy.Matrix([entry for difference in differences for entry in difference])

    def read(self, node: Node) -> sympy.Matrix:
        """The expression in components."""
        for part in walk(node):
            if isinstance(part, Integral) or (isinstance(part, Call) and part.function not in ("sin", "cos")):
                raise NotPosed
            if isinstance(part, Symbol) and part not in self.values:
                self._declare(part)
        try:
            return in_sympy(node, self.values)
        except (TypeError, KeyError) as error:
            raise NotPosed from error

    def _declare(self, symbol: Symbol) -> None:
        if symbol in self._rules:
            self.values[symbol] = self.read(self._rules[symbol])
        elif symbol.stands_for is not None:
            self.read(symbol.stands_for)
        else:
            self.values[symbol] = self._components(symbol, self._kinds.get(symbol))

    def _components(self, symbol: Symbol, hypothesis: Hypothesis | None) -> sympy.Matrix:
        name = symbol.name.replace("'", "_")
        make = sympy.Symbol if symbol.constant else dynamicsymbols
        rows, columns = symbol.shape
        kind = hypothesis.kind if hypothesis else ""
        if kind == "unit" and self._angular:
            one, other = make(f"{name}_alpha"), make(f"{name}_beta")
            sine = sympy.sin(one)
            return sympy.Matrix([sine * sympy.cos(other), sine * sympy.sin(other), sympy.cos(one)])
        if kind == "rotation" and self._angular:
            turns = (sympy.rot_ccw_axis3, sympy.rot_ccw_axis2, sympy.rot_ccw_axis3)
            angles = (make(f"{name}_{angle}") for angle in ("alpha", "beta", "gamma"))
            one, two, three = (turn(angle) for turn, angle in zip(turns, angles, strict=True))
            return one * two * three
        made = sympy.Matrix(rows, columns, lambda i, j: make(f"{name}_{i}{j}"))
        if kind == "unit":
            self.conditions.append((made.T * made)[0] - 1)
        if kind == "rotation":
            self.conditions += list(made.T * made - sympy.eye(3))
        return made


def is_zero_after(simplifier: Callable[[sympy.Expr], sympy.Expr]) -> Solver:
    """Whether every entry becomes zero."""
    return lambda difference, _: all(simplifier(entry) == 0 for entry in difference)


def reduces_to_zero(difference: sympy.Matrix, conditions: list[sympy.Expr]) -> bool:
    """Whether every numerator is a combination of the conditions, by division in the order given."""
    time = dynamicsymbols._t
    derived = [each for c in conditions for each in (c, c.diff(time), c.diff(time, 2)) if each != 0]
    for entry in difference:
        asked = [sympy.fraction(sympy.together(sympy.expand_trig(entry)))[0], *derived]
        atoms = set().union(*(each.atoms(sympy.Derivative, sympy.Function, sympy.Symbol) for each in asked)) - {time}
        angles = {atom.args[0] for atom in atoms if atom.func == sympy.sin}
        asked += [sympy.sin(angle) ** 2 + sympy.cos(angle) ** 2 - 1 for angle in sorted(angles, key=str)]
        names = {atom: sympy.Symbol(f"x{k}") for k, atom in enumerate(sorted(atoms, key=sympy.default_sort_key))}
        dividend, *divisors = (sympy.expand(each.xreplace(names)) for each in asked)
        left = dividend if dividend == 0 or not divisors else sympy.reduced(dividend, divisors, *names.values())[1]
        if left != 0:
            return False
    return True


SOLVERS: dict[str, tuple[Solver, bool]] = {
    "sympy.simplify": (is_zero_after(sympy.simplify), True),
    "sympy.trigsimp": (is_zero_after(lambda e: sympy.trigsimp(sympy.expand(e))), True),
    "sympy.polys.reduced": (reduces_to_zero, False),
}


def within(seconds: float, work: Callable[[], bool]) -> bool:
    """What the work says; raises OutOfBudget."""

    def stop(*_: object) -> None:
        raise OutOfBudget

    signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        return work()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


def asked(solver: Solver, angular: bool, problem: Problem, budget: float) -> bool | None:
    """The answer of one solver; None where it has none."""
    try:

        def work() -> bool:
            posed = InComponents(problem, angular)
            return solver(posed.difference, posed.conditions)

        return within(budget, work)
    except (OutOfBudget, NotPosed, sympy.PolynomialError, NotImplementedError, RecursionError):
        return None


def main() -> None:
    """Print a line for each solver."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--budget", type=float, default=5.0, help="seconds for one question to one solver")
    parser.add_argument("--every", type=int, default=1, help="only every n-th claim")
    options = parser.parse_args()
    tallies = {name: Tally() for name in ("chasles", *SOLVERS)}
    count = 0
    for problem, _, true in questions(options.every):
        try:
            InComponents(problem, angular=False)
        except NotPosed:
            continue
        count += 1
        ours = lambda problem=problem: decide_problem(problem).true  # noqa: E731
        for name, tally in tallies.items():
            started = perf_counter()
            answer = ours() if name == "chasles" else asked(*SOLVERS[name], problem, options.budget)
            tally.seconds.append(perf_counter() - started)
            tally.answers["none" if answer is None else "right" if answer == true else "wrong"] += 1
    print(f"{count} equations, half of them false; {options.budget:g} s for each")
    print(f"{'':28}{'right':>6}{'wrong':>6}{'none':>6}{'median ms':>12}{'total s':>10}")
    for name, tally in tallies.items():
        print(tally.row(name))


if __name__ == "__main__":
    main()
