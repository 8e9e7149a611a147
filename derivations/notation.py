"""Every symbol once: name, letter, meaning and dimension, before any equation uses it.

Conventions: a rotation Q is active and multiplies columns from the left; a twist has the angular velocity on top, a
wrench the moment; angles are in radians; arrays are in SI units. A trailing underscore stands for the book's prime.
"""
