"""BOUNDS: how far rounding can take a program's results from its exact values, proved for all inputs of a domain.

Compared are the computed result and what the program's formula gives for the same inputs without any rounding; where
the kernel's hypotheses hold, that is the value of its statement. A unit u is the roundoff: 2^-53 for double precision,
2^-24 for single precision.

The rounding model: additions, subtractions, multiplications, divisions and square roots are correctly rounded to
nearest; sine and cosine are what rounding makes of something within 0.3 units in the last place of their exact value,
so that they are within 0.8 units, the arctangent of something within half a unit; they are exact at zero; a product may
be contracted with the sum that follows it; no step overflows or underflows; operations come in the program's order.

A vector counts as a unit vector if its length is within 2^-21 of 1, a matrix as a rotation if its entries are within
2^-21 of those of one. Where a program compares rounded values and takes one case or another, its result is compared
with the formula of the case that it takes. The condition of a divisor is the sum of the sizes of its terms over its own
size. Where the result is not a number, as at a singular point, nothing is said.
"""
