"""Pages: the displayed equations of each kind, with number, label, section and line; what is broken is said."""

from __future__ import annotations

import json
import time
from contextlib import suppress
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chasles.reading.atoms import marks_of
from chasles.reading.equations import read_equations
from chasles.reading.lexemes import BadPage
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import Kind, displayed, kind_of
from chasles.reading.printed import PrintedEquation

from .counted import at_most
from .sampling import WHOLE


def texts(found: tuple[PrintedEquation, ...]) -> list[str]:
    return ["".join(marks_of(each.atoms)) for each in found]


def in_document(body: str, head: str = "") -> tuple[PrintedEquation, ...]:
    return displayed(f"{head}\\begin{{document}}\n{body}\n\\end{{document}} $$no = more$$", "tex")


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (r"\[ a = b \]", ["a=b"]),
        (r"$$ a = b. $$", ["a=b"]),
        (r"\begin{equation} a = b \end{equation}", ["a=b"]),
        (r"\begin{equation*} a = b \end{equation*}", ["a=b"]),
        (r"\begin{align} a &= b, \\ c &= d. \end{align}", ["a=b", "c=d"]),
        (r"\begin{align} a &= b & c &= d \end{align}", [r"a=b\quadc=d"]),
        (r"\begin{align*} a &= b \\ &= c \\ &\quad + d \end{align*}", ["a=b=c+d"]),
        (r"\begin{align} a &= b \\ &= c \end{align}", ["a=b", "b=c"]),
        (r"\begin{align} a &= b, c \\ &= d \end{align}", ["a=b,c=d"]),
        (r"\begin{align} a &= b \\ , \\ \quad . \\ c &= d \end{align}", ["a=b", "c=d"]),
        (r"\begin{align} a ={}& b \nonumber\\ & - c \end{align}", ["a=b-c"]),
        (r"\begin{align} a &= (b \\ & + c) \\ -d &= e \end{align}", ["a=(b+c)", "-d=e"]),
        (r"\begin{align} a &= b \\ &\vdots \\ c &= d \end{align}", ["a=b", "c=d"]),
        (r"\begin{gather} a = b \\ c = d \end{gather}", ["a=b", "c=d"]),
        (r"\begin{multline} a + b \\ + c \\ = d \end{multline}", ["a+b+c=d"]),
        (r"\begin{eqnarray} a &=& b \nonumber \\ &=& c \\ d &=& e \end{eqnarray}", ["a=b=c", "d=e"]),
        (r"\begin{equation}\begin{split} a &= b \\ &= c \end{split}\end{equation}", ["a=b=c"]),
        (r"\begin{equation}\begin{aligned} a &= b \\ c &= d \end{aligned}\end{equation}", [r"a=b\\c=d"]),
        (r"\[\begin{aligned} a &= b \\ c &= d \end{aligned} \quad \text{if } e > f\]", [r"a=b\\c=d\quad\text{if}e>f"]),
        (r"\[a = e, \begin{aligned} a &= b \\ &= d \end{aligned}\]", [r"a=e\\a=b=d"]),
        (r"\[a \begin{aligned} &= b \\ &= d \end{aligned} , c = e\]", ["a=b=d,c=e"]),
        (r"\[a = \begin{aligned} b &= c \end{aligned} d\]", [r"a=\begin{aligned}b&=c\end{aligned}d"]),
        (r"\[\left\{\begin{array}{l} a = b \\ c = d \end{array}\right.\]", [r"a=b\\c=d"]),
        (r"\[\begin{cases} a = b \\ c = d \end{cases}\]", [r"a=b\\c=d"]),
        (r"\[f = \begin{cases} a & b = 1 \\ c & d \end{cases}\]", [r"f=\begin{cases}a&b=1\\c&d\end{cases}"]),
        (r"\begin{alignat}{2} a &= b &\quad c &= d \end{alignat}", [r"a=b\quadc=d"]),
        (r"\begin{IEEEeqnarray}{rCl} a &=& b \end{IEEEeqnarray}", ["a=b"]),
        (r"\begin{empheq}[box=\fbox]{align} a &= b \\ c &= d \end{empheq}", ["a=b", "c=d"]),
        ("\\begin{comment}\n$$a=b$$\\end{comment} % $$c=d$$\n\\verb|$$e=f$$| \\iffalse $$g=h$$\\fi $$i=j$$", ["i=j"]),
        (r"costs \$5, $a = b$ and \(c = d\) $$e = f$$", ["e=f"]),
        (r"\[ a \] $$ \sum_{i=1}^n a_i $$", []),
        (r"\[ a = b % = c" + "\n = d \\]", ["a=b=d"]),
        (r"\[ a = \mbox{$b$ if $c$} \]", [r"a=\text{$b$ if $c$}"]),
    ],
)  # fmt: skip
def test_displays_of_latex(body: str, expected: list[str]) -> None:
    assert texts(in_document(body)) == expected


def numbers(body: str, head: str = "") -> list[str | None]:
    return [each.number for each in in_document(body, head)]


@pytest.mark.parametrize(
    ("body", "head", "expected"),
    [
        (r"\begin{equation}a=b\end{equation}\[c=d\]\begin{equation}e=f\end{equation}", "", ["1", None, "2"]),
        (r"\begin{align}a&=b\\c&=d\nonumber\\e&=f\end{align}", "", ["1", None, "2"]),
        (r"\begin{align}a&=b\tag{*}\\c&=d\tag*{A.1}\\e&=f\end{align}", "", ["*", "A.1", "1"]),
        (r"\begin{subequations}\begin{align}a&=b\\c&=d\end{align}\end{subequations}\begin{equation}e=f\end{equation}",
         "", ["1a", "1b", "2"]),
        (r"\section{A}\begin{equation}a=b\end{equation}\section{B}\begin{equation}a=b\end{equation}",
         r"\numberwithin{equation}{section}", ["1.1", "2.1"]),
        (r"\chapter{A}\section{A}\begin{equation}a=b\end{equation}\chapter{B}\begin{equation}a=b\end{equation}",
         r"\documentclass[11pt]{book}", ["1.1", "2.1"]),
        (r"\section{A}\begin{equation}a=b\end{equation}\appendix\section{B}\begin{equation}a=b\end{equation}",
         r"\renewcommand{\theequation}{\thesection.\arabic{equation}}", ["1.1", "A.1"]),
        (r"\setcounter{equation}{6}\begin{equation}a=b\end{equation}", "", ["7"]),
        (r"$$a=b \eqno(3.4)$$ $$c = d \quad (12)$$ $$e = f(2)$$ $$g = h \qquad \text{(A.3)}$$", "",
         ["3.4", "12", None, "A.3"]),
        (r"\begin{equation}a=\frac{b\end{equation}\begin{equation}c=d\end{equation}", "", ["1", "2"]),
        (r"\begin{multline}a=b\\+c\end{multline}\begin{gather*}a=b\\c=d\end{gather*}", "", ["1", None, None]),
    ],
)  # fmt: skip
def test_numbers_are_counted_as_latex_does(body: str, head: str, expected: list[str | None]) -> None:
    assert numbers(body, head) == expected


MACROS = [
    (r"\newcommand{\be}{\begin{equation}}\newcommand{\ee}{\end{equation}}\be a = b \ee", ["a=b"]),
    (r"\def\beq{$$}\def\eeq{$$}\beq a = b \eeq", ["a=b"]),
    (r"\newenvironment{eq}{\begin{equation}}{\end{equation}}\begin{eq} a = b \end{eq}", ["a=b"]),
    (r"\newcommand\vb[1]{\mathbf{#1}}$$\vb{a} = \vb b$$", [r"\mathbf{a}=\mathbf{b}"]),
    (r"\newcommand{\rot}[3][R]{#1_{#2#3}}$$\rot12 = \rot[Q]{A}{B}$$", ["R_{12}=Q_{AB}"]),
    (r"\def\skew#1{[#1]_\times}$$\skew a = \skew{b}$$", [r"[a]_{\times}=[b]_{\times}"]),
    (r"\let\oldvec\vec\renewcommand{\vec}[1]{\mathbf{\oldvec{#1}}}$$\vec a = 0$$", [r"\vec{\mathbf{a}}=0"]),
    (r"\DeclareMathOperator{\tr}{tr}\DeclareMathOperator*{\argmax}{arg\,max}$$\tr A = \argmax B$$",
     [r"\operatorname{tr}A=\operatorname{argmax}B"]),
    (r"\DeclarePairedDelimiter{\norm}{\lVert}{\rVert}$$\norm*{a} = \norm[\big]{b} = \norm c$$", [r"\|a\|=\|b\|=\|c\|"]),
    (r"\NewDocumentCommand{\x}{O{1} m}{#2_#1}$$\x{a} = \x[2]{b}$$", ["a_{1}=b_{2}"]),
    (r"\newcommand{\a}{1}\providecommand{\a}{2}\renewcommand{\b}{\a}\renewcommand{\a}{3}$$\a = \b$$", ["3=3"]),
    (r"$$\newcommand{\a}{b} \a = c$$ $$\a = d$$", ["b=c", "b=d"]),
    (r"\newcommand{\broken}[1{x} $$a = b$$", ["a=b"]),
    (r"\def\delimited(#1){x} $$a = b$$", ["a=b"]),
    (r"\DeclareMathAlphabet{\mbf}{OT1}{ptm}{b}{n}$$\mbf{a} = \mbf 1$$", [r"\mathbf{a}=\mathbf{1}"]),
    (r"\DeclareMathAlphabet\up{OT1}{cmr}{m}{n}$$\up{a} = b$$", [r"\mathrm{a}=b"]),
    (r"\DeclareMathAlphabet{\broken}$$a = b$$", ["a=b"]),
]  # fmt: skip


@pytest.mark.parametrize(("body", "expected"), MACROS)
def test_macros(body: str, expected: list[str]) -> None:
    assert texts(in_document(body)) == expected
    if not any(begin in body for begin in (r"\be ", r"\beq ")):
        assert texts(displayed(body, "md")) == expected


def test_macros_of_another_file_are_known() -> None:
    assert texts(displayed(r"$$\R = a$$", "md", macros=r"\newcommand{\R}{\mathbf{R}} $$x = y$$")) == [r"\mathbf{R}=a"]


def test_what_a_macro_writes_has_the_place_of_its_use() -> None:
    (found,) = displayed("\\newcommand{\\f}[1]{#1\n+\nc}\n$$\n  \\f{ab} = d\n$$", "tex")
    assert [(atom.text, atom.place.line, atom.place.column) for atom in found.atoms] == [
        ("a", 5, 6), ("b", 5, 7), ("+", 5, 3), ("c", 5, 3), ("=", 5, 10), ("d", 5, 12),
    ]  # fmt: skip


MARKDOWN = """# 2 Motion

$$a = b$$ (eq-one)

## 2.1 Turning

```{math}
:label: turn

c = d
```

```python
x = "$$no = no$$"
```

````{note}
```{math}
:label: inner
e = f
```
$$g = h \\quad (2.7)$$
````

`$$no = no$$` and \\$$no <!-- $$no = no$$ -->

\\begin{align}
i &= j \\\\
k &= l \\tag{9}
\\end{align}

```math
m = n
```

> $$o = p$$
"""


def test_markdown() -> None:
    found = displayed(MARKDOWN, "md", file="page.md")
    said = [(each.line, each.number, each.label, each.section) for each in found]
    assert [(text, *each) for text, each in zip(texts(found), said, strict=True)] == [
        ("a=b", 3, None, "eq-one", "2"), ("c=d", 10, None, "turn", "2.1"), ("e=f", 20, None, "inner", "2.1"),
        ("g=h", 22, "2.7", None, "2.1"), ("i=j", 28, None, None, "2.1"), ("k=l", 29, "9", None, "2.1"),
        ("m=n", 33, None, None, "2.1"), ("o=p", 36, None, None, "2.1"),
    ]  # fmt: skip
    assert {each.file for each in found} == {"page.md"}


STRUCTURED = """
Turning
=======

.. math:: a = b
   :label: one

.. math::
   :label: two
   :nowrap:

   c &= d \\\\
     &= e

   f = g

A literal block::

   .. math:: no = no

.. code-block:: rst

   .. math:: no = no

.. note::

   .. math::

      h = i
"""


def test_restructured_text() -> None:
    found = displayed(STRUCTURED, "rst")
    said = [(each.line, each.label, each.section) for each in found]
    assert [(text, *each) for text, each in zip(texts(found), said, strict=True)] == [
        ("a=b", 5, "one", "Turning"), (r"c=d=e\\f=g", 12, "two", "Turning"), ("h=i", 29, None, "Turning"),
    ]  # fmt: skip


def test_doxygen() -> None:
    page = "\\f$\\newcommand{\\R}{\\ {}^{A}R_B}\\f$ \\f[ \\R = a \\f] and \\f$ b = \\R\\f$, \\f$ c\n\n"
    assert texts(displayed(page, "md")) == ["{}^{A}R_{B}=a"]
    assert texts(displayed(page, "md", is_inline=True)) == ["{}^{A}R_{B}=a", "b={}^{A}R_{B}"]


def test_one_equation_alone() -> None:
    assert texts(displayed(r"\begin{aligned} a &= b \\ &= c \end{aligned}", "equation")) == ["a=b=c"]


def test_inline_formulas_on_request() -> None:
    assert texts(displayed(r"let $a = b$ and $c$ and \(d = e\)", "tex", is_inline=True)) == ["a=b", "d=e"]


@pytest.mark.parametrize(
    ("page", "fault", "line"),
    [
        ("\n$$ a = b\n\nprose $c$\n\n$$d = e$$", r"$$ has no $$", 2),
        ("\\begin{equation} a = b\n\\section{A} $$d = e$$", r"equation has no \end{equation}", 1),
        ("\\begin{equation} a = b\n\\begin{align} d = e\\end{align}", r"equation has no \end{equation}", 1),
        ("\n\n$$ a = \\frac{b $$ $$d = e$$", "{ is not closed", 3),
        ("$$ a = b }$$ $$d = e$$", "} closes nothing", 1),
        ("\\def\\a{\\a\\a}\n$$\\a = b$$ $$d = e$$", r"\a expands without end: does it use itself?", 2),
        ("\\def\\a{x\\b}\\def\\b{\\a}\n$$\\a = b$$ $$d = e$$",
         r"\a expands without end: does it use itself?", 2),
        ("\\def\\a#1{#1#1}\n$$\\a{\\a{b}$$\n\n$$d = e$$", r"the argument of \a is not closed", 2),
        (f"$$ a = {'{' * 100}b{'}' * 100}$$ $$d = e$$", "groups nested more than 60 deep", 1),
        (f"$$ {'a + ' * 20_000} = c$$ $$d = e$$", "an equation of more than 20000 tokens: split it", 1),
        (r"\begin{align*} a &= b \\ & c \end{align*}$$d = e$$",
         "a row that neither begins an equation nor goes on with a sign", 1),
    ],
)  # fmt: skip
def test_a_broken_display_is_said_and_the_others_are_read(page: str, fault: str, line: int) -> None:
    broken, *others = displayed(page, "tex")
    assert (broken.fault, broken.line) == (fault, line)
    assert texts(tuple(others)) == ["d=e"]
    with pytest.raises(BadPage):
        assert broken.atoms


def test_bombs_are_bounded() -> None:
    letters = "abcdefghijklmnopqrstuvwxyz"
    bomb = "".join(rf"\def\{b}{{\{a}\{a}}}" for a, b in pairwise(letters))
    with at_most(calls=10_000_000):
        found = displayed(rf"\def\a{{x}}{bomb}" + "$$\\z = 1$$\n" * 20, "tex")
    assert len(found) == 20
    assert all("expands without end" in each.fault for each in found)


@pytest.mark.sampled(5)
@pytest.mark.parametrize(
    "piece",
    ["$", "$$", "\\begin{align}", "{", "\\def\\a", "\\a", "`", "\n```\n", "::\n\n", "\\[", "\\newcommand{\\a}[1]{"]
)  # fmt: skip
@pytest.mark.parametrize("kind", ["tex", "md", "rst"])
def test_large_pages_take_no_long_time(piece: str, kind: Kind) -> None:
    page = piece * (20_000 // len(piece))
    # What a regular expression does is no call: this is processor time, a tenth of it at most.
    start = time.process_time()
    with suppress(BadPage):
        displayed(page, kind)
    assert time.process_time() - start < 5


def test_a_page_that_is_too_large_is_refused() -> None:
    with pytest.raises(BadPage, match=r"the page has 10\.0 MB, of which 5 MB are read: split it"):
        displayed("x" * 10_000_000, "tex")


def test_included_files_on_request() -> None:
    files = {"a": r"$$a = b$$\input{b}", "b": r"$$c = d$$"}
    page = r"\input{a} \input b"
    assert displayed(page, "tex") == ()
    found = displayed(page.replace(" b", "{b}"), "tex", file="page", included=lambda name: (name + ".tex", files[name]))
    assert [(each.file, text) for each, text in zip(found, texts(found), strict=True)] == [
        ("a.tex", "a=b"), ("b.tex", "c=d"), ("b.tex", "c=d"),
    ]  # fmt: skip


def test_files_that_include_each_other_are_refused() -> None:
    files = {"a": r"\input{b}", "b": r"\input{a}"}
    with pytest.raises(BadPage, match=r"a includes itself: page -> a -> b -> a"):
        displayed(r"\input{a}", "tex", file="page", included=lambda name: (name, files[name]))


def test_kinds_of_pages() -> None:
    assert (kind_of("a/b.tex"), kind_of("x.MD"), kind_of("y.rst")) == ("tex", "md", "rst")
    assert (kind_of("a.html"), kind_of("a.wiki"), kind_of("a.ipynb")) == ("html", "html", "ipynb")
    with pytest.raises(BadPage, match=r"x\.pdf: pages are read whose names end with \.tex"):
        kind_of("x.pdf")


@pytest.mark.parametrize(
    ("body", "expected", "line"),
    [
        ("<h2>Two</h2>\n<p>Say $$ a &lt; b, $$ <b>x</b></p><pre>$$no = more$$</pre>", "a<b", 2),
        ('<script>$$no = more$$\n</script><script type="math/tex; mode=display">a = b</script>', "a=b", 2),
        ("<!-- $$no = more$$ -->\n<code>$$no = more</code>\\[ a = b \\]<style>$$c = d$$", "a=b", 2),
        ("so that\n:<math>a = b</math>, and <math>c = d</math>", "a=b", 2),
        ('so that <math display="block">\n a = b</math>, and <math>c = d</math>', "a=b", 2),
        ('<math xmlns="w" display="block"><mi>a</mi><annotation encoding="application/x-tex">a = b</annotation></math>'
         '<math xmlns="w"><annotation encoding="application/x-tex">c = d</annotation></math>', "a=b", 1),
        ("<" * 50_000 + "<script>" * 20_000, None, 0),
    ],
)  # fmt: skip
def test_mathematics_in_hypertext(body: str, expected: str | None, line: int) -> None:
    found = displayed(body, "html")
    assert (texts(found), [each.line for each in found]) == (([expected], [line]) if expected else ([], []))
    assert all(each.section == "Two" for each in found if "h2" in body)


CONFIGURED = {
    "JavaScript": r"MathJax = {tex: {macros: {RR: '{\\bf R}', 'pair': ['{#1}_{#2}', 2]}}, svg: {a: 'no'}};",
    "Python": "mathjax3_config = {'tex': {\n 'macros': {\n  # 'RR': 'no',\n  'RR': r'{\\bf R}',\n"
              "  'pair': [r'{#1}_{#2}', 2],\n }}}\nother = {'pair': 'no'}",
    "YAML": "tex:\n  macros:\n    RR: '{\\bf R}'\n    pair: [\"{#1}_{#2}\", 2]\n  other: no\n",
    "KaTeX": r'macros: {"\\RR": "{\\bf R}", "\\pair": "{#1}_{#2}"}',
}  # fmt: skip


@pytest.mark.parametrize("language", CONFIGURED)
def test_macros_of_mathjax_are_expanded(language: str) -> None:
    expected = [r"\mathbf{R}=a_{b}"]
    assert texts(displayed(r"$$\RR = \pair{a}{b}$$", "md", macros=CONFIGURED[language])) == expected
    assert texts(displayed(rf"<script>{CONFIGURED[language]}</script> \[\RR = \pair a b\]", "html")) == expected


def test_a_display_may_have_empty_lines_and_no_prose() -> None:
    assert texts(displayed("$$\na = b\n\nb = c\n$$\n\n$$a = c$$", "md")) == ["a=b\\\\b=c", "a=c"]
    assert texts(displayed("\\f[\na = b\n\n\\quad + c\n\\f]", "md")) == ["a=b+c"]
    broken = displayed("$$\na = b\n\nwhere the letter is\n\n$$a = c$$", "md")
    assert [each.fault for each in broken] == ["$$ has no $$", ""]
    assert texts(broken[1:]) == ["a=c"]


@pytest.mark.parametrize("indent", [1, None])
def test_the_cells_of_a_notebook_keep_their_lines(indent: int | None) -> None:
    kinds = {"code": ["x = '$$no = more$$'"], "markdown": ["# One\n", 'so \\"that\n', "$$\\frac{a}{b} = c$$"]}
    cells = [{"cell_type": kind, "metadata": {}, "source": source} for kind, source in kinds.items()]
    text = json.dumps({"cells": cells, "nbformat": 4}, indent=indent)
    (found,) = displayed(text, "ipynb")
    assert (found.latex, found.section) == (r"\frac{a}{b} = c", "One")
    assert indent is None or "frac" in text.split("\n")[found.line - 1]
    for broken in ("", "[]", '{"cells": 1}', '{"cells": [{}]}', "[" * 100_000):
        with pytest.raises(BadPage, match="no Jupyter notebook"):
            displayed(broken, "ipynb")


PIECES = st.sampled_from(
    [
        "$$",
        "$",
        r"\[",
        r"\]",
        r"\begin{align}",
        r"\end{align}",
        r"\begin{equation}",
        r"\end{equation}",
        "`",
        "|",
        "(",
        ")",
        r"\begin{aligned}",
        r"\end{aligned}",
        r"\\",
        "&",
        "=",
        "a",
        "+",
        "{",
        "}",
        "\n",
        "\n\n",
        r"\def\a#1{",
        r"\a",
        "%",
        r"\newcommand{\a}",
        "[1]",
        "{#1}",
        r"\tag{3}",
        r"\label{x}",
        r"\nonumber",
        "```{math}\n",
        "```\n",
        "# 2\n",
        "::\n",
        ".. math::",
        "    ",
        r"\section{",
        r"\let\a=\b",
        r"\begin{subequations}",
        r"\end{subequations}",
        r"\quad (3.1)",
        r"\left\{",
        r"\begin{cases}",
        r"\end{cases}",
        r"\text{",
        r"\newenvironment{b}{",
        r"\begin{b}",
        r"\verb",
        r"\iffalse",
        r"\fi",
        r"\numberwithin{equation}{",
        r"\setcounter{equation}{2}",
        "\\",
    ]
)


@settings(max_examples=300 if WHOLE else 100, deadline=None)
@given(st.lists(PIECES, max_size=30).map("".join), st.sampled_from(["tex", "md", "rst", "equation"]))
def test_broken_pages_are_read_as_far_as_they_go(page: str, kind: Kind) -> None:
    for each in displayed(page, kind):
        assert each.line >= 1
        assert "\n" not in each.fault
        if not each.fault:
            assert each.atoms


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("a = " + "(" * 400 + "a" + ")" * 400, "brackets nested more than"),
        ("a = (b = " * 1100 + "a" + ")" * 1100, "brackets nested more than"),
        ("a = " + "a(" * 400 + "a" + ")" * 400, "brackets nested more than"),
        ("a = " + r"\left[" * 400 + "a" + r"\right]" * 400, "brackets nested more than"),
        ("a = " + "{" * 400 + "a" + "}" * 400, "nested more than"),
        ("a = b + " + r"\sum_{i=1}^{9}" * 8 + "a", "what b is"),
        ("a = " + " + ".join(["a"] * 4000), "a sum of more than"),
        ("a = " + " ".join(["a"] * 2000), "too many ways"),
        ("a" + "_{a" * 400 + "}" * 400 + " = a", "nested more than"),
    ],
)
def test_hostile_formulas_are_told_in_a_line(text: str, why: str) -> None:
    (found,) = read_equations(displayed(f"$$ {text} $$", "tex"), load_notation("[symbols]\na = 'scalar'"))
    assert found.status == "unread"
    assert why in found.why


@pytest.mark.parametrize("page", [r"$$ a = b \tag{3 $$ $$ c = d $$", r"$$ a = b \tag $$ $$ c = d $$"])
def test_a_number_without_an_end_is_told(page: str) -> None:
    first, *_, last = displayed(page, "tex")
    assert first.line == 1
    assert last.fault or last.latex in ("c = d", "a = b")


@pytest.mark.parametrize(
    "text", [r"a = a / \times a", r"a = a \times / a", r"a = / a", r"a = a \cdot", r"a = a / a / \cdot a"]
)
def test_signs_side_by_side_are_told(text: str) -> None:
    notation = load_notation("[symbols]\na = 'scalar'\nv = { is = 'array', shape = [2, 3] }")
    (found,) = read_equations(displayed(f"$$ a = {text} $$", "tex"), notation)
    assert found.status == "unread"
    assert found.why or found.printed.fault


def test_no_equation_is_lost_that_has_a_comma_or_a_word_in_its_scripts() -> None:
    page = r"\begin{align} \dot x &= v_{1,2} \\ \dot y &= w_{\text{a, b}} \end{align} $$p = q_{1,2},\quad i = 1,2$$"
    assert texts(displayed(page, "tex")) == [
        r"\dot{x}=v_{1,2}", r"\dot{y}=w_{\text{a, b}}", r"p=q_{1,2},\quadi=1,2",
    ]  # fmt: skip
    letters = {name: {"is": "scalar"} for name in ("x", "y", "p", "v_{##}", "w_{##}", "q_{##}")}
    chains = r"\begin{aligned} \dot x &= v_{1,2} \\ \dot y &= w_{1,3} \end{aligned}"
    (read,) = read_equations([PrintedEquation(chains)], load_notation({"symbols": letters}))
    assert len(read.readings[0].parts) == 2


@pytest.mark.parametrize(
    "head",
    [
        r"\let\old\section \newcommand\new{\end{a}\begin{a}} \renewcommand\section{\new\old}",
        r"\newcommand\section{\begin{a}\section}",
        r"\def\section{\section}",
    ],
)
def test_commands_of_prose_that_are_made_of_themselves_end(head: str) -> None:
    with at_most(calls=3_000_000):
        found = in_document(r"\section{One} \[ a = b \] \section{Two} \[ c = d \]", head)
    assert texts(found)[-1:] == ["c=d"]
