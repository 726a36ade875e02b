"""Many models at once: arrays of parameters in, arrays of results out, on all processors."""

from __future__ import annotations

import sys
import time
from typing import TYPE_CHECKING, Any, Callable, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _native
from ._along import Along
from ._model import Model
from ._solution import Array, Positions, positions_of
from ._threads import number_of

if TYPE_CHECKING:
    import pandas

STATUSES = np.array(["solved", "no-equilibrium", "not-converged", "wrong"])
"""How it went, by the numbers of the compiled half."""

Progress = Union[None, bool, Callable[[int, int], object]]

Parameters = Union[Mapping[str, Union[npt.ArrayLike, Along]], "pandas.DataFrame"]
"""Names of parameters with a number for all models, a number for each, or values along the beam."""


class Extremes(NamedTuple):
    """The smallest and the largest values of a field, one of each model, and where they are."""

    min_x: Array
    min: Array
    max_x: Array
    max: Array


class Batch(Mapping[str, Array]):
    """The answers to many models, in their order: ``batch["moment"]`` is an array of models by positions.

    A model without an answer has NaN for numbers, and tells why in ``status`` and ``messages``.
    """

    at: Array
    """The positions of the fields [m]."""
    status: npt.NDArray[np.str_]
    """Of each model ``solved``, ``no-equilibrium``, ``not-converged`` or ``wrong``."""
    messages: list[Optional[str]]
    """Why there is no answer, in words; ``None`` where there is one."""
    end_forces: Array
    """The concentrated contact forces under the left and the right end [N], models by 2."""
    lifted_share: Array
    """The part of the beam that does not touch."""
    relative_gap: Array
    """The error bound of the certificate, relative to the strain energy."""
    motion: Array
    """Of models without equilibrium r(0), r(l) and the loads' work in it, models by 3."""
    extremes: dict[str, Extremes]
    """Of the fields that were asked for."""

    def __init__(
        self, table: dict[str, Any], at: Array, fields: Sequence[str], extremes: Sequence[str]
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
        """How many models there are."""
        return len(self.status)

    @property
    def solved(self) -> npt.NDArray[np.bool_]:
        """Which of them have an answer."""
        return np.asarray(self.status == "solved", dtype=np.bool_)

    def contact(self, number: int) -> list[tuple[float, float]]:
        """Where beam and ground touch in one of the models."""
        if not -self.count <= number < self.count:
            raise IndexError(f"there are {self.count} models")
        number %= self.count
        regions = self._edges[self._starts[number] : self._starts[number + 1]]
        return [(float(start), float(end)) for start, end in regions]

    def to_pandas(self) -> pandas.DataFrame:
        """One row for each model: status, end forces, lifted share, error bound, and the extremes."""
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
    method: str = "exact",
    elements: int = 100,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Batch:
    """Solves a list of models, or one model under many sets of parameters, with no Python in the loop.

    A parameter is one number for all models, or an array of one number for each; the columns of a table of pandas are such
    arrays. All are in SI units:

    * ``k``, ``mu``, ``EI``, ``GA``, ``axial_force``;
    * ``k_factor``, ``mu_factor``, ``EI_factor``, ``GA_factor`` and ``load_factor``, which multiply what the model has;
    * of the loads, which count from 0, ``load[0]`` (its size), ``load[0].at``, and of distributed loads ``load[0].from``,
      ``.to``, ``.start`` and ``.end``;
    * of segments ``k[0]``, ``mu_factor[1]`` and so on, of what is outside them ``k[]``;
    * ``support[0].settlement``, ``.spring`` and ``.rotational_spring``, ``hinge[0]``, ``gap[0]``.

    ``k``, ``mu`` and ``EI`` may also vary along the beam. The values of a row then have a shape: ``Points(values)`` are
    values at even points with straight lines between them, ``Steps(values)`` values of equal stretches,
    ``ControlValues(values)`` the control values of one curve, as ``Foundation(k=[...])`` takes them. ``values`` is one row
    for all models, or an array of models by values. An array of models by two values needs no shape: it runs linearly from
    end to end. A row of three or more values without a shape is a ``ValueError``.

    ``at`` are the positions of ``fields``, on the beam; a model whose beam ends before a position has NaN there. ``extremes`` names fields of which the smallest and the largest values are
    located. ``threads`` defaults to as many as there are processors; the answers have the same bits with any number.
    A model that fails does not stop the others. ``progress=True`` draws a bar; a function is called with how many are
    done and how many there are.
    """
    several = [models] if isinstance(models, Model) else list(models)
    given = {} if parameters is None else {str(name): each for name, each in parameters.items()}
    fields, extremes = _names(fields), _names(extremes)
    rows = {name: _rows(name, values) for name, values in given.items()}
    counts = {} if isinstance(models, Model) else {"models": len(several)}
    counts |= {name: len(values) for name, values in rows.items() if len(values) != 1}
    count = next(iter(counts.values()), 1)
    if any(each != count for each in counts.values()):
        listed = ", ".join(f"{name}: {each}" for name, each in counts.items())
        raise ValueError(f"these differ in length: {listed}")
    for model in several:
        model._refuse_more_than_one_answer()
    positions = np.ascontiguousarray(np.atleast_1d(positions_of(None, at)))
    if positions.ndim != 1:
        raise ValueError("positions are one list")
    beside = not set(fields) - {"settlement"}
    length = max((model.length for model in several), default=0.0)
    if not beside and not ((positions >= 0.0) & (positions <= length)).all():
        raise ValueError(f"a position lies off the beam, which goes from 0 to {length:g}")
    if not several:
        count = 0
    table = _native.solve_many(
        [model._inner for model in several],
        count,
        [(name, _shape(given[name]), values) for name, values in rows.items()],
        positions,
        fields,
        extremes,
        method,
        elements,
        number_of(threads),
        _Bar() if progress is True else progress or None,
    )
    return Batch(table, positions, fields, extremes)


def _names(names: Union[str, Sequence[str]]) -> list[str]:
    """A list of names; one name may stand alone."""
    return [names] if isinstance(names, str) else list(names)


def _shape(values: Union[npt.ArrayLike, Along]) -> Optional[str]:
    """What the values of a row mean, if that is said."""
    return type(values).__name__ if isinstance(values, Along) else None


def _rows(name: str, values: Union[npt.ArrayLike, Along]) -> Array:
    """A row for each model, or one for all."""
    if isinstance(values, Along):
        return np.ascontiguousarray(values.values)
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"parameter `{name}`: takes numbers in SI units ({error})") from None
    if array.ndim > 2:
        raise ValueError(f"parameter `{name}`: one number for each model, or a row along the beam")
    array = array.reshape(-1, 1) if array.ndim < 2 else array
    return np.ascontiguousarray(array)


class _Bar:
    """A bar on standard error for whatever takes more than a second."""

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
