"""What does a user get? A kernel: a ufunc where it was compiled, else its NumPy text, and all that is known of it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import cached_property
from inspect import cleandoc
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy

from chasles.compiling.packing import packing_of
from chasles.compiling.recall import Sources, recalled
from chasles.compiling.shared_objects import compiled, sources_of_program
from chasles.display import Displayed
from chasles.kernels.signatures import signature_of_call
from chasles.lowering.program import Op, Program

if TYPE_CHECKING:
    from chasles.bounds.box import BoxBound

MANY_SINGLES = 2**20
"""So many numbers of single precision in a kernel's results are worth a compiler's time."""
_SILENT = numpy.errstate(all="ignore")
"""Nothing is warned of that is computed for a piece that is not taken."""


class CompiledKernel(Displayed):
    """A function of arrays: core axes come last, batch axes before them broadcast; float32 stays float32.

    The first million results in float32 are rounded from double; then single precision is compiled, too.

    Attributes:
        name: what it is called.
        signature: its core shapes, as NumPy writes them.
        backend: "c" or "numpy".
        inputs: what goes in, by name: how many numbers, and which variables they are.
        ufunc: the `numpy.ufunc` of the "c" backend, else None; it takes the scalars of more than 32 operands, and gives
            results of as many, in one array.
        one: the same for one element or a C-contiguous batch of one shape, all of one precision, for a fraction of a
            call's time, as in `chasles.kernels.one`; the kernel itself of the "numpy" backend.
        program: the straight-line program of which all texts are made.
        pattern: the rows and columns of what is not zero by construction, of each Jacobian and Hessian, by name.
        operations: how often each operation occurs, by its name.
        c_source: C99 functions of one item, in both precisions, to be used anywhere.
        numpy_source: the same as a Python function of arrays.
        array_api: that function, for arrays of every library of the array API, which may trace and differentiate it.
    """

    def __init__(
        self, program: Program, sources: Sources, ufunc: Any, one: Any, written: Callable[..., Any], levels: str
    ) -> None:
        self.name = program.name
        self.signature = sources.signature
        self.backend = "numpy" if ufunc is None else "c"
        self.program = program
        counts = program.operations
        self.operations = {op.value: counts[op] for op in Op if counts[op]}
        self.c_source = sources.c
        self.numpy_source = sources.numpy
        self.array_api = written
        self.__doc__ = written.__doc__
        self._levels, self._singles = levels, 0
        self._take(ufunc, one)
        self.inputs = {argument.name: argument.meaning for argument in program.arguments}
        patterns = ((each.name, each.pattern) for each in program.results if each.pattern is not None)
        self.pattern = {name: tuple(numpy.array(places, dtype=int).reshape(-1, 2).T) for name, places in patterns}
        self._names = tuple(self.inputs)
        self.__signature__ = signature_of_call(self._function, self._names, by_name=True)

    def _take(self, ufunc: Any, one: Any) -> None:
        """Call these, or the NumPy text where there are none."""
        packing = packing_of(self.program) if ufunc is not None else None
        called, alone = (ufunc, one) if packing is None else map(packing.around, (ufunc, one))
        self.ufunc = ufunc
        self._function: Callable[..., Any] = _SILENT(self.array_api) if ufunc is None else called
        self.one: Callable[..., Any] = alone or self._function

    def __call__(self, *inputs: Any, **options: Any) -> Any:
        """The results for the inputs, in their order or by name; a tuple where there are several.

        Raises ValueError for masked arrays, TypeError where inputs are missing or come twice.
        """
        if len(inputs) != len(self._names):
            inputs = self._in_order(inputs, options)
        found = self._function(*inputs, **options)
        first = found[0] if type(found) is tuple else found
        is_plain = type(first) is numpy.ndarray or not isinstance(first, numpy.ndarray)
        if not is_plain and isinstance(first, numpy.ma.MaskedArray):
            # NumPy gives a result the mask of an input, whose shape is another. It loads these when they are named.
            raise ValueError(f"{self.name}: an input is a masked array: hand over its numbers, as .filled(nan)")
        if self._singles < MANY_SINGLES and self.ufunc is not None and first.dtype == numpy.float32:
            self._count_singles(first.size)
        return found

    def _count_singles(self, many: int) -> None:
        """Once there are many, single precision is compiled, too; until then it is computed in double and rounded."""
        self._singles += many
        if self._singles >= MANY_SINGLES:
            ufunc, one = compiled(
                self.program, *sources_of_program(self.program, narrowed=False), self.__doc__ or "", self._levels
            )
            self._take(ufunc or self.ufunc, one or self.one)

    def _in_order(self, inputs: tuple[Any, ...], options: dict[str, Any]) -> tuple[Any, ...]:
        """The inputs with those that are among the options, by their names."""
        wanted = self._names[len(inputs) :]
        missing = [name for name in wanted if name not in options]
        if missing or not wanted:
            said = f"without {', '.join(missing)}" if missing else f"with {len(inputs)} inputs"
            raise TypeError(f"{self.name} is called {said}: it takes {', '.join(self._names)}")
        return (*inputs, *(options.pop(name) for name in wanted))

    def error_bound(self, box: Mapping[str, Any], dtype: Any = numpy.float64) -> BoxBound:
        """How far rounding takes the results from the exact values of the expressions, proved for all floats of a box.

        Args:
            box: for each argument, by name, a number or a pair (low, high); the ends of an array's entries are numbers
                or arrays of its core shape.
            dtype: float64 or float32.

        Returns:
            for each result its `absolute` errors, entry by entry, and `units`: the largest of them in roundoffs of the
            largest entry. The rounding model is that of `chasles.bounds`: correctly rounded operations, in any of
            which a product may be contracted with a sum, sine and cosine within 0.8 units in the last place.

        Raises:
            ValueError: for a box that does not fit; where the box holds a singularity, with the place.
            ModuleNotFoundError: where expressions with sines or arctangents are to be bounded without python-flint.
        """
        from chasles.bounds.box import bound_of_program

        return bound_of_program(self.program, box, dtype, in_numpy=self.backend == "numpy")

    def write(
        self,
        folder: str | PathLike[str],
        targets: str | Iterable[str] = ("c",),
        *,
        box: Mapping[str, Any] | None = None,
        license: str = "BSD-3-Clause",
    ) -> tuple[Path, ...]:
        """The files below the folder that hold the kernel in other languages and need nothing of this package.

        Args:
            folder: where each target gets a folder of its own; it is made where it is missing.
            targets: names of languages: "c" for C99, "cpp" for C++20, "rust" for a crate, "cuda", "jax", "torch".
            box: inputs as for `error_bound`, whose bounds in both precisions are then in the heads of the files.
            license: the SPDX identifier in the first line of each file.

        Raises:
            ValueError: for a target that there is not or that cannot spell the kernel, and as `error_bound` does.
            OSError: where a file cannot be written; then none is.
        """
        from chasles.bounds.box import bound_of_program
        from chasles.compiling.sources import target_kernel
        from chasles.compiling.written import written
        from chasles.targets.c.functions import precisions_of

        kernel = target_kernel(self.program)
        if box is not None:
            precisions = (numpy.float64, numpy.float32)[: len(precisions_of(kernel))]
            bounds = tuple(bound_of_program(self.program, box, precision) for precision in precisions)
            kernel = replace(kernel, box_bounds=bounds)
        return written(kernel, Path(folder), targets, license)

    def __repr__(self) -> str:
        return f"<chasles kernel {self.name} {self.signature}, {self.backend}>"

    def __reduce__(self) -> tuple[Callable[[Program], CompiledKernel], tuple[Program]]:
        return kernel_of, (self.program,)


def kernel_of(program: Program, levels: str = "own") -> CompiledKernel:
    """The kernel of a program: compiled, from the cache where that has it; the NumPy text where nothing compiles.

    The `levels` are those of `chasles.compile`. A compiler that fails is warned of. Raises `LoweringError` where no
    target can spell the program.
    """
    return _kernel(program, *sources_of_program(program), levels)


def kernel_for(key: str, make: Callable[[], Program], levels: str = "own") -> CompiledKernel:
    """The kernel of a program that is made now, or was made before for this key; as `kernel_of` does it."""
    files: dict[str, str] = {}

    def made() -> tuple[Program, Sources]:
        program = make()
        sources, texts = sources_of_program(program)
        files.update(texts)
        return program, sources

    return _kernel(*recalled(key, made), files, levels)


def _kernel(program: Program, sources: Sources, files: dict[str, str], levels: str) -> CompiledKernel:
    written = _WrittenOut(program.name, sources.numpy)
    ufunc, one = compiled(program, sources, files, written.__doc__ or "", levels)
    return CompiledKernel(program, sources, ufunc, one, written, levels)


class _WrittenOut:
    """The function that a NumPy text defines, which is read when it is first called."""

    def __init__(self, name: str, text: str) -> None:
        self.__name__ = name
        # The first text within triple quotes is the module's; to parse a long program takes longer than to start it.
        self.__doc__ = cleandoc(text.split('"""')[3]) if text.count('"""') > 3 else ""
        self._text = text

    @cached_property
    def _function(self) -> Callable[..., Any]:
        names: dict[str, Any] = {"__name__": f"{__name__}.{self.__name__}"}
        exec(compile(self._text, f"<chasles.compile: {self.__name__}>", "exec"), names)
        function: Callable[..., Any] = names[self.__name__]
        return function

    def __call__(self, *inputs: Any, **options: Any) -> Any:
        return self._function(*inputs, **options)
