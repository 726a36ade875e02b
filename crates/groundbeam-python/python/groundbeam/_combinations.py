"""The answers to all combinations of a model, and their envelope."""

from __future__ import annotations

from typing import TYPE_CHECKING, Iterator, Mapping, NamedTuple, Optional, Union

import numpy as np

from . import _native
from ._errors import NoEquilibrium, NotConverged
from ._frames import frame
from ._solution import Array, Position, Positions, Solution, positions_of

if TYPE_CHECKING:
    import pandas

Answer = Union[Solution, NoEquilibrium, NotConverged]
"""What came out for one combination."""


class Bound(NamedTuple):
    """One line of an envelope: its values, and the names of the combinations that govern."""

    values: Array
    governs: list[str]


class Envelope(NamedTuple):
    """The smallest and the largest values of a field over all combinations."""

    min: Bound
    max: Bound


class Banded(NamedTuple):
    """A number on the best ground, and the smallest and the largest on all grounds of a band that were solved."""

    best: float
    low: float
    high: float


class Band(NamedTuple):
    """The smallest and the largest value of a field, each with its band over the grounds."""

    min: Banded
    max: Banded


class Combinations(Mapping[str, Answer]):
    """The answer to each combination by its name; those that failed are there as what ``solve`` would raise."""

    _inner: _native.Answers
    _answers: dict[str, Answer]

    def __init__(self, native: _native.Answers) -> None:
        self._inner = native
        self._answers = {
            name: Solution(answer) if isinstance(answer, _native.Solution) else answer
            for name, answer in native.answers()
        }

    def __getitem__(self, name: str) -> Answer:
        return self._answers[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._answers)

    def __len__(self) -> int:
        return len(self._answers)

    @property
    def solutions(self) -> dict[str, Solution]:
        """Those that were solved."""
        return {name: each for name, each in self.items() if isinstance(each, Solution)}

    @property
    def load_cases(self) -> dict[str, bool]:
        """Every load case, and whether it could stand by itself."""
        return dict(self._inner.load_cases())

    @property
    def limit_states(self) -> list[str]:
        """The limit states of the solved combinations; empty if they name none."""
        return list(self._inner.limit_states())

    def envelope(
        self, field: str, x: Union[Position, Positions], limit_state: Optional[str] = None
    ) -> Envelope:
        """The envelope of a field at positions, of all combinations or of those of a limit state; where it jumps, both
        sides count."""
        if limit_state is not None and limit_state not in self.limit_states:
            known = ", ".join(self.limit_states) or "none"
            raise ValueError(f"no solved combination is of {limit_state}; the limit states: {known}")
        at = np.atleast_1d(positions_of(None, x))
        if not self.solutions:
            raise ValueError("no combination has an equilibrium: there is no envelope")
        names = list(self.solutions)
        length = self.solutions[names[0]].length
        if not ((at >= 0.0) & (at <= length)).all():
            raise ValueError(f"a position lies off the beam, which goes from 0 to {length:g}")
        bounds = self._inner.envelope(field, at.ravel(), limit_state)
        low, high = (
            Bound(values.reshape(at.shape), [names[i] for i in by]) for values, by in bounds
        )
        return Envelope(low, high)

    def band(self, field: str) -> Band:
        """The smallest and the largest value of a field over all combinations on one ground, with their bands over all
        grounds. Nothing is proven of grounds between those that were solved."""
        found = self._inner.band(field)
        if found is None:
            raise ValueError("the model has no band of grounds, or nothing was solved on the best ground")
        low, high = found
        return Band(Banded(*low), Banded(*high))

    def stations(self) -> Array:
        """Positions at which the envelope is worth listing, the changes of what governs among them."""
        return self._inner.stations()

    def to_json(self) -> str:
        """The document, as ``groundbeam solve --json`` prints it."""
        return self._inner.to_json(None)

    def to_csv(self) -> str:
        """The envelope as a table."""
        return self._inner.to_csv(None)

    def to_svg(self) -> str:
        """A picture of the envelope."""
        return self._inner.to_svg()

    def to_pandas(self) -> pandas.DataFrame:
        """The table of ``to_csv`` as a data frame."""
        return frame(self.to_csv())

    def __str__(self) -> str:
        return self._inner.report()

    def __repr__(self) -> str:
        return f"<groundbeam.Combinations: {len(self.solutions)} of {len(self)} solved>"

