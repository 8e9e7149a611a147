"""Emitted kernels, one folder a language. Made by `chasles emit`; not to be edited by hand."""
