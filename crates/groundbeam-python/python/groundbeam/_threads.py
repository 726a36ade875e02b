"""How many threads a call uses."""

from __future__ import annotations

from typing import Optional


def number_of(threads: Optional[int]) -> int:
    """The number that was asked for; 0 leaves it to the compiled half."""
    if threads is None:
        return 0
    if threads < 1:
        raise ValueError("it takes at least one thread")
    return threads
