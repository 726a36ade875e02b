"""Solves many models at once on all processors, from arrays of parameters to arrays of results."""

from __future__ import annotations

import sys
import time
from typing import TYPE_CHECKING, Any, Callable, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _native
from ._along import Along
from ._model import Model
from ._solution import FIELDS, Array, Positions, positions_of, refuse_outside
from ._threads import number_of

if TYPE_CHECKING:
    import pandas

STATUSES = np.array(["solved", "no-equilibrium", "not-converged", "wrong"])
"""Names of the statuses, indexed by the status codes of the compiled extension."""

Progress = Union[None, bool, Callable[[int, int], object]]

Parameters = Union[Mapping[str, Union[npt.ArrayLike, Along]], "pandas.DataFrame"]
"""Parameter names, each with one number for all models, one number for each model, or values along the beam."""


class Extremes(NamedTuple):
    """The smallest and the largest value of a field for each model, with their positions."""

    min_x: Array
    min: Array
    max_x: Array
    max: Array


class Batch(Mapping[str, Array]):
    """The results for many models, in the order of the models: ``batch["moment"]`` is an array with
    one row for each model and one column for each position.

    A model without a result has NaN for numbers; ``status`` and ``messages`` give the reason.
    """

    at: Array
    """The positions at which the fields are evaluated [m]."""
    status: npt.NDArray[np.str_]
    """Status of each model: ``solved``, ``no-equilibrium``, ``not-converged`` or ``wrong``."""
    messages: list[Optional[str]]
    """Message for each model without a result; ``None`` for each model with a result."""
    end_forces: Array
    """Point contact forces under the left and the right end [N]: an array with one row for each model and two columns."""
    lifted_share: Array
    """Fraction of the beam length that is not in contact."""
    relative_gap: Array
    """The error bound of the certificate, relative to the strain energy."""
    motion: Array
    """Motion r of the beam that proves that a model has no equilibrium: an array with one row for each model. Its columns
    are the values r(0) and r(l) at the ends, and the work of the loads."""
    extremes: dict[str, Extremes]
    """Extremes of the requested fields."""
    gradients: dict[str, Array]
    """Derivatives of the requested outputs: one row for each model and one column for each parameter. For fields, the
    indices are those of model, position and parameter. NaN for an output that a model does not have."""
    one_sided: dict[str, npt.NDArray[np.bool_]]
    """Whether derivatives of an output hold for small changes in one direction only, for each model; for fields, for
    each model and position."""

    def __init__(
        self,
        table: dict[str, Any],
        at: Array,
        fields: Sequence[str],
        extremes: Sequence[str],
        gradients: Sequence[str],
    ) -> None:
        count = len(table["status"])
        self.at = at
        self.status = STATUSES[table["status"]]
        self.messages = table["messages"]
        self.end_forces = np.stack([table["left"], table["right"]], axis=1)
        self.lifted_share = table["lifted_share"]
        self.relative_gap = table["relative_gap"]
        motions = [table[f"motion_{part}"] for part in ("left", "right", "work")]
        self.motion = np.stack(motions, axis=1)
        self.extremes = {
            name: Extremes(*(table[f"{name}_{part}"] for part in Extremes._fields))
            for name in extremes
        }
        self._fields: dict[str, Array] = {name: table[name].reshape(count, len(at)) for name in fields}
        wide = [len(at) if name in FIELDS else 1 for name in gradients]
        one_sided = table["one_sided"].reshape(count, sum(wide))
        number = table["gradients"].size // max(one_sided.size, 1)
        derivatives = table["gradients"].reshape(count, sum(wide), number)
        self.gradients, self.one_sided = {}, {}
        for name, width, end in zip(gradients, wide, np.cumsum(wide)):
            own = slice(end - width, end) if name in FIELDS else end - 1
            self.gradients[name], self.one_sided[name] = derivatives[:, own], one_sided[:, own]
        self._starts = table["contact_starts"]
        self._edges = table["contact_edges"].reshape(-1, 2)

    def __getitem__(self, field: str) -> Array:
        return self._fields[field]

    def __iter__(self) -> Any:
        return iter(self._fields)

    def __len__(self) -> int:
        return len(self._fields)

    @property
    def count(self) -> int:
        """Number of models."""
        return len(self.status)

    @property
    def solved(self) -> npt.NDArray[np.bool_]:
        """For each model, whether it has a result."""
        return np.asarray(self.status == "solved", dtype=np.bool_)

    def contact(self, number: int) -> list[tuple[float, float]]:
        """Contact zones of one model."""
        if not -self.count <= number < self.count:
            raise IndexError(f"there are {self.count} models")
        number %= self.count
        regions = self._edges[self._starts[number] : self._starts[number + 1]]
        return [(float(start), float(end)) for start, end in regions]

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame with one row for each model: status, end forces, lifted share, error bound, and extremes."""
        import pandas

        columns: dict[str, Any] = {
            "status": self.status,
            "left": self.end_forces[:, 0],
            "right": self.end_forces[:, 1],
            "lifted_share": self.lifted_share,
            "relative_gap": self.relative_gap,
        }
        for name, extremes in self.extremes.items():
            columns |= {f"{name}_{part}": each for part, each in extremes._asdict().items()}
        return pandas.DataFrame(columns)

    def __repr__(self) -> str:
        return f"<groundbeam.Batch: {int(self.solved.sum())} of {self.count} solved>"


def solve_many(
    models: Union[Model, Sequence[Model]],
    parameters: Optional[Parameters] = None,
    *,
    at: Union[Positions, float] = (),
    fields: Union[str, Sequence[str]] = ("deflection", "moment", "pressure"),
    extremes: Union[str, Sequence[str]] = (),
    gradients: Union[str, Sequence[str]] = (),
    with_respect_to: Sequence[str] = (),
    method: str = "exact",
    elements: int = 100,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Batch:
    """Solves a list of models, or one model with many sets of parameters, in compiled code.

    A parameter is one number for all models, or an array with one number for each. Columns of a pandas table are
    such arrays. All are in SI units:

    * ``k``, ``mu``, ``EI``, ``GA``, ``axial_force``;
    * ``k_factor``, ``mu_factor``, ``EI_factor``, ``GA_factor`` and ``load_factor``, which multiply the values of
      the model;
    * loads, numbered from 0: ``load[0]`` (its size), ``load[0].at``, and for distributed loads ``load[0].from``,
      ``.to``, ``.start`` and ``.end``;
    * segments: ``k[0]``, ``mu_factor[1]`` and so on; the rest outside the segments: ``k[]``;
    * ``support[0].settlement``, ``.spring`` and ``.rotational_spring``, ``hinge[0]``, ``gap[0]``.

    ``k``, ``mu`` and ``EI`` may also vary along the beam. The values of a row then have a shape.
    ``Points(values)`` are values at equidistant points, linear between them; ``Steps(values)`` are values on equal
    stretches; ``ControlValues(values)`` are the control values of one curve, as in ``Foundation(k=[...])``.
    ``values`` is one row for all models, or an array of models by values. An array of models by two values needs
    no shape: it varies linearly from end to end. A row of three or more values without a shape raises
    ``ValueError``.

    ``at`` are the positions of ``fields`` on the beam; a model with a shorter beam has NaN beyond its end.
    ``extremes`` names the fields whose smallest and largest values are computed with their positions.
    ``gradients`` names the outputs whose derivatives are computed, as in ``Solution.gradient``, and
    ``with_respect_to`` the parameters; fields are derived at the positions ``at``. ``threads``
    defaults to the number of processors; the results have the same bits with any number. A model that fails does
    not stop the others. ``progress=True`` draws a bar; a function is called with the number of finished models and
    the total number.
    """
    several = [models] if isinstance(models, Model) else list(models)
    given = {} if parameters is None else {str(name): each for name, each in parameters.items()}
    fields, extremes, gradients = _names(fields), _names(extremes), _names(gradients)
    if isinstance(with_respect_to, str):
        raise ValueError(f"with_respect_to: give a list of names, as in [{with_respect_to!r}]")
    if bool(gradients) != bool(len(with_respect_to)):
        raise ValueError("gradients and with_respect_to: give both of them, or leave both out")
    rows = {name: _rows(name, values) for name, values in given.items()}
    counts = {} if isinstance(models, Model) else {"models": len(several)}
    counts |= {name: len(values) for name, values in rows.items() if len(values) != 1}
    count = next(iter(counts.values()), 1)
    if any(each != count for each in counts.values()):
        listed = ", ".join(f"{name}: {each}" for name, each in counts.items())
        raise ValueError(f"models and parameters differ in length: {listed}")
    for model in several:
        model._refuse_more_than_one_answer(None)
    # Positions given as text are read once for each system of units of the models.
    read = [positions_of(model._inner, at) for model in {each.units: each for each in several}.values()]
    positions = np.ascontiguousarray(np.atleast_1d(read[0] if read else np.asarray(at, dtype=np.float64)))
    if positions.ndim != 1:
        raise ValueError("positions are one list")
    beside = not (set(fields) | set(gradients) & set(FIELDS)) - {"settlement"}
    length = max((model.length for model in several), default=0.0)
    refuse_outside(positions, length, beside)
    if not several:
        count = 0
    table = _native.solve_many(
        [model._inner for model in several],
        count,
        [(name, _shape(given[name]), values) for name, values in rows.items()],
        positions,
        fields,
        extremes,
        [
            (name, x, "right")
            for name in gradients
            for x in (positions.tolist() if name in FIELDS else [0.0])
        ],
        list(with_respect_to),
        method,
        elements,
        number_of(threads),
        _Bar() if progress is True else progress or None,
    )
    return Batch(table, positions, fields, extremes, gradients)


def _names(names: Union[str, Sequence[str]]) -> list[str]:
    """Converts a list of names or a single name to a list of names."""
    return [names] if isinstance(names, str) else list(names)


def _shape(values: Union[npt.ArrayLike, Along]) -> Optional[str]:
    """Name of the class that says how the values vary along the beam; ``None`` for plain values."""
    return type(values).__name__ if isinstance(values, Along) else None


def _rows(name: str, values: Union[npt.ArrayLike, Along]) -> Array:
    """Values of a parameter, with one row for each model or one row for all models."""
    if isinstance(values, Along):
        return np.ascontiguousarray(values.values)
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"parameter `{name}`: takes numbers in SI units ({error})") from None
    if array.ndim > 2:
        raise ValueError(
            f"parameter `{name}`: give one number for each model, or one row of values along the beam for each model"
        )
    array = array.reshape(-1, 1) if array.ndim < 2 else array
    return np.ascontiguousarray(array)


class _Bar:
    """A progress bar on standard error for work that takes more than a second."""

    WIDTH = 40

    def __init__(self) -> None:
        self.began = time.monotonic()
        self.drawn = False

    def __call__(self, done: int, count: int) -> None:
        took = time.monotonic() - self.began
        if done < count and took < 1.0:
            return
        if done == count and not self.drawn:
            return
        self.drawn = True
        filled = self.WIDTH * done // max(count, 1)
        left = took * (count - done) / done if done else float("nan")
        bar = "#" * filled + "." * (self.WIDTH - filled)
        end = "\n" if done == count else ""
        sys.stderr.write(f"\r[{bar}] {done} of {count}, {left:.0f} s left {end}")
        sys.stderr.flush()
