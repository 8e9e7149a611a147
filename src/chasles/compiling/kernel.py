"""What does a user get? A kernel: a ufunc where it was compiled, else its NumPy text, and all that is known of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import wraps
from hashlib import sha256
from typing import Any
from warnings import warn

import numpy

from chasles import kernels
from chasles.bounds import BoxBound
from chasles.compiling.bound import error_bound
from chasles.compiling.compiler import Compiler, CompilerFailed, found
from chasles.compiling.sources import Sources, sources_of
from chasles.compiling.store import loaded
from chasles.display import Displayed
from chasles.kernels.chapter import functions_of
from chasles.kernels.signatures import signature_of_call
from chasles.lowering.program import Op, Program
from chasles.targets.kernel import Heading, TargetKernel, signature

__all__ = ["CompiledKernel", "kernel_of"]


class CompiledKernel(Displayed):
    """A function of arrays: core axes come last, batch axes before them broadcast; float32 stays float32.

    Attributes:
        name: what it is called.
        signature: its core shapes, as NumPy writes them.
        backend: "c" or "numpy".
        ufunc: the `numpy.ufunc` of the "c" backend, else None.
        one: the same for one element or a C-contiguous batch of one shape, all of one precision, for a fraction of a
            call's time, as in `chasles.kernels.one`; the kernel itself of the "numpy" backend.
        program: the straight-line program of which all texts are made.
        operations: how often each operation occurs, by its name.
        c_source: C99 functions of one item, in both precisions, to be used anywhere.
        numpy_source: the same as a Python function of arrays.
        array_api: that function, for arrays of every library of the array API, which may trace and differentiate it.
    """

    def __init__(self, program: Program, sources: Sources, ufunc: Any, one: Any, written: Callable[..., Any]) -> None:
        self.name = program.name
        self.signature = signature(program)
        self.backend = "numpy" if ufunc is None else "c"
        self.ufunc = ufunc
        self.program = program
        counts = program.operations
        self.operations = {op.value: counts[op] for op in Op if counts[op]}
        self.c_source = sources.c
        self.numpy_source = sources.numpy
        self.array_api = written
        self.__doc__ = written.__doc__
        self._function: Callable[..., Any] = _undisturbed(written) if ufunc is None else ufunc
        self.one: Callable[..., Any] = one or self._function
        self.__signature__ = signature_of_call(self._function, (argument.name for argument in program.arguments))

    def __call__(self, *inputs: Any, **options: Any) -> Any:
        """The results for the inputs; a tuple where there are several. Raises ValueError for masked arrays."""
        found = self._function(*inputs, **options)
        if isinstance(found[0] if type(found) is tuple else found, numpy.ma.MaskedArray):
            # NumPy gives a result the mask of an input, whose shape is another.
            raise ValueError(f"{self.name}: an input is a masked array: hand over its numbers, as .filled(nan)")
        return found

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
        return error_bound(self.program, box, dtype)

    def __repr__(self) -> str:
        return f"<chasles kernel {self.name} {self.signature}, {self.backend}>"

    def __reduce__(self) -> tuple[Callable[[Program], CompiledKernel], tuple[Program]]:
        return kernel_of, (self.program,)


def kernel_of(program: Program) -> CompiledKernel:
    """The kernel of a program: compiled, from the cache where that has it; the NumPy text where nothing compiles.

    A compiler that fails is warned of. Raises `LoweringError` where no target can spell the program.
    """
    digest = sha256(repr(program).encode()).hexdigest()
    heading = Heading("Expression", "given to chasles.compile.", "nothing is claimed", (), digest, section="expression")
    sources = sources_of(TargetKernel(program, heading))
    written = _written_out(program, sources)
    ufunc, one = _compiled(program, sources, written.__doc__ or "")
    return CompiledKernel(program, sources, ufunc, one, written)


def _compiled(program: Program, sources: Sources, doc: str) -> tuple[Any, Any]:
    """The ufunc of the compiled program and its light function; None where nothing compiles or nothing makes these."""
    compiler = found(kernels.instructions) if kernels.make_ufunc is not None else None
    if compiler is None:
        return None, None
    try:
        library = loaded(_key(sources, compiler), lambda folder: compiler.shared_object(sources.files, folder))
    except (CompilerFailed, OSError) as error:
        warn(f"{program.name} runs as NumPy kernel: it could not be compiled: {error}", RuntimeWarning, stacklevel=4)
        return None, None
    names = ([item.name for item in items] for items in (program.arguments, program.results))
    return functions_of(library, 0, program.name, doc, signature(program), *names)


def _key(sources: Sources, compiler: Compiler) -> str:
    return sha256(repr((compiler.key(sources.files), sorted(sources.files.items()))).encode()).hexdigest()


def _written_out(program: Program, sources: Sources) -> Callable[..., Any]:
    """The function that the NumPy text defines."""
    names: dict[str, Any] = {"__name__": f"{__name__}.{program.name}"}
    exec(compile(sources.numpy, f"<chasles.compile: {program.name}>", "exec"), names)
    function: Callable[..., Any] = names[program.name]
    return function


def _undisturbed(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function without warnings of what is computed for a piece that is not taken."""

    @wraps(function)
    def called(*inputs: Any, **options: Any) -> Any:
        with numpy.errstate(all="ignore"):
            return function(*inputs, **options)

    return called
