"""The solution of a model: fields at any positions, contact, forces, and the certificate."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, NamedTuple, Optional, Protocol, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from . import _native
from ._frames import frame

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]
Position = Union[str, float]
"""A number in m (or in the file's own unit of length), or text: with a unit if the file has units, and without a unit
if it has none."""
Positions = Union[Sequence[Position], npt.NDArray[np.floating], npt.NDArray[np.integer]]
"""Several positions."""

FIELDS = _native.FIELDS
"""Names of all fields, in the order in which results list them."""


class EndForces(NamedTuple):
    """Point contact forces under the beam's ends [N], nonnegative, upward on the beam."""

    left: float
    right: float


class Force(NamedTuple):
    """Position [m] and size [N] of a point contact force between the ends of the beam, upward on the beam."""

    at: float
    force: float


class Reaction(NamedTuple):
    """Reaction of a support on the beam: a force [N], positive upward, and a moment [N m], positive clockwise."""

    at: float
    force: float
    moment: float


class HingeTurn(NamedTuple):
    """A hinge: its rotation (jump of the slope, right minus left) [rad], and its moment [N m]."""

    at: float
    rotation: float
    moment: float


class LiftOff(NamedTuple):
    """A stretch without contact, with the position and size of the largest gap [m]."""

    start: float
    end: float
    at: float
    largest_gap: float


class Extreme(NamedTuple):
    """Position and value of an extreme of a field."""

    x: float
    value: float


class Range(NamedTuple):
    """The smallest and the largest value of a field."""

    min: Extreme
    max: Extreme


class Fields(NamedTuple):
    """All fields at one position as numbers, or at an array of positions as arrays of the same shape."""

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
    """One or several outputs of a solution, with derivatives."""

    value: Union[float, Array]
    """Value of the output; an array for several positions."""
    derivatives: Array
    """Derivatives of the output with respect to each parameter, in the given order. For several positions, the array has
    one row for each position."""
    one_sided: list[str]
    """Reasons why the derivatives hold for small changes in one direction only; empty if all hold in both directions."""


class Certificate(NamedTuple):
    """Energies, recomputed from model and result (docs/proof.md)."""

    primal_energy: float
    """The primal energy: the total potential energy of the computed deflection and settlement [N m]."""
    dual_energy: float
    """The dual energy, also called reciprocal energy, of bending moments and pressures in equilibrium with the loads [N m]."""
    gap: float
    """The primal energy minus the dual energy [N m], an estimate of the energy of the error."""
    relative_gap: float
    """The energy gap relative to the strain energy."""


class Reader(Protocol):
    """Reads positions with the units of a model."""

    def read_position(self, text: str) -> float: ...


def positions_of(reader: Reader, x: Union[Position, Positions]) -> Array:
    """Positions as numbers. Positions given as text are read in the units of the model."""
    if isinstance(x, str):
        return np.array(reader.read_position(x))
    each = list(x) if isinstance(x, Sequence) else x
    if isinstance(each, list):
        each = [reader.read_position(one) if isinstance(one, str) else one for one in each]
    try:
        return np.asarray(each, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(
            'positions are numbers, texts, or one list of them, as in ["1 m", "2 m"], or an array of numbers'
        ) from None


def refuse_outside(at: Array, length: float, beside: bool = False) -> None:
    """Raises an error for positions that are not numbers, and for positions outside the beam unless ``beside`` is true."""
    if beside and np.isnan(at).any():
        raise ValueError("a position is not a number")
    if not beside and not ((at >= 0.0) & (at <= length)).all():
        raise ValueError(f"a position lies outside the beam, which extends from 0 to {length:g}")


class Solution:
    """An equilibrium with its certificate, returned by ``Model.solve``."""

    _inner: _native.Solution

    def __init__(self, native: _native.Solution) -> None:
        self._inner = native

    def _field(self, name: str, x: Union[Position, Positions], side: str) -> Union[float, Array]:
        at = self._positions(x, beside=name == "settlement")
        values = self._inner.field(name, at.ravel(), side)
        return float(values[0]) if at.ndim == 0 else values.reshape(at.shape)

    def _positions(self, x: Union[Position, Positions], beside: bool = False) -> Array:
        at = positions_of(self._inner, x)
        refuse_outside(at, self._inner.length, beside)
        return at

    # A `str` is one position, so the first overload applies, although a `str` is also a sequence of strings.
    @overload
    def deflection(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def deflection(self, x: Positions, side: str = "right") -> Array: ...
    def deflection(
        self, x: Union[Position, Positions], side: str = "right"
    ) -> Union[float, Array]:
        """The deflection w of the beam [m], positive downward."""
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
        """The rotation phi of the cross-sections; without shear deformation it is the slope [rad]."""
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
        """The settlement u of the ground surface [m], positive downward. ``x`` may lie outside the beam."""
        return self._field("settlement", x, side)

    @overload
    def gap(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def gap(self, x: Positions, side: str = "right") -> Array: ...
    def gap(self, x: Union[Position, Positions], side: str = "right") -> Union[float, Array]:
        """The gap between beam and ground, nonnegative [m]."""
        return self._field("gap", x, side)

    @overload
    def pressure(self, x: Position, side: str = "right") -> float: ...  # type: ignore[overload-overlap]
    @overload
    def pressure(self, x: Positions, side: str = "right") -> Array: ...
    def pressure(self, x: Union[Position, Positions], side: str = "right") -> Union[float, Array]:
        """The contact pressure p per length of beam, nonnegative [N/m]. It does not include ``end_forces``."""
        return self._field("pressure", x, side)

    def at(self, x: Union[Position, Positions], side: str = "right") -> Fields:
        """All fields at positions on the beam. Where a field jumps, ``side`` selects the ``right`` or the
        ``left`` value."""
        at = self._positions(x)
        values = {name: self._field(name, at, side) for name in FIELDS}
        return Fields(float(at) if at.ndim == 0 else at, **values)

    def range(self, field: str) -> Range:
        """Smallest and largest value of a field on the whole beam, with positions, from the roots of its
        derivative."""
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
        """Exact derivatives of an output with respect to parameters (docs/derivatives.md), for solutions of the
        exact method.

        Outputs are: the fields ``at`` positions; ``largest moment``, ``smallest gap``, …, at their own positions;
        ``edge[0].left`` and ``edge[0].right``, the ends of a contact zone; ``end_force.left``,
        ``end_force.right``; ``support[0].force``, ``support[0].moment``; ``potential_energy``. Parameters have the
        names of ``solve_many``: ``k``, ``mu_factor``, ``EI[0]``, ``load[1].at``, ``gap[0]``, …
        """
        if isinstance(with_respect_to, str):
            raise ValueError(f"with_respect_to: give a list of names, as in [{with_respect_to!r}]")
        names = list(with_respect_to)
        if (at is None) == (output in FIELDS):
            what = "give the positions" if at is None else "it has no position"
            raise ValueError(f"`{output}`: {what}")
        x = np.asarray(0.0) if at is None else self._positions(at, beside=output == "settlement")
        asked = [(output, float(each), side) for each in x.ravel()]
        value, flat, one_sided = self._inner.gradients(asked, names)
        derivatives = flat.reshape(x.shape + (len(names),))
        why = list(dict.fromkeys(reason for reasons in one_sided for reason in reasons))
        return Gradient(float(value[0]) if x.ndim == 0 else value.reshape(x.shape), derivatives, why)

    def stations(self, even: int = 100) -> Array:
        """Default positions for listing: equal steps, all loads, supports, hinges, contact edges, and
        extremes."""
        return self._inner.stations(even)

    @property
    def units(self) -> str:
        """Unit system of the model: ``SI``, or ``none`` for a file in its own consistent system."""
        return self._inner.units

    @property
    def length(self) -> float:
        """The beam's length [m]."""
        return self._inner.length

    @property
    def contact(self) -> list[tuple[float, float]]:
        """Contact zones from left to right [m]; for a point contact both ends are equal."""
        return self._inner.contact

    @property
    def lift_off(self) -> list[LiftOff]:
        """The stretches without contact."""
        return [LiftOff(*each) for each in self._inner.lift_off]

    @property
    def end_forces(self) -> EndForces:
        """The point contact forces under the beam's ends [N]."""
        return EndForces(*self._inner.end_forces)

    @property
    def concentrated_forces(self) -> list[Force]:
        """Point contact forces inside the beam."""
        return [Force(*each) for each in self._inner.concentrated_forces]

    @property
    def reactions(self) -> list[Reaction]:
        """The reactions of the supports, in the order of the model."""
        return [Reaction(*each) for each in self._inner.reactions]

    @property
    def hinges(self) -> list[HingeTurn]:
        """Rotations and moments of the hinges, in the order of the model."""
        return [HingeTurn(*each) for each in self._inner.hinges]

    @property
    def certificate(self) -> Certificate:
        """The certificate."""
        return Certificate(*self._inner.certificate)

    @property
    def verdict(self) -> str:
        """``unique``, ``not-unique`` if this is one equilibrium of many, or ``local`` for an equilibrium under
        compression that needs the ground."""
        return self._inner.verdict

    @property
    def sentence(self) -> str:
        """The reason why an equilibrium exists, as a sentence."""
        return self._inner.sentence

    @property
    def combination(self) -> Optional[str]:
        """The combination, if the model was solved for one."""
        return self._inner.combination

    @property
    def method(self) -> str:
        """The method of solution."""
        return self._inner.method

    @property
    def iterations(self) -> int:
        """Number of steps of the method."""
        return self._inner.iterations

    @property
    def elements(self) -> int:
        """Number of elements of the mesh, or of closed-form pieces of the exact method."""
        return self._inner.elements

    @property
    def seconds(self) -> float:
        """Duration of the solve [s]."""
        return self._inner.seconds

    def to_json(self, at: Union[None, Positions] = None) -> str:
        """The result document of ``groundbeam solve --json``."""
        return self._inner.to_json(None if at is None else self._positions(at).ravel().tolist())

    def to_csv(self, at: Union[None, Positions] = None) -> str:
        """All fields as a table. Where a field jumps, there is one row for each side."""
        return self._inner.to_csv(None if at is None else self._positions(at).ravel().tolist())

    def to_svg(self) -> str:
        """A picture: the beam on its ground, pressure, moment and shear."""
        return self._inner.to_svg()

    def to_png(self) -> bytes:
        """The picture as PNG."""
        return self._inner.to_png()

    def to_pandas(self, at: Union[None, Positions] = None) -> pandas.DataFrame:
        """The table of ``to_csv`` as a data frame; its columns are ``x_m``, ``deflection_m``, ``moment_Nm``, …"""
        return frame(self.to_csv(at))

    def plot(self) -> Figure:
        """A matplotlib figure: deflection with the ground and the lifted stretches, pressure, moment, shear."""
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
