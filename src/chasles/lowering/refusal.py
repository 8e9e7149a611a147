"""Why a kernel is not made."""


class LoweringError(ValueError):
    """A statement that no program is made of; the message says which, why, and what to do."""
