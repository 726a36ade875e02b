"""Number of threads of a call."""

from __future__ import annotations

from typing import Optional


def number_of(threads: Optional[int]) -> int:
    """The requested number of threads; 0 without a request, and the compiled extension then chooses the number."""
    if threads is None:
        return 0
    if threads < 1:
        raise ValueError("at least one thread is needed")
    return threads
