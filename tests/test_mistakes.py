"""Mistakes of an author are told in one line, with the place of the declaration: for every argument of every word."""

from __future__ import annotations

import copy
import inspect
import pickle
import re
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np
import pytest
from click.testing import CliRunner

import chasles.statements.derivation as steps
from chasles import statements, vocabulary
from chasles.cli import main
from chasles.decisions.session import Session
from chasles.statements import (
    Always,
    Branch,
    Chapter,
    Claim,
    Condition,
    DeclarationError,
    Definition,
    Entry,
    Hypothesis,
    Inverse,
    Kernel,
    Section,
    Statement,
    Theorem,
    nonzero,
    unit,
)
from chasles.statements.derivation import Take
from chasles.statements.induction import ForAllK
from chasles.vocabulary import (
    CPM,
    LENGTH,
    Identity,
    Index,
    Misfit,
    Node,
    Zero,
    dot,
    scalar,
    square,
    vector,
)
from chasles.vocabulary.arguments import Declared, WrongArgument, declaring
from chasles.vocabulary.functions import maximum
from chasles.vocabulary.notation import Notation
from chasles.vocabulary.sizes import Size

s, k, phi = scalar("s", "s", ""), scalar("k", "k", ""), scalar("phi", r"\phi", "")
v, w, e = vector("v", "v", ""), vector("w", "w", ""), vector("e", "e", "")
M = square("M", "M", "")
defined = Definition("0", s, dot(v, w))
HERE = Path(__file__).name

NAMED: list[tuple[Callable[[], Any], str]] = [
    (lambda: Claim("1", s, s, assuming=unit(v)), "`assuming` is a Hypothesis, and must be a tuple .*: write assuming="),
    (lambda: Claim("1", s, s, given=defined), "`given` is a Definition, and must be a tuple .* write given=(…,)"),
    (lambda: Claim(1, s, s), 'Claim: `number` is 1, and must be a text: write "1"'),
    (lambda: Claim(3.1, s, s), 'Claim: `number` is 3.1, and must be a text: write "3.1"'),
    (lambda: Claim("1", s, 1), "Claim '1': `right` is 1, and must be an expression: write number(1)"),
    (lambda: Claim("1", s, 0.5), "must be an expression: write an exact number"),
    (lambda: Claim("1", s, "s"), "`right` is 's', and must be an expression: declare what it names"),
    (lambda: Claim("1", s), "`right` is missing, and must be an expression"),
    (lambda: Claim("1", s == s), "`left` is True, .* write the two sides with a comma between them"),
    (lambda: Claim("1", s, s, given=(unit(v),)), "part 1 of `given` is a Hypothesis, .*: `assuming` takes that"),
    (lambda: Claim("1", s, s, assuming=(defined,)), "part 1 of `assuming` is a Definition, .*: `given` takes that"),
    (lambda: Claim("1", s, s, assuming=(unit(v), defined)), "part 2 of `assuming` is a Definition"),
    (lambda: Claim("1", s, s, assuming=[unit(v)]), "is a list (a Hypothesis), .*: write a tuple, in round brackets"),
    (lambda: Claim("1", s, s, assuming=(unit,)), "part 1 of `assuming` is unit itself, .*: call it, as unit(…)"),
    (lambda: Claim("1", s, s, assume=(unit(v),)), "takes no `assume`; near it: `assuming`"),
    (lambda: Claim("1", s, s, kernel=s), "`kernel` is the expression s, and must be a Kernel"),
    (lambda: Claim("1", s, s, kernel=(v,)), "`kernel` is a tuple (the expression v), and must be a Kernel"),
    (lambda: Claim("1", s, s, kernel=Kernel(v)), "Kernel: `of` is the expression v, .* write of=(…,)"),
    (lambda: Claim("1", s, s, part="2"), "`part` is '2', and must be a whole number"),
    (lambda: Claim("1", s, s, part=True), "`part` is True, and must be a whole number"),
    (lambda: Claim("1", s, s, says=("a", "b")), "`says` is a tuple ('a', 'b'), and must be a text"),
    (lambda: Claim("1", s, s, sic="yes"), "`sic` is 'yes', and must be True or False"),
    (lambda: Claim("1", s, s, reading=[s, s]), "`reading` is a list .*: write a tuple, in round brackets"),
    (lambda: Claim("1", s, s, restates="0"), "`restates` is '0', and must be a Statement or a tuple"),
    (lambda: Claim("1", s, s, solves=(defined,)), "`solves` is a tuple (a Definition), and must be a Statement"),
    (lambda: Claim("1", s, s, *range(20)), "must be a text"),
    (lambda: Condition("1", s, k, on=s), "`on` is the expression s, .* write on=(…,)"),
    (lambda: Condition("1", s, k, on=(s + k,)), "part 1 of `on` is the expression .*, and must be a Symbol"),
    (lambda: Theorem("T", "", Always(s, s)), "`forms` is an Always, and must be a tuple .* write forms=(…,)"),
    (lambda: Theorem("T", "", (s,)), "part 1 of `forms` is the expression s, and must be a Form"),
    (lambda: Theorem("T", "", (Always,)), "part 1 of `forms` is Always itself, .* call it, as Always(…)"),
    (lambda: Always(s, 0), "Always: `right` is 0, and must be an expression: write number(0)"),
    (lambda: unit("v"), "unit: `vector` is 'v', and must be an expression"),
    (lambda: unit(*()), "unit: `vector` is missing"),
    (lambda: unit(v, w), "unit takes vector, and is given 1 more"),
    (lambda: nonzero(0), "nonzero: `expression` is 0"),
    (lambda: dot(v, 1), "dot: `right` is 1, and must be an expression: write number(1)"),
    (lambda: vocabulary.column(v, "x"), r"column: blocks\[1] is 'x', and must be an expression or a whole number"),
    (lambda: vocabulary.matrix(v, v), r"matrix: rows\[0] is the expression v, .* write rows\[0]=(…,)"),
    (lambda: scalar("x", "x", "", "LENGTH"), "scalar: `dimension` is 'LENGTH', and must be a Dimension"),
    (lambda: scalar("x", "x", LENGTH), "scalar: `meaning` is a Dimension, .*: `dimension` takes that"),
    (lambda: Take((defined,)), r"Take: statements\[0] is a tuple (a Definition), .*: leave the brackets"),
    (lambda: Zero("3", 1), "'3' is no size: write a whole number, or a letter for one"),
    (lambda: Identity(M), "M is no size: write a whole number, or a letter for one"),
    (lambda: vector("z", "z", "", size=0), "0 is no size: it is 1 or more"),
    (lambda: Size("n") * 2.5, "2.5 is no size"),
    (lambda: Notation({"sinus": "#1"}), "'sinus' is no function of a scalar: name a word itself"),
    (lambda: Notation({"sin": "#2"}), "for sin has to name its 1 part"),
    (lambda: Notation([CPM]), "Notation takes a table of words and forms"),
    (lambda: vocabulary.Dot(v, 3), "Dot: `right` is 3, and must be an expression"),
]  # fmt: skip


@pytest.mark.parametrize(("write", "said"), NAMED)
def test_a_mistake_is_told_with_its_place(write: Callable[[], Any], said: str) -> None:
    pattern = rf"{HERE}, line \d+: .*{said.replace('(', '[(]').replace(')', '[)]')}"
    with pytest.raises(WrongArgument, match=pattern) as raised:
        write()
    assert "\n" not in str(raised.value)
    assert str(raised.value).startswith(f"{__file__}, line {write.__code__.co_firstlineno}: ")


@pytest.mark.parametrize(
    ("write", "said"),
    [
        (lambda: np.eye(3) @ v, "got a ndarray: write `matrix` or `column`, of exact numbers"),
        (lambda: np.array([1, 2, 3]) * s, "got a ndarray: write `matrix` or `column`, of exact numbers"),
        (lambda: np.float64(0.5) * s, "got np.float64(0.5): write Fraction(1, 2)"),
        (lambda: M.x, "M is 3 x 3: a component is that of a column"),
        (maximum, "max takes one scalar or more"),
    ],
)
def test_what_no_operator_takes_is_told(write: Callable[[], Any], said: str) -> None:
    with pytest.raises((TypeError, Misfit), match=re.escape(said)):
        write()


# Every argument of every word, with things of other types.

EXAMPLES: dict[Any, Any] = {
    "Claim": ("1", s, s), "Condition": ("1", s, k), "Definition": ("1", s, k), "Postulate": ("1", s, k),
    "Statement": ("1", s, k), "Theorem": ("T", "", (Always(s, s),)), "Always": (s, s), "Hypothesis": ("unit", (v,)),
    "Minimum": (s, k, s, k, (v,)), "Definite": (s, (v,)), "OnlyWhere": (M, M, M, (s,)), "Iff": (v, w, M, M),
    "Exists": (v, w, s, s), "Unique": (v, w, M), "Kernel": ((v,),), "Stack": ("q", (s, k)), "Packed": (M,),
    "Branch": ("case", s, ((v, w),)), "Inverse": ("1", defined, (Branch("case", s, ((v, w),)),), (v,)),
    "Section": ("1", "Title"), "ForAllK": (s, s, s, s, (), ()),
    "Take": (defined,), "Consider": (s,), "Substitute": (defined,), "Expand": (), "Factor": (s,), "FactorOut": (s,),
    "Ansatz": (v, w), "Solve": (s,), "Differentiate": (), "Multiply": (s,), "TakeVector": (), "Compare": (defined,),
    "Derivation": ("1", None, "", (Take(defined),)), "DerivationStep": (),
    "unit": (v,), "unit_column": (s, v), "nonzero": (s,), "positive": (s,), "symmetric": (M,), "definite": (M,),
    "rotation": (M,), "half_turn": (M,), "orthonormal": (v, w, e), "perpendicular": (v, w),
    "scalar": ("x", "x", ""), "vector": ("x", "x", ""), "square": ("x", "x", ""), "array": ("x", "x", "", v),
    "abbreviation": ("x", "x", v, ""), "cos": (phi,), "sin": (phi,), "tan": (phi,), "cot": (phi,), "dot": (v, w),
    "cross": (v, w), "norm": (v,), "tr": (M,), "det": (M,), "vect": (M,), "CPM": (v,), "inverse": (M,), "rate": (v,),
    "integral": (v, s, w), "at": (v, "t"), "number": (1,), "over": (1, 2), "paren": (v,), "bracket": (v,),
    "in_frame": (v, "A"), "column": (v, w), "row": (v, w), "matrix": ((s, k), (k, s)),
    "Family": ("v", (v, w, e)), "Index": ("i",),
}  # fmt: skip
WRONG: list[Any] = [
    None, 7, 0.5, True, "text", (), (s,), [s], {"s": s}, s, v, M, unit(v), (unit(v),), defined, (defined,),
    Kernel((v,)), Always(s, s), LENGTH, unit, Claim, object(), Index("i"), Take(defined), (1, 2), ((s, k),),
    Fraction(1, 2), (Fraction(1, 2),), b"text", {s}, lambda: s,
]  # fmt: skip
TOLD = (WrongArgument, Misfit, DeclarationError, TypeError)


def declared_words() -> Iterator[tuple[str, Any]]:
    """What authors call: functions, and classes of what is declared."""
    own = [name for name, found in vars(steps).items() if getattr(found, "__module__", "") == steps.__name__]
    for module, names in ((statements, statements.__all__), (vocabulary, vocabulary.__all__), (steps, own)):
        for name in names:
            word = getattr(module, name)
            if (inspect.isclass(word) and issubclass(word, Declared)) or hasattr(word, "__wrapped__"):
                yield name, word
    yield "ForAllK", ForAllK


@pytest.mark.parametrize(("name", "word"), list(declared_words()))
def test_no_argument_of_another_type_is_believed_or_ends_in_a_surprise(name: str, word: Any) -> None:
    args = EXAMPLES[name]
    word(*args)
    parameters = list(inspect.signature(word.__init__ if inspect.isclass(word) else word).parameters)
    names = parameters[1:] if inspect.isclass(word) else parameters
    for place in range(len(args)):
        for wrong in WRONG:
            attempt(word, (*args[:place], wrong, *args[place + 1 :]), {})
    kinds = inspect.signature(word.__init__ if inspect.isclass(word) else word).parameters
    for keyword in names[len(args) :]:
        if kinds[keyword].kind is not inspect.Parameter.VAR_POSITIONAL:
            for wrong in WRONG:
                attempt(word, args, {keyword: wrong})


def attempt(word: Any, args: tuple[Any, ...], named: dict[str, Any]) -> None:
    """The call makes something that can be used, or says what is wrong with it."""
    try:
        made = word(*args, **named)
    except TOLD as error:
        if "\n" in str(error) or any(words in str(error) for words in PYTHON):
            pytest.fail(f"{word.__name__}{args}{named}: {error}")
        return
    use(made)


PYTHON = ("object is not", "unsupported operand", "positional argument", "has no len", "unhashable", "not iterable",
          "unexpected keyword", "has no attribute", "must be str")  # fmt: skip
"""What Python says where nobody looked at the types."""


def use(made: Any) -> None:
    """What was made can be written, copied and decided."""
    copy.copy(made)
    match made:
        case Statement() | Theorem() | Inverse():
            judge = Session(budget=2)
            before = [Entry("before", Section("1", ""), defined)] if made is not defined else []
            Chapter("", (*before, Entry("it", Section("1", ""), made)))
            judge.decide(made)
        case Node():
            vocabulary.latex(made), vocabulary.plain(made)
        case Hypothesis() if made.subjects:
            judge = Session(budget=2)
            judge.decide(Claim("9", s, s, assuming=(made,)))


def test_copies_and_pickles_of_what_is_declared_are_made() -> None:
    claim = Claim("1", s, dot(v, w), assuming=(unit(v),), kernel=Kernel((v,)))
    for made in (claim, unit(v), Kernel((v,)), Section("1", ""), Always(s, s)):
        for other in (copy.copy(made), copy.deepcopy(made), pickle.loads(pickle.dumps(made))):
            assert type(other) is type(made)
            assert repr(other) == repr(made)


def test_declared_types_of_everything_are_known() -> None:
    for _, word in declared_words():
        assert get_type_hints(word)


# Through the command line.

CHAPTER = '''"""A chapter."""
from chasles.statements import *
from chasles.vocabulary import *

head = Section("1", "Head")
s, v, M = scalar("s", "s", ""), vector("v", "v", ""), square("M", "M", "")
d = Definition("1.0", s, dot(v, v))
'''
LINES = [
    'c = Claim("1.1", s, s, assuming=unit(v))', 'c = Claim("1.1", s, s, given=d)', "c = Claim(1.1, s, s)",
    'c = Claim("1.1", s, 1)', 'c = Claim("1.1", s, "s")', 'c = Claim("1.1", s)', 'c = Claim("1.1", s == s)',
    'c = Claim("1.1", s, s, given=(unit(v),))', 'c = Claim("1.1", s, s, assuming=[unit(v)])',
    'c = Claim("1.1", s, s, kernel=v)', 'c = Claim("1.1", s, s, kernel=Kernel(v))', 'c = Claim("1.1", s, s, givn=(d,))',
    'c = Condition("1.1", s, s, on=s)', 'c = Theorem("1.1", "", Always(s, s))', 'c = Claim("1.1", v, v, says=None)',
    'c = Claim("1.1", s + "a", s)', 'c = Claim("1.1", v @ None, s)', 'c = Claim("1.1", norm(2), s)',
    'c = Claim("1.1", -unit(v), s)', 'c = Claim("1.1", s, s, assuming=(unit,))', 'c = Claim("1.1", s, v)',
    'c = Claim("1.1", s, s, part="b")', 'c = Claim("1.1", s, s, part=None)', 'c = Claim("1.1", s / 0.5, s)',
    'c = Claim("1.1", s**v, s)', 'c = Claim("1.1", v.T.T2, s)', 'h = Section(1, "Head")', 'e = vector("e", 5, "")',
    'c = Claim("1.1", s, s, assuming=(unit(2 * v),))', 'c = Claim("1.1", s, s, sign=3)',
]  # fmt: skip


@pytest.mark.parametrize("command", ["decide", "list"])
@pytest.mark.parametrize("line", LINES)
def test_the_command_line_tells_it_in_one_line(line: str, command: str, tmp_path: Path) -> None:
    folder = tmp_path / "mistaken_chapter"
    folder.mkdir()
    (folder / "__init__.py").write_text('TITLE = "It"\nSECTIONS = ("first",)\n', "utf-8")
    (folder / "first.py").write_text(f"{CHAPTER}{line}\n", "utf-8")
    done = CliRunner().invoke(main, ["--chapter", str(folder), command], prog_name="chasles")
    sys.modules.pop("mistaken_chapter.first", None)
    sys.modules.pop("mistaken_chapter", None)
    assert done.exit_code == 2
    assert done.stderr.count("\n") == 1
    place = f"{folder / 'first.py'}, line {CHAPTER.count(chr(10)) + 1}: "
    assert done.stderr.startswith(f"chasles: {place}")
    assert done.stderr.count(str(folder)) == 1
    assert "defect" not in done.stderr


def test_a_function_that_is_declaring_is_otherwise_the_same() -> None:
    @declaring
    def double(of: int, *rest: str, times: int = 2) -> int:
        """Twice."""
        return of * times + len(rest)

    assert double(3) == 6
    assert double(3, "a", times=1) == 4
    assert double.__doc__ == "Twice."
    for write in (lambda: double("3"), lambda: double(3, 4), lambda: double(3, times="2"), lambda: double(3, time=2)):
        with pytest.raises(WrongArgument):
            write()
