"""The results for all combinations of a model, and their envelope."""

from __future__ import annotations

from typing import TYPE_CHECKING, Iterator, Mapping, NamedTuple, Optional, Union

import numpy as np

from . import _native
from ._errors import NoEquilibrium, NotConverged
from ._frames import frame
from ._solution import Array, Position, Positions, Solution, positions_of, refuse_outside

if TYPE_CHECKING:
    import pandas

Answer = Union[Solution, NoEquilibrium, NotConverged]
"""Result for one combination."""


class Bound(NamedTuple):
    """One bound of an envelope: its values, and the names of the governing combinations."""

    values: Array
    governs: list[str]


class Envelope(NamedTuple):
    """The smallest and the largest values of a field over all combinations."""

    min: Bound
    max: Bound


class Banded(NamedTuple):
    """A value for the best estimates of k and mu, and its smallest and largest value over all pairs of k and mu that
    ``[foundation.band]`` gives."""

    best: float
    low: float
    high: float


class Band(NamedTuple):
    """The smallest and the largest value of a field, each with its range over all pairs of k and mu that
    ``[foundation.band]`` gives."""

    min: Banded
    max: Banded


def refuse_other_than(known: list[str], limit_state: Optional[str]) -> None:
    """Raises an error for a limit state without a solved combination."""
    if limit_state is not None and limit_state not in known:
        names = ", ".join(known) or "none"
        raise ValueError(f"no solved combination belongs to {limit_state}; solved limit states: {names}")


class Combinations(Mapping[str, Answer]):
    """Results of all combinations by name; a combination without a solution has the exception that ``solve``
    would raise."""

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
        """The solved combinations."""
        return {name: each for name, each in self.items() if isinstance(each, Solution)}

    @property
    def load_cases(self) -> dict[str, bool]:
        """Load cases, and whether each one alone has an equilibrium."""
        return dict(self._inner.load_cases())

    @property
    def limit_states(self) -> list[str]:
        """The limit states of the solved combinations; empty if the combinations name no limit state."""
        return list(self._inner.limit_states())

    def envelope(
        self, field: str, x: Union[Position, Positions], limit_state: Optional[str] = None
    ) -> Envelope:
        """The envelope of a field at positions, over all combinations or those of a limit state. Where the field
        jumps, both sides count."""
        refuse_other_than(self.limit_states, limit_state)
        at = np.atleast_1d(positions_of(self._inner, x))
        if not self.solutions:
            raise ValueError("no combination has an equilibrium: there is no envelope")
        names = list(self.solutions)
        refuse_outside(at, self._inner.length)
        bounds = self._inner.envelope(field, at.ravel(), limit_state)
        low, high = (
            Bound(values.reshape(at.shape), [names[i] for i in by]) for values, by in bounds
        )
        return Envelope(low, high)

    def band(self, field: str) -> Band:
        """The smallest and the largest value of a field over all combinations, for the best estimates of k and mu, with
        their ranges over all pairs of k and mu that ``[foundation.band]`` gives. Nothing is proven for values of k and
        mu between the solved ones."""
        found = self._inner.band(field)
        if found is None:
            raise ValueError(
                "the model has no [foundation.band], or no combination was solved with the best estimates of k and mu"
            )
        low, high = found
        return Band(Banded(*low), Banded(*high))

    def stations(self) -> Array:
        """Default positions for listing the envelope, including those where the governing combination
        changes."""
        return self._inner.stations()

    def to_json(self) -> str:
        """The result document of ``groundbeam solve --json``."""
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

