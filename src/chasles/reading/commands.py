"""What each command of LaTeX is to a reader: layout, a style of letters, a mark on one argument, another's synonym."""

from __future__ import annotations

import unicodedata

TEXT_STYLES = {r"\textbf": r"\mathbf", r"\textit": "", r"\textsf": r"\mathsf"}
"""The typeface of one letter in a text; of other texts it is upright."""
NAMES_OF_ANGLES = ("sin", "cos", "tan", "sinh", "cosh", "tanh")
PLAIN_NAMES = {
    **{name: rf"\{name}" for name in (*NAMES_OF_ANGLES, "arcsin", "arccos", "arctan", "exp", "log")},
    **{
        name: rf"\operatorname{{{name}}}"
        for name in ("asin", "acos", "atan", "atan2", "arctan2", "sqrt", "abs", "max", "min")
    },
}
"""Functions that are typed as letters side by side, before brackets, or where that can be nothing else."""
OPTIONAL_ARGUMENT = ("aligned", "alignedat", "array", "gathered", "split", "tabular")
TAKES_COLUMNS = ("array", "tabular", "alignedat", "alignat", "alignat*", "subarray")
EQUAL = frozenset({"=", ":=", "=:"})
SAYS = r"(?:: ?)?(?:=|\\equiv|\\triangleq)"
"""Behind a letter: what says by a text what it is."""
DOTS = (r"\dots", r"\ldots", r"\cdots", r"\vdots", r"\ddots")
"""Signs for what is left out."""
_STYLE_NAMES = {"BOLD": r"\mathbf", "BOLD ITALIC": r"\boldsymbol", "ITALIC": "", "SCRIPT": r"\mathcal"}


def _commands(names: str) -> frozenset[str]:
    return frozenset("\\" + name for name in names.split())


def _pairs(text: str) -> dict[str, str]:
    words = text.split()
    return dict(zip(words[::2], words[1::2], strict=True))


STYLES = {
    **{command: command for command in _commands("mathbf boldsymbol mathcal mathsf mathbb mathfrak mathscr mathrm")},
    **dict.fromkeys(_commands("operatorname mathup"), r"\mathrm"),
    **dict.fromkeys(_commands("mathit mathnormal"), ""),
    **dict.fromkeys(_commands("bm pmb"), r"\boldsymbol"),
    **_pairs(r"\bold \mathbf \Bbb \mathbb \mathds \mathbb \mathbbm \mathbb"),
}
"""Commands that set one argument in another typeface, each with the one that it is written as; italics are usual."""

SWITCHES = {
    **dict.fromkeys(_commands("bf bfseries"), r"\mathbf"),
    **dict.fromkeys(_commands("it mit"), ""),
    **_pairs(r"\boldmath \boldsymbol \rm \mathrm \sf \mathsf \cal \mathcal"),
}
"""Commands that set the rest of their group in another typeface."""

TEXT = _commands("text textrm textnormal texttt textbf textit textup textsf mbox hbox intertext shortintertext")
CONNECTIVES = _commands(
    "a all an and any are as at but by each either else every for from given hence i if in is let n of on or "
    "otherwise respectively since so such that the then therefore thus to unless when where which while with"
)
"""Words of prose, as if they were commands; any other single word in \\text is a name, as \\text{tr} is."""

LETTERS = _commands(
    "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa varkappa lambda mu nu xi omicron pi "
    "varpi rho varrho sigma varsigma tau upsilon phi varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon "
    "Phi Psi Omega varGamma varDelta varTheta varLambda varXi varPi varSigma varPhi varPsi varOmega ell hbar imath "
    "jmath wp Re Im aleph nabla partial infty"
)
"""Control words that are one letter each, which a typeface is set for."""

FUNCTIONS = _commands(
    "arccos arcsin arctan arg cos cosh cot coth csc deg det dim exp gcd hom ker lg ln log Pr sec sin sinh tan tanh tr"
)

MARKS = _commands(
    "dot ddot dddot ddddot hat widehat tilde widetilde bar overline underline vec overrightarrow overleftarrow acute "
    "grave breve check mathring underrightarrow overleftrightarrow wideparen cancel utilde underbar"
)
WITH_LIMITS = _commands("sum prod int lim min max sup inf bigcup bigcap") | {
    rf"\operatorname{{{name}}}" for name in ("argmin", "argmax", "min", "max")
}
"""Signs under which stands what runs."""
TWO_ARGUMENTS = _commands("frac binom overset underset stackrel")
ARGUMENT_KEPT = _commands(
    "boxed mathbin mathrel mathord mathop mathopen mathclose mathpunct mathinner ensuremath smash lefteqn fbox "
    "underbrace overbrace vcenter"
)
COLOURED = _commands("textcolor mathcolor")
"""Commands of which the second argument is kept."""
ARGUMENT_DROPPED = _commands("label tag phantom hphantom vphantom footnote cite citep citet color index vspace hspace")
DROPPED = _commands(
    "displaystyle textstyle scriptstyle scriptscriptstyle limits nolimits displaylimits allowbreak nobreak break "
    "nonumber notag noindent strut mathstrut protect hline toprule midrule bottomrule relax thinspace medspace "
    "thickspace negthinspace negmedspace negthickspace enspace enskip linebreak pagebreak unboldmath normalsize small "
    "footnotesize scriptsize large xspace displaybreak centering par f therefore qedhere empty checkmark"
) | {r"\,", r"\;", r"\:", r"\!", r"\ ", r"\/", r"\-", r"\>", r"\@", "\\\n", "~"}
LENGTHS = _commands(
    "hskip mskip kern mkern arraycolsep tabcolsep jot thinmuskip medmuskip thickmuskip abovedisplayskip"
)
"""Commands that a length follows, or a sign of equality and a length."""

SPACES = _commands("quad qquad hfill hfil")
"""Space wide enough to part two equations on a line."""

DELIMITER_SIZES = _commands("left right middle") | frozenset(
    "\\" + size + side for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r", "m")
)

SYNONYMS = {
    **dict.fromkeys(_commands("dfrac tfrac cfrac sfrac nicefrac"), r"\frac"),
    **dict.fromkeys(_commands("dbinom tbinom"), r"\binom"),
    **dict.fromkeys(_commands("lvert rvert vert"), "|"),
    **dict.fromkeys(_commands("lVert rVert Vert"), r"\|"),
    **dict.fromkeys(_commands("coloneqq coloneq defeq"), ":="),
    **dict.fromkeys(_commands("cr newline tabularnewline"), r"\\"),
    **_pairs(r"\lbrack [ \rbrack ] \lbrace \{ \rbrace \} \colon : \vcentcolon : \le \leq \leqslant \leq \ge \geq"),
    **_pairs(r"\lt < \gt > \geqslant \geq \ne \neq \to \rightarrow \gets \leftarrow \prime '"),
    **_pairs(r"\ast * \eqdef \triangleq \land \wedge \# \sharp \intercal \top"),
}

RELATIONS = frozenset({*EQUAL, "<", ">"}) | _commands(
    "equiv triangleq leq geq neq approx sim simeq cong propto ll gg in subset subseteq ni doteq Rightarrow "
    "Leftrightarrow Longleftrightarrow implies iff rightarrow leftarrow longrightarrow Longrightarrow mapsto models "
    "prec succ preceq succeq preccurlyeq succcurlyeq lesssim gtrsim perp parallel asymp leadsto rightsquigarrow"
)
IN_ASCII = _pairs(r":= := =: =: => \Rightarrow -> \rightarrow <= \leq >= \geq")
"""Signs of relation that are typed as two characters."""
IMPLICATIONS = _commands(
    "implies Rightarrow Longrightarrow leadsto rightsquigarrow iff Leftrightarrow Longleftrightarrow"
)
"""Between two equations: what stands before is a condition of what follows."""
OPERATORS = frozenset("+-*/") | _commands("times cdot pm mp wedge otimes oplus circ bullet star div odot boxplus")

_SIGNS = dict.fromkeys("\u00a0\u2009\u200b", " ") | _pairs(
    r"− - × \times · \cdot ⋅ \cdot ′ ' ″ '' ≡ \equiv ∥ \| ≤ \leq ≥ \geq ≠ \neq ‖ \| ≜ \triangleq ≔ := ∈ \in ∞ \infty "
    r"∂ \partial ∇ \nabla ° ^\circ"
)


def ascii_spelling(sign: str) -> str:
    """The LaTeX command for a character that is not ASCII, such as α, ×, ₂ or 𝐩; the character itself if none is."""
    if sign in _SIGNS or len(sign) > 1:
        return _SIGNS.get(sign, sign)
    name, plain = unicodedata.name(sign, ""), unicodedata.normalize("NFKC", sign)
    if name.startswith("GREEK") and len(words := name.split()) == 4:
        letter = words[3].replace("LAMDA", "LAMBDA").lower()
        return "\\" + (letter.capitalize() if words[1] == "CAPITAL" else letter)
    if name.startswith(("SUPERSCRIPT", "SUBSCRIPT")) and plain.isascii():
        return ("^" if name.startswith("SUPER") else "_") + "{" + plain + "}"
    if name.startswith("MATHEMATICAL") and plain != sign and len(plain) == 1:
        style = name.removeprefix("MATHEMATICAL ").partition(" CAPITAL")[0].partition(" SMALL")[0]
        if style in _STYLE_NAMES:
            return _STYLE_NAMES[style] + "{" + (plain if plain.isascii() else ascii_spelling(plain)) + "}"
    return sign
