"""Which kernels `chasles.kernels` hands out: the compiled ones where they load, else or when told the NumPy ones."""

from __future__ import annotations

import sys
import types
from collections.abc import Callable
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import find_spec, module_from_spec

import pytest

Chooser = Callable[[str], types.ModuleType]


def module(name: str, **members: object) -> types.ModuleType:
    made = types.ModuleType(name)
    made.__spec__ = ModuleSpec(name, None)
    vars(made).update(members)
    return made


@pytest.fixture
def choose(monkeypatch: pytest.MonkeyPatch) -> Chooser:
    """A fresh chasles.kernels under a value of CHASLES_BACKEND, over stand-ins for both sets of kernels."""
    for name in ("chasles.generated", "chasles.generated.numpy"):
        monkeypatch.setitem(sys.modules, name, module(name))
    written_out = module("chasles.generated.numpy.kernels", __all__=["twist"], twist="numpy", np="an import")
    monkeypatch.setitem(sys.modules, written_out.__name__, written_out)
    monkeypatch.setitem(sys.modules, "chasles._kernels", module("chasles._kernels", twist="c"))

    def chosen(backend: str) -> types.ModuleType:
        monkeypatch.setenv("CHASLES_BACKEND", backend)
        spec = find_spec("chasles.kernels")
        assert spec is not None
        assert spec.loader is not None
        kernels = module_from_spec(spec)
        spec.loader.exec_module(kernels)
        return kernels

    return chosen


@pytest.mark.parametrize(("wanted", "got"), [("", "c"), ("c", "c"), ("numpy", "numpy")])
def test_backend_is_the_compiled_one_unless_told_otherwise(choose: Chooser, wanted: str, got: str) -> None:
    kernels = choose(wanted)
    assert (kernels.backend, kernels.twist) == (got, got)


def test_backend_without_compiled_kernels(choose: Chooser, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "chasles._kernels", None)
    assert (choose("").backend, choose("").twist) == ("numpy", "numpy")
    with pytest.raises(ImportError, match=r"no C compiler or no Python\.h at installation"):
        choose("c")


def test_backend_whose_compiled_kernels_do_not_load(choose: Chooser, monkeypatch: pytest.MonkeyPatch) -> None:
    class Broken(MetaPathFinder, Loader):
        def find_spec(self, name: str, *_: object) -> ModuleSpec | None:
            return ModuleSpec(name, self) if name == "chasles._kernels" else None

        def exec_module(self, module: types.ModuleType) -> None:
            raise ImportError("undefined symbol: sincos")

    monkeypatch.delitem(sys.modules, "chasles._kernels")
    monkeypatch.setattr(sys, "meta_path", [Broken(), *sys.meta_path])
    with pytest.warns(RuntimeWarning, match="undefined symbol: sincos"):
        assert choose("").backend == "numpy"
    with pytest.raises(ImportError, match="undefined symbol: sincos"):
        choose("c")
    assert choose("numpy").backend == "numpy"


def test_backend_nobody_knows(choose: Chooser) -> None:
    with pytest.raises(ImportError, match="CHASLES_BACKEND is 'fortran'; expected 'c', 'numpy' or nothing"):
        choose("fortran")


def test_kernel_nobody_knows(choose: Chooser) -> None:
    kernels = choose("numpy")
    assert dir(kernels) == ["array_api", "backend", "instructions", "one", "twist"]
    for name in ("np", "twits", "_private"):
        with pytest.raises(AttributeError, match=f"has no kernel '{name}'"):
            getattr(kernels, name)
