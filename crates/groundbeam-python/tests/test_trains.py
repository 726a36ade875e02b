"""Tests trains, bands of grounds and comparisons of methods."""

from __future__ import annotations

import json
from typing import Any, Mapping

import numpy as np
import pytest

import groundbeam as gb

EI, K, FORCE = 6.4e6, 40e6, 100e3
RAIL: dict[str, object] = {
    "beam": {"length": 20.0, "EI": EI},
    "foundation": {"k": K},
    "load": [{"distributed": 40e3}],
}
WHEEL = {"name": "wheel", "axles": [{"at": 0.0, "force": FORCE}]}


def rail(**more: object) -> gb.Model:
    tables: Mapping[str, object] = {**RAIL, **more}
    return gb.Model.from_dict(tables)  # type: ignore[arg-type]


def beta() -> float:
    return float((K / (4.0 * EI)) ** 0.25)


def test_a_wheel_on_a_rail_has_the_moment_of_zimmermann() -> None:
    """M = F/(4 beta) under a wheel on an infinite rail that its weight keeps in contact."""
    passages = rail(train=[WHEEL]).solve_trains()
    [passage] = passages
    assert (passage.combination, passage.train, passage.range) == (None, "wheel", (0.0, 20.0))
    assert passage.without_equilibrium == [] and passage.not_converged == []
    low, high = passages.envelope("moment", [9.0, 10.0])
    assert np.allclose(high.values, FORCE / (4.0 * beta()), rtol=1e-3)
    assert np.allclose(high.first_axle, [9.0, 10.0]) and high.passage == [0, 0]
    assert np.allclose(low.values, -np.exp(-np.pi / 2.0) * FORCE / (4.0 * beta()), rtol=1e-3)
    at, solution = passage.nearest(10.0)
    assert at in passage.positions and abs(at - 10.0) < 0.2
    assert abs(solution.range("moment").max.x - at) < 1e-9
    document = json.loads(passages.to_json())
    assert document["status"] == "solved" and document["train"]["name"] == "wheel"
    assert "wheel" in str(passages) and passages.to_svg().startswith("<svg")
    assert "moment_max_Nm" in passages.to_pandas().columns


def test_any_number_of_threads_gives_trains_on_combinations_the_same_bits() -> None:
    model = rail(
        load=[{"distributed": 40e3, "case": "G"}],
        train=[WHEEL, {**WHEEL, "name": "second"}],
        combination=[{"name": "a", "factors": {"G": 1.0}}, {"name": "b", "factors": {"G": 1.5}}],
    )
    one, two = (model.solve_trains(threads=threads) for threads in (1, 2))
    assert [(p.combination, p.train) for p in one] == [
        ("a", "wheel"),
        ("a", "second"),
        ("a", "no train"),
        ("b", "wheel"),
        ("b", "second"),
        ("b", "no train"),
    ]
    assert one.to_csv() == two.to_csv()
    assert [p.combination for p in model.solve_trains(combination="b")] == ["b", "b", "b"]


def test_a_slab_tips_at_the_position_given_by_statics() -> None:
    tables = {
        "beam": {"length": 10.0, "EI": 1e9},
        "foundation": {"k": 40e6, "mu": 4e6},
        "load": [{"distributed": 2.65e3}],
        "train": [
            {
                "axles": [{"at": 0.0, "force": 20e3}, {"at": 9.0, "force": -15e3}],
                "from": 9.0,
                "to": 10.0,
            }
        ],
    }
    [passage] = gb.Model.from_dict(tables).solve_trains()  # type: ignore[arg-type]
    edge = 10.0 - (0.75 * 9.0 * 20e3 - 0.5 * 2.65e3 * 100.0) / (0.25 * 20e3)
    [(start, end)] = passage.without_equilibrium
    assert abs(start - edge) < 1e-7 and end == 10.0


def test_a_model_without_trains_is_refused() -> None:
    with pytest.raises(ValueError, match="no trains"):
        rail().solve_trains()
    with pytest.raises(ValueError, match="solve_trains"):
        rail(train=[WHEEL]).solve()


def test_a_band_of_ground_stiffnesses_has_its_closed_form() -> None:
    """M = P/(4 beta), with half and twice k."""
    model = rail(
        load=[{"point": FORCE, "at": 10.0}, {"distributed": 40e3}],
        foundation={"k": K, "band": {"k": [0.5, 2.0]}},
    )
    band = model.solve_combinations().band("moment")
    assert band.max.low < band.max.best < band.max.high
    assert abs(band.max.best / (FORCE / (4.0 * beta())) - 1.0) < 1e-3
    assert abs(band.max.high / band.max.best - 2.0**0.25) < 1e-2
    combined = rail(
        load=[{"distributed": 40e3, "case": "G"}],
        combination=[{"name": "a", "factors": {"G": 1.0}}],
    ).solve_combinations()
    with pytest.raises(ValueError, match=r"no \[foundation\.band\]"):
        combined.band("moment")


def test_methods_agree() -> None:
    compared = rail(load=[{"point": FORCE, "at": 10.0}]).compare(elements=200)
    assert list(compared)[0] == "exact" and "active-set" in compared
    assert compared["exact"].errors == gb.MethodErrors(0.0, 0.0, 0.0, 0.0)
    errors = compared["active-set"].errors
    assert errors is not None and errors.deflection < 1e-2
    assert "active-set" in str(compared)
    assert json.loads(compared.to_json())["methods"][0]["method"] == "exact"


def test_a_model_that_tips_is_not_compared() -> None:
    with pytest.raises(gb.NoEquilibrium):
        rail(load=[{"moment": 1e6, "at": 10.0}]).compare()


@pytest.mark.parametrize("x", [25.0, -5.0, float("nan"), [10.0, 25.0]])
def test_the_envelope_of_trains_refuses_positions_off_the_beam(x: Any) -> None:
    with pytest.raises(ValueError, match="outside the beam, which extends from 0 to 20"):
        rail(train=[WHEEL]).solve_trains().envelope("moment", x)


@pytest.mark.parametrize("first_axle", [float("nan"), float("inf"), -float("inf")])
def test_no_solved_position_is_nearest_to_a_number_that_is_not_finite(first_axle: float) -> None:
    [passage] = rail(train=[WHEEL]).solve_trains()
    with pytest.raises(ValueError, match="give a finite number"):
        passage.nearest(first_axle)


def test_one_answer_leaves_a_train_out_only_for_a_chosen_combination() -> None:
    model = rail(load=[{"distributed": 40e3, "case": "G"}], train=[WHEEL])
    for call in (model.solve, model.compare, lambda: gb.solve_many(model)):
        with pytest.raises(ValueError, match=r"use solve_trains\(\)"):
            call()
    combined = rail(
        load=[{"distributed": 40e3, "case": "G"}],
        train=[WHEEL],
        combination=[{"name": "a", "factors": {"G": 1.0}}],
    )
    [alone] = combined.solve_combinations().solutions.values()
    assert alone.deflection(4.0) == combined.solve(combination="a").deflection(4.0)
