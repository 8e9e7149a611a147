"""How is a variable called in a program? By an identifier made of its name, the same in every language."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from keyword import iskeyword

import sympy
from sympy.core.function import AppliedUndef

_MARKS = {
    "'": "_prime",
    "\u2032": "_prime",
    "\u0307": "_dot",
    "\u0308": "_ddot",
    "\u0302": "_hat",
    "\u0303": "_tilde",
    "\u0304": "_bar",
    "\u0305": "_bar",
    "\u20d7": "_vec",
}
"""What is said of the marks at a letter."""
_DOTS = 3
"""As many dots are counted, as in q_dddot; further derivatives are numbered."""


def identifier(variable: sympy.Basic) -> str:
    """What a symbol, an applied function, its derivative or an entry is called; "" where nothing is left of its name.

    Derivatives by the time t are q_dot, q_ddot, others f_x_y. Greek letters and marks are spelled: omega, q_hat.
    """
    if isinstance(variable, sympy.Derivative):
        return _plain(f"{identifier(variable.expr)}{_derived(variable)}")
    if isinstance(variable, AppliedUndef):
        said = [str(each) for each in variable.args if not isinstance(each, sympy.Symbol)]
        return _plain("_".join([variable.func.__name__, *said]))
    return _plain(getattr(variable, "name", "") or str(variable))


def name_of_group(variables: Sequence[sympy.Basic]) -> str:
    """What several variables are called together: by what is left without numbers, or by how all names begin."""
    names = [identifier(variable) for variable in variables]
    if len(names) == 1:
        return names[0]
    stems = {re.sub("[0-9]+", "", name) for name in names}
    if len(stems) == 1:
        return _plain(stems.pop())
    text = names[0]
    while not all(name.startswith(text) for name in names):
        text = text[:-1]
    return _plain(text.rstrip("0123456789"))


def _derived(derivative: sympy.Derivative) -> str:
    [(variable, order), *others] = derivative.variable_count
    if not others and str(variable) == "t":
        return f"_{'d' * int(order)}ot" if order <= _DOTS else f"_d{order}"
    return "".join(f"_{each}" for each in derivative.variables)


def _plain(text: str) -> str:
    """Letters, digits and single underscores, no keyword and no number in front."""
    spelled = "".join(map(_spelled, unicodedata.normalize("NFKD", text)))
    name = re.sub("[^A-Za-z0-9]+", "_", spelled).strip("_")
    if name[:1].isdigit():
        name = f"value_{name}"
    return f"{name}_" if iskeyword(name) else name


def _spelled(letter: str) -> str:
    said = unicodedata.name(letter, "")
    if not said.startswith("GREEK"):
        return _MARKS.get(letter, letter)
    word = said.split(" WITH ")[0].split()[-1].replace("LAMDA", "LAMBDA")
    return word.capitalize() if "CAPITAL" in said else word.lower()
