"""Modules for JAX and PyTorch that are taken away give what the Python kernel gives, and are traced and differentiated.

Where a library is not installed, NumPy stands in for it.
"""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Iterator
from contextlib import nullcontext
from importlib.util import find_spec
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import sympy as sp

import chasles
from chasles.lowering.refusal import LoweringError

from .conftest import PROGRAMS, imported
from .taken import EXPRESSIONS, KINDS, LACKING, points, require_close, taken, wanted, written_out  # noqa: F401

x, y = sp.symbols("x y")
INSTALLED = {name for name in ("jax", "torch") if find_spec(name) is not None}


@pytest.fixture(autouse=True)
def nothing_is_compiled_to_be_called(monkeypatch: Any) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")


class Tensor(np.ndarray):
    """An array with what PyTorch's have."""

    device = None

    def is_complex(self) -> bool:
        return np.iscomplexobj(self)

    def is_floating_point(self) -> bool:
        return np.issubdtype(self.dtype, np.floating)

    def to(self, dtype: Any) -> Any:
        return self.astype(dtype)


class Alike(ModuleType):
    """A module with NumPy's names."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return getattr(np, name)


def on_arrays(function: Any) -> Any:
    """The function of numbers on arrays, NaN where it has no value."""

    def quiet(number: float) -> float:
        try:
            return float(function(number))
        except ValueError:
            return math.nan

    return lambda array: np.vectorize(quiet, otypes=[array.dtype])(array).view(type(array))


def stand_ins() -> dict[str, ModuleType]:
    jax, numpy, torch = ModuleType("jax"), Alike("jax.numpy"), Alike("torch")
    jax.numpy, jax.Array = numpy, np.ndarray  # type: ignore[attr-defined]
    torch.Tensor = Tensor  # type: ignore[attr-defined]
    torch.asarray = lambda value, **said: np.asarray(value, **said).view(Tensor)  # type: ignore[attr-defined]
    special = ModuleType("special")
    for name, called in {"erf": math.erf, "erfc": math.erfc, "gamma": math.gamma, "gammaln": math.lgamma}.items():
        setattr(special, name, on_arrays(called))
    scipy = ModuleType("jax.scipy")
    scipy.special = special  # type: ignore[attr-defined]
    torch.erf, torch.erfc = special.erf, special.erfc  # type: ignore[attr-defined]
    return {"jax": jax, "jax.numpy": numpy, "jax.scipy": scipy, "torch": torch}


@pytest.fixture(scope="module", params=["jax", "torch", "stand-in for jax", "stand-in for torch"])
def library(request: Any, taken: Any, written_out: Any) -> Iterator[Any]:  # noqa: F811
    """The library's name, what makes its arrays, and the functions by their names."""
    name = request.param.split()[-1]
    if request.param == name and name not in INSTALLED:
        pytest.skip(f"no {name}")
    folder = written_out(name)
    with pytest.MonkeyPatch.context() as patch:
        for module, stand_in in stand_ins().items() if request.param != name else ():
            patch.setitem(sys.modules, module, stand_in)
        __import__("jax.numpy" if name == "jax" else name)
        asarray = sys.modules["jax.numpy" if name == "jax" else name].asarray
        wide = getattr(sys.modules[name], "enable_x64", None)
        with nullcontext() if wide is None else wide(True):
            functions = {
                kernel: getattr(imported(f"{kernel}_{name}", folder / f"{kernel}_{name}.py"), kernel)
                for kernel in taken
                if kernel not in LACKING.get(name, ())
            }
            yield name, asarray, functions
    for kernel in taken:
        sys.modules.pop(f"{kernel}_{name}", None)


@pytest.mark.sampled(7)
@pytest.mark.parametrize("function", [*PROGRAMS, *EXPRESSIONS])
def test_the_functions_are_those_of_the_python_kernel(library: Any, taken: Any, function: str) -> None:  # noqa: F811
    _, asarray, functions = library
    kernel = taken[function]
    if function not in functions:
        pytest.skip("PyTorch has no gamma function")

    def called(inputs: Any) -> list[np.ndarray]:
        with np.errstate(all="ignore"):
            found = functions[function](*map(asarray, inputs))
        return [np.asarray(part) for part in (found if isinstance(found, tuple) else (found,))]

    for kind in KINDS.values():
        rows = list(points(kernel.program, kind))
        batches = [np.stack(column) for column in zip(*rows, strict=True)]
        for got, expected in zip(called(batches), wanted(kernel, batches), strict=True):
            require_close(kernel.name, kind, rows, got, expected)
        for got, expected in zip(called(rows[0]), wanted(kernel, rows[0]), strict=True):
            assert (got.shape, got.dtype) == (expected.shape, expected.dtype)
            np.testing.assert_allclose(got, expected, rtol=1e-5)


def test_batches_broadcast_and_numbers_join_arrays(library: Any) -> None:
    _, asarray, functions = library
    unit, length = functions["unit_and_length"](asarray(np.ones((4, 1, 3), np.float32)))
    assert (tuple(unit.shape), tuple(length.shape), str(length.dtype).split(".")[-1]) == ((4, 1, 3), (4, 1), "float32")
    many = functions["new"](asarray(np.ones((4, 1))), 0.1, asarray(np.zeros(3)))
    np.testing.assert_allclose(np.asarray(many), np.full((4, 3), 0.8), rtol=1e-15)
    assert np.asarray(functions["ratio"](asarray(np.array([1, 3])), 2)).tolist() == [0.5, 1.5]


@pytest.mark.parametrize(("value", "error", "said"), [([1.0, 2.0], ValueError, r"v must have the core shape \(3,\)")])
def test_what_does_not_fit_is_said(library: Any, value: Any, error: type[Exception], said: str) -> None:
    _, asarray, functions = library
    with pytest.raises(error, match=said):
        functions["unit_and_length"](asarray(np.array(value)))
    with pytest.raises(ValueError, match=said):
        functions["unit_and_length"](1.0)
    with pytest.raises(TypeError, match="v must hold real numbers"):
        functions["unit_and_length"](asarray(np.ones(3, complex)))


def test_jax_traces_maps_and_differentiates(library: Any) -> None:
    name, asarray, functions = library
    if not hasattr(sys.modules[name], "jacfwd"):
        pytest.skip("of JAX alone")
    import jax

    turned, v = functions["turned"], asarray(np.array([3.0, 0.0, 4.0]))
    angles = asarray(np.array([0.3, -1.0]))
    np.testing.assert_array_equal(jax.jit(turned)(angles), jax.vmap(turned)(angles))
    slopes = jax.vmap(jax.jacfwd(lambda a: turned(a)[0, 1]))(angles)
    np.testing.assert_allclose(slopes, -np.cos(angles), rtol=1e-15)
    slopes = jax.jacrev(lambda v: functions["unit_and_length"](v)[0])(v)
    np.testing.assert_allclose(slopes, (np.eye(3) - np.outer(v, v) / 25) / 5, atol=1e-16)


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_torch_maps_and_differentiates(library: Any) -> None:
    name, asarray, functions = library
    if not hasattr(sys.modules[name], "autograd"):
        pytest.skip("of PyTorch alone")
    import torch

    turned, v = functions["turned"], asarray(np.array([3.0, 0.0, 4.0]))
    angles = asarray(np.array([0.3, -1.0]))
    np.testing.assert_array_equal(turned(angles), torch.func.vmap(turned)(angles))
    slopes = torch.func.vmap(torch.func.jacfwd(lambda a: turned(a)[0, 1]))(angles)
    np.testing.assert_allclose(slopes, -np.cos(angles), rtol=1e-15)
    slopes = torch.autograd.functional.jacobian(lambda v: functions["unit_and_length"](v)[0], v)
    np.testing.assert_allclose(slopes, (np.eye(3) - np.outer(v, v) / 25) / 5, atol=1e-16)
    half = torch.tensor([1.0], requires_grad=True)
    functions["ratio"](half, 2.0).sum().backward()
    assert half.grad.tolist() == [0.5]


@pytest.mark.parametrize("target", ["jax", "torch"])
def test_the_module_needs_nothing_of_ours(tmp_path: Any, target: str) -> None:
    [path] = chasles.compile(sp.sin(x) * y, [x, y]).write(tmp_path, target)
    assert path.name == f"expression_{target}.py"
    text = path.read_text()
    assert {line for line in text.splitlines() if line.startswith(("import ", "from "))} <= {
        "from __future__ import annotations",
        "from functools import reduce",
        "from typing import Any, NamedTuple",
        "import jax",
        "import jax.numpy as xp",
        "from jax.scipy import special",
        "import torch as xp",
    }
    if target in INSTALLED:
        code = "import sys, EXPRESSION as m; print(m.expression(0.0, 1.0)); sys.exit('chasles' in sys.modules)"
        subprocess.run([sys.executable, "-c", code.replace("EXPRESSION", path.stem)], cwd=path.parent, check=True)


@pytest.mark.parametrize("called", ["Batch", "prepared", "reduce", "jax"])
def test_a_name_that_the_module_needs_itself_is_refused(tmp_path: Any, called: str) -> None:
    with pytest.raises(LoweringError, match=f"target jax: a kernel may not be called {called}"):
        chasles.compile(x, [x], name=called).write(tmp_path, "jax")


def test_a_function_that_the_library_lacks_is_named(tmp_path: Any) -> None:
    kernel = chasles.compile(sp.gamma(x), [x])
    with pytest.raises(LoweringError, match="target torch: PyTorch has no function tgamma"):
        kernel.write(tmp_path, ("jax", "torch"))
    assert not list(tmp_path.iterdir())
