"""Trains that pass over the beam: results at their positions, and their envelope."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy as np

from . import _native
from ._combinations import refuse_other_than
from ._frames import frame
from ._solution import Array, Position, Positions, Solution, positions_of, refuse_outside

if TYPE_CHECKING:
    import pandas


class MovingBound(NamedTuple):
    """One bound of an envelope of trains: its values, with the position of the first axle and the index of the
    passage."""

    values: Array
    first_axle: Array
    passage: list[int]


class MovingEnvelope(NamedTuple):
    """The smallest and the largest values of a field over all positions of all trains."""

    min: MovingBound
    max: MovingBound


class Passage:
    """The passage of one train over the beam under the loads of one combination."""

    combination: Optional[str]
    """Name of the combination; ``None`` if all loads of the file act without a combination."""
    train: str
    """The name of the train."""
    range: Tuple[float, float]
    """First and last position of the first axle [m]."""
    without_equilibrium: list[Tuple[float, float]]
    """Ranges of the first axle's position without equilibrium [m]."""
    not_converged: list[float]
    """Positions of the first axle at which no result could be certified [m]."""

    def __init__(self, inner: _native.Answers, number: int) -> None:
        self._inner, self._number = inner, number
        combination, train, (start, end), none, failed = inner.passages()[number]
        self.combination, self.train, self.range = combination, train, (start, end)
        self.without_equilibrium = [(a, b) for a, b in none]
        self.not_converged = failed

    @property
    def positions(self) -> Array:
        """Positions of the first axle that have a solution, from left to right [m]."""
        return self._inner.positions(self._number)

    def nearest(self, first_axle: float) -> Tuple[float, Solution]:
        """The position of the first axle that has a solution and is nearest to ``first_axle``, and this solution."""
        if not math.isfinite(first_axle):
            raise ValueError(f"the position of the first axle is {first_axle}: give a finite number")
        found = self._inner.nearest(self._number, first_axle)
        if found is None:
            raise ValueError("there is no solution for any position of the train")
        at, solution = found
        return at, Solution(solution)

    def __repr__(self) -> str:
        under = f" under {self.combination!r}" if self.combination else ""
        return f"<groundbeam.Passage: {self.train!r}{under}, {len(self.positions)} positions solved>"


class Passages(Sequence[Passage]):
    """The passages of all trains, grouped by combination. Within a group, the passages are in the order of the trains."""

    _inner: _native.Answers
    _all: list[Passage]

    def __init__(self, native: _native.Answers) -> None:
        self._inner = native
        self._all = [Passage(native, number) for number in range(len(native.passages()))]

    @overload
    def __getitem__(self, number: int) -> Passage: ...
    @overload
    def __getitem__(self, number: slice) -> Sequence[Passage]: ...
    def __getitem__(self, number: Union[int, slice]) -> Union[Passage, Sequence[Passage]]:
        return self._all[number]

    def __len__(self) -> int:
        return len(self._all)

    @property
    def limit_states(self) -> list[str]:
        """The limit states of the solved combinations; empty if the combinations name no limit state."""
        return list(self._inner.limit_states())

    def envelope(
        self, field: str, x: Union[Position, Positions], limit_state: Optional[str] = None
    ) -> MovingEnvelope:
        """The envelope of a field at positions, over all combinations or those of a limit state. Where the field
        jumps, both sides count."""
        refuse_other_than(self.limit_states, limit_state)
        at = np.atleast_1d(positions_of(self._inner, x))
        refuse_outside(at, self._inner.length)
        found = self._inner.moving_envelope(field, at.ravel(), limit_state)
        if found is None:
            raise ValueError("there is no envelope, because no position of any train has a solution")
        low, high = (
            MovingBound(values.reshape(at.shape), axle.reshape(at.shape), passage)
            for values, axle, passage in found
        )
        return MovingEnvelope(low, high)

    def stations(self) -> Array:
        """Default positions on the beam for listing the envelope."""
        return self._inner.stations()

    def to_json(self) -> str:
        """The result document of ``groundbeam solve --json``."""
        return self._inner.to_json(None)

    def to_csv(self) -> str:
        """The envelope as a table."""
        return self._inner.to_csv(None)

    def to_svg(self) -> str:
        """A picture of the train at the position of the largest moment, and of the envelopes."""
        return self._inner.to_svg()

    def to_png(self) -> bytes:
        """The picture as PNG."""
        return self._inner.to_png()

    def to_pandas(self) -> pandas.DataFrame:
        """The table of ``to_csv`` as a data frame."""
        return frame(self.to_csv())

    def __str__(self) -> str:
        return self._inner.report()

    def __repr__(self) -> str:
        return f"<groundbeam.Passages: {len(self)}>"
