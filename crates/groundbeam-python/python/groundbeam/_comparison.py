"""The results of all methods for one model, with their errors relative to the exact method."""

from __future__ import annotations

from typing import Iterator, Mapping, NamedTuple, Optional, Union

from . import _native
from ._errors import ModelError, NoEquilibrium, NotConverged
from ._solution import Solution


class MethodErrors(NamedTuple):
    """Errors relative to the exact method: the largest difference along the beam, relative to the largest
    value."""

    deflection: float
    moment: float
    settlement: float
    end_forces: float
    """The larger of the errors of the two end forces, relative to the resultant."""


class MethodAnswer(NamedTuple):
    """The result of one method."""

    answer: Union[Solution, NoEquilibrium, NotConverged, ModelError]
    """The solution, or the exception that ``solve`` would raise."""
    errors: Optional[MethodErrors]
    """The errors relative to the exact method; ``None`` without a solution."""
    seconds: float
    """Duration [s]."""


class Comparison(Mapping[str, MethodAnswer]):
    """The results of all methods by name, ``exact`` first."""

    def __init__(self, native: _native.Answers) -> None:
        self._inner = native
        self._answers = {
            name: MethodAnswer(
                Solution(answer) if isinstance(answer, _native.Solution) else answer,
                None if errors is None else MethodErrors(*errors),
                seconds,
            )
            for name, answer, errors, seconds in native.methods()
        }

    def __getitem__(self, name: str) -> MethodAnswer:
        return self._answers[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._answers)

    def __len__(self) -> int:
        return len(self._answers)

    def to_json(self) -> str:
        """The document of ``groundbeam compare --json``."""
        return self._inner.to_json(None)

    def __str__(self) -> str:
        return self._inner.report()

    def __repr__(self) -> str:
        return f"<groundbeam.Comparison: {', '.join(self)}>"
