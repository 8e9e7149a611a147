"""The names of symbols and of their rates in Coq; what Coq or the theories call otherwise is renamed here."""

from __future__ import annotations

import re
from functools import cache
from hashlib import sha256
from importlib.resources import files

from chasles import vocabulary as w

THEORIES = ("Words", "Hypotheses", "Reckon", "Steps", "Motion", "Bodies", "Points", "Forms", "Scalars")
"""The files that come with every folder, each requiring those before it."""
BINDERS = ("T", "t", "B", "b", "integral")
"""Instants, one of them, the elements of a body, one of them, the integral over them."""
OF_COQ = (
    "as at by cofix else end exists exists2 fix for forall fun if in let match mod return then using where with "
    "Prop Set Type SProp R M PI sin cos tan sqrt eq open_set IZR Rplus Rminus Rmult Rdiv Ropp Rinv nat bool unit "
    "exp ln sinh cosh tanh asin acos atan Rpower Rabs Rmax Rmin Rlt_dec Rle_dec Req_EM_T"
)
"""Words of Coq that statements spell: where a symbol had their name, it would be meant instead."""


def theory(name: str) -> str:
    """The text of a theory."""
    return (files("chasles.coq") / "theories" / f"{name}.v").read_text("utf-8")


@cache
def hash_of_theories(version: str) -> str:
    """The hash of the theories' texts and of the version of Coq that reads them."""
    return sha256("\0".join((version, *map(theory, THEORIES))).encode()).hexdigest()


@cache
def _taken() -> frozenset[str]:
    words = (re.findall(r"^(?:Definition|Fixpoint|Lemma) (\w+)", theory(name), re.MULTILINE) for name in THEORIES)
    return frozenset((*BINDERS, *OF_COQ.split(), *(word for found in words for word in found)))


def identifier(name: str) -> str:
    """A name that Coq accepts and that nothing else has."""
    plain = re.sub(r"(\w+)/\|\1\|", r"direction_of_\1", name.replace("~", "_tilde").replace("'", "_prime"))
    plain = re.sub(r"\|(\w+)\|", r"length_of_\1", plain)
    plain = re.sub(r"\W", "_", plain, flags=re.ASCII)
    return f"{plain}_" if plain in _taken() or not plain[0].isalpha() else plain


class CoqNames:
    """What each symbol, and the rate of each expression, is called in one statement; as in others it is `like`."""

    def __init__(self, like: CoqNames | None = None) -> None:
        self._like = like
        self.symbols: dict[w.Symbol, str] = {}
        self.rates: dict[w.Rate, str] = {}

    def symbol(self, symbol: w.Symbol) -> str:
        """The name of a symbol."""
        if symbol not in self.symbols:
            known = self._like.symbols.get(symbol) if self._like else None
            self.symbols[symbol] = known or self.fresh(identifier(symbol.name))
        return self.symbols[symbol]

    def rate(self, node: w.Rate) -> str:
        """The name of the function that is the rate of an expression."""
        of = bare_of(node.of)
        key = w.Rate(of)
        if self._like and key in self._like.rates:
            self.rates[key] = self._like.rates[key]
        if key not in self.rates:
            match of:
                case w.Symbol():
                    stem = f"{self.symbol(of)}_dot"
                case w.Rate() if self.rate(of).endswith("dot"):
                    stem = f"{self.rate(of)[:-3]}ddot"
                case _:
                    stem = f"rate_{len(self.rates) + 1}"
            self.rates[key] = self.fresh(stem)
        return self.rates[key]

    def fresh(self, stem: str) -> str:
        """The name, with as many marks as make it new."""
        while stem in self.symbols.values() or stem in self.rates.values():
            stem += "_"
        return stem


def bare_of(node: w.Node) -> w.Node:
    """An expression without the brackets and the argument that the author prints."""
    while isinstance(node, w.At | w.Group):
        node = node.of
    return node
