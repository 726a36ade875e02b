"""Runs the tutorial and compares its output. ``UPDATE_EXPECTED=1`` rewrites the output."""

from __future__ import annotations

import contextlib
import doctest
import io
import os
import re
from pathlib import Path

import groundbeam
import pytest
from conftest import REPOSITORY

TUTORIAL = REPOSITORY / "docs" / "python.md"
# A block of code, followed by its output if it has one.
BLOCK = re.compile(r"```python\n(.*?)```\n(?:```text\n(.*?)```\n)?", re.DOTALL)


def test_the_tutorial_prints_its_listed_output(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = TUTORIAL.read_text()
    names: dict[str, object] = {}
    monkeypatch.chdir(tmp_path)
    for file in (REPOSITORY / "docs").glob("*.toml"):
        (tmp_path / file.name).write_text(file.read_text())

    def ran(block: re.Match[str]) -> str:
        code = block[1]
        printed = io.StringIO()
        line = text.count("\n", 0, block.start(1))
        with contextlib.redirect_stdout(printed):
            exec(compile("\n" * line + code, str(TUTORIAL), "exec"), names)
        # The duration differs in each run.
        shown = re.sub(r"(Method .* steps), .*", r"\1, …", printed.getvalue())
        return f"```python\n{code}```\n" + (f"```text\n{shown}```\n" if shown else "")

    made = BLOCK.sub(ran, text)
    if "UPDATE_EXPECTED" in os.environ:
        TUTORIAL.write_text(made)
    assert len(BLOCK.findall(text)) > 8
    assert made == TUTORIAL.read_text()


def test_the_examples_in_the_docstring_of_the_package_are_correct() -> None:
    assert doctest.testmod(groundbeam) == doctest.TestResults(failed=0, attempted=5)
