"""NUMBERS: kernels against 50-digit evaluations of the statements they come from. Nothing here decides what is true."""

from chasles.numerics.reference import NoValue, Singular, evaluate
from chasles.numerics.request import Input, Output, Request, request_of
from chasles.numerics.request_of_inverse import request_of_inverse
from chasles.numerics.sampling import STRATEGIES, Unsatisfiable, draw
from chasles.numerics.verify import Evidence, Finding, verify, verify_all

__all__ = [
    "STRATEGIES",
    "Evidence",
    "Finding",
    "Input",
    "NoValue",
    "Output",
    "Request",
    "Singular",
    "Unsatisfiable",
    "draw",
    "evaluate",
    "request_of",
    "request_of_inverse",
    "verify",
    "verify_all",
]
