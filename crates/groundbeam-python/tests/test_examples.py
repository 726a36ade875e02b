"""Tests that each Python example prints the same as its Rust counterpart."""

from __future__ import annotations

import subprocess
import sys

import pytest
from conftest import REPOSITORY

RUST = REPOSITORY / "crates" / "groundbeam" / "examples"
NAMES = sorted(path.stem for path in RUST.glob("*.rs"))


def test_the_list_of_examples_is_not_empty() -> None:
    assert "footing" in NAMES


@pytest.mark.parametrize("name", NAMES)
def test_python_and_rust_examples_print_the_same(name: str) -> None:
    twin = REPOSITORY / "crates" / "groundbeam-python" / "examples" / f"{name}.py"
    done = subprocess.run([sys.executable, str(twin)], capture_output=True, text=True, check=True)
    assert done.stdout == (RUST / f"{name}.expected").read_text()
