"""Tests calibration with synthetic measurements of known parameters, with noise.

Claims: `docs/derivatives.md`.
"""

from __future__ import annotations

from typing import Any

import groundbeam as gb
import numpy as np
import pytest
from groundbeam._solution import Array

X = np.linspace(0.0, 12.0, 13)
TRUTH = {"k": 40e6, "mu": 9e6}


def guess(footing: gb.Model) -> gb.Model:
    return gb.Model(
        gb.Beam(12.0, 1.28e9),
        gb.Foundation(10e6, 30e6),
        loads=[gb.Load.point(900e3, 1.5), gb.Load.distributed(10e3, 0.0, 12.0)],
    )


def settled(model: gb.Model) -> Array:
    return np.asarray(model.solve().deflection(X))


def test_the_true_parameters_are_found_without_noise(footing: gb.Model) -> None:
    found = gb.calibrate(guess(footing), {"deflection": (X, settled(footing))}, ["k", "mu"], noise=1e-5)
    for name, true in TRUTH.items():
        assert found.values[name] == pytest.approx(true, rel=1e-7)
    assert found.steps < 40 and found.unidentified == [] and found.at_bound == []
    assert np.abs(found.residuals["deflection"]).max() < 1e-10


def test_standard_errors_cover_the_true_parameters(footing: gb.Model) -> None:
    """Of 300 results, 68 % lie within one standard error and 95 % within two, up to three standard deviations of
    such a count."""
    exact, model, noise = settled(footing), guess(footing), 3e-5
    inside = {name: np.zeros(2) for name in TRUTH}
    seeds = 300
    for seed in range(seeds):
        measured = exact + np.random.default_rng(seed).normal(0.0, noise, X.size)
        found = gb.calibrate(model, {"deflection": (X, measured)}, ["k", "mu"], noise=noise)
        for name, true in TRUTH.items():
            off = abs(found.values[name] - true) / found.standard_errors[name]
            inside[name] += [off < 1.0, off < 2.0]
    for counts in inside.values():
        for count, share in zip(counts, (0.683, 0.954)):
            assert abs(count / seeds - share) < 3.0 * np.sqrt(share * (1.0 - share) / seeds)


def test_the_noise_is_estimated(footing: gb.Model) -> None:
    noise = 3e-5
    estimates = []
    for seed in range(40):
        measured = settled(footing) + np.random.default_rng(seed).normal(0.0, noise, X.size)
        estimates.append(gb.calibrate(footing, {"deflection": (X, measured)}, ["k", "mu"]).noise)
    assert np.sqrt(np.mean(np.square(estimates))) == pytest.approx(noise, rel=0.1)


def test_parameters_that_are_not_identifiable_are_named(footing: gb.Model) -> None:
    """The settlement of a very stiff beam does not depend on EI, and only weakly on the shear layer beside the
    spring."""
    stiff = gb.Model(
        gb.Beam(4.0, 1e12), gb.Foundation(40e6, 9e6), loads=[gb.Load.point(900e3, 2.0)]
    )
    x = np.array([0.0, 1.0, 2.0, 3.0, 4.0])
    measured = np.asarray(stiff.solve().deflection(x))
    found = gb.calibrate(stiff, {"deflection": (x, measured)}, ["k", "mu", "EI"], noise=1e-5)
    assert sorted(found.unidentified) == ["EI", "mu"]
    assert found.singular_values[0] > 10.0 > 1.0 > found.singular_values[1]
    # Ends that settle as much as the middle determine only one combination of k and mu.
    middle = gb.calibrate(
        stiff, {"deflection": ([2.0, 2.0], [measured[2]] * 2)}, ["k", "mu"], noise=1e-7
    )
    [combination] = middle.unidentified
    assert combination in ("mu up with k down", "k down with mu up", "k up with mu down", "mu")


def test_parameters_stay_within_their_bounds(footing: gb.Model) -> None:
    found = gb.calibrate(
        footing,
        {"deflection": (X, settled(footing))},
        ["k", "mu"],
        noise=1e-5,
        bounds={"k": (20e6, 30e6)},
        start={"k": 25e6},
    )
    assert found.values["k"] == 30e6 and found.at_bound == ["k"]
    assert np.isnan(found.standard_errors["k"]) and found.standard_errors["mu"] > 0.0


def test_several_kinds_of_measurements_determine_unknown_loads(footing: gb.Model) -> None:
    exact = footing.solve()
    measured: dict[str, Any] = {
        "deflection": (X[::4], exact.deflection(X[::4])),
        "end_force.left": exact.end_forces.left,
    }
    found = gb.calibrate(
        footing,
        measured,
        ["load[0]", "load[0].at"],
        noise={"deflection": 1e-5, "end_force.left": 1e3},
        start={"load[0]": 700e3, "load[0].at": 2.0},
    )
    assert found.values["load[0]"] == pytest.approx(900e3, rel=1e-6)
    assert found.values["load[0].at"] == pytest.approx(1.5, rel=1e-6)


@pytest.mark.parametrize(
    ("measured", "unknown", "why"),
    [
        ({}, ["k"], "nothing was measured"),
        ({"deflection": (X, X[:3])}, ["k"], "13 positions but 3 values"),
        ({"deflection": ([1.0], [1e-3])}, ["k", "mu"], "cannot determine 2 unknowns"),
        ({"deflection": (X, X)}, [], "names of one or more"),
        ({"deflection": (X, X)}, ["kk"], "unknown name"),
        ({"largest moment": 1.0, "deflection": (X, X)}, ["k"], "need `noise`"),
    ],
)
def test_invalid_calibrations_are_refused(
    footing: gb.Model, measured: dict[str, Any], unknown: list[str], why: str
) -> None:
    with pytest.raises(ValueError, match=why):
        gb.calibrate(footing, measured, unknown)


def test_noise_is_given_for_each_kind_of_measurement(footing: gb.Model) -> None:
    solution = footing.solve()
    measured = {"deflection": (X, solution.deflection(X)), "slope": (X, solution.slope(X))}
    with pytest.raises(ValueError, match="noise of `slope`: give its standard deviation"):
        gb.calibrate(footing, measured, ["k"], noise={"deflection": 1e-4})
    with pytest.raises(ValueError, match="noise of `gap`: nothing of this name was measured"):
        gb.calibrate(footing, measured, ["k"], noise={"deflection": 1e-4, "slope": 1e-4, "gap": 1e-4})


def test_a_model_with_combinations_needs_one_of_them() -> None:
    loads = [gb.Load.point(600e3, 6.0, case="G"), gb.Load.moment(1e6, 6.0, case="W")]
    combinations = [gb.Combination("a", {"G": 1.0}), gb.Combination("b", {"G": 1.0, "W": 1.0})]
    model = gb.Model(
        gb.Beam(12.0, 1.28e9), gb.Foundation(40e6, 9e6), loads=loads, combinations=combinations
    )
    measured = {"deflection": (X, model.solve(combination="a").deflection(X))}
    with pytest.raises(ValueError, match=r"2 combinations: use calibrate\(combination='a'\)"):
        gb.calibrate(model, measured, ["k"])
    found = gb.calibrate(model, measured, ["k"], start={"k": 30e6}, combination="a")
    assert found.values["k"] == pytest.approx(40e6, rel=1e-7)


def test_the_message_about_an_invalid_calibration_names_its_remedy(footing: gb.Model) -> None:
    for x in (15.0, float("nan")):
        why = "measured `deflection`: a position lies outside the beam, which extends from 0 to 12"
        with pytest.raises(ValueError, match=why):
            gb.calibrate(footing, {"deflection": ([x], [1e-3])}, ["k"])
    with pytest.raises(ValueError, match="measured `settlement`: a position is not a number"):
        gb.calibrate(footing, {"settlement": ([float("nan")], [1e-3])}, ["k"])
    with pytest.raises(ValueError, match=r"`unknown` must be a list of names, as in \['mu'\]"):
        gb.calibrate(footing, {"deflection": (X, X)}, "mu")


def test_settlements_beside_the_beam_determine_the_ground(footing: gb.Model) -> None:
    beside = np.array([-2.0, -1.0, -0.5])
    measured = {"settlement": (beside, footing.solve().settlement(beside))}
    found = gb.calibrate(guess(footing), measured, ["k", "mu"], noise=1e-6)
    for name, true in TRUTH.items():
        assert found.values[name] == pytest.approx(true, rel=1e-6)
