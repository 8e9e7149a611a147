"""Does a program compute what it should? Programs are read as fractions in what goes in, and compared exactly.

`differences` holds a program against a request, `equivalent` against another program.
"""

from chasles.lowering.equivalence.programs import equivalent
from chasles.lowering.equivalence.requests import differences

__all__ = ["differences", "equivalent"]
