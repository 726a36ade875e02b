"""Number of threads of a call."""

from __future__ import annotations

from typing import Optional


def number_of(threads: Optional[int]) -> int:
    """The requested number; 0 if not given, which lets the compiled extension choose."""
    if threads is None:
        return 0
    if threads < 1:
        raise ValueError("at least one thread is needed")
    return threads
