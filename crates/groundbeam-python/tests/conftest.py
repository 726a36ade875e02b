"""Fixtures of the tests."""

from __future__ import annotations

from pathlib import Path

import groundbeam as gb
import pytest

REPOSITORY = Path(__file__).resolve().parents[3]


@pytest.fixture
def footing() -> gb.Model:
    """The footing of the README; its right end lifts off."""
    return gb.Model(
        gb.Beam.uniform(12.0, 1.28e9),
        gb.Foundation.pasternak(40e6, 9e6),
        loads=[gb.Load.point(900e3, 1.5), gb.Load.uniform(10e3, 0.0, 12.0)],
    )
