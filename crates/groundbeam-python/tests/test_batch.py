"""Tests that many models give the same bits as one by one, on any number of threads."""

from __future__ import annotations

import re
import time
from typing import Mapping

import groundbeam as gb
import numpy as np
import numpy.typing as npt
import pandas
import pytest
from groundbeam._batch import Parameters
from groundbeam._solution import Array
from groundbeam._tables import Value


def grounds(count: int) -> dict[str, Array]:
    """Parameters near those of the footing: ground, stiffness, forces and loads."""
    random = np.random.default_rng(1)

    def around(middle: float) -> Array:
        return middle * np.exp(random.normal(0.0, 0.4, count))

    return {
        "k": around(40e6),
        "mu": around(9e6),
        "EI": around(1.28e9),
        "axial_force": around(1e5),
        "load[0]": around(900e3),
        "load[0].at": random.uniform(0.0, 12.0, count),
        "load[1].end": around(10e3),
    }


def one_by_one(parameters: dict[str, Array], number: int) -> gb.Model:
    p = {name: values[number] for name, values in parameters.items()}
    return gb.Model(
        gb.Beam(12.0, p["EI"], axial_force=p["axial_force"]),
        gb.Foundation(p["k"], p["mu"]),
        loads=[
            gb.Load.point(p["load[0]"], p["load[0].at"]),
            gb.Load.distributed([10e3, p["load[1].end"]], 0.0, 12.0),
        ],
    )


def test_a_batch_has_the_same_bits_as_single_solves(footing: gb.Model) -> None:
    parameters = grounds(200)
    x = np.linspace(0.0, 12.0, 7)
    batch = gb.solve_many(
        footing, parameters, at=x, fields=["moment", "gap"], extremes=["pressure", "moment"]
    )
    assert batch.solved.all() and batch.count == 200 and batch["moment"].shape == (200, 7)
    for number in range(200):
        alone = one_by_one(parameters, number).solve()
        np.testing.assert_array_equal(batch["moment"][number], alone.moment(x))
        np.testing.assert_array_equal(batch["gap"][number], alone.gap(x))
        assert batch.contact(number) == alone.contact
        assert tuple(batch.end_forces[number]) == alone.end_forces
        assert batch.relative_gap[number] == alone.certificate.relative_gap
        low, high = alone.range("moment")
        assert batch.extremes["moment"].min[number] == low.value
        assert batch.extremes["moment"].max_x[number] == high.x
        lifted = sum(each.end - each.start for each in alone.lift_off) / 12.0
        assert batch.lifted_share[number] == pytest.approx(lifted, abs=1e-15)
    assert (batch.lifted_share > 0.0).any() and (batch.lifted_share == 0.0).any()


def test_gradients_of_a_batch_agree_with_single_gradients(footing: gb.Model) -> None:
    parameters = grounds(40)
    by = ["k", "mu_factor", "load[0].at"]
    outputs = ["largest moment", "settlement", "edge[0].right", "edge[1].left"]
    batch = gb.solve_many(footing, parameters, at=[1.0, 7.0], gradients=outputs, with_respect_to=by)
    assert batch.gradients["settlement"].shape == (40, 2, 3)
    assert batch.gradients["largest moment"].shape == (40, 3)
    assert not batch.one_sided["settlement"].any()
    for number in range(40):
        alone = one_by_one(parameters, number).solve()
        for name in ("largest moment", "edge[0].right"):
            exact = alone.gradient(name, with_respect_to=by)
            found = batch.gradients[name][number]
            np.testing.assert_allclose(found, exact.derivatives, rtol=1e-9)
            assert batch.one_sided[name][number] == bool(exact.one_sided)
        settles = alone.gradient("settlement", at=[1.0, 7.0], with_respect_to=by)
        scale = np.abs(settles.derivatives).max(axis=0)
        np.testing.assert_allclose(
            batch.gradients["settlement"][number] / scale, settles.derivatives / scale, rtol=0, atol=1e-9
        )
        second = len(alone.contact) > 1
        assert np.isfinite(batch.gradients["edge[1].left"][number]).all() == second
    threads = gb.solve_many(
        footing, parameters, at=[1.0, 7.0], gradients=outputs, with_respect_to=by, threads=1
    )
    for name in outputs:
        assert threads.gradients[name].tobytes() == batch.gradients[name].tobytes()
    tips = gb.solve_many(footing, {"load[0]": [-5e6]}, gradients=["edge[0].left"], with_respect_to=["k"])
    assert np.isnan(tips.gradients["edge[0].left"]).all()


def test_wrong_gradients_are_refused(footing: gb.Model) -> None:
    with pytest.raises(ValueError, match="give both of them"):
        gb.solve_many(footing, gradients="largest moment")
    with pytest.raises(ValueError, match="no such number"):
        gb.solve_many(footing, gradients="largest moment", with_respect_to=["load[7]"])
    with pytest.raises(ValueError, match="no output has the name"):
        gb.solve_many(footing, gradients="greatest moment", with_respect_to=["k"])
    with pytest.raises(ValueError, match="exact method"):
        gb.solve_many(footing, gradients="largest moment", with_respect_to=["k"], method="active-set")


def test_any_number_of_threads_gives_the_same_bits(footing: gb.Model) -> None:
    parameters = grounds(300)
    batches = [
        gb.solve_many(footing, parameters, at=[0, 3, 6], extremes=["gap"], threads=threads)
        for threads in (1, 2, 3, 8)
    ]
    for other in batches[1:]:
        for field in other:
            assert other[field].tobytes() == batches[0][field].tobytes()
        assert other.extremes["gap"].max.tobytes() == batches[0].extremes["gap"].max.tobytes()
        assert other.end_forces.tobytes() == batches[0].end_forces.tobytes()


def test_a_list_of_models_is_solved(footing: gb.Model) -> None:
    models = [footing, footing.with_load(gb.Load.point(5e5, 11)), footing]
    batch = gb.solve_many(models, at=["1 m", 2.0])
    for number, model in enumerate(models):
        np.testing.assert_array_equal(batch["pressure"][number], model.solve().pressure([1, 2]))
    both = gb.solve_many(models, {"load_factor": [1.0, 1.0, 2.0]}, at=[1])
    assert both["deflection"][2] == 2.0 * both["deflection"][0], "loads times two, bit for bit"
    assert gb.solve_many([]).count == 0


def test_failures_are_reported_as_a_status_of_each_row(footing: gb.Model) -> None:
    force = [900e3, -5e6, 900e3, np.nan]
    k = [40e6, 40e6, -1.0, 40e6]
    batch = gb.solve_many(footing, {"load[0]": force, "k": k}, at=[0.0, 6.0])
    assert batch.status.tolist() == ["solved", "no-equilibrium", "wrong", "wrong"]
    assert np.isnan(batch["moment"][1:]).all() and np.isfinite(batch["moment"][0]).all()
    assert batch.messages[0] is None
    assert "lifts the beam" in str(batch.messages[1]) and "positive" in str(batch.messages[2])
    alone = footing.with_load(gb.Load.point(-5.9e6, 1.5))
    with pytest.raises(gb.NoEquilibrium) as caught:
        alone.solve()
    motion = (caught.value.left, caught.value.right, caught.value.work)
    np.testing.assert_allclose(batch.motion[1], motion, rtol=1e-12)
    assert np.isnan(batch.motion[0]).all() and batch.contact(1) == []
    table = batch.to_pandas()
    assert table["status"].tolist() == batch.status.tolist() and len(table) == 4


def test_parameters_can_vary_along_the_beam() -> None:
    bare = gb.Model(gb.Beam(10.0, 1e8), gb.Foundation(1e7, 1e6), loads=[gb.Load.point(1e5, 3.0)])
    k = np.array([[1e7, 2e7, 3e7], [3e7, 1e7, 1e7]])
    mu = np.array([[1e6, 2e6, 1e6]])
    stiffness = np.array([[1e8, 1e8, 2e8, 1e8, 3e8], [1e8, 2e8, 1e8, 1e8, 1e8]])
    x = np.linspace(0.0, 10.0, 11)
    batch = gb.solve_many(bare, {"k": gb.Points(k), "mu": gb.Points(mu), "EI": gb.Points(stiffness)}, at=x)
    assert batch.solved.all()
    for number in range(2):
        ground: list[Mapping[str, Value]] = [
            {"from": 5.0 * i, "to": 5.0 * (i + 1), "k": k[number, i : i + 2], "mu": mu[0, i : i + 2]}
            for i in range(2)
        ]
        beam: list[Mapping[str, Value]] = [
            {"from": 2.5 * i, "to": 2.5 * (i + 1), "EI": stiffness[number, i : i + 2]}
            for i in range(4)
        ]
        model = gb.Model(
            gb.Beam(10.0, 1e8, segments=beam),
            gb.Foundation(1e7, 1e6, segments=ground),
            loads=[gb.Load.point(1e5, 3.0)],
        )
        # A model file writes each side of a joint separately; the numbers here are the same.
        np.testing.assert_array_equal(batch["moment"][number], model.solve().moment(x))
    constant = gb.solve_many(bare, {"k": gb.Points(np.full(9, 1e7))}, at=x)
    np.testing.assert_allclose(
        constant["moment"][0], bare.solve().moment(x), rtol=0, atol=1e-9 * 1e5
    )


LOADS = [gb.Load.point(1e5, 3.0), gb.Load.uniform(1e3, 0.0, 10.0)]
X = np.linspace(0.0, 10.0, 11)


def solved(parameters: Parameters) -> Array:
    model = gb.Model(gb.Beam(10.0, 1e8), gb.Foundation(1e7, 1e6), loads=LOADS)
    return gb.solve_many(model, parameters, at=X)["deflection"]


def test_control_values_have_the_meaning_that_they_have_in_a_model() -> None:
    rows = np.array([[40e6, 8e6, 40e6], [40e6, 10e6, 20e6]])
    found = solved({"k": gb.ControlValues(rows)})
    stiff = np.array([[1e8, 3e8, 2e8, 1e8], [2e8, 1e8, 2e8, 4e8]])
    of_beam = solved({"EI": gb.ControlValues(stiff)})
    for number in range(2):
        model = gb.Model(gb.Beam(10.0, 1e8), gb.Foundation(rows[number], 1e6), loads=LOADS)
        np.testing.assert_array_equal(found[number], model.solve().deflection(X))
        model = gb.Model(gb.Beam(10.0, stiff[number]), gb.Foundation(1e7, 1e6), loads=LOADS)
        np.testing.assert_array_equal(of_beam[number], model.solve().deflection(X))
    points = solved({"k": gb.Points(rows)})
    assert (np.abs(points / found - 1.0).max(axis=1) > 0.05).all(), "the shapes differ"
    one_for_all = solved({"k": gb.ControlValues(rows[0]), "mu": np.array([1e6, 2e6])})
    np.testing.assert_array_equal(one_for_all[0], found[0])


def test_two_values_mean_the_same_with_and_without_a_shape() -> None:
    k = np.array([[1e7, 4e7], [4e7, 2e7]])
    bare = solved({"k": k})
    np.testing.assert_array_equal(solved({"k": gb.Points(k)}), bare)
    np.testing.assert_array_equal(solved({"k": gb.ControlValues(k)}), bare)
    model = gb.Model(gb.Beam(10.0, 1e8), gb.Foundation(k[1], 1e6), loads=LOADS)
    np.testing.assert_array_equal(bare[1], model.solve().deflection(X))


def test_k_and_mu_can_vary_along_the_beam_in_different_ways() -> None:
    k, mu = [40e6, 8e6, 40e6], [1e6, 2e6]
    found = solved({"k": gb.ControlValues(k), "mu": np.array([mu])})
    model = gb.Model(gb.Beam(10.0, 1e8), gb.Foundation(k, mu), loads=LOADS)
    np.testing.assert_array_equal(found[0], model.solve().deflection(X))
    steps = [1e6, 2e6, 3e6, 2e6]
    found = solved({"k": gb.ControlValues(k), "mu": gb.Steps(steps)})
    segments: list[Mapping[str, Value]] = [
        {"from": 2.5 * i, "to": 2.5 * (i + 1), "mu": each} for i, each in enumerate(steps)
    ]
    model = gb.Model(gb.Beam(10.0, 1e8), gb.Foundation(k, segments=segments), loads=LOADS)
    np.testing.assert_array_equal(found[0], model.solve().deflection(X))


def test_steps_are_segments() -> None:
    k = [1e7, 4e7, 2e7, 3e7]
    segments: list[Mapping[str, Value]] = [
        {"from": 2.5 * i, "to": 2.5 * (i + 1), "k": each, "mu": 1e6} for i, each in enumerate(k)
    ]
    model = gb.Model(gb.Beam(10.0, 1e8), gb.Foundation(1e7, 1e6, segments=segments), loads=LOADS)
    np.testing.assert_array_equal(solved({"k": gb.Steps(k)})[0], model.solve().deflection(X))


def test_factors_multiply_the_values_of_the_model() -> None:
    model = gb.Model(
        gb.Beam(10.0, 1e8, segments=[{"from": 2.0, "to": 4.0, "EI": 5e8}]),
        gb.Foundation(1e7, 1e6, segments=[{"from": 6.0, "to": 10.0, "k": 4e7, "mu": 1e6}]),
        loads=[gb.Load.point(1e5, 3.0)],
    )
    same: Mapping[str, npt.ArrayLike] = {"k_factor": [2.0], "mu_factor": 2.0, "EI_factor": 2.0, "load_factor": [1.0, 2.0]}
    batch = gb.solve_many(model, same, at=[1.0, 5.0])
    # With everything twice as stiff the settlement is half as large; under twice the loads it is the same
    # again, bit for bit.
    alone = model.solve().deflection([1.0, 5.0])
    np.testing.assert_array_equal(batch["deflection"], [alone / 2.0, alone])
    with pytest.raises(ValueError, match="k_factor"):
        gb.solve_many(model, {"k": [1e7]})


@pytest.mark.parametrize(
    "parameters, words",
    [
        ({"K": [1.0]}, "unknown name"),
        ({"load[2]": [1.0]}, "numbered from 0, and the model has 2"),
        ({"load[0].from": [1.0]}, "no such number"),
        ({"load[0]": [[1.0, 2.0]]}, "one number for each model"),
        ({"k": [1.0, 2.0], "mu": [1.0, 2.0, 3.0]}, "differ in length: k: 2, mu: 3"),
        ({"k": gb.Points([1.0, 2.0, 3.0]), "mu": gb.Steps([[1.0, 2.0, 3.0]])}, "2 stretches along the beam and `mu` has 3"),
        ({"k": [[1.0, 2.0, 3.0]]}, "groundbeam.Points(values) .* groundbeam.ControlValues(values)"),
        ({"EI": np.ones((4, 3))}, "groundbeam.Points(values) .* groundbeam.ControlValues(values)"),
        ({"mu": gb.ControlValues([1.0, 2.0, 3.0, 4.0])}, "at most 3 control values, but 4 are given"),
        ({"EI": gb.ControlValues(np.ones((2, 7)))}, "at most 6 control values, but 7 are given"),
        ({"load[0]": gb.Points([1.0, 2.0, 3.0])}, "one number for each model"),
        ({"k": [1.0, 2.0], "mu": gb.Points(np.ones((3, 4)))}, "differ in length: k: 2, mu: 3"),
        ({"load[1].start": [1.0], "load[1]": [2.0]}, "`load[1].start` and `load[1]` set the same number"),
        ({"load[1]": [2.0], "load[1].start": [1.0]}, "`load[1]` and `load[1].start` set the same number"),
        ({"k": gb.Points([1.0, 2.0, 3.0]), "k[]": [1.0]}, "`k` and `k[]` set the same number"),
        ({"k": [[[1.0]]]}, "one row of values along the beam"),
        ({"k": ["40 MN/m^2"]}, "`k`: takes numbers in SI units"),
    ],
)
def test_wrong_parameters_are_refused(
    footing: gb.Model, parameters: Parameters, words: str
) -> None:
    with pytest.raises(ValueError, match=re.sub(r"([\[(])", r"\\\1", words).replace("values)", r"values\)")):
        gb.solve_many(footing, parameters)


def test_a_pandas_table_can_hold_the_parameters(footing: gb.Model) -> None:
    table = pandas.DataFrame({"k": [4e7, 5e7], "mu": [9e6, 8e6]})
    of_table = gb.solve_many(footing, table, at=[1.0], fields="moment", extremes="moment")
    of_arrays = gb.solve_many(footing, {"k": [4e7, 5e7], "mu": [9e6, 8e6]}, at=[1.0])
    np.testing.assert_array_equal(of_table["moment"], of_arrays["moment"])
    assert list(of_table) == list(of_table.extremes) == ["moment"]


def test_positions_off_the_beam_are_refused(footing: gb.Model) -> None:
    for off in (-0.1, 12.1, float("nan")):
        with pytest.raises(ValueError, match="outside the beam"):
            gb.solve_many(footing, at=[1.0, off])
    beside = gb.solve_many(footing, at=[12.5], fields="settlement")
    assert beside["settlement"][0, 0] == footing.solve().settlement(12.5)
    longer = gb.Model(gb.Beam(15.0, 1e9), gb.Foundation(4e7), loads=[gb.Load.point(1e5, 7.0)])
    both = gb.solve_many([footing, longer], at=[13.0])
    assert np.isnan(both["moment"][0, 0]) and np.isfinite(both["moment"][1, 0])


def test_progress_is_reported_and_can_stop_a_batch(footing: gb.Model) -> None:
    told: list[tuple[int, int]] = []
    gb.solve_many(footing, {"k": np.full(50, 4e7)}, progress=lambda *how: told.append(how))
    assert told[-1] == (50, 50)

    def stop(done: int, count: int) -> None:
        raise KeyboardInterrupt

    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        gb.solve_many(footing, {"k": np.full(2_000_000, 4e7)}, threads=1, progress=stop)
    assert time.monotonic() - began < 20.0


def test_a_progress_bar_is_drawn_for_long_batches(
    footing: gb.Model, capsys: pytest.CaptureFixture[str]
) -> None:
    from groundbeam._batch import _Bar

    bar = _Bar()
    bar(1, 4)
    bar(4, 4)
    assert capsys.readouterr().err == "", "what is done in a second needs no bar"
    bar.began -= 10.0
    bar(1, 4)
    bar(4, 4)
    drawn = capsys.readouterr().err
    assert "1 of 4, 30 s left" in drawn and drawn.endswith("4 of 4, 0 s left \n")
    assert gb.solve_many(footing, {"k": [4e7]}, progress=True).count == 1
