"""Estimates ground parameters from measured settlements: bounded least squares with exact derivatives."""

from __future__ import annotations

from typing import Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._errors import NoEquilibrium, NotConverged
from ._model import Model
from ._solution import FIELDS, Array, Position, Positions, Solution, positions_of, refuse_outside

Measured = Mapping[str, Union[float, Tuple[Union[Position, Positions], Union[float, Sequence[float], Array]]]]
"""Fields with positions and values, as ``{"settlement": (x, values)}``; other outputs with one value."""

_STEPS = 200
"""Maximum number of solves."""
_SMALL = 1e-10
"""Step size below which the iteration ends."""
_FLAT = 1e-14
"""Expected relative decrease of the sum of squares below which rounding error dominates and the iteration ends."""
_FIRST_DAMPING, _HIGHEST_DAMPING = 1e-3, 1e12
_FARTHEST = 2.0
"""Longest step, in logarithms."""
_VAGUE = 1.0
"""A linear combination of the logarithms of the unknowns counts as identified only if its inverse standard error exceeds
this value."""


class Calibration(NamedTuple):
    """Result of a calibration."""

    values: dict[str, float]
    """Values of the unknowns."""
    standard_errors: dict[str, float]
    """Standard error of each unknown due to the measurement noise. NaN for an unknown at one of its bounds, and for all
    unknowns if the noise cannot be estimated."""
    correlation: Array
    """Correlation matrix of the errors of the unknowns; NaN for unknowns at bounds."""
    residuals: dict[str, Array]
    """Measured values minus computed values, for each output."""
    noise: float
    """Standard deviation of the residuals after each residual is divided by its given noise. If no noise is given, the
    residuals are not divided."""
    singular_values: Array
    """Inverse standard errors of linear combinations of the logarithms of the unknowns, the largest first."""
    directions: Array
    """The linear combinations to which ``singular_values`` belong: one row of coefficients for each singular value, with
    one coefficient for each unknown."""
    unidentified: list[str]
    """Descriptions of the linear combinations of logarithms of the unknowns whose standard error is at least 1, a factor
    of e (2.718) in the unknowns."""
    at_bound: list[str]
    """Unknowns at a bound."""
    one_sided: bool
    """Whether a computed value has only one-sided derivatives with respect to an unknown at the solution. The standard errors
    neglect this."""
    steps: int
    """Number of solves."""
    solution: Solution
    """The solution of the model with the estimated values."""


class _Problem:
    """The residuals and their derivatives with respect to the scaled unknowns."""

    def __init__(
        self,
        model: Model,
        measured: Measured,
        unknown: Sequence[str],
        noise: Union[None, float, Mapping[str, float]],
        combination: Optional[str],
    ) -> None:
        if isinstance(unknown, str):
            raise ValueError(f"`unknown` must be a list of names, as in [{unknown!r}]")
        self.model, self.unknown, self.combination = model, list(unknown), combination
        if not self.unknown or len(set(self.unknown)) != len(self.unknown):
            raise ValueError("`unknown` must contain the names of one or more parameters, and each name only once")
        self.outputs: list[Tuple[str, float, str]] = []
        self.names: list[str] = list(measured)
        self.shapes: list[int] = []
        values: list[Array] = []
        sizes: list[Array] = []
        if noise is None and len(measured) > 1:
            raise ValueError("several kinds of measurements need `noise` for their weights")
        if isinstance(noise, Mapping):
            for name in [*measured, *noise]:
                if name not in noise:
                    raise ValueError(f"noise of `{name}`: give its standard deviation")
                if name not in measured:
                    raise ValueError(f"noise of `{name}`: nothing of this name was measured")
        for name, given in measured.items():
            at: Optional[Array] = None
            if name in FIELDS:
                if not isinstance(given, tuple):
                    raise ValueError(f"measured `{name}`: give positions and values as a tuple, (x, values)")
                at = np.atleast_1d(positions_of(model._inner, given[0])).ravel()
                try:
                    refuse_outside(at, model.length, beside=name == "settlement")
                except ValueError as error:
                    raise ValueError(f"measured `{name}`: {error}") from None
                value = np.atleast_1d(np.asarray(given[1], dtype=np.float64)).ravel()
                if at.shape != value.shape:
                    raise ValueError(f"measured `{name}`: there are {at.size} positions but {value.size} values")
            else:
                if isinstance(given, tuple):
                    raise ValueError(f"measured `{name}`: give one value")
                value = np.array([float(given)])
            own = noise[name] if isinstance(noise, Mapping) else noise
            size = 1.0 if own is None else float(own)
            if not size > 0.0 or not np.isfinite(size):
                raise ValueError(f"noise of `{name}`: give a positive standard deviation")
            if not np.isfinite(value).all():
                raise ValueError(f"measured `{name}`: a value is not a number")
            self.outputs += [(name, float(x), "right") for x in ([0.0] if at is None else at)]
            self.shapes.append(value.size)
            values.append(value)
            sizes.append(np.full(value.size, size))
        if not values:
            raise ValueError("nothing was measured")
        self.measured, self.noise = np.concatenate(values), np.concatenate(sizes)
        self.noise_given = noise is not None
        if self.measured.size < len(self.unknown):
            raise ValueError(
                f"{self.measured.size} measurements cannot determine {len(self.unknown)} unknowns"
            )

    def at(self, values: Array) -> Tuple[Array, Array, Solution, bool]:
        """Weighted residuals, their derivatives with respect to the unknowns, the solution, and whether these
        are one-sided."""
        numbers = [(name, float(value)) for name, value in zip(self.unknown, values)]
        solution = Solution(self.model._inner.solve_with(numbers, self.combination))
        found, slopes, one_sided = solution._inner.gradients(self.outputs, self.unknown)
        residual = (found - self.measured) / self.noise
        jacobian = slopes.reshape(found.size, -1) / self.noise[:, None]
        return residual, jacobian, solution, any(one_sided)


def _is_positive(name: str) -> bool:
    word = name.split("[")[0].split(".")[0]
    return word in ("k", "mu", "EI", "hinge") or word.endswith("_factor") or "spring" in name


def calibrate(
    model: Model,
    measured: Measured,
    unknown: Sequence[str],
    *,
    noise: Union[None, float, Mapping[str, float]] = None,
    bounds: Optional[Mapping[str, Tuple[float, float]]] = None,
    start: Optional[Mapping[str, float]] = None,
    combination: Optional[str] = None,
) -> Calibration:
    """Finds parameters of a model that fit measurements, by least squares.

    ``measured`` has fields with positions and values, ``{"settlement": ([1.0, 3.0], [0.004, 0.003])}``, and single
    outputs such as ``"end_force.left"``; ``unknown`` has names of parameters, as in ``Solution.gradient``: ``k``, ``mu``,
    ``EI``, ``k[0]`` of a segment, factors, loads. ``noise`` is the standard deviation of the measurements, one for
    all, or a dictionary with one for each key of ``measured``. By default it is estimated from the residuals, for
    measurements of one kind. ``bounds`` limit unknowns. ``start``
    gives starting values; by default they are those of the model. Positive unknowns are transformed to logarithms.
    All are in SI units. A model with combinations or trains needs ``combination``, the loads during the measurement.

    The result has the values, their standard errors, and descriptions of combinations that the measurements do not
    determine (docs/derivatives.md#calibration).
    """
    if combination is None:
        model._refuse_more_than_one_answer("calibrate")
    problem = _Problem(model, measured, unknown, noise, combination)
    for what in (bounds or {}), (start or {}):
        for name in what:
            if name not in problem.unknown:
                raise ValueError(f"`{name}` is not one of the unknowns {', '.join(problem.unknown)}")
    scale = _Scale(problem, bounds or {}, start or {})
    return _judged(problem, scale, _least(problem, scale))


class _Scale:
    """Transformation of the unknowns: positive unknowns become logarithms, others are divided by their own scale."""

    def __init__(
        self,
        problem: _Problem,
        bounds: Mapping[str, Tuple[float, float]],
        start: Mapping[str, float],
    ) -> None:
        names, model = problem.unknown, problem.model
        own = [model._inner.number(name, problem.combination) for name in names]
        first = np.array([start.get(name, value) for name, value in zip(names, own)], dtype=np.float64)
        limits = np.array([bounds.get(name, (-np.inf, np.inf)) for name in names], dtype=np.float64)
        self.positive = np.array([_is_positive(name) for name in names])
        self.lowest, self.highest = limits[:, 0], limits[:, 1]
        for name, value, lowest, highest, positive in zip(
            names, first, self.lowest, self.highest, self.positive
        ):
            if not lowest < highest or not lowest <= value <= highest:
                raise ValueError(
                    f"the starting value of `{name}`, {value:g}, is not between {lowest:g} and {highest:g}"
                )
            if positive and not value > 0.0:
                raise ValueError(f"the starting value of `{name}` is {value:g}: give a positive start")
        width = self.highest - self.lowest
        size = np.where(first != 0.0, np.abs(first), 1.0)
        self.unit = np.where(np.isfinite(width), width, size)
        self.low, self.high = self.scaled(self.lowest), self.scaled(self.highest)
        self.first = np.clip(self.scaled(first), self.low, self.high)

    def scaled(self, values: Array) -> Array:
        with np.errstate(divide="ignore"):
            logarithms = np.log(np.maximum(values, 0.0))
        return np.where(self.positive, logarithms, values / self.unit)

    def values(self, theta: Array) -> Array:
        logarithms = np.where(self.positive, theta, 0.0)
        values = np.where(self.positive, np.exp(logarithms), theta * self.unit)
        # An unknown at a bound has exactly the bound's value.
        values = np.where(theta <= self.low, self.lowest, values)
        return np.asarray(np.where(theta >= self.high, self.highest, values))

    def slopes(self, theta: Array) -> Array:
        """d value/d theta."""
        return np.where(self.positive, self.values(theta), self.unit)


class _Least(NamedTuple):
    """The least-squares problem: transformed unknowns, and the last evaluation of the residuals."""

    theta: Array
    residual: Array
    jacobian: Array
    solution: Solution
    one_sided: bool
    steps: int


def _least(problem: _Problem, scale: _Scale) -> _Least:
    """Levenberg–Marquardt method, with steps cut off at the bounds."""

    def look(theta: Array, steps: int) -> _Least:
        residual, jacobian, solution, one_sided = problem.at(scale.values(theta))
        return _Least(theta, residual, jacobian * scale.slopes(theta), solution, one_sided, steps)

    best, damping = look(scale.first, 1), _FIRST_DAMPING
    for steps in range(2, _STEPS + 1):
        step = _step(best, scale, damping)
        trial = np.clip(best.theta + step, scale.low, scale.high)
        moved = trial - best.theta
        was = best.residual @ best.residual
        expected = was - ((best.residual + best.jacobian @ moved) ** 2).sum()
        if np.abs(moved).max() <= _SMALL or expected <= _FLAT * was:
            break
        try:
            found = look(trial, steps)
        except (NoEquilibrium, NotConverged):
            damping *= 10.0
            continue
        now = found.residual @ found.residual
        if now >= was:
            damping *= 10.0
            if damping > _HIGHEST_DAMPING:
                break
            continue
        damping = damping / 10.0 if was - now > 0.25 * expected else damping * 2.0
        best = found
    return best._replace(steps=steps)


def _step(best: _Least, scale: _Scale, damping: float) -> Array:
    """Damped least-squares step of the unknowns that are not held at a bound."""
    downhill = -best.jacobian.T @ best.residual
    low, high = best.theta <= scale.low, best.theta >= scale.high
    free = ~((low & (downhill < 0.0)) | (high & (downhill > 0.0)))
    step = np.zeros(best.theta.size)
    own = best.jacobian[:, free]
    if not own.any():
        return step
    squares = (own**2).sum(axis=0)
    weights = np.sqrt(damping * np.maximum(squares, _SMALL * squares.max()))
    system = np.vstack([own, np.diag(weights)])
    aim = np.concatenate([-best.residual, np.zeros(weights.size)])
    step[free] = np.linalg.lstsq(system, aim, rcond=None)[0]
    return np.asarray(step * min(1.0, _FARTHEST / max(float(np.abs(step).max()), _SMALL)))


def _judged(problem: _Problem, scale: _Scale, best: _Least) -> Calibration:
    """The calibration with its statistics."""
    names, count = problem.unknown, len(problem.unknown)
    values = scale.values(best.theta)
    bound = (best.theta <= scale.low) | (best.theta >= scale.high)
    free = np.flatnonzero(~bound)
    over = best.residual.size - free.size
    noise = float(np.sqrt(best.residual @ best.residual / over)) if over > 0 else float("nan")
    # A given noise replaces the estimate of the noise.
    size = 1.0 if problem.noise_given else noise
    _, singular, directions = np.linalg.svd(best.jacobian[:, free], full_matrices=False)
    with np.errstate(divide="ignore", invalid="ignore"):
        known = singular / size
        spread = directions.T / known
        errors = np.sqrt((spread**2).sum(axis=1))
        correlations = spread @ spread.T / np.outer(errors, errors)
    whole = np.full(count, np.nan)
    whole[free] = errors * scale.slopes(best.theta)[free]
    correlation = np.full((count, count), np.nan)
    correlation[np.ix_(free, free)] = correlations
    rows = np.zeros((singular.size, count))
    rows[:, free] = directions
    vague = [row for row, known in zip(rows, known) if not known > _VAGUE]
    split = np.split(-best.residual * problem.noise, np.cumsum(problem.shapes)[:-1])
    return Calibration(
        {name: float(value) for name, value in zip(names, values)},
        {name: float(error) for name, error in zip(names, whole)},
        correlation,
        dict(zip(problem.names, split)),
        noise,
        known,
        rows,
        [_in_words(names, row) for row in vague],
        [name for name, stops in zip(names, bound) if stops],
        best.one_sided,
        best.steps,
        best.solution,
    )


def _in_words(names: Sequence[str], row: Array) -> str:
    """Text for a linear combination of the unknowns. It omits unknowns whose coefficient is less than a fifth of the
    largest one."""
    largest = row[np.argmax(np.abs(row))]
    parts = [
        (name, "up" if share * largest > 0.0 else "down")
        for name, share in zip(names, row)
        if abs(share) >= 0.2 * abs(largest)
    ]
    return parts[0][0] if len(parts) == 1 else " with ".join(" ".join(part) for part in parts)
