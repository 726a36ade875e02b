"""One model solved by every method."""

from __future__ import annotations

from typing import Iterator, Mapping, NamedTuple, Optional, Union

from . import _native
from ._errors import ModelError, NoEquilibrium, NotConverged
from ._solution import Solution


class MethodErrors(NamedTuple):
    """How far an answer is from the exact one: the largest difference along the beam over the largest value."""

    deflection: float
    moment: float
    settlement: float
    end_forces: float
    """The larger difference of both end forces, over the resultant of the loads."""


class MethodAnswer(NamedTuple):
    """The answer of one method."""

    answer: Union[Solution, NoEquilibrium, NotConverged, ModelError]
    """The solution, or the exception that ``solve`` would raise."""
    errors: Optional[MethodErrors]
    """None without a solution."""
    seconds: float
    """How long it took [s]."""


class Comparison(Mapping[str, MethodAnswer]):
    """The answers of all methods by name, ``exact`` first."""

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
        """The document, as ``groundbeam compare --json`` prints it."""
        return self._inner.to_json(None)

    def __str__(self) -> str:
        return self._inner.report()

    def __repr__(self) -> str:
        return f"<groundbeam.Comparison: {', '.join(self)}>"
