"""Formulas as MathML, by latex2mathml, from a LaTeX of ours that says what browsers need; sentences with formulas."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from html import unescape
from itertools import pairwise
from unicodedata import lookup, name
from xml.etree.ElementTree import Element, SubElement, tostring

from latex2mathml.converter import convert_to_element
from markupsafe import Markup, escape

from chasles.report.html.breaking import in_lines, width_of
from chasles.vocabulary import Node, plain, walk
from chasles.vocabulary.notation import notation_of
from chasles.vocabulary.pieces import Piece, Precedence
from chasles.vocabulary.spelling import spell
from chasles.vocabulary.typesetting import Latex

FUNCTIONS = (r"\sin", r"\cos", r"\det", r"\text{")
CLOSING = (r"\right)", r"\right]", r"\right\}")
THIN = r"\,"
ACCENTS = {"~": "\N{SMALL TILDE}", "\N{DOT ABOVE}": "\N{DOT ABOVE}", "\N{DIAERESIS}": "\N{DIAERESIS}"}
"""Marks over a letter; of the tilde there is a small one."""
PRIMES = ("\N{PRIME}", "\N{DOUBLE PRIME}")
"""In fonts these are small and raised as they are: as superscripts they would be so twice."""
SIGNS_OF_TERMS = ("\N{MINUS SIGN}", "+")
LEADING = ("=", "\N{IDENTICAL TO}", "(", "[", "{", ",", "\N{ALMOST EQUAL TO}")
"""After these, a sign belongs to what follows it, and there is no space between the two."""
BRACKETS = {"(": "prefix", "[": "prefix", "{": "prefix", ")": "postfix", "]": "postfix", "}": "postfix"}
"""What a bracket is, also where it does not stand at the edge of a row."""
OPENED, CLOSED = r"\left[ \begin{matrix}", r"\end{matrix} \right]"
"""A matrix in brackets: the converter leaves those of `bmatrix` outside where it has an exponent."""
NAMES = ("sin", "cos", "tan", "det", "vect", "tr")
SIGNS_IN_WORDS = re.compile(r"\\([&%$#_^~])(?:\{\})?")
WORDS_AFTER = re.compile(r"(.*\S)\s*\\text\{( [^{}\\$]+)\}")
"""Words after a formula within a line are text of the line: there they break."""
TALL = ("mfrac", "mtable")
"""Around what brackets grow; elsewhere a bracket that may grow only takes more room."""
WIDE = 40
"""What is wider may have to be printed smaller to fit on a page: the style sheet is told how wide it is."""
BOLD = {"bold": "MATHEMATICAL BOLD", "bold-italic": "MATHEMATICAL BOLD ITALIC"}
"""Browsers know bold letters as characters of their own, and no other `mathvariant` than normal."""
ARTICLES = ("a", "A", "I")
"""Letters that are words as well."""


class _ForMathML(Latex):
    """LaTeX in which brackets that grow are pairs, and the space around a function's name is said."""

    def product(self, factors: list[str]) -> str:
        text = factors[0]
        for before, factor in pairwise(factors):
            apart = factor.startswith(FUNCTIONS) or _is_bare_call(before)
            text += f" {THIN} {factor}" if apart else f" {factor}"
        return text

    def function(self, name: str, argument: Piece, exponent: str = "") -> Piece:
        spelled = super().function(name, argument, exponent)
        command, blank, rest = spelled.text.partition(" ")
        if spelled.level is Precedence.PRODUCT and blank:
            return Piece(f"{command} {THIN} {rest}", spelled.level, spelled.depth)
        return spelled

    def norm(self, of: Piece) -> Piece:
        inner = super().norm(of)
        text = inner.text.removeprefix(r"\|").removesuffix(r"\|")
        return Piece(rf"\left\| {text} \right\|", inner.level, inner.depth)

    def block(self, rows: list[list[str]]) -> str:
        made = super().block(rows)
        return made.replace(r"\begin{bmatrix}", OPENED, 1).removesuffix(r"\end{bmatrix}") + CLOSED


def _is_bare_call(factor: str) -> bool:
    """Whether it is a function of a letter without brackets, which must not run on into what follows."""
    return factor.startswith(FUNCTIONS) and not factor.endswith(CLOSING)


def latex_for_mathml(node: Node) -> str:
    """The expression in LaTeX, as it is to be turned into MathML."""
    return spell(node, _ForMathML(notation_of(node))).text


def equation_tree(left: Node, right: Node, sign: str = "=") -> Element:
    """The MathML of an equation."""
    return tree_of(f"{latex_for_mathml(left)} {sign} {latex_for_mathml(right)}")


@cache
def math(latex: str) -> Markup:
    """The formula as MathML within a line of text."""
    found = WORDS_AFTER.fullmatch(latex)
    formula, words = found.groups() if found else (latex, "")
    return markup(tree_of(formula), block=False) + words


def tree_of(latex: str) -> Element:
    """The formula's MathML, without the element `math` around it."""
    root = convert_to_element(latex)
    _settle(root)
    return root[0] if len(root) == 1 else root


def displayed(latex: str) -> Markup:
    """A formula that was not spelled for MathML, on a line of its own: names of functions stand apart from letters."""
    tree = tree_of(latex.replace(r"\begin{bmatrix}", OPENED).replace(r"\end{bmatrix}", CLOSED))
    for row in tree.iter("mrow"):
        _set_apart(row)
    for words in tree.iter("mtext"):
        words.text = SIGNS_IN_WORDS.sub(r"\1", words.text or "")
    return markup(tree)


def _set_apart(row: Element) -> None:
    """A thin space before and after the name of a function, but not beside a sign or a bracket."""
    parts: list[Element] = []
    for before, part in zip((None, *row), row, strict=False):
        named = [each is not None and each.text in NAMES for each in (before, part)]
        if before is not None and any(named) and before.tag != "mo" and not _begins_with_a_sign(part):
            parts.append(Element("mspace", width="0.167em"))
        parts.append(part)
    row[:] = parts


def _begins_with_a_sign(element: Element) -> bool:
    while element.tag in ("mrow", "msup", "msub", "msubsup") and len(element):
        element = element[0]
    return element.tag == "mo"


def markup(tree: Element, block: bool = True) -> Markup:
    """The formula as text of a page; a `block` stands on a line of its own, or on several."""
    shown = in_lines(tree) if block else tree
    width = width_of(shown)
    classes = f' class="wide" style="--wide: {width:.0f}"' if width > WIDE else ""
    display = ' display="block"' if block else ""
    inner = tostring(shown, encoding="unicode")
    return Markup("<math{}{}>{}</math>").format(Markup(display), Markup(classes), Markup(inner))


def _settle(element: Element) -> None:
    """Characters instead of their codes, accents told as such, no row around a single thing."""
    element.text = unescape(element.text or "") or None
    variant = BOLD.get(element.get("mathvariant", ""))
    if variant and element.text:
        del element.attrib["mathvariant"]
        element.text = "".join(_bold(letter, variant) for letter in element.text)
    for place, child in enumerate(list(element)):
        _settle(child)
        element[place] = _simplest(child)
    for before, sign in zip((None, *element), element, strict=False):
        if sign.tag == "mo" and sign.text in SIGNS_OF_TERMS and (before is None or before.text in LEADING):
            sign.set("form", "prefix")
        elif sign.tag == "mo" and sign.text in BRACKETS:
            sign.set("form", BRACKETS[sign.text])
    if element.tag == "mover" and element[1].text in ACCENTS:
        element.set("accent", "true")
        element[1].text = ACCENTS[element[1].text]
        element[1].set("stretchy", "false")
    if element.tag == "mrow" and not any(part.tag in TALL for part in element.iter()):
        for fence in element.findall("mo[@fence]"):
            fence.set("stretchy", "false")


def _simplest(element: Element) -> Element:
    """The element as it is drawn best: what stands alone in a row, a prime beside its letter and not above it."""
    if element.tag == "mrow" and len(element) == 1:
        return element[0]
    if element.tag in ("msup", "msubsup") and element[-1].text in PRIMES:
        row = Element("mrow")
        inner = element[0] if element.tag == "msup" else SubElement(row, "msub")
        if inner is element[0]:
            row.append(inner)
        else:
            inner.extend((element[0], element[1]))
        prime = SubElement(row, "mo", lspace="0", rspace="0")
        prime.text = element[-1].text
        return row
    return element


def _bold(letter: str, variant: str) -> str:
    """The bold form of a Greek letter or a digit; the letter itself if there is none."""
    words = name(letter, "").removeprefix("GREEK ").replace(" LETTER", "")
    kind = "MATHEMATICAL BOLD" if words.startswith("DIGIT") else variant
    try:
        return lookup(f"{kind} {words}")
    except KeyError:
        return letter


def with_formulas(text: str, nodes: Iterable[Node], of_words: bool = True) -> Markup:
    """The text, in which each part of the nodes that it spells in plain text is a formula, and so is an entry of one.

    The longest are found first. In a sentence `of_words` a letter that is a word too stays one.
    """
    known = {plain(part): part for node in nodes for part in walk(node)}
    spelled = [name for name in known if not name.isdecimal() and not (of_words and name in ARTICLES)]
    if not spelled:
        return escape(text)
    anyone = "|".join(re.escape(name) for name in sorted(spelled, key=lambda name: (-len(name), name)))
    pieces = re.split(rf"(?<![\w'^.(])({anyone})(?:_(\d\d?)(?!\w)|(?![\w'^~]))", text)
    found = escape(pieces[0])
    for piece, entry, words in zip(pieces[1::3], pieces[2::3], pieces[3::3], strict=True):
        latex = latex_for_mathml(known[piece])
        found += math(f"{{{latex}}}_{{{entry}}}" if entry else latex) + escape(words)
    return found
