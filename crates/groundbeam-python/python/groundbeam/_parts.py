"""Parts of a model that is built in code. Each is a table of the model file.

A number is in SI units (m, N, N/m, N m, rad). A text is a number with a unit, ``"12 m"`` or ``"40 MN/m^2"``. Both
may be mixed.
"""

from __future__ import annotations

from typing import Mapping, Optional, Sequence, SupportsFloat, Tuple, Union

from ._tables import Tables, Value

Quantity = Union[str, SupportsFloat]
"""A number in SI units, or text with a unit."""

Course = Union[Quantity, Sequence[Quantity]]
"""A quantity along a stretch: one value, or a list of two for the left and the right end."""


class Part:
    """A table of the model file."""

    table: dict[str, Value]
    """The keys of the table, explained in ``docs/file-format.md``."""

    def __init__(self, **keys: Optional[Value]) -> None:
        """Accepts any keys of the model file, and omits keys with the value ``None``."""
        self.table = {key: value for key, value in keys.items() if value is not None}

    def __repr__(self) -> str:
        keys = ", ".join(f"{key}={value!r}" for key, value in self.table.items())
        return f"{type(self).__name__}({keys})"

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Part) and self.table == other.table

    __hash__ = None  # type: ignore[assignment]


class Beam(Part):
    """The beam: its length, its stiffness, and its axial force."""

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
        """The stiffness is ``EI``, or ``E`` with ``I`` or with a ``section``. The axial force is positive in
        tension."""
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
        """A beam with constant bending stiffness."""
        return cls(length, bending_stiffness)


class Foundation(Part):
    """The ground: ``k`` per length of beam and ``mu``, or constants per area with a ``width``, or a ``soil``."""

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
        """Without ``mu`` the ground consists of independent springs (Winkler)."""
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
        """Uniform Winkler ground."""
        return cls(spring)


class Load(Part):
    """A load, positive downward. A positive moment turns the right side down."""

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
        """A force per length between two positions, uniform or linear; along the whole beam by default."""
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
        """A moment per length between two positions; along the whole beam by default."""
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
        """An imposed curvature [1/m], positive if it bends the ends down. For a temperature gradient write
        ``Load(temperature_difference="15 K", ...)``."""
        return cls(curvature=curvature, **_between(start, end), case=case)


def _between(start: Optional[Quantity], end: Optional[Quantity]) -> dict[str, Optional[Value]]:
    return {"from": start, "to": end}


class Support(Part):
    """A support of the beam.

    ``acts="up"`` is a bearing that only pushes the beam up, ``acts="down"`` a hold-down, which only pulls it down. A
    support with a ``settlement`` holds the beam at this deflection.
    """

    @classmethod
    def pinned(cls, at: Quantity, **more: Value) -> Support:
        """A support that prevents deflection, but not rotation."""
        return cls(at=at, type="pinned", **more)

    @classmethod
    def fixed(cls, at: Quantity, **more: Value) -> Support:
        """A support that prevents deflection and rotation."""
        return cls(at=at, type="fixed", **more)

    @classmethod
    def spring(
        cls,
        at: Quantity,
        spring: Optional[Quantity] = None,
        rotational_spring: Optional[Quantity] = None,
        **more: Value,
    ) -> Support:
        """Translational spring [N/m] and rotational spring [N m/rad]."""
        return cls(at=at, spring=spring, rotational_spring=rotational_spring, **more)


class Hinge(Part):
    """A hinge inside the beam. It transmits shear, and the moment of its spring."""

    def __init__(self, at: Quantity, rotational_spring: Optional[Quantity] = None) -> None:
        """Takes the stiffness of the rotational spring [N m/rad]. Without this spring the hinge rotates freely."""
        super().__init__(at=at, rotational_spring=rotational_spring)


class GroundLoad(Part):
    """A force on the surface of the ground, positive downward. It does not act on the beam."""

    @classmethod
    def point(cls, force: Quantity, at: Quantity, *, case: Optional[str] = None) -> GroundLoad:
        """A point force on the ground. The ground must have a shear layer."""
        return cls(point=force, at=at, case=case)

    @classmethod
    def distributed(
        cls, intensity: Course, start: Quantity, end: Quantity, *, case: Optional[str] = None
    ) -> GroundLoad:
        """A force per length between two positions, uniform or linear."""
        return cls(distributed=intensity, **_between(start, end), case=case)


class Trough(Part):
    """A settlement trough: at x, the ground settles by S exp(-(x - x0)^2/(2 i^2)). S is the largest settlement, x0 its
    position, and i the distance from x0 to the point of inflection."""

    def __init__(self, at: Quantity, settlement: Quantity, width: Quantity) -> None:
        """Takes the position of the middle of the trough, its largest settlement, and the distance from the middle to the
        point of inflection."""
        super().__init__(at=at, settlement=settlement, width=width)


class Train(Part):
    """Axles and distributed loads that move along the beam together."""

    def __init__(
        self,
        axles: Sequence[Tuple[Quantity, Quantity]] = (),
        *,
        name: Optional[str] = None,
        set: Optional[str] = None,
        uniform: Sequence[Mapping[str, Value]] = (),
        start: Optional[Quantity] = None,
        end: Optional[Quantity] = None,
        factor: Optional[SupportsFloat] = None,
        dynamic: Optional[SupportsFloat] = None,
        case: Optional[str] = None,
    ) -> None:
        """``axles`` are distances behind the first axle with their forces, or a ``set`` gives them. The first axle goes
        from ``start`` to ``end``. ``factor`` multiplies all loads; ``dynamic`` also multiplies the axles."""
        super().__init__(
            name=name,
            set=set,
            axles=[{"at": at, "force": force} for at, force in axles] or None,
            uniform=list(uniform) or None,
            **_between(start, end),
            factor=factor,
            dynamic=dynamic,
            case=case,
        )


LimitStates = Union[str, Sequence[str]]
"""One limit state, such as ``STR/GEO`` or ``SLS characteristic``, or a list of limit states."""


class Checks(Part):
    """The limits of a design, and the limit states in which each limit is checked."""

    def __init__(
        self,
        *,
        bearing_pressure: Optional[Quantity] = None,
        bearing_resistance: Optional[Quantity] = None,
        width: Optional[Quantity] = None,
        settlement: Optional[Quantity] = None,
        lifted_share: Optional[SupportsFloat] = None,
        eccentricity: Optional[Quantity] = None,
        overturning: Optional[SupportsFloat] = None,
        limit_states: Mapping[str, LimitStates] = {},
    ) -> None:
        """``limit_states`` replaces the default limit states of a check; ``eccentricity`` may be ``"l/6"``."""
        super().__init__(
            bearing_pressure=bearing_pressure,
            bearing_resistance=bearing_resistance,
            width=width,
            settlement=settlement,
            lifted_share=lifted_share,
            eccentricity=eccentricity,
            overturning=overturning,
            limit_states=dict(limit_states) or None,
        )


class Combination(Part):
    """Load cases with their factors."""

    def __init__(
        self,
        name: str,
        factors: Mapping[str, SupportsFloat],
        *,
        limit_state: Optional[LimitStates] = None,
    ) -> None:
        """Load cases without a given factor have the factor 0. Without a ``limit_state`` all limits are checked."""
        super().__init__(name=name, factors=dict(factors), limit_state=limit_state)


Gap = Sequence[Tuple[Quantity, Quantity]]
"""Points of the initial gap. Each point is a position and a gap, which is positive if open."""


def tables(
    beam: Beam,
    foundation: Foundation,
    several: Mapping[str, Sequence[Part]],
    gap: Gap,
    checks: Optional[Checks],
    title: Optional[str],
) -> Tables:
    """The model file for the parts."""
    made: dict[str, Value] = {} if title is None else {"title": title}
    made |= {"beam": beam.table, "foundation": foundation.table}
    for name, parts in several.items():
        made[name] = [part.table for part in parts]
    made["gap"] = [{"at": at, "value": value} for at, value in gap]
    if checks is not None:
        made["checks"] = checks.table
    return {name: each for name, each in made.items() if each != []}
