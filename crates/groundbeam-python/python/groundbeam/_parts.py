"""The parts of a model that is built in code, each a table of the model file.

Every number is in SI units (m, N, N/m, N m, rad) and every text a number with a unit, ``"12 m"`` or ``"40 MN/m^2"``; both
may stand side by side.
"""

from __future__ import annotations

from typing import Mapping, Optional, Sequence, SupportsFloat, Tuple, Union

from ._tables import Tables, Value

Quantity = Union[str, SupportsFloat]
"""A number in SI units, or text with a unit."""

Course = Union[Quantity, Sequence[Quantity]]
"""A quantity along a stretch: one for all of it, or one at its left and one at its right end."""


class Part:
    """A table of the model file."""

    table: dict[str, Value]
    """Its keys, as ``docs/file-format.md`` explains them."""

    def __init__(self, **keys: Optional[Value]) -> None:
        """Any keys that the model file knows; those that are ``None`` are left out."""
        self.table = {key: value for key, value in keys.items() if value is not None}

    def __repr__(self) -> str:
        keys = ", ".join(f"{key}={value!r}" for key, value in self.table.items())
        return f"{type(self).__name__}({keys})"

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Part) and self.table == other.table

    __hash__ = None  # type: ignore[assignment]


class Beam(Part):
    """The beam: its length, how stiff it is, and the axial force in it."""

    def __init__(
        self,
        length: Quantity,
        EI: Optional[Course] = None,
        *,
        E: Optional[Course] = None,
        I: Optional[Course] = None,
        section: Optional[Mapping[str, Value]] = None,
        axial_force: Optional[Quantity] = None,
        unit_weight: Optional[Quantity] = None,
        segments: Sequence[Mapping[str, Value]] = (),
        **more: Value,
    ) -> None:
        """The stiffness is ``EI``, or ``E`` with ``I`` or with a ``section``; the axial force is positive in tension."""
        super().__init__(
            length=length,
            EI=EI,
            E=E,
            I=I,
            section=section,
            axial_force=axial_force,
            unit_weight=unit_weight,
            segment=list(segments) or None,
            **more,
        )

    @classmethod
    def uniform(cls, length: Quantity, bending_stiffness: Quantity) -> Beam:
        """A beam of one bending stiffness."""
        return cls(length, bending_stiffness)


class Foundation(Part):
    """The ground: ``k`` per length of beam and ``mu``, or those of an area with a ``width``, or a ``soil``."""

    def __init__(
        self,
        k: Optional[Course] = None,
        mu: Optional[Course] = None,
        *,
        subgrade_modulus: Optional[Course] = None,
        width: Optional[Course] = None,
        C1: Optional[Course] = None,
        C2: Optional[Course] = None,
        soil: Optional[Mapping[str, Value]] = None,
        band: Optional[Mapping[str, Value]] = None,
        segments: Sequence[Mapping[str, Value]] = (),
        **more: Value,
    ) -> None:
        """Without ``mu`` the ground is of separate springs (Winkler)."""
        super().__init__(
            k=k,
            mu=mu,
            subgrade_modulus=subgrade_modulus,
            width=width,
            C1=C1,
            C2=C2,
            soil=soil,
            band=band,
            segment=list(segments) or None,
            **more,
        )

    @classmethod
    def pasternak(cls, spring: Quantity, shear: Quantity) -> Foundation:
        """Uniform ground with a shear layer."""
        return cls(spring, shear)

    @classmethod
    def winkler(cls, spring: Quantity) -> Foundation:
        """Uniform ground of separate springs."""
        return cls(spring)


class Load(Part):
    """A load, down positive; a moment is positive where it turns the right side down."""

    @classmethod
    def point(cls, force: Quantity, at: Quantity, *, case: Optional[str] = None) -> Load:
        """A force at a point."""
        return cls(point=force, at=at, case=case)

    @classmethod
    def moment(cls, moment: Quantity, at: Quantity, *, case: Optional[str] = None) -> Load:
        """A moment at a point."""
        return cls(moment=moment, at=at, case=case)

    @classmethod
    def distributed(
        cls,
        intensity: Course,
        start: Optional[Quantity] = None,
        end: Optional[Quantity] = None,
        *,
        case: Optional[str] = None,
    ) -> Load:
        """A force per length between two positions, even or linear; along the whole beam if no positions are given."""
        return cls(distributed=intensity, **_between(start, end), case=case)

    @classmethod
    def uniform(cls, intensity: Quantity, start: Quantity, end: Quantity) -> Load:
        """A uniform force per length between two positions."""
        return cls.distributed(intensity, start, end)

    @classmethod
    def distributed_moment(
        cls,
        intensity: Course,
        start: Optional[Quantity] = None,
        end: Optional[Quantity] = None,
        *,
        case: Optional[str] = None,
    ) -> Load:
        """A moment per length between two positions; along the whole beam if no positions are given."""
        return cls(distributed_moment=intensity, **_between(start, end), case=case)


    @classmethod
    def curvature(
        cls,
        curvature: Course,
        start: Optional[Quantity] = None,
        end: Optional[Quantity] = None,
        *,
        case: Optional[str] = None,
    ) -> Load:
        """A curvature that no moment makes [1/m], positive where it bends the ends down; of a temperature gradient
        it is ``Load(temperature_difference="15 K", ...)``."""
        return cls(curvature=curvature, **_between(start, end), case=case)


def _between(start: Optional[Quantity], end: Optional[Quantity]) -> dict[str, Optional[Value]]:
    return {"from": start, "to": end}


class Support(Part):
    """What holds the beam besides the ground.

    ``acts="up"`` is a bearing that the beam may lift from, ``acts="down"`` a strap; a support that has settled holds the
    beam at its ``settlement``.
    """

    @classmethod
    def pinned(cls, at: Quantity, **more: Value) -> Support:
        """No deflection; the beam may turn."""
        return cls(at=at, type="pinned", **more)

    @classmethod
    def fixed(cls, at: Quantity, **more: Value) -> Support:
        """Neither deflection nor slope."""
        return cls(at=at, type="fixed", **more)

    @classmethod
    def spring(
        cls,
        at: Quantity,
        spring: Optional[Quantity] = None,
        rotational_spring: Optional[Quantity] = None,
        **more: Value,
    ) -> Support:
        """Springs against deflection [N/m] and rotation [N m/rad]."""
        return cls(at=at, spring=spring, rotational_spring=rotational_spring, **more)


class Hinge(Part):
    """A joint inside the beam that hands on shear, and a moment only as far as its spring does."""

    def __init__(self, at: Quantity, rotational_spring: Optional[Quantity] = None) -> None:
        """Without a spring [N m/rad] it turns freely."""
        super().__init__(at=at, rotational_spring=rotational_spring)


class Combination(Part):
    """Load cases with their factors."""

    def __init__(self, name: str, factors: Mapping[str, SupportsFloat]) -> None:
        """Cases that are not named have the factor 0."""
        super().__init__(name=name, factors=dict(factors))


Gap = Sequence[Tuple[Quantity, Quantity]]
"""Corners of the initial clearance: each a position and a clearance, positive open."""


def tables(
    beam: Beam,
    foundation: Foundation,
    several: Mapping[str, Sequence[Part]],
    gap: Gap,
    title: Optional[str],
) -> Tables:
    """The model file that the parts make."""
    made: dict[str, Value] = {} if title is None else {"title": title}
    made |= {"beam": beam.table, "foundation": foundation.table}
    for name, parts in several.items():
        made[name] = [part.table for part in parts]
    made["gap"] = [{"at": at, "value": value} for at, value in gap]
    return {name: each for name, each in made.items() if each != []}
