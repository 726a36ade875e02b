"""Exceptions that are raised if a model is invalid or cannot be solved."""

from __future__ import annotations

from typing import Iterable, NamedTuple, Sequence, Tuple


class Diagnostic(NamedTuple):
    """One fault of a model."""

    code: str
    """A fixed code such as ``GB015``; docs/diagnostics.md lists all of them."""
    message: str
    """The fault, in one sentence."""
    hint: str
    """The remedy; may be empty."""
    line: int
    """Line number in the model's text, counted from 1."""
    column: int
    """Column number in the line, counted in characters from 1."""


class GroundbeamError(Exception):
    """Base class of ``ModelError``, ``NoEquilibrium`` and ``NotConverged``."""


class ModelError(GroundbeamError, ValueError):
    """The model is invalid. Its text shows every fault at its location in the model file.

    For a model that was built in code, the model file is ``Model.to_toml()``.
    """

    diagnostics: list[Diagnostic]
    """All faults, in the order of the text; never empty."""

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
        """Remedy of the first fault."""
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
    """There is no equilibrium. The motion proves it.

    The motion varies linearly between hinges, from ``left`` at x = 0 to ``right`` at x = l. It is zero or negative
    (upward) everywhere, so no part of the beam moves into the ground. The loads do positive ``work``.
    """

    sentence: str
    """The reason, as a sentence."""
    left: float
    """Value r(0) of the motion r at the left end of the beam: 0 (no displacement) or -1 (upward)."""
    right: float
    """Value r(l) of the motion r at the right end of the beam: 0 (no displacement) or -1 (upward)."""
    work: float
    """F(r), the work of the loads in the motion r [N m per m of lift]."""
    static_reactions: Tuple[float, ...]
    """Static reactions [N]: forces of supports under both ends and under each free hinge between them, for a rigid
    beam on these supports only."""
    hinges: Tuple[float, ...]
    """Displacement of each hinge in the motion r that proves that there is no equilibrium."""

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
    """The method did not reach its tolerance, so no result could be certified."""

    method: str
    """The method."""
    iterations: int
    """Number of steps."""
    tolerance: float
    """Requested relative tolerance."""
    reached: float
    """Achieved relative tolerance."""
    what: str
    """Description of the quantity that exceeds its tolerance."""

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
