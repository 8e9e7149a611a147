"""Kernels for every array library of the array API. Made by `chasles emit`; not to be edited by hand."""
