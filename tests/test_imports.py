"""Imports go one way: a room knows the rooms before it, the book knows words and sentences, nothing knows the book."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from importlib.util import resolve_name
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
pytestmark = pytest.mark.skipif(not (ROOT / "pyproject.toml").exists(), reason="needs the checkout")

# Rooms, and the modules beside them, each after everything it may import.
ORDER = (
    "display",
    "several",
    "cache",
    "nearest",
    "vocabulary",
    "reading",
    "evaluation",
    "statements",
    "rewriting",
    "motions",
    "algebra",
    "verdict",
    "checker",
    "problems",
    "points",
    "prover",
    "from_sympy",
    "prove",
    "deciding",
    "repairs",
    "decisions",
    "pages",
    "deriving",
    "asking",
    "exact",
    "exercises",
    "lowering",
    "coq",
    "bounds",
    "targets",
    "kernels",
    "emitted",
    "checked",
    "compiling",
    "numerics",
    "report",
    "cli",
    "__main__",
)
# SymPy and floating point come in with `algebra`.
SYMBOLS_ONLY = ("vocabulary", "reading", "statements", "rewriting")
COMPUTING = ("sympy", "flint", "numpy", "mpmath")
# What the numbers are to check; they borrow nothing from it.
CHECKED_BY_NUMBERS = ("lowering", "bounds", "targets", "compiling")
BOOKS = ("derivations", "rotations")
BOOK_MAY_IMPORT = ("vocabulary", "statements")
EXERCISES_MAY_IMPORT = (*BOOK_MAY_IMPORT, "exact", "exercises")


@cache
def imported_names(module: str, is_package: bool, source: str) -> tuple[tuple[int, str], ...]:
    """Line and absolute dotted name of everything imported anywhere in the module, named dynamic imports included."""
    return tuple(names_in(ast.parse(source), module if is_package else module.rpartition(".")[0]))


def names_in(tree: ast.Module, package: str) -> Iterator[tuple[int, str]]:
    for node in ast.walk(tree):
        match node:
            case ast.Import(names=names):
                yield from ((node.lineno, alias.name) for alias in names)
            case ast.ImportFrom(module=origin, names=names, level=level):
                base = resolve_name("." * level + (origin or ""), package)
                yield from ((node.lineno, f"{base}.{alias.name}") for alias in names)
            case ast.Call(
                func=ast.Name(id=called) | ast.Attribute(attr=called), args=[ast.Constant(value=str(name)), *_]
            ):
                if called in ("import_module", "__import__"):
                    yield node.lineno, name


def objection(module: str, name: str) -> str | None:
    """Why the module may not import the name, or None if it may."""
    top, _, rest = name.partition(".")
    home, target = module.split(".")[1:2], rest.split(".")[0]
    unit = home[0] if home else ""
    if top in BOOKS:
        return f"the book is imported as chasles.{top}"
    if unit in BOOKS:
        return objection_in_book(module, top, rest)
    if top != "chasles":
        return f"{unit} computes nothing" if unit in SYMBOLS_ONLY and top in COMPUTING else None
    if target in BOOKS:
        return "src reaches the book through load() only"
    if unit == "" or target in (unit, "__version__"):
        return None
    if unit not in ORDER or target not in ORDER:
        return f"{unit if unit not in ORDER else name} has no place in ORDER"
    if unit == "kernels" and target != "display":
        return "the kernels stand alone"
    if unit == "numerics" and target in CHECKED_BY_NUMBERS:
        return "numbers borrow nothing from what they check"
    return None if ORDER.index(target) < ORDER.index(unit) else f"{target} comes after {unit}"


def objection_in_book(module: str, top: str, rest: str) -> str | None:
    """The same for a module of the book, which may look back at earlier sections and never forward.

    It computes nothing, but for what exercises have among their calculations: there no section is known.
    """
    computes = ".exercises.calculations" in module
    if top != "chasles":
        return None if computes or top == "__future__" else "the book computes nothing"
    target, *inner = rest.split(".")
    book = module.split(".")[1]
    if computes:
        within = inner[:2] == ["exercises", "calculations"]
        return None if within or target in EXERCISES_MAY_IMPORT else f"not {rest}"
    exercise = module.startswith(f"chasles.{book}.exercises")
    if target != book:
        return None if target in (EXERCISES_MAY_IMPORT if exercise else BOOK_MAY_IMPORT) else f"not {target}"
    here = module.split(".")[2:]
    own_part = inner[: len(here)] == here
    return None if own_part or place(inner) < place(here) else "it does not come earlier in the book"


def place(inner: list[str]) -> tuple[bool, list[str]]:
    """Sorts as the book does: notation, the sections by their numbers, the exercises and the roads."""
    return inner[:1] in (["exercises"], ["roads"]), inner


def objections(module: str, source: str, is_package: bool = False) -> list[str]:
    """One line for each import the module may not make."""
    found = imported_names(module, is_package, source)
    return [f"{module}:{line}: {name}: {why}" for line, name in found if (why := objection(module, name))]


def project_modules() -> Iterator[tuple[str, Path]]:
    """Dotted name and file of every module of src and of the book."""
    books = [(ROOT / book, ("chasles", book)) for book in BOOKS]
    for folder, prefix in ((ROOT / "src" / "chasles", ("chasles",)), *books):
        for path in sorted(folder.rglob("*.py")):
            inner = path.relative_to(folder).with_suffix("").parts
            yield ".".join((*prefix, *(inner[:-1] if path.stem == "__init__" else inner))), path


def test_imports_go_one_way() -> None:
    modules = list(project_modules())
    assert {"chasles", "chasles.kernels", "chasles.derivations"} <= {module for module, _ in modules}
    found = [objections(name, path.read_text("utf-8"), path.stem == "__init__") for name, path in modules]
    assert not [line for lines in found for line in lines]


@pytest.mark.parametrize(
    ("module", "source"),
    [
        ("chasles.vocabulary.words", "from chasles.statements import Claim"),
        ("chasles.vocabulary.words", "def f():\n    from ..problems.unfold import unfold"),
        ("chasles.vocabulary.words", "import sympy"),
        ("chasles.statements.load", "import chasles"),
        ("chasles.statements.load", "from chasles import prove"),
        ("chasles.statements.load", "from chasles.derivations import s02_screw"),
        ("chasles.statements.load", "import importlib\nimportlib.import_module('chasles.derivations.notation')"),
        ("chasles.prover.decide", "from derivations import notation"),
        ("chasles.prover.decide", "from .. import targets"),
        ("chasles.prove", "from chasles.lowering.program import Program"),
        ("chasles.prover.decide", "import chasles.prove"),
        ("chasles.targets.c", "from chasles import kernels"),
        ("chasles.kernels", "from chasles.vocabulary import words"),
        ("chasles.numerics.reference", "from chasles.lowering.request import Request"),
        ("chasles.newcomer", "from chasles.vocabulary import words"),
        ("chasles.cli", "import chasles.newcomer"),
        ("chasles.derivations.notation", "from chasles.prover import decide"),
        ("chasles.derivations.notation", "import sympy"),
        ("chasles.derivations.s02_screw", "from chasles.exact import line"),
        ("chasles.derivations.s02_screw", "from chasles.derivations.s04_twist import twist"),
        ("chasles.derivations.s02_screw", "from .exercises.x3_01 import answer"),
        ("chasles.derivations.notation", "from .s02_screw import screw_axis"),
        ("chasles.derivations.exercises.x3_01", "from .x3_02 import answer"),
        ("chasles.derivations.exercises.calculations.lines", "from ...s02_screw import screw_axis"),
        ("chasles.derivations.exercises.calculations.lines", "from chasles.prover import decide"),
    ],
)
def test_an_import_the_other_way_is_found(module: str, source: str) -> None:
    assert len(objections(module, source, is_package=module == "chasles.kernels")) == 1


@pytest.mark.parametrize(
    ("module", "source"),
    [
        ("chasles.statements.claim", "from ..vocabulary.words import Sum\nfrom . import load"),
        ("chasles.prove", "from chasles.prover.decide import decide\nimport sympy"),
        ("chasles.targets.c", "from chasles import __version__"),
        ("chasles.numerics.verify", "from chasles import kernels"),
        ("chasles.derivations", "import chasles.derivations.s02_screw"),
        ("chasles.derivations.s04_twist", "from chasles.derivations import notation, s02_screw"),
        ("chasles.derivations.s04_twist", "from .notation import e, phi\nfrom .s02_screw import screw_axis"),
        ("chasles.derivations.exercises.x3_02", "from chasles.exact import line\nfrom ..s04_twist import twist"),
        ("chasles.derivations.exercises.calculations.lines", "import sympy\nfrom .solids import prism"),
    ],
)
def test_an_import_the_right_way_is_let_through(module: str, source: str) -> None:
    assert objections(module, source) == []


def test_the_manual_says_where_everything_is() -> None:
    """Each folder has a place in the table, in which none imports one below it."""
    table = (ROOT / "docs" / "extending.md").read_text("utf-8").split("| Folder | Holds |")[1].split("\n\n")[0]
    rows = [re.findall(r"`(\w+)(?:\.py)?`", line.split("|")[1]) for line in table.splitlines()[1:]]
    place = {name: row for row, names in enumerate(rows) for name in names}
    assert {path.parent.name for path in (ROOT / "src" / "chasles").glob("*/__init__.py")} <= set(place)
    for module, path in project_modules():
        here = place.get((*module.split("."), "")[1])
        for _, name in imported_names(module, path.stem == "__init__", path.read_text("utf-8")):
            there = place.get((*name.split("."), "")[1]) if name.startswith("chasles.") else None
            assert here is None or there is None or there <= here, f"{module} imports {name}"


def test_dir_names_what_is_public_alone() -> None:
    import chasles
    import chasles.statements  # an import binds the module's name

    assert dir(chasles) == sorted(chasles.__all__)
