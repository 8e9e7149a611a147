# SPDX-License-Identifier: BSD-3-Clause
# Emitted by chasles 0.2.0.
"""Emitted kernels, one folder a language. Made by `chasles emit`; not to be edited by hand."""
