"""What is printed in LaTeX is read as what it was."""

from __future__ import annotations

from types import ModuleType

from hypothesis import assume, given, settings
from hypothesis import strategies as st

from chasles.reading.equations import read_equations
from chasles.reading.printed import PrintedEquation
from chasles.vocabulary import At, Group, Identity, Node, Number, Rate, Symbol, Zero, latex, walk

from .sampling import WHOLE
from .test_read_back import LETTERS, Q, b, expressions, s
from .test_reading import in_module, ungrouped


def quantity(letter: Node) -> Node:
    """The symbol without rates and without its time."""
    return quantity(letter.below[0]) if isinstance(letter, Rate | At) else letter


MODULE = ModuleType("round_trip")
MODULE.__dict__.update({f"letter_{k}": letter for k, letter in enumerate(dict.fromkeys(map(quantity, LETTERS)))})
MODULE.__dict__.update(one=Identity(3), zero=Zero(3, 3))
NOTATION = in_module(MODULE)


@settings(max_examples=400 if WHOLE else 150, deadline=None)
@given(st.sampled_from(("scalar", "vector", "matrix")).flatmap(lambda kind: expressions(kind, 2)))
def test_a_random_word_is_read_back(node: Node) -> None:
    """A letter alone in brackets is left out: behind a letter it is an argument."""
    assume(node.fault is None)
    assume(not any(isinstance(each, Group) and isinstance(quantity(each.of), Symbol | Number) for each in walk(node)))
    left = {(1, 1): s, (3, 1): b, (3, 3): Q}[node.shape]
    (found,) = read_equations([PrintedEquation(f"{latex(left)} = {latex(node)}")], NOTATION)
    sides = [ungrouped(reading.parts[0].right) for reading in found.readings]
    assert ungrouped(node) in sides, (found.why, latex(node))
