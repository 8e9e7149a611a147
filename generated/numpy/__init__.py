# SPDX-License-Identifier: BSD-3-Clause
# Emitted by chasles 0.2.0.
"""Kernels for every array library of the array API. Made by `chasles emit`; not to be edited by hand."""
