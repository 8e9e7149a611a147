"""Nothing is decided by simplification, by a heuristic test for zero, or by comparing floating-point numbers."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import chasles

ROOMS = (
    *("vocabulary", "evaluation", "statements", "rewriting", "algebra", "checker", "problems", "points", "prover"),
    *("repairs", "decisions", "deriving", "from_sympy"),
)
PACKAGE = Path(chasles.__file__).parent
CHOOSING = {PACKAGE / "repairs" / "real_test.py"}
"""It chooses, by random motions in floating point, which repairs are tried; each is proved before it is told."""
MODULES = sorted(
    {*(path for room in ROOMS for path in (PACKAGE / room).rglob("*.py")), PACKAGE / "prove.py"} - CHOOSING
)
GUESSES = {
    *("simplify", "trigsimp", "nsimplify", "radsimp", "ratsimp", "powsimp", "logcombine", "hyperexpand", "fu"),
    *("equals", "is_constant", "checksol", "verify_numerically"),
}
ROUNDED = {"evalf", "N", "isclose", "allclose", "assert_allclose", "round", "float", "Float", "approx"}
EXACT = {"ceil", "comb", "factorial", "floor", "gcd", "inf", "isqrt", "lcm", "prod"}
ENCLOSED = {"MPIntervalContext"}
"""What rounds outwards: that two intervals are apart is no guess."""
ROUNDING = {"cmath", "decimal", "mpmath", "numpy", "random.uniform"}


def faults(source: str) -> Iterator[str]:
    """What in a module could let a guess or a rounded number decide."""
    tree = ast.parse(source)
    messages = {id(node) for block in raising_blocks(tree) for node in ast.walk(block)}
    notes = {id(node) for each in annotations(tree) for node in ast.walk(each)}
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Attribute(value=ast.Name(id="self"))):
                continue
            case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name)) if id(node) not in messages:
                if name in GUESSES | ROUNDED:
                    yield f"line {node.lineno}: calls {name}"
            case ast.Name(id=name) if name in GUESSES and id(node) not in messages | notes:
                yield f"line {node.lineno}: names {name}"
            case ast.Compare(left=left, comparators=others):
                sides = [left, *others]
                if any(is_float(side) for side in sides) and not any(is_draw(side) for side in sides):
                    yield f"line {node.lineno}: compares with a floating-point number"
            case ast.Import(names=names):
                for name in names:
                    if name.name.split(".")[0] in ROUNDING | {"math"}:
                        yield f"line {node.lineno}: imports {name.name}"
            case ast.ImportFrom(module=module, names=names):
                for name in names:
                    rounds = (module or "").split(".")[0] in ROUNDING and name.name not in ENCLOSED
                    if name.name in GUESSES or rounds:
                        yield f"line {node.lineno}: imports {name.name}"
                    elif module == "math" and name.name not in EXACT:
                        yield f"line {node.lineno}: imports {name.name} from math"


def raising_blocks(tree: ast.AST) -> Iterator[ast.stmt]:
    """The statements of blocks that end by raising: what they compute only words a message."""
    for node in ast.walk(tree):
        block = getattr(node, "body", None)
        if isinstance(block, list) and block and isinstance(block[-1], ast.Raise):
            yield from block


def annotations(tree: ast.AST) -> Iterator[ast.AST]:
    for node in ast.walk(tree):
        for name in ("annotation", "returns"):
            if isinstance(said := getattr(node, name, None), ast.AST):
                yield said


def is_float(node: ast.AST) -> bool:
    return any(isinstance(part, ast.Constant) and isinstance(part.value, float) for part in ast.walk(node))


def is_draw(node: ast.AST) -> bool:
    """Whether it is a random number, by which a sample is chosen and nothing is decided."""
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "random"


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.relative_to(PACKAGE).as_posix())
def test_nothing_is_guessed(path: Path) -> None:
    assert list(faults(path.read_text(encoding="utf-8"))) == []


@pytest.mark.parametrize(
    "source",
    [
        "import sympy\nassert sympy.simplify(a - b) == 0",
        "from sympy import trigsimp as t",
        "holds = (a - b).equals(0)",
        "holds = abs(a - b) < 1e-9",
        "import math",
        "from math import sqrt",
        "import numpy as np",
        "holds = isclose(a, b)",
        "holds = expression.evalf() == 0",
        "todo = map(simplify, entries)",
        "if float(a) == float(b): pass",
    ],
)
def test_a_guess_would_be_noticed(source: str) -> None:
    assert list(faults(source))


@pytest.mark.parametrize(
    "source",
    [
        "if bad:\n    exact = nsimplify(x)\n    raise ValueError(exact)",
        "def f(seconds: float) -> float: ...",
        "from math import gcd, isqrt",
        "if draw.random() < 0.5: pass",
        "from mpmath import MPIntervalContext",
        "BUDGET = 20.0",
    ],
)
def test_what_decides_nothing_is_let_be(source: str) -> None:
    assert list(faults(source)) == []
