"""The statements written for Coq, read back by a reader of their own, say what the declarations say, word by word.

Nothing of how they are spelled is used here but what each symbol is called.
"""

from __future__ import annotations

import re
from functools import cache

import pytest

from chasles import vocabulary as w
from chasles.coq.expressions import Unsaid
from chasles.coq.quantifiers import cover_and_proof, theorem_and_proof
from chasles.coq.sentences import failing, holding, satisfiable
from chasles.coq.statement import CoqStatement
from chasles.coq.theorems import claims_of
from chasles.decisions.decision import Decision
from chasles.decisions.session import Session
from chasles.statements import Claim, Condition, Inverse, Theorem, load, problem_of, unit
from chasles.statements.forms import Always, Definite, Form, Iff, Minimum, OnlyWhere
from chasles.statements.inequalities import says_that
from chasles.statements.inversion import COVER, problems_of_inverse
from chasles.statements.problem import Goal, Problem
from chasles.verdict import Holds, HoldsUnder
from chasles.vocabulary.sizes import Size

from .decided import chapter_session

Tree = tuple[object, ...] | str
TOKEN = re.compile(r"\s*(%M|\*:|:=|->|=>|<=|<>|/\\|[A-Za-z_][\w']*|\d+|[-+*/^()=,<])")


class Reader:
    """Coq's precedences: application, powers, minus, products, sums; `^T` binds closest of all."""

    def __init__(self, text: str) -> None:
        self.tokens = TOKEN.findall(text)
        assert "".join(self.tokens) == re.sub(r"\s", "", text)
        self.place = 0

    @property
    def next(self) -> str:
        return self.tokens[self.place] if self.place < len(self.tokens) else ""

    def take(self, expected: str = "") -> str:
        token = self.next
        assert token == expected or not expected, (token, expected, self.tokens)
        self.place += 1
        return token

    def sum(self) -> Tree:
        tree = self.product()
        while self.next in ("+", "-"):
            tree = (self.take(), tree, self.product())
        return tree

    def product(self) -> Tree:
        tree = self.minus()
        while self.next in ("*", "/", "*:"):
            tree = (self.take(), tree, self.minus())
        return tree

    def minus(self) -> Tree:
        if self.next == "-":
            self.take()
            return ("neg", self.minus())
        base = self.application()
        if self.next == "^":
            self.take()
            return ("^", base, self.minus())
        return base

    def application(self) -> Tree:
        parts = [self.atom()]
        while re.match(r"[A-Za-z_(\d]", self.next) and self.next not in ("t", "b"):
            parts.append(self.atom())
        return parts[0] if len(parts) == 1 else tuple(parts)

    def atom(self) -> Tree:
        if self.next == "(":
            self.take()
            if self.next == "fun":
                self.take()
                binder = self.take()
                self.take("=>")
                tree: Tree = ("fun", binder, self.sum())
            else:
                tree = self.sum()
            self.take(")")
        else:
            tree = self.take()
            while self.next in ("t", "b"):  # what a function of time, or of an element, is there
                self.take()
        if self.next == "%M":
            self.take()
        while self.next == "^" and self.tokens[self.place + 1] == "T":
            self.take()
            self.take()
            tree = ("^T", tree)
        return tree


def equation(text: str) -> Tree:
    """An equation as a tree."""
    inner = text.strip().removesuffix("%M")
    inner = inner[1:-1] if inner != text.strip() else inner
    reader = Reader(inner)
    left = reader.sum()
    reader.take("=")
    right = reader.sum()
    assert reader.place == len(reader.tokens), text
    return ("=", left, right)


class Expected:
    """What a declaration says, as such a tree."""

    def __init__(self, said: CoqStatement) -> None:
        self.names = said.names

    def side(self, node: w.Node) -> Tree:
        return self.number(node) if node.shape == (1, 1) else self.matrix(node)

    def number(self, node: w.Node) -> Tree:
        match node:
            case w.At(of) | w.Group(of) | w.Transpose(of):
                return self.number(of)
            case w.Number(value):
                size = str(abs(value.numerator))
                tree: Tree = size if value >= 0 else ("neg", size)
                return tree if value.denominator == 1 else ("/", tree, str(value.denominator))
            case w.Zero():
                return "0"
            case w.Identity():
                return "1"
            case w.Norm(of) | w.Trace(of) | w.Determinant(of):
                return ({"Norm": "norm", "Trace": "trace", "Determinant": "det"}[type(node).__name__], self.matrix(of))
            case w.Dot(one, other):
                return ("dot", self.matrix(one), self.matrix(other))
            case w.Call(function, argument):
                return (function, self.number(argument))
            case w.Scale(one, other):
                return ("*", self.number(one), self.number(other))
            case w.Contract() | w.Block():
                return ("the", self.matrix(node))
            case w.Integral(of):
                return ("integral", ("fun", "b", self.number(of)))
        return self.alike(node, self.number)

    def matrix(self, node: w.Node) -> Tree:
        match node:
            case w.At(of) | w.Group(of):
                return self.matrix(of)
            case w.Contract((first, *others)):
                tree = self.matrix(first)
                for each in others:
                    tree = ("*", tree, self.matrix(each))
                return tree
            case w.Block(rows):
                return folded("below", [folded("beside", [self.matrix(each) for each in row]) for row in rows])
            case _ if node.shape == (1, 1):
                return ("number", self.number(node))
            case w.Zero(rows, columns):
                return ("zero", str(rows), str(columns))
            case w.Identity(size):
                return ("one", str(size))
            case w.Scale(one, other):
                return ("*:", self.number(one), self.matrix(other))
            case w.Transpose(of):
                return ("^T", self.matrix(of))
            case w.Skew(of) | w.Vect(of) | w.Cofactor(of):
                return ({"Skew": "CPM", "Vect": "vect", "Cofactor": "cofactor"}[type(node).__name__], self.matrix(of))
            case w.Cross(one, other):
                return ("cross", self.matrix(one), self.matrix(other))
            case w.Integral(of):
                return ("integrated", "integral", ("fun", "b", self.matrix(of)))
        return self.alike(node, self.matrix)

    def alike(self, node: w.Node, part) -> Tree:  # type: ignore[no-untyped-def]
        match node:
            case w.Symbol():
                return "PI" if node == w.PI else self.names.symbols[node]
            case w.Rate():
                return self.names.rate(node)
            case w.Negative(of):
                return ("neg", part(of))
            case w.Quotient(one, other):
                return ("/", part(one), self.number(other))
            case w.Power(of, exponent):
                return ("^", part(of), str(exponent))
            case w.Sum((first, *others)):
                tree = part(first)
                for each in others:
                    minus = isinstance(each, w.Negative)
                    tree = ("-" if minus else "+", tree, part(each.term if minus else each))
                return tree
        raise AssertionError(node)


def folded(word: str, parts: list[Tree]) -> Tree:
    return parts[0] if len(parts) == 1 else (word, parts[0], folded(word, parts[1:]))


@cache
def problems() -> list[tuple[str, Problem]]:
    found = []
    for entry in load():
        decision = chapter_session().decide(entry.statement)
        if not hasattr(decision.verdict, "certificate") or decision.verdict.name == "contradictory":
            continue
        if isinstance(entry.statement, Inverse):
            found += [(entry.number, each) for _, each in problems_of_inverse(entry.statement, decision.accepted)]
        else:
            found.append((entry.number, problem_of(entry.statement, "printed", decision.accepted)))
    return found


HYPOTHESES = {"unit": "unit_vector", "symmetric": "symmetric", "definite": "definite", "rotation": "rotation",
              "perpendicular": "perpendicular", "orthonormal": "orthonormal", "half_turn": "half_turn"}  # fmt: skip


def equations_of(text: str) -> tuple[list[Tree], list[Tree], list[Tree]]:
    """The equations that a statement assumes, those that it claims, and the words of which something is assumed."""
    assumed, claims, words = parts_of(text)
    return assumed, [equation(each) for each in claims], words


def parts_of(text: str) -> tuple[list[Tree], list[str], list[Tree]]:
    """The same, the claims as they are written."""
    body = re.sub(r"^Definition .*?:=\n(?:  forall .*?,\n)?", "", text, flags=re.DOTALL).rstrip().removesuffix(".")
    *premises, claim = body.split(" ->\n")
    assumed, words = assumed_in(premises)
    claim = re.sub(r"^  during T \(fun t =>\s*(.*)\)$", r"\1", claim, flags=re.DOTALL)
    return assumed, claim.split(" /\\\n"), words


def assumed_in(premises: list[str]) -> tuple[list[Tree], list[Tree]]:
    """The equations and the words that are assumed."""
    assumed: list[Tree] = []
    words: list[Tree] = []
    for premise in premises:
        inner = premise.strip()
        inner = re.sub(r"^during T \(fun t => (.*)\)$", r"\1", inner, flags=re.DOTALL)
        inner = re.sub(r"^\((forall b, .*)\)$", r"\1", inner, flags=re.DOTALL).removeprefix("forall b, ")
        if re.search(r"(?<![:=<])=(?!>)", inner) and not inner.startswith(("rate", "scalar_rate")):
            assumed.append(equation(inner))
        elif "<" not in inner:
            words.append(Reader(inner).sum())
    return assumed, words


def words_expected(said: CoqStatement, expected: Expected) -> list[Tree]:
    """The hypotheses that have words, and what is assumed to be the rate of what."""
    found: list[Tree] = []
    for h in said.problem.hypotheses:
        if h.kind in HYPOTHESES:
            found.append((HYPOTHESES[h.kind], *map(expected.matrix, h.subjects)))
    for node, name in said.names.rates.items():
        of = expected.side(node.of)
        of = of if isinstance(of, str) and not said.runs(node) and said.moves(node.of) else ("fun", "t", of)
        value = ("fun", "t", name) if said.runs(node) else name
        found.append(("scalar_rate" if node.shape == (1, 1) else "rate", "T", of, value))
    return found


def test_statements_read_back_say_what_is_declared() -> None:
    assert len(problems()) >= 290
    for number, problem in problems():
        said = CoqStatement(problem)
        text = holding("statement", said)
        assumed, claimed, words = equations_of(text)
        expected = Expected(said)
        goals = [("=", expected.side(goal.left), expected.side(goal.right)) for goal in problem.goals]
        assert claimed == goals, number
        pairs = [(goal.left, goal.right) for goal in problem.conditions]
        pairs += [(left, right) for left, right in said.rules.items() if said.is_named(left)]
        given = [("=", expected.side(left), expected.side(right)) for left, right in pairs]
        assert all(each in assumed for each in given), number
        assert {*words_expected(said, expected)} == {
            each for each in words if each[0] not in ("open_set", "linear", "differentiable_under")
        }, number
        others = len(assumed) - len(given)
        assert others == sum(
            len(h.equations) for h in problem.hypotheses if h.kind in ("unit column", "direction", "untaken")
        )


def test_what_fails_is_the_negation_of_what_would_hold() -> None:
    for number, problem in problems()[::7]:
        said = CoqStatement(problem)
        negated = re.fullmatch(
            r"Definition statement : Prop := ~ \(\n(.*)\)\.\n", failing("statement", said), re.DOTALL
        )
        assert negated is not None
        text = f"Definition statement : Prop :=\n{negated[1]}.\n"
        assert equations_of(text) == equations_of(holding("statement", said)), number
        assert bound_in(text, "forall") == said.binders, number


def test_what_is_assumed_is_what_there_is_said_to_be() -> None:
    for number, problem in problems():
        said = CoqStatement(problem)
        if not said.premises:
            continue
        text = satisfiable("statement", said)
        body = re.sub(r"^Definition .*?:=\n(?:  exists .*?,\n)?", "", text, flags=re.DOTALL).rstrip().removesuffix(".")
        whole, _, words = equations_of(holding("statement", said))
        assert assumed_in(body.split(" /\\\n")) == (whole, words), number
        assert bound_in(text, "exists") == said.binders, number


def decided(kind: type) -> list[tuple[str, Decision]]:
    found = [(entry.number, chapter_session().decide(entry.statement)) for entry in load()]
    return [(number, decision) for number, decision in found if isinstance(decision.statement, kind)]


def form_expected(form: Form, goals: list[Goal], expected: Expected) -> Tree:
    """What a form of a theorem says, as a tree."""

    def vanishing(node: w.Node) -> Tree:
        return ("=", expected.side(node), "0" if node.is_scalar else expected.matrix(w.Zero(*node.shape)))

    match form:
        case Always(left, right):
            return ("=", expected.side(left), expected.side(right))
        case Iff():
            return ("<->", vanishing(goals[1].left), vanishing(goals[0].left))
        case Minimum(over=over, at=at):
            of = goals[0].left
            assert isinstance(of, w.Sum)
            least, value = of.terms
            assert isinstance(value, w.Negative)
            function: Tree = ("fun", expected.names.symbols[over], expected.number(least))
            return ("least", function, expected.number(value.term), expected.side(at))
        case Definite(of=of, squares=squares, over=over):
            below: Tree = ("<=", expected.number(of))
            if any(isinstance(part, w.Integral) for square in squares for part in w.walk(square)):
                return ("if positive", below)
            return (below, vanishing(of), vanishing(w.column(*over))) if over else below
        case OnlyWhere(left=left, right=right, squares=squares):
            return (("=", expected.side(left), expected.side(right)), *map(vanishing, squares))
    raise AssertionError(form)


def form_read(text: str) -> Tree:
    text = text.strip()
    return form_inside(text[1:-1] if "->" in text or "<=" in text else text)


def form_inside(text: str) -> Tree:
    if found := re.fullmatch(r"(.*) <-> (.*)", text):
        return ("<->", equation(found[1]), equation(found[2]))
    if text.startswith("positive_integral integral -> "):
        return ("if positive", form_inside(text.removeprefix("positive_integral integral -> ")))
    if found := re.fullmatch(r"0 <= (.*?)(?: /\\ \((.*) -> (.*)\))?", text):
        below = ("<=", Reader(found[1]).sum())
        return (below, equation(found[2]), equation(found[3])) if found[2] else below
    if found := re.fullmatch(r"(.*?) -> (.*)", text):
        return (equation(found[1]), *map(equation, found[2].split(" /\\ ")))
    return Reader(text).sum() if text.startswith("least") else equation(text)


def test_theorems_read_back_say_what_is_declared() -> None:
    read = 0
    for number, decision in decided(Theorem):
        assert isinstance(decision.statement, Theorem)
        assert isinstance(decision.verdict, HoldsUnder | Holds)
        problem = problem_of(decision.statement, "printed", decision.accepted)
        said = CoqStatement(problem)
        try:
            text, _ = theorem_and_proof("statement", decision.statement, said, decision.verdict.certificate)
        except Unsaid:
            continue
        assumed, claims, words = parts_of(text)
        whole, _, others = equations_of(holding("statement", said))
        assert (assumed, words) == (whole, others), number
        assert bound_in(text, "forall") == said.binders
        goals = iter(problem.goals)
        for form, claim in zip(decision.statement.forms, claims, strict=True):
            its = [next(goals) for _ in form.equations()]
            assert form_read(claim) == form_expected(form, its, Expected(said)), number
        read += 1
    assert read == 15


def test_of_cases_one_is_said_to_apply() -> None:
    for number, decision in decided(Inverse):
        assert isinstance(decision.statement, Inverse)
        problem = dict(problems_of_inverse(decision.statement, decision.accepted))[COVER]
        said = CoqStatement(problem)
        text, _ = cover_and_proof("statement", said, decision.verdict.certificate["branches"][COVER])  # type: ignore[attr-defined]
        _, [claim], _ = parts_of(text)
        cases = [Reader(each.removesuffix(" <> 0")).sum() for each in claim.strip().split(" \\/ ")]
        assert all(each.endswith(" <> 0") for each in claim.strip().split(" \\/ "))
        assert cases == [Expected(said).number(branch.where) for branch in decision.statement.branches], number


def bound_in(text: str, word: str) -> list[tuple[str, str]]:
    """The names that are bound, with their types."""
    found = re.search(rf"^  {word} (.*?),$", text, re.MULTILINE)
    groups = re.findall(r"\(([^:()]+) : ((?:[^()]|\([^()]*\))+)\)", found[1]) if found else []
    return [(name, kind) for names, kind in groups for name in names.split()]


@pytest.mark.parametrize(
    ("one", "other"),
    [("a - (b - c) = d", "a - b - c = d"), ("(- a) * b = d", "- (a * b) = d"), ("(a * b)^T = d", "a * b^T = d")],
)
def test_the_reader_tells_apart(one: str, other: str) -> None:
    assert equation(one) != equation(other)


def test_what_cannot_be_said_is_refused() -> None:
    x = w.scalar("x", "x", "") if hasattr(w, "scalar") else None
    assert x is not None
    with pytest.raises(Unsaid):
        CoqStatement(Problem(())).spelling.number(abs(x))


x, y, a = (w.scalar(name, name, name, w.LENGTH) for name in "xya")
mass, u = w.scalar("mass", "m", "a mass", w.MASS), w.vector("u", "u", "a vector")
P, Q = (w.square(name, name, "a matrix", size=Size("n")) for name in "PQ")
SUM, DIFFERENCE = Condition("1", x + y, a, on=(x, y)), Condition("2", x - y, w.number(0) * a, on=(x, y))


@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        (Claim("3", x, u, sic=True), ""),
        (Claim("4", x, mass, sic=True), "its sizes fit together"),
        (Claim("5", w.norm(u) ** 2 / w.norm(u), w.norm(u)), ""),
        (Claim("6", w.rate(x), w.rate(a) / 2, given=(SUM, DIFFERENCE)), "the rate of x, which conditions determine"),
        (Claim("7", w.rate(w.det(w.CPM(u) @ w.CPM(u))), w.number(0)), "the rate of a determinant"),
        (Claim("8", *says_that(w.dot(u, u) >= 0)), ""),
        (Claim("9", (P @ Q).T, Q.T @ P.T), "matrices of any size"),
        (Claim("10", P @ Q, Q @ P, sic=True), "matrices of any size"),
    ],
)
def test_what_coq_is_not_told_has_a_reason(claim: Claim, reason: str) -> None:
    first, *_ = claims_of([Session().decide(claim)])
    assert bool(first.proof) == (not reason)
    assert reason in first.why_not


def test_that_a_statement_with_functions_fails_is_said_entry_by_entry() -> None:
    number = w.scalar("x", "x", "a number")
    normal = w.vector("n", "n", "a direction")
    wrong = Claim("1", abs(number) * normal, number * normal, assuming=(unit(normal),))
    claim = next(claims_of([Session().decide(wrong)]))
    assert claim.said.startswith("Definition eq_1_1_fails : Prop := ~ (")
    assert "n_1 * Rabs x = n_1 * x" in claim.said
    assert claim.proof
