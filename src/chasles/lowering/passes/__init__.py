"""Passes: each turns a program into an equal one."""
