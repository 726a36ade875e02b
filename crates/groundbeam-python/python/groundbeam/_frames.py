"""Converts tables to pandas data frames."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING, Union

if TYPE_CHECKING:
    import pandas


def frame(table: str) -> pandas.DataFrame:
    """Data frame of a table with a header. Numbers keep all digits; other cells remain text."""
    import pandas

    head, *rows = csv.reader(io.StringIO(table))
    columns = zip(*rows) if rows else [()] * len(head)
    return pandas.DataFrame({name: _column(each) for name, each in zip(head, columns)})


def _column(cells: tuple[str, ...]) -> Union[list[float], list[str]]:
    try:
        return [float(cell) for cell in cells]
    except ValueError:
        return list(cells)
