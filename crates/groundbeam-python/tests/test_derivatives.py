"""Tests derivatives against differences of solutions, and refused requests."""

from __future__ import annotations

import groundbeam as gb
import numpy as np
import pytest

PARAMETERS = ["k", "mu", "EI", "load[0]", "load[0].at", "load[1].end", "load_factor"]


def value(model: gb.Model, output: str, at: float) -> float:
    solution = model.solve()
    named = {
        "deflection": lambda: solution.deflection(at),
        "moment": lambda: solution.moment(at),
        "largest moment": lambda: solution.range("moment").max.value,
        "edge[0].right": lambda: solution.contact[0][1],
        "end_force.left": lambda: solution.end_forces.left,
    }
    return float(named[output]())


@pytest.mark.parametrize(
    "output", ["deflection", "moment", "largest moment", "edge[0].right", "end_force.left"]
)
def test_derivatives_agree_with_finite_differences(footing: gb.Model, output: str) -> None:
    at = 4.0 if output in ("deflection", "moment") else None
    found = footing.solve().gradient(output, at=at, with_respect_to=PARAMETERS)
    assert found.derivatives.shape == (len(PARAMETERS),) and found.one_sided == []
    assert found.value == value(footing, output, 4.0)
    own = {"k": 40e6, "mu": 9e6, "EI": 1.28e9, "load[0]": 900e3, "load[0].at": 1.5, "load[1].end": 10e3}
    for name, exact in zip(PARAMETERS, found.derivatives):
        middle = own.get(name, 1.0)
        step = 1e-5 * middle
        more, less = [
            value_with(footing, output, name, middle + sign * step) for sign in (1.0, -1.0)
        ]
        quotient, rounding = (more - less) / (2.0 * step), 1e-11 * abs(more) / step
        assert abs(quotient - exact) <= 1e-5 * abs(exact) + rounding


def value_with(model: gb.Model, output: str, name: str, number: float) -> float:
    p = {"k": 40e6, "mu": 9e6, "EI": 1.28e9, "load[0]": 900e3, "load[0].at": 1.5}
    p |= {"load[1].end": 10e3, "load_factor": 1.0}
    p[name] = number
    factor = p["load_factor"]
    changed = gb.Model(
        gb.Beam(12.0, p["EI"]),
        gb.Foundation(p["k"], p["mu"]),
        loads=[
            gb.Load.point(factor * p["load[0]"], p["load[0].at"]),
            gb.Load.distributed([factor * 10e3, factor * p["load[1].end"]], 0.0, 12.0),
        ],
    )
    return value(changed, output, 4.0)


def test_an_array_of_positions_gives_an_array_of_derivatives(footing: gb.Model) -> None:
    solution = footing.solve()
    x = np.linspace(0.0, 12.0, 6).reshape(2, 3)
    found = solution.gradient("settlement", at=x, with_respect_to=["k", "mu"])
    assert found.derivatives.shape == (2, 3, 2)
    np.testing.assert_array_equal(np.asarray(found.value), solution.settlement(x))
    alone = solution.gradient("settlement", at="4.8 m", with_respect_to=["mu"])
    assert isinstance(alone.value, float)
    np.testing.assert_allclose(alone.derivatives, found.derivatives[0, 2, 1:], rtol=1e-9)


def test_derivatives_by_the_loads_satisfy_the_theorem_of_euler(footing: gb.Model) -> None:
    """Without a gap, all results except the contact are homogeneous in the loads, of degree one."""
    solution = footing.solve()
    by = ["load[0]", "load[1]"]
    moment = solution.gradient("largest moment", with_respect_to=by)
    assert moment.derivatives @ [900e3, 10e3] == pytest.approx(moment.value, rel=1e-12)
    edge = solution.gradient("edge[0].right", with_respect_to=by)
    assert abs(edge.derivatives @ [900e3, 10e3]) < 1e-9


def test_one_sided_derivatives_are_reported(footing: gb.Model) -> None:
    level = gb.Model(
        gb.Beam(2.0, 1.0), gb.Foundation(1.0, 1.0), loads=[gb.Load.distributed(1.0, 0.0, 2.0)]
    )
    assert level.solve().gradient("end_force.left", with_respect_to=["k"]).one_sided == []
    there = footing.solve().gradient("shear_force", at=1.5, with_respect_to=["load[0].at"])
    assert "left and right derivatives" in there.one_sided[0]


@pytest.mark.parametrize(
    ("output", "at", "by", "why"),
    [
        ("deflexion", None, "k", "no output has the name"),
        ("deflection", None, "k", "give the positions"),
        ("largest moment", 1.0, "k", "it has no position"),
        ("edge[7].left", None, "k", "does not contain the requested output"),
        ("deflection", 1.0, "kk", "unknown name"),
        ("deflection", 1.0, "load[9]", "no such number"),
        ("deflection", 1.0, "k[0]", "no such number"),
    ],
)
def test_unknown_outputs_and_parameters_are_refused(
    footing: gb.Model, output: str, at: float, by: str, why: str
) -> None:
    with pytest.raises(ValueError, match=why):
        footing.solve().gradient(output, at=at, with_respect_to=[by])


def test_only_exact_solutions_have_derivatives(footing: gb.Model) -> None:
    with pytest.raises(ValueError, match="active-set"):
        footing.solve("active-set").gradient("deflection", at=1.0, with_respect_to=["k"])


def test_batches_have_derivatives_by_segments_and_supports() -> None:
    model = gb.Model(
        gb.Beam(4.0, 1.0),
        gb.Foundation(1.0, 1.0, segments=[{"from": 0.0, "to": 2.0, "k": 2.0, "mu": 1.0}]),
        loads=[gb.Load.point(1.0, 2.0)],
        supports=[gb.Support.spring(0.0, 3.0)],
    )
    step = 1e-5
    owns = {"support[0].spring": 3.0, "k[0]": 2.0, "k[]": 1.0, "mu_factor[0]": 1.0}
    for name, own in owns.items():
        numbers = [own - step, own, own + step]
        batch = gb.solve_many(model, {name: numbers}, at=[0.0], fields=["deflection"])
        low, middle, high = batch["deflection"][:, 0]
        exact = model.solve().gradient("deflection", at=0.0, with_respect_to=[name])
        assert exact.value == middle
        assert exact.derivatives[0] == pytest.approx((high - low) / (2.0 * step), rel=1e-6)


def test_derivatives_of_a_beam_with_shear_deformation() -> None:
    """w = F l³/48EI + F l/4S in the middle of a beam on two supports; phi differs from the slope where there is
    shear force."""
    length, force, bending, shear = 6.0, 1.5, 7.0, 3.0
    model = gb.Model.from_toml(
        f"""
        [beam]
        length = {length}
        EI = {bending}
        GA = {shear}
        [foundation]
        k = 1
        [[gap]]
        at = 0
        value = 1000
        [[support]]
        at = 0
        type = "pinned"
        [[support]]
        at = {length}
        type = "pinned"
        [[load]]
        point = {force}
        at = {length / 2}
        """
    )
    solution = model.solve()
    found = solution.gradient("deflection", at=length / 2, with_respect_to=["GA", "EI", "GA_factor"])
    assert found.value == pytest.approx(force * length**3 / 48 / bending + force * length / 4 / shear)
    by_shear = -force * length / 4 / shear**2
    by_bending = -force * length**3 / 48 / bending**2
    np.testing.assert_allclose(found.derivatives, [by_shear, by_bending, shear * by_shear], rtol=1e-10)
    at = solution.at([1.0, 4.0])
    np.testing.assert_allclose(at.slope - at.rotation, np.array([0.5, -0.5]) * force / shear, rtol=1e-10)
    assert solution.rotation(1.0) == at.rotation[0]  # type: ignore[index]


def test_settlements_have_derivatives_beside_the_beam(footing: gb.Model) -> None:
    """As in `solve_many`."""
    one = footing.solve().gradient("settlement", at=[-1.0, 2.0], with_respect_to=["k", "mu"])
    many = gb.solve_many(
        footing, at=[-1.0, 2.0], fields=(), gradients="settlement", with_respect_to=["k", "mu"]
    )
    np.testing.assert_array_equal(one.derivatives, many.gradients["settlement"][0])
    assert one.derivatives[0].all()
