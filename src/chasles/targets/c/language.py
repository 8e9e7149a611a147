"""How is a program spelled in C? In double and in float, clear of every word that C, C++ and their headers use."""

from __future__ import annotations

from collections.abc import Mapping

from chasles.lowering.program import Op
from chasles.targets.constants import DOUBLE, SINGLE, Precision, literals
from chasles.targets.dialect import ARITHMETIC, CONDITIONAL, Dialect, Level, Phrase, call, circular, flat

_KEYWORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    alignas alignof asm atomic bool constexpr generic imaginary noreturn nullptr thread_local typeof typeof_unqual
    and and_eq bitand bitor catch class char8_t char16_t char32_t co_await co_return co_yield compl concept const_cast
    consteval constinit decltype delete dynamic_cast explicit export false friend mutable namespace new noexcept not
    not_eq operator or or_eq private protected public reinterpret_cast requires static_assert static_cast template
    this throw true try typeid typename using virtual wchar_t xor xor_eq
    linux unix far near interface small huge pascal cdecl fortran
"""
# What <math.h>, <complex.h>, <stddef.h>, <errno.h> and their kin name, as functions or as macros.
_LIBRARY = """
    acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh drem erf erfc exp exp2 exp10 expm1 fabs fdim
    finite floor fma fmax fmin fmod frexp gamma gamma_r hypot ilogb isinf isnan j0 j1 jn ldexp lgamma lgamma_r llrint
    llround log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter nexttoward pow pow10 remainder remquo
    rint round scalb scalbln scalbn significand sin sincos sinh sqrt tan tanh tgamma trunc y0 y1 yn
    cabs carg cimag conj cproj creal cexp clog cpow csqrt csin ccos ctan
    abs div index remove signal time tm size_t ptrdiff_t errno isfinite isnormal signbit fpclassify signgam
    complex I EOF NULL NAN INFINITY HUGE_VAL EDOM ERANGE DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS M_PI M_E assert
    min max main
"""
_FLOATS = " ".join(f"{word}f {word}l" for word in _LIBRARY.split() if word.islower())

RESERVED = frozenset(f"{_KEYWORDS} {_LIBRARY} {_FLOATS}".split())
"""Words that name no argument, result or temporary."""


def _dialect(precision: Precision) -> Dialect:
    def declare(name: str, text: str, truth: bool) -> str:
        return f"const {'int' if truth else precision.name} {name} = {text};"

    def function(name: str, operands: int) -> Phrase:
        return call(f"{name}{precision.suffix}", operands)

    spell = {**ARITHMETIC, **circular(function), Op.NOT_A_NUMBER: Phrase("NAN", Level.ATOM, ()), Op.SELECT: CONDITIONAL}
    return Dialect(spell, literals(precision), flat, declare, RESERVED, function=function)


DIALECTS: Mapping[Precision, Dialect] = {precision: _dialect(precision) for precision in (DOUBLE, SINGLE)}
