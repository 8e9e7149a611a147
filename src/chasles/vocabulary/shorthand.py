"""Words that are short for simpler ones: what they mean is said once, in the word, and everything else follows."""

from __future__ import annotations

from functools import lru_cache
from typing import ClassVar

from chasles.vocabulary.fitting import measured
from chasles.vocabulary.measure import Measure
from chasles.vocabulary.nodes import Node
from chasles.vocabulary.tree import with_inner


class Shorthand(Node):
    """A word that is short for its `definition`; printed as the `function` of its parts.

    Decided, checked, lowered and evaluated is the definition, whose shape and dimensions the word has.
    """

    __slots__ = ()
    function: ClassVar[str]

    @property
    def definition(self) -> Node:
        """The same in simpler words. Raises `Misfit` for parts that do not fit together."""
        raise NotImplementedError(type(self).__name__)

    def _measured(self) -> Measure:
        return measured(self.definition)


@lru_cache(maxsize=4096)
def opened(node: Node) -> Node:
    """The expression with every defined word in it said in simpler words."""
    if isinstance(node, Shorthand):
        return opened(node.definition)
    return with_inner(node, opened)
