"""Formulas as MathML: every letter of the statement is there, spelled as browsers draw it; what differs is marked."""

from __future__ import annotations

from xml.etree.ElementTree import tostring

import pytest

from chasles.report.html.breaking import in_lines, width_of
from chasles.report.html.differences import mark_differences
from chasles.report.html.formulas import equation_tree, latex_for_mathml, markup, tree_of
from chasles.statements import Statement, load
from chasles.vocabulary import symbols_of, walk


def test_every_statement_converts() -> None:
    for entry in load():
        if isinstance(entry.statement, Statement):
            tree = equation_tree(entry.statement.left, entry.statement.right, entry.statement.sign)
            letters = "".join(tree.itertext())
            assert len(letters) >= 3, entry.number
            assert tree.find(".//merror") is None


def marked(before: str, after: str) -> tuple[list[str], list[str]]:
    """What is marked in two formulas, given as LaTeX."""
    old, new = tree_of(before), tree_of(after)
    mark_differences(old, new)
    return tuple(["".join(part.itertext()) for part in tree.iter() if "class" in part.attrib] for tree in (old, new))


@pytest.mark.parametrize(
    ("before", "after", "taken", "added"),
    [
        ("a + b", "a + b", [], []),
        ("a + b", "a + c", ["b"], ["c"]),
        ("a + b", "a + b + c", [], ["+c"]),
        (r"a \cdot b", r"\left( a \cdot b \right) c", [], ["(", ")", "c"]),
        (r"\frac{a}{b}", r"\frac{a}{c}", ["b"], ["c"]),
        (r"x = a b + c", r"x = c", ["ab+"], []),
        (r"\begin{matrix} a b \end{matrix} + c", r"\begin{matrix} a & b \end{matrix} + c", [], ["b"]),
    ],
)
def test_what_differs_is_marked(before: str, after: str, taken: list[str], added: list[str]) -> None:
    assert marked(before, after) == (taken, added)


def test_marks_change_nothing_else() -> None:
    old, new = tree_of(r"x = a b + c"), tree_of(r"x = \left( a + d \right) b")
    spelled = ["".join(tree.itertext()) for tree in (old, new)]
    mark_differences(old, new)
    assert ["".join(tree.itertext()) for tree in (old, new)] == spelled


def test_a_long_formula_is_broken_between_terms() -> None:
    terms = " + ".join(f"a_{{{k}}} b_{{{k}}} c_{{{k}}} d_{{{k}}}" for k in range(30))
    tree = tree_of(f"x = {terms}")
    lines = in_lines(tree)
    rows = lines.findall("mtr")
    assert lines.tag == "mtable"
    assert len(rows) > 1
    assert max(map(width_of, rows)) < 80
    assert "".join(lines.itertext()) == "".join(tree_of(f"x = {terms}").itertext())
    short = tree_of("x = a + b")
    assert in_lines(short) is short


def test_brackets_and_bold_letters_are_what_browsers_draw() -> None:
    text = markup(tree_of(r"\boldsymbol{\omega}' = \left( \mathbf{1} \right)"))
    assert "\N{MATHEMATICAL BOLD ITALIC SMALL OMEGA}" in text
    assert "\N{MATHEMATICAL BOLD DIGIT ONE}" in text
    assert 'stretchy="false"' in text
    assert "msup" not in text
    tall = tostring(tree_of(r"\left( \frac{a}{b} \right)"), encoding="unicode")
    assert 'stretchy="true"' in tall


def test_the_mathml_says_every_letter_of_the_statement() -> None:
    for entry in load().select(["3.18", "3.96e", "3.148"]):
        assert isinstance(entry.statement, Statement)
        latex = latex_for_mathml(entry.statement.right)
        for symbol in symbols_of(entry.statement.right):
            assert symbol.letter in latex
        assert len(list(walk(entry.statement.right))) > 3


def test_a_function_of_a_letter_does_not_run_on() -> None:
    (rotation,) = load().select(["2.49"])
    assert isinstance(rotation.statement, Statement)
    latex = latex_for_mathml(rotation.statement.right)
    assert r"\cos \, \phi \, \left( \mathbf{1}" in latex
    assert r"\sin \, \phi \, \mathbf{E}" in latex


def test_a_left_side_does_not_stand_alone() -> None:
    wide = " ".join(f"a_{{{k}}}" for k in range(60))
    tree = tree_of(f"x = {wide}")
    assert in_lines(tree) is tree
    assert len(in_lines(tree_of(f"x = {wide} + {wide}")).findall("mtr")) == 2
