"""Exceptions for solves without a result."""

from __future__ import annotations

from typing import Iterable, NamedTuple, Sequence, Tuple


class Diagnostic(NamedTuple):
    """One thing that is wrong with a model."""

    code: str
    """A fixed code, ``GB015``: docs/diagnostics.md lists all of them."""
    message: str
    """What is wrong, in one sentence."""
    hint: str
    """What would be right; may be empty."""
    line: int
    """Line of the model's text, from 1."""
    column: int
    """Column in characters, from 1."""


class GroundbeamError(Exception):
    """Why there is no answer: the base of the three below."""


class ModelError(GroundbeamError, ValueError):
    """The model is wrong. Printed, it shows every fault where it stands in the model's text.

    For a model that was built in code that text is ``Model.to_toml()`` of what was given.
    """

    diagnostics: list[Diagnostic]
    """Everything that is wrong, in the order of the text; never empty."""

    def __init__(
        self, shown: str, diagnostics: Iterable[Tuple[str, str, str, int, int]]
    ) -> None:
        self.diagnostics = [Diagnostic(*each) for each in diagnostics]
        super().__init__(shown, self.diagnostics)

    def __str__(self) -> str:
        return str(self.args[0])

    @property
    def code(self) -> str:
        """Code of the first fault."""
        return self.diagnostics[0].code

    @property
    def hint(self) -> str:
        """What would be right instead of the first fault."""
        return self.diagnostics[0].hint

    @property
    def line(self) -> int:
        """Line of the first fault."""
        return self.diagnostics[0].line

    @property
    def column(self) -> int:
        """Column of the first fault."""
        return self.diagnostics[0].column


class NoEquilibrium(GroundbeamError):
    """The loads tip or lift the beam: there is no equilibrium, and this is the motion that proves it.

    The motion goes from ``left`` at x = 0 to ``right`` at x = l, straight but for hinges, zero or negative (upward) everywhere, so that it
    presses nowhere on the ground; the loads do ``work`` in it that nothing resists.
    """

    sentence: str
    """Why, in words."""
    left: float
    """r(0): 0 or -1."""
    right: float
    """r(l): 0 or -1."""
    work: float
    """F(r), the work of the loads [N m per m of lift]."""
    static_reactions: Tuple[float, ...]
    """What supports under both ends, and under each free hinge between them, would carry if the beam were rigid and
    stood on them alone [N]."""
    hinges: Tuple[float, ...]
    """r at the hinges, where the motion may have corners."""

    def __init__(
        self,
        sentence: str,
        left: float,
        right: float,
        work: float,
        static_reactions: Sequence[float],
        hinges: Sequence[float],
    ) -> None:
        super().__init__(sentence, left, right, work, static_reactions, hinges)
        self.sentence = sentence
        self.left = left
        self.right = right
        self.work = work
        self.static_reactions = tuple(static_reactions)
        self.hinges = tuple(hinges)

    def __str__(self) -> str:
        return self.sentence


class NotConverged(GroundbeamError):
    """The method did not reach its own tolerance, so that no answer could be certified."""

    method: str
    """The method."""
    iterations: int
    """Steps taken."""
    tolerance: float
    """What was asked for, relative."""
    reached: float
    """What was reached, relative."""
    what: str
    """What was not reached, in words."""

    def __init__(
        self, shown: str, method: str, iterations: int, tolerance: float, reached: float, what: str
    ) -> None:
        super().__init__(shown, method, iterations, tolerance, reached, what)
        self.method = method
        self.iterations = iterations
        self.tolerance = tolerance
        self.reached = reached
        self.what = what

    def __str__(self) -> str:
        return str(self.args[0])
