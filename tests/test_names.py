"""Names and docstrings of the sources: one name for one notion, the field's terms, a sentence for what is public.

The sources are read, not imported.
"""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping
from functools import cache
from pathlib import Path

import pytest

import chasles

SRC = Path(chasles.__file__).parent
ROOT = Path(__file__).resolve().parents[1]
pytestmark = pytest.mark.skipif(not (SRC / "cli").is_dir(), reason="needs the sources")

SHARED_CLASS_NAMES = {
    "Entry": "chapters import both: an entry of a chapter, and the word for an entry of a matrix",
    "Inverse": "chapters import both: an inverse function, and the word for the inverse of a matrix",
}
"""Names of more than one class, each with the reason why neither has another."""

PRIVATE_WORDS = {
    "judge": "session",
    "foresee": "predict",
    "foreseen": "predicted",
    "bearing": "relevant",
    "passage": "step",
    "passages": "steps",
    "watched": "progress",
    "miss": "residual",
    "staged": "system",
    "undone": "edited",
    "door": "context",
}
"""Words that only their author understood, each with what is said instead."""

PRIVATE_PHRASES = {
    r"\b(the|a|each|no) prints?\b(?! \(|,? (in|on) )": "the printed equation",
    r"\b(does|do) not stand\b|\bthat stands?\b(?! alone)": "is wrong as printed",
    r"\bstands? in for\b": "replaces",
    r"\broads? (to|leads?|stops?|arrives?|of|that)\b": "derivation",
    r"\bjudges?\b": "session",
    r"\btakes? your word\b": "is not checked",
    r"\bbelieved?\b": "trusted",
    r"\b1 (statements|kernels|steps|certificates|counterexamples|points|numbers)\b": "singular",
}
"""What nobody says of an equation, in what a user reads, each with what is said instead."""


parse = cache(ast.parse)


@cache
def sources() -> Mapping[Path, str]:
    return {path.relative_to(SRC): path.read_text("utf-8") for path in sorted(SRC.rglob("*.py"))}


def definitions(tree: ast.Module) -> Iterator[tuple[ast.ClassDef | None, ast.ClassDef | ast.FunctionDef]]:
    """What a module defines, and its classes: each with the class it is in. What is in a function is not seen."""
    waiting: list[tuple[ast.ClassDef | None, ast.AST]] = [(None, tree)]
    while waiting:
        inside, parent = waiting.pop()
        for node in ast.iter_child_nodes(parent):
            if isinstance(node, ast.ClassDef | ast.FunctionDef):
                yield inside, node
            if isinstance(node, ast.ClassDef):
                waiting.append((node, node))
            elif isinstance(node, ast.If):
                waiting.append((inside, node))


def bases(node: ast.ClassDef) -> set[str]:
    return {ast.unparse(base.value if isinstance(base, ast.Subscript) else base) for base in node.bases}


def repeated_classes(texts: Mapping[Path, str]) -> dict[str, list[str]]:
    """The names that more than one class has, private ones included, and where."""
    found: dict[str, list[str]] = defaultdict(list)
    for path, text in texts.items():
        for _, node in definitions(parse(text)):
            if isinstance(node, ast.ClassDef):
                found[node.name].append(str(path))
    return {name: places for name, places in found.items() if len(places) > 1}


def undocumented(texts: Mapping[Path, str]) -> list[str]:
    """Public classes and functions without a docstring.

    A method has one too if a class that its own derives from says it, if that class is a library's, or if it is one
    that a Protocol asks for: what it does is then said there, once.
    """
    trees = {path: parse(text) for path, text in texts.items()}
    classes = {node.name: node for t in trees.values() for _, node in definitions(t) if isinstance(node, ast.ClassDef)}
    asked = {
        node.name
        for tree in trees.values()
        for inside, node in definitions(tree)
        if inside is not None and "Protocol" in bases(inside)
    }
    said = {
        (inside.name, node.name)
        for tree in trees.values()
        for inside, node in definitions(tree)
        if inside is not None and ast.get_docstring(node)
    }

    def says(name: str, method: str) -> bool:
        if "." in name or (name, method) in said:
            return True
        return name in classes and any(says(base, method) for base in bases(classes[name]))

    found = []
    for path, tree in trees.items():
        for inside, node in definitions(tree):
            if node.name.startswith("_") or ast.get_docstring(node) or is_repeated(node):
                continue
            if inside is not None and inside.name.startswith("_"):
                continue
            if inside is None or not (says(inside.name, node.name) or node.name in asked):
                found.append(f"{path}:{node.lineno} {node.name}")
    return found


def is_repeated(node: ast.ClassDef | ast.FunctionDef) -> bool:
    """Whether it is an overload, a setter or a case of a function that is documented at its first definition."""
    return any(re.search(r"\boverload$|\.setter$|\.register", ast.unparse(each)) for each in node.decorator_list)


def words_in(texts: Mapping[Path, str], words: Collection[str]) -> list[str]:
    """Where identifiers have one of these words in them."""
    pattern = re.compile(rf"(?:^|_)(?:{'|'.join(words)})(?:_|$)", re.IGNORECASE)
    return [
        f"{path}:{token.start[0]} {token.string}"
        for path, text in texts.items()
        if any(word in text.lower() for word in words)
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
        if token.type == tokenize.NAME
        for name in [re.sub(r"(?<=[A-Za-z])(?=[A-Z][a-z])", "_", token.string)]
        if pattern.search(name)
    ]


def test_no_class_has_the_name_of_another() -> None:
    found = repeated_classes(sources())
    assert {name: places for name, places in found.items() if name not in SHARED_CLASS_NAMES} == {}


def test_what_is_public_says_what_it_is() -> None:
    assert undocumented(sources()) == []


def test_every_module_says_what_it_holds() -> None:
    assert [path for path, text in sources().items() if not ast.get_docstring(parse(text))] == []


def test_names_are_words_of_the_field() -> None:
    assert words_in(sources(), PRIVATE_WORDS) == []


def strings_in(text: str) -> str:
    """The strings of a module that are no docstrings, a line for each; of its commands also the help, a docstring."""
    tree = parse(text)
    parents = [node for node in ast.walk(tree) if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)]
    said = {
        id(child.value)
        for parent in parents
        if not (isinstance(parent, ast.FunctionDef) and parent.name == "command")
        for child in parent.body
        if isinstance(child, ast.Expr)
    }
    strings = (node for node in ast.walk(tree) if isinstance(node, ast.Constant) and id(node) not in said)
    return "\n".join(node.value for node in strings if isinstance(node.value, str))


def what_a_user_reads() -> Iterator[tuple[str, str]]:
    """Messages, help, templates of pages and the manual, each with its place."""
    yield from ((str(path), strings_in(text)) for path, text in sources().items())
    pages = [*(SRC / "report").rglob("*.jinja"), *(ROOT / "docs").glob("*.md")]
    for path in (*pages, ROOT / "README.md", ROOT / "CONTRIBUTING.md"):
        yield path.name, path.read_text("utf-8")


def phrases_in(text: str) -> list[str]:
    """The phrases of the list that occur, each once."""
    return [found[0] for phrase in PRIVATE_PHRASES if (found := re.search(phrase, text))]


def test_what_a_user_reads_is_plain_english() -> None:
    assert {place: found for place, text in what_a_user_reads() if (found := phrases_in(text))} == {}


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("equal to the print", ["the print"]),
        ("a print that is wrong", ["a print"]),
        ("(3.1) does not stand", ["does not stand"]),
        ("the roads lead to (3.1)", ["roads lead"]),
        ("1 statements", ["1 statements"]),
        ("11 statements", []),
        ("the printed equation is right", []),
    ],
)
def test_a_private_phrase_is_found(text: str, found: list[str]) -> None:
    assert phrases_in(text) == found


def test_messages_and_help_are_read_and_docstrings_are_not() -> None:
    text = '"""A."""\n\ndef f():\n    """B."""\n    raise E(f"C {d}")\n\n\ndef command():\n    """D."""\n'
    assert set(strings_in(text).split("\n")) == {"C ", "D."}


BARE = 'class A:\n    """A."""\n\n    def f(self): ...\n'
SAID = 'class A:\n    """A."""\n\n    def f(self):\n        """F."""\n'


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (BARE, ["a.py:4 f"]),
        (SAID, []),
        (f'{SAID}class B(A):\n    """B."""\n    def f(self): ...\n', []),
        (f'{SAID}class B:\n    """B."""\n    def f(self): ...\n', ["a.py:8 f"]),
        ('class A(Protocol):\n    """A."""\n    def f(self): ...\nclass B:\n    """B."""\n    def f(self): ...\n', []),
        ('class A(click.Group):\n    """A."""\n    def f(self): ...\n', []),
        ("def _f(): ...\ndef g(): ...\n", ["a.py:2 g"]),
        ("if X:\n    def g(): ...\n", ["a.py:2 g"]),
        ("class A: ...\n", ["a.py:1 A"]),
        ('def g():\n    """G."""\n    def h(): ...\n', []),
        ("@g.register\ndef h(): ...\n", []),
    ],
)
def test_a_missing_docstring_is_found(text: str, expected: list[str]) -> None:
    assert undocumented({Path("a.py"): text}) == expected


def test_a_second_class_of_a_name_is_found() -> None:
    texts = {Path("a.py"): "class A: ...", Path("b.py"): "class B:\n    class A: ..."}
    assert repeated_classes(texts) == {"A": ["a.py", "b.py"]}


@pytest.mark.parametrize("name", ["judge", "_judge", "judge_of", "AJudge", "JUDGE", "the_judge"])
def test_a_private_word_is_found(name: str) -> None:
    assert words_in({Path("a.py"): f"{name} = 1\n"}, PRIVATE_WORDS) == [f"a.py:1 {name}"]


@pytest.mark.parametrize("text", ["judged = 1", "'judge'", "# judge", "prejudge = 1", "missing = 1"])
def test_other_words_are_none(text: str) -> None:
    assert words_in({Path("a.py"): f"{text}\n"}, PRIVATE_WORDS) == []
