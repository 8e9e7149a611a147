"""Formulas as MathML: every letter of the statement is there, spelled as browsers draw it; what differs is marked."""

from __future__ import annotations

from xml.etree.ElementTree import tostring

import pytest

from chasles.report.html.breaking import FEW, MOST, in_lines, width_of
from chasles.report.html.differences import mark_differences
from chasles.report.html.formulas import equation_tree, latex_for_mathml, markup, math, tree_of
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
        (r"\mathbf{N} \dot{\mathbf{v}}", r"\mathbf{N} \dot{\nu}", ["𝐯˙"], ["ν˙"]),
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


LONG = r"\sin \left( \phi \right) \mathbf{a} + \frac{b}{c} \mathbf{d}^T - \mathbf{e} \cdot \mathbf{f}"
SUM = " + ".join([LONG] * 5)
WIDE_FORMS = {
    "a sum in brackets": rf"x = \left[ {SUM} \right]",
    "with an exponent": rf"x = y + \left[ {SUM} \right]^T",
    "in a frame": rf"x = \left[ {SUM} \right]_F",
    "brackets in brackets": rf"x = a \left[ b \left( {SUM} \right) + c \left( {SUM} \right) \right]",
    "a function of brackets": rf"\text{{vect}} \left( {SUM} \right) = 0",
    "factors": " ".join([rf"\left[ {LONG} \right]"] * 6),
    "a fraction": rf"x = \frac{{{SUM}}}{{{SUM}}}",
    "a root": rf"x = \sqrt{{{SUM}}}",
    "a root of a fraction": rf"x = \sqrt{{\frac{{{SUM}}}{{c}}}}",
    "a column": rf"x = \left[ \begin{{matrix}} {SUM} \\ {SUM} \end{{matrix}} \right]",
    "a row": rf"x = \left[ \begin{{matrix}} {SUM} & {SUM} \end{{matrix}} \right]",
    "a wide entry": rf"x = \left[ \begin{{matrix}} 1 & {SUM} \\ 0 & 2 \end{{matrix}} \right]^T y",
    "brackets in an entry": rf"\left[ \begin{{matrix}} \left\{{ {SUM} \right\}} a \\ 2 \end{{matrix}} \right]",
    "no sign": " ".join(f"a_{{{k}}}" for k in range(90)),
    "a matrix in a fraction": rf"\frac{{\left[ \begin{{matrix}} {SUM} & 1 \end{{matrix}} \right]}}{{2}} = x",
}


@pytest.mark.parametrize("form", WIDE_FORMS)
def test_whatever_is_too_wide_comes_in_lines(form: str) -> None:
    tree = tree_of(WIDE_FORMS[form])
    said = "".join(tree.itertext())
    assert width_of(tree) > 1.4 * MOST
    lines = in_lines(tree)
    assert width_of(lines) <= 1.15 * MOST
    assert "".join(lines.itertext()) == said
    for row in lines.iter("mrow"):
        assert row[-1].get("form") != "prefix", "a line ends with a bracket that opens"
        first = row[1] if row[0].tag == "mspace" and len(row) > 1 else row[0]
        assert first.get("form") != "postfix" or not first.get("fence"), "a line begins with a bracket that closes"


def test_words_after_a_formula_in_a_line_are_words_of_the_line() -> None:
    assert math(r"\mathbf{Q} \text{ orthonormal, right-handed}").endswith("</math> orthonormal, right-handed")
    for latex in (r"\text{CPM}", r"\text{ on}", r"\mathbf{Q} \text{ of } \mathbf{e}"):
        assert math(latex).endswith("</math>")


def test_marks_stay_where_brackets_come_apart() -> None:
    tree = tree_of(rf"x = \left[ {SUM} \right]")
    tree[-1].set("class", "taken")
    marked = [part for part in in_lines(tree).iter() if part.get("class") == "taken"]
    assert "".join("".join(part.itertext()) for part in marked) == "".join(tree[-1].itertext())


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
    for formula in (f"x = {wide}", f"x = {wide} + {wide}"):
        rows = in_lines(tree_of(formula)).findall("mtr")
        assert len(rows) > 1
        assert all(width_of(row) > FEW for row in rows[:-1])
        assert all(width_of(row) <= MOST + 4 for row in rows)
