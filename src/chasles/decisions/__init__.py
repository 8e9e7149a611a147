"""Decisions on all statements of a chapter, kept, recalled and checked again."""
