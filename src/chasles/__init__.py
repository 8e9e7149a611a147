"""A textbook chapter on rigid-body kinematics, statics and dynamics as checked code and fast kernels.

``chasles.prove`` decides an equation of your own; ``chasles.decide``, ``chasles.repair`` and ``chasles.derive`` ask the
book, ``chasles.chapter``, by number; ``chasles.load`` reads another one, ``chasles.solve`` works an exercise,
``chasles.practice`` draws new data for one and grades answers, ``chasles.kernels`` holds the compiled formulas,
``chasles.checked`` the same with their inputs tested, and ``chasles.compile`` makes a kernel of an expression of your
own; ``chasles.read`` decides the equations of a page in LaTeX; ``chasles.kernel`` says what is known of one of the
book's. Each is imported on first use, so that ``import chasles`` costs neither SymPy nor NumPy. In a notebook each
thing is displayed as the report shows it.
"""

from __future__ import annotations

from importlib import import_module
from sys import modules
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from chasles import checked as checked
    from chasles import kernels as kernels
    from chasles.asking import decide as decide
    from chasles.asking import derive as derive
    from chasles.asking import repair as repair
    from chasles.compiling import compile as compile
    from chasles.emitted import kernel as kernel
    from chasles.exercises.practice import practice as practice
    from chasles.exercises.solving import solve as solve
    from chasles.pages.page import read as read
    from chasles.prove import prove as prove
    from chasles.statements import Chapter
    from chasles.statements import load as load

    chapter: Chapter

__version__ = "0.2.0"
__all__ = [
    "__version__", "chapter", "checked", "compile", "decide", "derive", "kernel", "kernels", "load", "practice",
    "prove", "read", "repair", "solve",
]  # fmt: skip

# Name -> the module that holds what has that name.
_HELD = {
    **dict.fromkeys(("decide", "repair", "derive", "chapter"), "chasles.asking"),
    "prove": "chasles.prove",
    "load": "chasles.statements",
    "practice": "chasles.exercises.practice",
    "solve": "chasles.exercises.solving",
    "read": "chasles.pages.page",
    "compile": "chasles.compiling",
    "kernel": "chasles.emitted",
}
_PACKAGES = ("checked", "kernels")


class _Package(ModuleType):
    def __setattr__(self, name: str, value: object) -> None:
        # Importing a submodule binds it here under its own name, which would hide the function of the same name.
        if not (name in _HELD and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


modules[__name__].__class__ = _Package
# The modules whose functions say how a thing is displayed: `html`, `latex`, `text`; and `as_theorem` for Coq.
displayed_by = f"{__name__}.report.notebook", f"{__name__}.coq.identities"


def __getattr__(name: str) -> object:
    if name in _PACKAGES:
        return import_module(f"{__name__}.{name}")
    if name not in _HELD:
        raise AttributeError(f"module 'chasles' has no attribute {name!r}; it offers {', '.join(__all__)}")
    found = getattr(import_module(_HELD[name]), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted(__all__)
