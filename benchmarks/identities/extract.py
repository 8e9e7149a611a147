"""Writes `from_sympy.txt`: equations that SymPy's own test suite asserts, as pairs of sides, found true by numbers.

`assert simplify(a) == b` says that a = b, `assert cos(-x) == cos(x)` that the left side, before it is evaluated, is the
right one. The test functions are run with their assertions replaced by notes of both sides. SymPy's tests are under
SymPy's licence (BSD, https://github.com/sympy/sympy/blob/master/LICENSE).

    python -m benchmarks.identities.extract
"""

from __future__ import annotations

import ast
import importlib
import inspect
import signal
import warnings
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import sympy
from benchmarks.identities.numbers import agreement, falsified
from benchmarks.identities.pairs import ASSUMED, ELEMENTARY, Pair, read, text_of, written
from sympy.core.parameters import evaluate

HERE = Path(__file__).parent
MODULES = (
    *(f"simplify.tests.test_{name}" for name in ("trigsimp", "simplify", "radsimp", "sqrtdenest", "powsimp", "ratsimp",
                                                 "fu", "combsimp", "rewrite")),
    *(f"functions.elementary.tests.test_{name}" for name in ("complexes", "exponential", "hyperbolic", "miscellaneous",
                                                             "piecewise", "trigonometric")),
    *(f"core.tests.test_{name}" for name in ("arit", "expand", "power", "exprtools", "numbers")),
    *(f"matrices.tests.test_{name}" for name in ("commonmatrix", "determinant", "matrixbase")),
    *(f"matrices.expressions.tests.test_{name}" for name in ("adjoint", "blockmatrix", "determinant", "hadamard",
                                                             "inverse", "matadd", "matexpr", "matmul", "matpow",
                                                             "trace", "transpose")),
    "concrete.tests.test_sums_products", "functions.combinatorial.tests.test_comb_factorials",
)  # fmt: skip
REWRITERS = {
    *("simplify", "trigsimp", "radsimp", "sqrtdenest", "powsimp", "powdenest", "ratsimp", "together", "factor", "fu"),
    *("expand", "expand_trig", "expand_log", "expand_power_exp", "expand_power_base", "expand_mul", "collect", "doit"),
    *("cancel", "apart", "logcombine", "exptrigsimp", "futrig", "nsimplify", "rewrite", "as_explicit", "det", "inv"),
    *("besselsimp", "rad_rationalize", "piecewise_fold", "expand_func", "factor_terms", "trigsimp_groebner"),
    *("TR0", "TR1", "TR2", "TR2i", "TR3", "TR5", "TR6", "TR7", "TR8", "TR9", "TR10", "TR10i", "TR11", "TR12", "TR13"),
    *(
        "TRmorrie",
        "TR14",
        "TR15",
        "TR16",
        "TR22",
        "TR111",
        "L",
        "combsimp",
        "block_collapse",
        "gammasimp",
        "canonicalize",
    ),
    *("piecewise_exclusive", "refine", "T", "transpose", "adjugate", "trace", "_trigpats", "TRpower"),
}
KEPT_WHOLE = {"det", "inv", "T", "transpose", "adjugate", "trace"}
SECONDS = 6
LONGEST = 300


class _Notes(ast.NodeTransformer):
    """Replaces `assert left == right` by a note of what left is made from, and right."""

    def visit_Assert(self, node: ast.Assert) -> ast.AST:
        test = node.test
        if not (isinstance(test, ast.Compare) and isinstance(test.ops[0], ast.Eq)):
            return ast.copy_location(ast.Pass(), node)
        sides = [test.left, *test.comparators]
        calls = []
        for left, right in pairwise(sides):
            source, whole = _source(left)
            arguments = [_delayed(source), _delayed(right), ast.Constant(whole), ast.Constant(node.lineno)]
            calls.append(ast.Call(ast.Name("_note", ast.Load()), arguments, []))
        body = [ast.copy_location(ast.Expr(call), node) for call in calls]
        return ast.fix_missing_locations(ast.copy_location(ast.If(ast.Constant(True), body, []), node))


def _delayed(expression: ast.expr) -> ast.expr:
    empty = ast.arguments(posonlyargs=[], args=[], kwonlyargs=[], kw_defaults=[], defaults=[])
    return ast.Lambda(empty, expression)


def _source(left: ast.expr) -> tuple[ast.expr, bool]:
    """What the left side rewrites, and whether it is to be kept as it is built."""
    match left:
        case ast.Call(func=ast.Name(id=name), args=[first, *_]) if name in REWRITERS:
            return _source(first)
        case ast.Call(func=ast.Attribute(value=value, attr=name)) if name in REWRITERS - KEPT_WHOLE:
            return _source(value)
        case _:
            return left, True


def _asserted(module: str) -> Iterator[tuple[int, Any, Any]]:
    """Both sides of each assertion of a module's tests, with the line."""
    loaded = importlib.import_module(f"sympy.{module}")
    path = Path(inspect.getfile(loaded))
    tree = _Notes().visit(ast.parse(path.read_text("utf-8")))
    noted: list[tuple[int, Any, Any]] = []

    def note(left: Callable[[], Any], right: Callable[[], Any], whole: bool, line: int) -> None:
        try:
            wanted = right()
            made = left()
            if whole and _same(made, wanted):
                with evaluate(False):
                    made = left()
        except Exception:
            return
        noted.append((line, made, wanted))

    space: dict[str, Any] = {"__name__": loaded.__name__, "__package__": loaded.__package__, "_note": note}
    exec(compile(ast.fix_missing_locations(tree), str(path), "exec"), space)
    for name, test in list(space.items()):
        if name.startswith("test") and inspect.isfunction(test) and not getattr(test, "_slow", False):
            _run(test)
    yield from sorted(noted, key=lambda item: item[0])


def _same(made: Any, wanted: Any) -> bool:
    try:
        return bool(made == wanted)
    except Exception:
        return False


class _TooLong(BaseException):
    """A test or a comparison took too long."""


def _stop(*_: Any) -> None:
    raise _TooLong


def _run(test: Callable[[], Any]) -> None:
    signal.signal(signal.SIGALRM, _stop)
    signal.alarm(SECONDS)
    try:
        test()
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt):
            raise
    finally:
        signal.alarm(0)


def _kind(left: Any, right: Any) -> str | None:
    """Whether the pair is real, complex or special; None if it is no pair of scalars or matrices over symbols."""
    both = [left, right]
    if not all(isinstance(side, sympy.Expr | sympy.MatrixBase) for side in both):
        return None
    symbols = {s for side in both for s in side.atoms(sympy.Symbol)}
    known = all(not isinstance(s, sympy.Dummy | sympy.Wild) and set(s._assumptions_orig) <= ASSUMED for s in symbols)
    infinite = sympy.nan, sympy.zoo, sympy.oo, -sympy.oo, sympy.Float, sympy.Integral, sympy.Limit
    if not known or any(s.is_commutative is False for s in symbols) or any(side.has(*infinite) for side in both):
        return None
    if not {type(f) for side in both for f in side.atoms(sympy.Function)} <= ELEMENTARY:
        return "special"
    return "complex" if any(side.has(sympy.I) for side in both) or any(s.is_real is False for s in symbols) else "real"


def _pairs(module: str, seen: set[str]) -> Iterator[Pair]:
    """What a module's tests assert of real or complex expressions, each found true by numbers."""
    for line, one, other in _asserted(module):
        try:
            signal.alarm(SECONDS)
            left, right = sympy.sympify(one), sympy.sympify(other)
            kind = _kind(left, right)
            if kind in (None, "special"):
                continue
            pair = Pair(f"{module.replace('.', '/')}.py:{line}", str(kind), text_of(left), text_of(right), "")
            key = f"{pair.left} == {pair.right}"
            if key in seen or pair.left == pair.right or len(key) > LONGEST:
                continue
            seen.add(key)
            found = agreement(*read(pair))
            if found == "different":
                print("differs", pair.source, key)
            if found in ("equal", "complex"):
                wrong = falsified(pair) if len(seen) % 2 and kind == "real" and found == "equal" else ""
                yield pair._replace(kind="complex" if found == "complex" else pair.kind, wrong=wrong)
        except (Exception, _TooLong):
            continue
        finally:
            signal.alarm(0)


def main() -> None:
    """Runs the tests of the modules, and writes what they assert."""
    warnings.simplefilter("ignore")
    seen: set[str] = set()
    pairs: list[Pair] = []
    for module in MODULES:
        pairs += _pairs(module, seen)
        print(module, len(pairs), flush=True)
        (HERE / "from_sympy.txt").write_text(written(pairs), "utf-8")


if __name__ == "__main__":
    main()
