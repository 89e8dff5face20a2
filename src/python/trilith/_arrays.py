"""Numbers in and out: NumPy arrays where NumPy is there, lists where it is not."""

from __future__ import annotations

from typing import Any


def array(numbers: Any, width: int = 0) -> Any:
    """Nested lists as a NumPy array where NumPy is there, as they are where it is not.

    With a ``width``, an empty list becomes an array of no rows and as many columns.
    """
    try:
        import numpy
    except ImportError:
        return numbers
    made = numpy.array(numbers)
    return made.reshape(-1, width) if width and made.size == 0 else made


def plain(value: Any) -> Any:
    """A value with every array, NumPy number and tuple in it as Python's own lists and numbers."""
    if isinstance(value, dict):
        return {str(key): plain(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    if hasattr(value, "tolist"):
        return value.tolist()
    return value
