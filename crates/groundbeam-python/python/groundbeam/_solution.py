"""The solution: fields at any positions, contact, forces, and the proof."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, NamedTuple, Optional, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from . import _native
from ._frames import frame

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]
Position = Union[str, float]
"""A number in m (or in the file's own unit of length), or text with a unit."""
Positions = Union[Sequence[Position], npt.NDArray[np.floating], npt.NDArray[np.integer]]
"""Several of them."""

FIELDS = _native.FIELDS
"""The name of every field, in the order in which results list them."""


class EndForces(NamedTuple):
    """The concentrated contact forces under the beam's ends, not negative, pushing the beam up [N]."""

    left: float
    right: float


class Force(NamedTuple):
    """A concentrated contact force inside the beam, pushing it up [m, N]."""

    at: float
    force: float


class Reaction(NamedTuple):
    """What a support does: a force up [N], and a moment that turns the right side down [N m]."""

    at: float
    force: float
    moment: float


class HingeTurn(NamedTuple):
    """A hinge: how far the slope jumps, right less left [rad], and the moment it hands on [N m]."""

    at: float
    rotation: float
    moment: float


class LiftOff(NamedTuple):
    """A stretch that does not touch, and where the gap is largest and how large [m]."""

    start: float
    end: float
    at: float
    largest_gap: float


class Extreme(NamedTuple):
    """Where a field is smallest or largest, and how large."""

    x: float
    value: float


class Range(NamedTuple):
    """The smallest and the largest value of a field."""

    min: Extreme
    max: Extreme


class Fields(NamedTuple):
    """All fields at positions: numbers at a number, arrays of the same shape at an array."""

    x: Union[float, Array]
    deflection: Union[float, Array]
    slope: Union[float, Array]
    moment: Union[float, Array]
    shear_force: Union[float, Array]
    settlement: Union[float, Array]
    gap: Union[float, Array]
    pressure: Union[float, Array]
    rotation: Union[float, Array]


class Gradient(NamedTuple):
    """A number of a solution with its derivatives, or several of them."""

    value: Union[float, Array]
    """The output; at several positions an array of it."""
    derivatives: Array
    """By each parameter, in their order; at several positions a row for each."""
    one_sided: list[str]
    """Why the derivatives hold for small changes in one direction only, if they do."""


class Certificate(NamedTuple):
    """The energies, recomputed from model and answer (docs/proof.md)."""

    primal_energy: float
    """The potential energy of the deflections [N m]."""
    dual_energy: float
    """The reciprocal energy of moments and pressures [N m]."""
    gap: float
    """The difference, an estimate of the energy of the error [N m]."""
    relative_gap: float
    """The gap relative to the strain energy."""


def positions_of(native: Union[_native.Model, None], x: Union[Position, Positions]) -> Array:
    """Positions as numbers; texts with units are read by a model that has units."""
    if isinstance(x, str):
        return np.array(_read(native, x)).reshape(())
    if isinstance(x, np.ndarray) or not isinstance(x, Sequence):
        return np.asarray(x, dtype=np.float64)
    if any(isinstance(each, str) for each in x):
        numbers = [_read(native, each) if isinstance(each, str) else float(each) for each in x]
        return np.array(numbers, dtype=np.float64)
    return np.asarray(x, dtype=np.float64)


def _read(native: Union[_native.Model, None], text: str) -> float:
    reader = native or _native.Model("[beam]\nlength=1\nEI=1\n[foundation]\nk=1\n", "x", True, None, None)
    [number] = reader.positions(text)
    return number


class Solution:
    """An equilibrium with its certificate. ``Model.solve`` makes it."""

    _inner: _native.Solution

    def __init__(self, native: _native.Solution) -> None:
        self._inner = native

    def _field(self, name: str, x: Union[Position, Positions], side: str) -> Union[float, Array]:
        at = self._positions(x, beside=name == "settlement")
        values = self._inner.field(name, at.ravel(), side)
        return float(values[0]) if at.ndim == 0 else values.reshape(at.shape)

    def _positions(self, x: Union[Position, Positions], beside: bool = False) -> Array:
        at = positions_of(None, x)
        length = self._inner.length
        if np.isnan(at).any():
            raise ValueError("a position is not a number")
        if not beside and ((at < 0.0) | (at > length)).any():
            raise ValueError(f"a position lies off the beam, which goes from 0 to {length:g}")
        return at

    # Text is one position, though it is a sequence of text: the first signature holds for it.
    @overload
    def deflection(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def deflection(self, x: Positions, side: str = "right") -> Array: ...
    def deflection(
        self, x: Union[Position, Positions], side: str = "right"
    ) -> Union[float, Array]:
        """The beam's deflection w, down positive [m]."""
        return self._field("deflection", x, side)

    @overload
    def slope(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def slope(self, x: Positions, side: str = "right") -> Array: ...
    def slope(self, x: Union[Position, Positions], side: str = "right") -> Union[float, Array]:
        """The slope w', positive where the right side is lower [rad]."""
        return self._field("slope", x, side)

    @overload
    def rotation(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def rotation(self, x: Positions, side: str = "right") -> Array: ...
    def rotation(self, x: Union[Position, Positions], side: str = "right") -> Union[float, Array]:
        """The rotation phi of the sections: the slope, but of a beam that shears [rad]."""
        return self._field("rotation", x, side)

    @overload
    def moment(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def moment(self, x: Positions, side: str = "right") -> Array: ...
    def moment(self, x: Union[Position, Positions], side: str = "right") -> Union[float, Array]:
        """The bending moment M = -EI w'', sagging positive [N m]."""
        return self._field("moment", x, side)

    @overload
    def shear_force(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def shear_force(self, x: Positions, side: str = "right") -> Array: ...
    def shear_force(
        self, x: Union[Position, Positions], side: str = "right"
    ) -> Union[float, Array]:
        """The shear force V = M' [N]."""
        return self._field("shear_force", x, side)

    @overload
    def settlement(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def settlement(self, x: Positions, side: str = "right") -> Array: ...
    def settlement(
        self, x: Union[Position, Positions], side: str = "right"
    ) -> Union[float, Array]:
        """The settlement u of the ground's surface, down positive, also beside the beam [m]."""
        return self._field("settlement", x, side)

    @overload
    def gap(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def gap(self, x: Positions, side: str = "right") -> Array: ...
    def gap(self, x: Union[Position, Positions], side: str = "right") -> Union[float, Array]:
        """The clearance between beam and ground, not negative [m]."""
        return self._field("gap", x, side)

    @overload
    def pressure(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def pressure(self, x: Positions, side: str = "right") -> Array: ...
    def pressure(self, x: Union[Position, Positions], side: str = "right") -> Union[float, Array]:
        """The contact pressure p per length of beam, not negative [N/m]. ``end_forces`` come on top."""
        return self._field("pressure", x, side)

    def at(self, x: Union[Position, Positions], side: str = "right") -> Fields:
        """All fields at positions on the beam; where a field jumps, just to the ``right`` or to the ``left``."""
        at = self._positions(x)
        values = {name: self._field(name, at, side) for name in FIELDS}
        return Fields(float(at) if at.ndim == 0 else at, **values)

    def range(self, field: str) -> Range:
        """Where a field is smallest and largest on the whole beam: the roots of its derivative, not samples."""
        low_x, low, high_x, high = self._inner.range(field)
        return Range(Extreme(low_x, low), Extreme(high_x, high))

    def gradient(
        self,
        output: str,
        *,
        at: Union[None, Position, Positions] = None,
        with_respect_to: Sequence[str],
        side: str = "right",
    ) -> Gradient:
        """Exact derivatives of an output by parameters (docs/derivatives.md).

        Outputs are the fields ``at`` positions, and ``largest moment``, ``smallest gap``, … wherever they are;
        ``edge[0].left`` and ``edge[0].right``, the ends of a region of contact; ``end_force.left``, ``end_force.right``;
        ``support[0].force``, ``support[0].moment``; ``potential_energy``. Parameters are called as ``solve_many`` calls
        them: ``k``, ``mu_factor``, ``EI[0]``, ``load[1].at``, ``gap[0]``, … Only of solutions of the exact method.
        """
        if isinstance(with_respect_to, str):
            raise ValueError("with_respect_to is a list of names")
        names = list(with_respect_to)
        if (at is None) == (output in FIELDS):
            what = "say at which positions" if at is None else "it stands at no position of its own"
            raise ValueError(f"`{output}`: {what}")
        x = np.asarray(0.0) if at is None else self._positions(at)
        asked = [(output, float(each), side) for each in x.ravel()]
        value, flat, one_sided = self._inner.gradients(asked, names)
        derivatives = flat.reshape(x.shape + (len(names),))
        why = list(dict.fromkeys(reason for reasons in one_sided for reason in reasons))
        return Gradient(float(value[0]) if x.ndim == 0 else value.reshape(x.shape), derivatives, why)

    def stations(self, even: int = 100) -> Array:
        """Positions worth listing: equal steps, every load, support, joint, edge of contact, and every extreme."""
        return self._inner.stations(even)

    @property
    def units(self) -> str:
        """``SI``, or ``none`` for a file that gives numbers in a consistent system of its own."""
        return self._inner.units

    @property
    def length(self) -> float:
        """The beam's length [m]."""
        return self._inner.length

    @property
    def contact(self) -> list[tuple[float, float]]:
        """Where beam and ground touch, from left to right; a region of a single point begins where it ends [m]."""
        return self._inner.contact

    @property
    def lift_off(self) -> list[LiftOff]:
        """The stretches that do not touch."""
        return [LiftOff(*each) for each in self._inner.lift_off]

    @property
    def end_forces(self) -> EndForces:
        """The concentrated contact forces under the beam's ends [N]."""
        return EndForces(*self._inner.end_forces)

    @property
    def concentrated_forces(self) -> list[Force]:
        """Concentrated contact forces elsewhere."""
        return [Force(*each) for each in self._inner.concentrated_forces]

    @property
    def reactions(self) -> list[Reaction]:
        """The reactions of the supports, in the order of the model."""
        return [Reaction(*each) for each in self._inner.reactions]

    @property
    def hinges(self) -> list[HingeTurn]:
        """What the hinges do, in the order of the model."""
        return [HingeTurn(*each) for each in self._inner.hinges]

    @property
    def certificate(self) -> Certificate:
        """The proof."""
        return Certificate(*self._inner.certificate)

    @property
    def verdict(self) -> str:
        """``unique``, ``not-unique`` where this is one equilibrium of many, or ``local`` where the ground helps to bear
        compression."""
        return self._inner.verdict

    @property
    def sentence(self) -> str:
        """Why there is an equilibrium, in words."""
        return self._inner.sentence

    @property
    def combination(self) -> Optional[str]:
        """The combination that was solved, if the model was asked for one."""
        return self._inner.combination

    @property
    def method(self) -> str:
        """The method that found it."""
        return self._inner.method

    @property
    def iterations(self) -> int:
        """Steps of the method."""
        return self._inner.iterations

    @property
    def elements(self) -> int:
        """Elements of the mesh, or closed forms of the exact method."""
        return self._inner.elements

    @property
    def seconds(self) -> float:
        """How long it took [s]."""
        return self._inner.seconds

    def to_json(self, at: Union[None, Positions] = None) -> str:
        """The result document, as ``groundbeam solve --json`` prints it."""
        return self._inner.to_json(None if at is None else self._positions(at).ravel().tolist())

    def to_csv(self, at: Union[None, Positions] = None) -> str:
        """All fields as a table; where a field jumps, a row for each side."""
        return self._inner.to_csv(None if at is None else self._positions(at).ravel().tolist())

    def to_svg(self) -> str:
        """A picture: the beam on its ground, pressure, moment and shear."""
        return self._inner.to_svg()

    def to_png(self) -> bytes:
        """The same picture in pixels."""
        return self._inner.to_png()

    def to_pandas(self, at: Union[None, Positions] = None) -> pandas.DataFrame:
        """The table of ``to_csv`` as a data frame; its columns are ``x_m``, ``deflection_m``, ``moment_Nm``, …"""
        return frame(self.to_csv(at))

    def plot(self) -> Figure:
        """A figure of matplotlib: deflection with the ground and the lifted stretches, pressure, moment, shear."""
        from ._plot import figure

        return figure(self)

    def _repr_html_(self) -> str:
        report = html.escape(str(self))
        details = f"<details><summary>Report</summary><pre>{report}</pre></details>"
        return f'<div style="max-width: 60em">{self.to_svg()}{details}</div>'

    def __str__(self) -> str:
        return self._inner.report()

    def __repr__(self) -> str:
        touching = ", ".join(f"{start:g} to {end:g}" for start, end in self.contact) or "nowhere"
        gap = self.certificate.relative_gap
        return f"<groundbeam.Solution: contact {touching}; energy gap {gap:.0e}>"
