"""Why a kernel is not made."""

__all__ = ["LoweringError"]


class LoweringError(ValueError):
    """A statement that no program is made of; the message says which, why, and what to do."""
