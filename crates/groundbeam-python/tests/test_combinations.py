"""Tests combinations of load cases and their envelope."""

from __future__ import annotations

import json
from pathlib import Path

import groundbeam as gb
import numpy as np
import pytest
from conftest import REPOSITORY


def crane(uplift: float) -> gb.Model:
    return gb.Model(
        gb.Beam(12.0, 1.28e9),
        gb.Foundation(40e6, 9e6),
        loads=[
            gb.Load.point(600e3, 6.0, case="G"),
            gb.Load.point(300e3, 2.0, case="Q"),
            gb.Load.moment(uplift, 6.0, case="W"),
        ],
        combinations=[
            gb.Combination("dead", {"G": 1.35}),
            gb.Combination("live", {"G": 1.0, "Q": 1.5}),
            gb.Combination("wind", {"G": 0.9, "W": 1.5}),
        ],
    )


def test_each_combination_is_the_model_with_its_factors() -> None:
    model = crane(1000e3)
    assert [c.table["name"] for c in model.combinations()] == ["dead", "live", "wind"]
    with pytest.raises(ValueError, match="solve_combinations"):
        model.solve()
    combined = model.solve_combinations()
    assert list(combined) == ["dead", "live", "wind"] and len(combined.solutions) == 3
    assert combined.load_cases == {"G": True, "Q": True, "W": False}
    by_hand = gb.Model(
        gb.Beam(12.0, 1.28e9),
        gb.Foundation(40e6, 9e6),
        loads=[gb.Load.point(600e3, 6.0), gb.Load.point(450e3, 2.0)],
    ).solve()
    x = np.linspace(0.0, 12.0, 25)
    live = combined.solutions["live"]
    assert live.combination == "live"
    np.testing.assert_array_equal(live.moment(x), by_hand.moment(x))
    np.testing.assert_array_equal(model.solve(combination="live").moment(x), by_hand.moment(x))


def test_the_envelope_is_the_range_of_all_solutions() -> None:
    combined = crane(1000e3).solve_combinations()
    x = np.linspace(0.05, 11.95, 101)
    values = np.array([solution.moment(x) for solution in combined.solutions.values()])
    envelope = combined.envelope("moment", x)
    np.testing.assert_allclose(envelope.min.values, values.min(axis=0), rtol=1e-12)
    np.testing.assert_allclose(envelope.max.values, values.max(axis=0), rtol=1e-12)
    names = np.array(list(combined))
    assert envelope.max.governs == names[values.argmax(axis=0)].tolist()
    with pytest.raises(ValueError, match="outside the beam"):
        combined.envelope("moment", 13.0)


def test_a_combination_that_tips_does_not_stop_the_others() -> None:
    combined = crane(4000e3).solve_combinations()
    assert list(combined.solutions) == ["dead", "live"]
    wind = combined["wind"]
    assert isinstance(wind, gb.NoEquilibrium) and wind.work > 0.0
    document = json.loads(combined.to_json())
    assert document["status"] == "no-equilibrium"
    assert [each["status"] for each in document["combinations"]] == ["solved", "solved", "no-equilibrium"]
    assert "wind" in str(combined) and combined.to_svg().startswith("<svg")
    assert "moment_max_Nm" in combined.to_pandas().columns
    assert "2 of 3" in repr(combined)


def test_the_combinations_of_the_example_file_are_solved() -> None:
    model = gb.load(REPOSITORY / "docs" / "combinations.toml")
    combined = model.solve_combinations()
    assert len(combined) == len(model.combinations()) > 1


def test_a_model_without_combinations_is_refused(footing: gb.Model) -> None:
    with pytest.raises(ValueError, match="no combinations"):
        footing.solve_combinations()
    with pytest.raises(gb.ModelError, match="no combination has the name"):
        footing.solve(combination="ULS")


def test_a_model_with_trains_is_not_solved_without_them() -> None:
    def alone(path: Path) -> bool:
        text = path.read_text("utf-8", "replace")
        return "[[train]]" in text and "[[combination]]" not in text and "errors" not in path.parts

    passing = [path for path in sorted((REPOSITORY / "cases").rglob("*.toml")) if alone(path)]
    assert passing
    for path in passing:
        with pytest.raises(ValueError, match="train|combinations"):
            gb.load(path).solve()
