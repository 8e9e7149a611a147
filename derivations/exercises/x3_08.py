"""Exercise 3.8: vector products with one vector, over and over."""

from chasles.derivations.notation import omega, one, p

from chasles.exact.evaluate import Value
from chasles.exercises.draw import Draw
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim, Theorem
from chasles.statements.exercise import Answer, Datum, Exercise, Scalar, Word, vector_shape
from chasles.statements.induction import ForAllK
from chasles.vocabulary import FREQUENCY, LENGTH, cross, norm, number, paren, scalar, vector

MOST = 64
sign = scalar("(-1)^k", "(-1)^k", "the sign that changes with each k")
power, power_of_odd = (
    scalar(f"|omega|^{plain}", rf"\|\boldsymbol{{\omega}}\|^{{{plain}}}", "a power of the length of omega")
    for plain in ("2(k-1)", "2k")
)
even = vector("x_2k", r"x_{2k}", "what 2k factors make of p", LENGTH * FREQUENCY**2)
odd = vector("x_2k+1", r"x_{2k+1}", "what 2k+1 factors make of p", LENGTH * FREQUENCY)
squared = norm(omega) ** 2
twice = {x: cross(omega, cross(omega, x)) for x in (even, odd, p)}

formula_of_even = sign * paren(power * squared * one - power * omega @ omega.T) @ p
formula_of_odd = sign * cross(paren(power_of_odd * omega), p)

even_number_of_factors = Theorem(
    "Ex 3.8",
    says="The formula for 2k factors holds for every k from 1 on.",
    forms=(
        ForAllK(
            even,
            formula_of_even,
            first=twice[p],
            following=twice[even],
            at_first=((sign, number(-1)), (power, number(1))),
            afterwards=((sign, -sign), (power, power * squared)),
        ),
    ),
)

odd_number_of_factors = Theorem(
    "Ex 3.8",
    part=2,
    says="The formula for 2k+1 factors holds for every k from 0 on.",
    forms=(
        ForAllK(
            odd,
            formula_of_odd,
            first=cross(omega, p),
            following=twice[odd],
            at_first=((sign, number(1)), (power_of_odd, number(1))),
            afterwards=((sign, -sign), (power_of_odd, power_of_odd * squared)),
        ),
    ),
)

no_factor_at_all = Claim(
    "Ex 3.8",
    squared * p,
    paren(squared * one - omega @ omega.T) @ p,
    part=3,
    says="For k = 0 the formula for 2k factors, times |omega|^2, would say this of p itself.",
)


def solve(sheet: Worksheet) -> str:
    """Both formulas by induction; then the product, factor by factor, and by the formula."""
    count = int(sheet["factors"])
    sheet.state(even_number_of_factors, "An even number of factors, by induction over k; both equations hold for all.")
    sheet.state(odd_number_of_factors, "An odd number of factors, in the same way.")
    sheet.refute(no_factor_at_all, "It fails for k = 0, unless omega is perpendicular to p.")
    sheet.given({omega: sheet["omega"], p: sheet["p"]}, "The vectors.")
    value = sheet["p"]
    for _ in range(count):
        value = sheet.value(cross(omega, p), {p: value})
    sheet.step(f"{count} factors, one after the other.", ("value", value))
    if count:
        half, is_odd = divmod(count, 2)
        length = sheet.value(squared)
        at = {sign: (-1) ** half, power_of_odd if is_odd else power: length ** (half if is_odd else half - 1)}
        formula = formula_of_odd if is_odd else formula_of_even
        sheet.show(formula, f"The formula, with k = {half}.", at=at)
        sheet.check((sheet.value(formula, at), value), "The formula gives the same.")
    sheet.answer(value=value, even_formula_holds_for="k >= 1", odd_formula_holds_for="k >= 0")
    return "ok"


def instance(draw: Draw) -> dict[str, Value]:
    """Small integers."""
    return draw.written(omega=draw.vector(), p=draw.vector()) | {"factors": draw.integer(2, 6)}


exercise = Exercise(
    "3.8",
    "Vector products over and over",
    asked=(
        "Show what 2k vector products with omega make of p.",
        "Show what 2k+1 of them make of it.",
    ),
    data=(
        Datum("omega", vector_shape(), [1, 2, 2], "the vector that multiplies"),
        Datum("p", vector_shape(), [1, 0, -1], "the vector that is multiplied"),
        Datum("factors", Scalar(integer=True, least=0, most=MOST), 4, "how many omegas"),
    ),
    stand_ins={
        "omega": "The book gives no numbers; omega = (1, 2, 2) stands in.",
        "p": "p = (1, 0, -1) stands in.",
        "factors": "Four factors stand in.",
    },
    solve=solve,
    instance=instance,
    answers=(
        Answer("value", vector_shape(), "p after so many vector products with omega from the left"),
        *(
            Answer(f"{name}_formula_holds_for", Word(("k >= 0", "k >= 1", "k >= 2")), f"which k, {count} factors")
            for name, count in (("even", "2k"), ("odd", "2k+1"))
        ),
    ),
)
