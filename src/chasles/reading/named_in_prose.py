r"""What lines of prose between displays name: "with $v = R \omega$", "where $I = m R^2/2$ and $k = a/b$"."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from chasles.reading.commands import SAYS
from chasles.reading.printed import PrintedEquation, Remark
from chasles.reading.prose import AGAIN

NAMING = re.compile(
    r"\b(?:where|with|let|defin\w+|denot\w+|set|setting|put|putting|writ\w+|introduc\w+|the [a-z][\w\s'-]{1,40})"
    r"(?: us)?(?:[\w\s'-]|\$[^$]*\$){0,40}$",
    re.IGNORECASE,
)
"""What stands before a formula that says what its letter is."""
LOCAL = re.compile(
    r"\b(?:if|for|when\w*|at|case|until|unless|assum\w+|suppos\w+|near|around|only|provided|(?:such|so|follows) that"
    r"|condition|constraint|point"
    r"|thus|hence|then|therefore|so|giv\w+|get|obtain\w*|yield\w*|becom\w+|satisf\w+|find|since|because|limit|as)\b"
    r"(?:[^.;:$]|\$[^$]*\$){0,40}$",
    re.IGNORECASE,
)
"""What stands before one that says something else: a case, a place, what follows."""
NAMED = re.compile(rf"\s*(?:\\[A-Za-z]+|[A-Za-z])[^=<>]{{0,40}}?{SAYS}(?P<value>[^=<>:]*[A-Za-z][^=<>:]*)")
SIGNS = re.compile(
    r"\\(?:[lg]eq?|approx|sim(?:eq)?|neq?|in|to|rightarrow|dots|cdots|ldots|pm|mp|forall|text)(?![A-Za-z])"
)
SEPARATE = re.compile(r"[.!?]\s|\n\s*\n")


def with_names(found: Sequence[PrintedEquation], remarks: Iterable[Remark]) -> Iterator[PrintedEquation]:
    """The equations of a page, each with what the prose before it names, and what its own sentence goes on to name."""
    first = {each.display: place for place, each in reversed([*enumerate(found)])}
    beside: dict[int, list[PrintedEquation]] = defaultdict(list)
    for remark in _naming(remarks):
        said = PrintedEquation(remark.latex, remark.line, label=f"line {remark.line}")
        if remark.is_close and remark.follows:
            beside[first[found[remark.follows - 1].display]].append(said)
        beside[remark.follows].append(said)
    for place, each in enumerate(found):
        named = (replace(said, section=each.section, file=each.file) for said in beside[place])
        yield replace(each, beside=(*each.beside, *named)) if beside[place] else each


def _naming(remarks: Iterable[Remark]) -> Iterator[Remark]:
    is_named = False
    for remark in remarks:
        sentence = SEPARATE.split(remark.before)[-1]
        if not AGAIN.search(remark.before):
            is_named = bool(NAMING.search(sentence)) and not LOCAL.search(sentence)
        if is_named and NAMED.fullmatch(remark.latex) and not SIGNS.search(remark.latex):
            yield remark
