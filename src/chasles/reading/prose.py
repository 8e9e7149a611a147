"""What the prose of a page says that its letters are: a unit vector e, the mass m of a body, a rotation matrix R."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from chasles.reading.atoms import Unread
from chasles.reading.commands import SAYS
from chasles.reading.glyphs import Glyph, letter_in
from chasles.reading.lexemes import BadPage
from chasles.reading.printed import Remark

POSITIVE = {"is": "scalar", "positive": True}
_CONSTANT = {"is": "scalar", "constant": True, "positive": True}
NOUNS: dict[str, dict[str, Any]] = {
    r"unit(?: direction| normal)? vector|unit (?:normal|axis)": {"is": "unit vector"},
    r"(?:rotation|direction[- ]cosine|proper orthogonal|attitude|orientation) (?:matrix|tensor)": {"is": "rotation"},
    r"(?:symmetric )?positive[- ]definite (?:matrix|tensor)": {"is": "positive-definite"},
    r"(?:symmetric|diagonal|mass|inertia|stiffness|covariance) (?:matrix|tensor)": {"is": "symmetric"},
    r"unit quaternion": {"is": "unit quaternion"},
    r"quaternion": {"is": "quaternion"},
    r"matrix|tensor": {"is": "matrix"},
    r"vector": {"is": "vector"},
    r"angle": {"is": "angle"},
    r"scalar|real number": {"is": "scalar"},
    r"mass|moment of inertia|length|radius|stiffness|spring constant": _CONSTANT,
    r"positive (?:real )?(?:constant|parameter)": _CONSTANT,
    r"positive (?:real )?(?:number|scalar|quantity)|area|volume|density|thickness|diameter|wavelength"
    r"|resistance|capacitance|inductance|(?:young's|elastic|shear|bulk) modulus|natural frequency": POSITIVE,
    r"gravitational acceleration|acceleration (?:due to|of) gravity": _CONSTANT,
}
"""What a noun says of the letter that it is said of."""
BASES = {"unit vector": "vector", "unit quaternion": "quaternion", "symmetric": "matrix", "positive-definite": "matrix"}
"""The shape of what such a letter is."""
Told = Mapping[Glyph, Mapping[str, Any]]
"""What is said of each letter."""
_NOUN = "(?:" + "|".join(f"(?P<n{place}>{noun})" for place, noun in enumerate(NOUNS)) + ")"
_PLURAL = {"matrix": "matri(?:x|ces)", "axis": "ax[ei]s", "mass": "mass(?:es)?", "radius": "radi(?:us|i)"}
for _one, _several in _PLURAL.items():
    _NOUN = re.sub(rf"\b{_one}\b", _several, _NOUN)
BEFORE = re.compile(rf"(?<![\w-])(?<!center of )(?<!centre of )(?<!\bnot a )(?<!\bno ){_NOUN}s?\s*$")
FOLLOWS = (
    r"(?=\s*(?:[^\w\s-]|$|(?:of|in|on|at|from|to|for|with|along|which|that|whose|and|such|between|about|is|are)\b))"
)
BEHIND = re.compile(
    r"^(?:\s*(?:,|and|or|, and)\s*\$[^$]*\$)*\s*,?\s*(?:is|are|be|being|denotes?|represents?)\s+"
    r"(?:(?:called|said to be) )?(?:(?:an?|the|some|any) )?"
    rf"(?:(?!of\b|the\b|not?\b)[a-z-]+,? ){{0,3}}?{_NOUN}s?{FOLLOWS}"
)
AGAIN = re.compile(r"(?:\$|\\\)|`)\s*(?:,|and|or|, and)\s*$")
"""What stands between two letters of which the same is said."""
MARKUP = re.compile(r"\\(?:emph|text\w*)\s*\{([^{}]*)\}|[*_~]|\$\d+\s*(?:\\times|×)\s*\d+\$")
GROUPS = {"SO(3)": "rotation", "S^2": "unit vector", "S^3": "unit quaternion", "R^3": "vector"}
"""What the members of a set are; the letters of sets are printed in many faces."""
FACE = re.compile(r"\\(?:math(?:bb|cal|rm|sf|bf|frak)|operatorname|text|boldsymbol|left|right|,|;| )\s*|[\s{}]")
_BAR = r"(?:\\(?:left|right))?(?:\\[lr]?Vert|\\[lr]vert|\\\||\|)"
UNIT = re.compile(rf"^{_BAR}(.+?){_BAR}=1$")
SIGNED = re.compile(r"^([^<>=]+?)(>|<|\\gt|\\lt)0$")
OPENING = re.compile(r"(?:(?:`{3,}|~{3,}|:{3,})[ \t]*)?(?:\{?math\}?|\.\. math::)$|(?:`{3,}|~{3,}|:{3,})$")
"""What opens a display in Markdown and in reStructuredText."""
SENTENCE = re.compile(
    r"(?<![Ee]q)(?<!qs)(?<![Ff]ig)(?<!i\.e)(?<!e\.g)(?<!cf)[.!?]\s|\n\s*\n|\$\$|\\\]|\\end\{[^}]*\}|```|\\item\b|\}\s*\n"
)
"""What ends before the sentence that leads to a display."""
POSING = re.compile(
    r"(?:equations? of motion"
    r"|(?:governing|constitutive|state|differential|dynamical?|newton|euler|lagrange|balance|equilibrium) equations?"
    r"|\blaws?\b[\w\s-]{0,30}|\bdynamics|model|(?:constraint|condition)s?)\s*(?:(?:of|for|under|on) [\w\s-]{0,40})?"
    r"(?:then )?(?:is|are|reads?|states?(?: that)?|(?:has|takes?) the form|(?:is|are) given by|as follows"
    r"|(?:is|are|can|may) (?:now |then |also )?(?:be )?(?:stated|written|expressed) as)?\W*$"
    r"|\b(?:is|are|be|remains?) (?:\w+ly )?(?:perpendicular|normal|orthogonal|parallel|constant|fixed|zero)\b"
    r"[^.,;]*(?:, i\.e\.)?\W*$"
    r"|(?:satisf(?:y|ies)|obeys?|subject to|governed by|modell?ed (?:by|as)|described by"
    r"|(?:we )?(?:assume|require|postulate|suppose)(?: that)?)\s*(?:(?:the|a) )?"
    r"(?:following |differential |kinematic )*(?:equation|relation|condition|constraint|law)?s?\W*$"
)
"""How a text leads to a law or a condition."""
CASE = re.compile(r"\b(?:if|when|whenever|provided that|such that)\W*$")
"""How it leads to the condition of one case."""
LOCAL = re.compile(
    r"\b(?:initial|boundary|terminal|final) (?:conditions?|values?|states?|configurations?)\b[^.]*$|\binitially\b[^.]*$"
    r"|\bat (?:time |the (?:time|instant|point|boundary|end) )?\$?[a-z] ?= ?[^.]*$"
)
"""How it leads to what holds at one moment or place alone."""
RESTATING = re.compile(r"\W*(?:(?:or|i\.e|that is|namely|equivalently)\b\W*){0,2}$")
"""All that stands between two equations that say the same."""
OTHER = re.compile(r"\W*(?:or|alternatively|otherwise|whereas)\b(?!\W*equivalent)")
"""How it leads to what may be said instead of the display before."""
DERIVING = re.compile(
    r"\b(?:from|using|into|substitut|insert|differentiat|integrat|solv|multipl|eliminat|combin|simplif|linear[iz]|impl"
    r"|yield|gives?\b|obtain|deriv|becomes?|follows (?:that|from)|leads to|so that|conclud|therefore|hence|thus"
    r"|we (?:get|find|see))"
)
"""What is said of an equation that follows from others."""


REFERENCE = re.compile(r"\\\w*ref\*?\{([^{}]+)\}|\{eq\}`([^`]+)`|:eq:`([^`]+)`|\((\w[\w.:-]*)\)")


@dataclass(frozen=True, slots=True)
class Lead:
    """What the text before a display says of it: whether it is a law, or a condition of some case, or follows.

    What `is_local` holds at one moment or place alone. It is said `again` in other words what the display before says;
    what `is_other` may be said instead.
    `cited` are labels and numbers that may be those of equations, the last first.
    """

    is_posed: bool = False
    is_case: bool = False
    is_local: bool = False
    follows: bool = False
    again: bool = False
    is_other: bool = False
    cited: tuple[str, ...] = ()


def lead_of(before: str) -> Lead:
    """What the text before a display, and the sentence that leads to it, say of it."""
    sentence = re.sub(r"\([^()]*\) ?", "", _plain(SENTENCE.split(OPENING.sub("", before.rstrip()).rstrip())[-1]))
    found = POSING.search(sentence)
    derived = DERIVING.search(sentence[: found.start()] if found else sentence)
    names = (name.strip() for each in REFERENCE.findall(before) for name in "".join(each).split(","))
    return Lead(
        is_posed=found is not None and not derived,
        is_case=CASE.search(sentence) is not None,
        is_local=LOCAL.search(sentence) is not None and not derived,
        follows=derived is not None,
        again=(again := RESTATING.fullmatch(sentence) is not None),
        is_other=not again and OTHER.match(sentence) is not None,
        cited=tuple(dict.fromkeys(names))[::-1],
    )


def said_of_letters(remarks: Iterable[Remark], equations: str) -> Told:
    """What is said of each letter in words, if nothing else is said of it elsewhere.

    What has a rate in the `equations`, given as a line each, is not constant, nor is what they define by others.
    """
    found: dict[Glyph, Mapping[str, Any] | None] = {}
    for letter, said in _sayings(remarks):
        found[letter] = said if found.get(letter, said) == said else None
    return {
        letter: {name: each for name, each in said.items() if name != "constant" or not _moves(letter, equations)}
        for letter, said in found.items() if said is not None
    }  # fmt: skip


def base_of(said: Mapping[str, Any]) -> str:
    """What a letter is by its shape."""
    return BASES.get(said["is"], str(said["is"]))


def _moves(letter: Glyph, equations: str) -> bool:
    """Whether the equations have a rate of the letter, have it as a function of time, or say what it is."""
    of = rf"(?:\\\w+ \{{ )?{re.escape(letter.base)}(?!\w)"
    own = rf"(?:dot \{{ |\bd |\\partial ){of}|(?<!\w){of}(?: _ \{{[^{{}}]*\}})? \( t \)"
    return bool(re.search(rf"{own}|^{of}(?: _ \{{[^{{}}]*\}})? {SAYS}", equations, re.MULTILINE))


def _sayings(remarks: Iterable[Remark]) -> Iterator[tuple[Glyph, dict[str, Any]]]:
    before: dict[str, Any] | None = None
    for remark in remarks:
        left, set_of = _parts(remark.latex)
        said = _noun(BEFORE.search(_plain(remark.before))) or (before if AGAIN.search(remark.before) else None)
        before = said
        said = said or set_of or _noun(BEHIND.match(_plain(remark.after)))
        for text in left if said else ():
            try:
                letter = letter_in(text)
            except (Unread, BadPage):
                continue
            if letter and said:
                yield replace(letter, arguments=""), said


def _parts(latex: str) -> tuple[list[str], dict[str, Any] | None]:
    """The letters that a formula names, and what it says that they are: members of a set, or of length one."""
    if unit := UNIT.match(latex.replace(" ", "")):
        return [unit[1]], {"is": "unit vector"}
    if signed := SIGNED.match(latex.replace(" ", "")):
        return signed[1].split(","), POSITIVE if signed[2] in (">", r"\gt") else {"is": "scalar"}
    names, _, of = latex.partition(r"\in ")
    kind = GROUPS.get(FACE.sub("", of))
    return names.split(","), {"is": kind} if kind else None


def _plain(text: str) -> str:
    """The text in small letters, without what sets words apart and without the sizes of matrices."""
    return re.sub(r"\s+", " ", MARKUP.sub(lambda found: found[1] or " ", text)).lower()


def _noun(found: re.Match[str] | None) -> dict[str, Any] | None:
    return [*NOUNS.values()][int(found.lastgroup[1:])] if found and found.lastgroup else None
