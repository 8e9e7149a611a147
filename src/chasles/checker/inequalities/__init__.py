"""Claims that something is not negative, or positive, checked."""
