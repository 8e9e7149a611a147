"""NUMBERS: kernels against 50-digit evaluations of the statements they come from. Nothing here decides what is true."""

from chasles.numerics.reference import MissingValue, Singular, evaluate
from chasles.numerics.sampling import STRATEGIES, Unsatisfiable, draw
from chasles.numerics.specification import ExpectedOutput, KernelInput, Specification, specification_of
from chasles.numerics.specification_of_inverse import specification_of_inverse
from chasles.numerics.verify import Evidence, Finding, verify

__all__ = [
    "STRATEGIES",
    "Evidence",
    "ExpectedOutput",
    "Finding",
    "KernelInput",
    "MissingValue",
    "Singular",
    "Specification",
    "Unsatisfiable",
    "draw",
    "evaluate",
    "specification_of",
    "specification_of_inverse",
    "verify",
]
