"""Exercise 3.17: the rate of the inertia dyad, and with it that of the momentum screw."""

from chasles.derivations.exercises.calculations.turning import graph_of_rate
from chasles.derivations.notation import M, W_dyad, mu, t
from chasles.derivations.s08_dynamics import (
    inertia_turns_with_the_body,
    momentum_screw_by_dyad,
    rate_of_inertia_dyad,
    rate_of_momentum_screw_by_rate_of_dyad,
    twist_is_in_null_space,
)

from chasles.exercises.picture import Picture
from chasles.exercises.solution import Proofs
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim, Statement
from chasles.statements.exercise import Exercise
from chasles.vocabulary import rate

product_rule = Claim(
    "Ex 3.17",
    rate(mu),
    M @ rate(t) + rate(M) @ t,
    part=4,
    says="The rate of the momentum screw by the product rule.",
    given=(momentum_screw_by_dyad,),
)

rate_substituted = Claim(
    "Ex 3.17",
    rate(mu),
    M @ rate(t) + W_dyad @ M @ t - M @ W_dyad @ t,
    part=5,
    says="The rate of the dyad, substituted.",
    given=(momentum_screw_by_dyad, rate_of_inertia_dyad),
)

STEPS = (
    (inertia_turns_with_the_body, "The moment of inertia at C turns with the body; the mass stays."),
    (rate_of_inertia_dyad, "Blockwise: the rate of the inertia dyad."),
    (product_rule, "The momentum screw is a product."),
    (rate_substituted, "Into it goes the rate of the dyad."),
    (twist_is_in_null_space, "Its last term vanishes: the twist lies in the null space of W."),
    (rate_of_momentum_screw_by_rate_of_dyad, "What remains is (3.143)."),
)


def proved(sheet: Worksheet, steps: tuple[tuple[Statement, str], ...]) -> str:
    """Each step is decided where it is cited; the answers say what is proved, and under which hypotheses."""
    proofs = []
    for statement, says in steps:
        sheet.state(statement, says)
        (citation,) = sheet.steps[-1].cites
        number = f"{citation.shown} part {citation.part}"
        needs = list(citation.needs)
        proofs.append({"number": number, "says": statement.says, "verdict": citation.verdict, "needs": needs})
    sheet.answer(proofs=Proofs(proofs))
    return "ok"


def solve(sheet: Worksheet) -> str:
    """A road of decided steps."""
    sheet.picture = Picture("A moment of inertia in fixed axes, and its rate", (graph_of_rate(),))
    return proved(sheet, STEPS)


exercise = Exercise(
    "3.17",
    "The rate of the inertia dyad",
    asked=(
        "Show that the rate of the inertia dyad is W M - M W.",
        "Show with it that the rate of the momentum screw is M dt/dt + W M t.",
    ),
    assumptions=("The inertia dyad, the twist and the momentum screw are those at the center of mass.",),
    solve=solve,
)
