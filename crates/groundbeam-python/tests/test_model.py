"""Tests models built in code and read from files, and messages about invalid ones."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import groundbeam as gb
import numpy as np
import pytest
from conftest import REPOSITORY
from groundbeam._tables import Tables

CASES = sorted(
    path
    for path in (REPOSITORY / "cases").rglob("*.toml")
    if "errors" not in path.parts
)


def test_a_model_in_code_equals_the_file_bit_for_bit() -> None:
    in_code = gb.Model(
        gb.Beam("12 m", E="30 GPa", section={"width": "1 m", "height": 0.8}),
        gb.Foundation(subgrade_modulus="40 MN/m^3", width=1, mu=9e6),
        loads=[gb.Load.point("900 kN", at=1.5), gb.Load.distributed(np.float64(10e3))],
        title="Strip footing, heavy column near its left end",
    )
    of_file = gb.load(REPOSITORY / "docs" / "strip-footing.toml")
    assert in_code.title == of_file.title
    x = np.linspace(0.0, 12.0, 37)
    for one, other in zip(in_code.solve().at(x), of_file.solve().at(x)):
        np.testing.assert_array_equal(one, other)


def test_ground_loads_troughs_trains_and_checks_equal_those_of_a_file() -> None:
    """In the arguments of a model, added to a model, and as tables of a file."""
    beam, foundation = gb.Beam("20 m", EI="6 GN m^2"), gb.Foundation(k="40 MN/m^2", mu="2 MN")
    weight = gb.Load.distributed("30 kN/m", case="G")
    neighbour = gb.GroundLoad.point("10 kN", at="-1 m", case="G")
    backfill = gb.GroundLoad.distributed(["0 kN/m", "5 kN/m"], "20 m", "23 m")
    trough = gb.Trough("6 m", "5 mm", "3 m")
    uniform = [{"from": "3 m", "load": "4 kN/m"}]
    train = gb.Train([("0 m", "80 kN"), ("2 m", "80 kN")], name="bogie", uniform=uniform, end="3 m", dynamic=1.1)
    checks = gb.Checks(settlement="5 mm", limit_states={"settlement": ["STR/GEO", "SLS frequent"]})
    service = gb.Combination("service", {"G": 1.0}, limit_state="SLS frequent")
    at_once = gb.Model(
        beam,
        foundation,
        loads=[weight],
        ground_loads=[neighbour, backfill],
        troughs=[trough],
        trains=[train],
        combinations=[service],
        checks=checks,
    )
    added = gb.Model(beam, foundation, loads=[weight], combinations=[service])
    added = added.with_ground_load(neighbour).with_ground_load(backfill).with_trough(trough)
    added = added.with_train(train).with_checks(checks)
    in_file = gb.Model.from_dict(
        {
            "beam": {"length": 20, "EI": 6e9},
            "foundation": {"k": 40e6, "mu": 2e6},
            "load": [{"distributed": 30e3, "case": "G"}],
            "ground_load": [
                {"point": 10e3, "at": -1, "case": "G"},
                {"distributed": [0, 5e3], "from": 20, "to": 23},
            ],
            "gap_trough": [{"at": 6, "settlement": 0.005, "width": 3}],
            "train": [
                {
                    "name": "bogie",
                    "axles": [{"at": 0, "force": 80e3}, {"at": 2, "force": 80e3}],
                    "uniform": [{"from": 3, "load": 4e3}],
                    "to": 3,
                    "dynamic": 1.1,
                }
            ],
            "combination": [{"name": "service", "limit_state": "SLS frequent", "factors": {"G": 1}}],
            "checks": {"settlement": 0.005, "limit_states": {"settlement": ["STR/GEO", "SLS frequent"]}},
        }
    )
    documents = []
    for model in (at_once, added, in_file):
        combined = model.solve_combinations()
        assert combined.limit_states == ["SLS frequent"]
        checked = json.loads(combined.to_json())["checks"]
        passages = model.solve_trains()
        assert passages.limit_states == ["SLS frequent"]
        moment = passages.envelope("moment", 4.0, limit_state="SLS frequent")
        assert moment.max.values == passages.envelope("moment", 4.0).max.values
        with pytest.raises(ValueError, match="no solved combination belongs to EQU"):
            passages.envelope("moment", 4.0, limit_state="EQU")
        documents.append((checked, moment.max.values.tolist(), moment.max.first_axle.tolist()))
    assert documents[0] == documents[1] == documents[2]
    [check] = documents[0][0]
    assert check["limit_state"] == "SLS frequent" and check["passes"] in (True, False)
    with pytest.raises(gb.ModelError):
        added.with_checks(checks)


def test_every_kind_of_part_can_be_built_in_code() -> None:
    model = gb.Model(
        gb.Beam(8.0, 1e8, axial_force="10 kN", segments=[{"from": 0, "to": "2 m", "EI": [2e8, 1e8]}]),
        gb.Foundation("10 MN/m^2", 1e6, segments=[{"from": 5, "to": 8, "k": 2e7, "mu": 1e6}]),
        loads=[
            gb.Load.point(100e3, 1.0),
            gb.Load.moment("5 kN m", 2.0),
            gb.Load.distributed(["1 kN/m", 2e3], 1, "3 m"),
            gb.Load.distributed_moment("1 kN m/m"),
        ],
        supports=[gb.Support.pinned(8.0), gb.Support.spring(4.0, "1 MN/m", 1e6)],
        gap=[(0, "1 mm"), ("4 m", 0.0)],
    )
    solution = model.solve()
    assert [reaction.at for reaction in solution.reactions] == [8.0, 4.0]
    loads = 100e3 + 1.5e3 * 2
    pushed = sum(solution.end_forces) + sum(r.force for r in solution.reactions)
    pushed += sum(force.force for force in solution.concentrated_forces)
    assert abs(solution.deflection(8.0)) < 1e-12
    # Simpson's rule between stations: the fields are smooth there.
    x = np.union1d(solution.stations(400), np.linspace(0.0, 8.0, 4001))
    left, right = solution.pressure(x, "right")[:-1], solution.pressure(x, "left")[1:]
    middle = solution.pressure((x[1:] + x[:-1]) / 2)
    pushed += float(np.sum(np.diff(x) * (left + 4.0 * middle + right) / 6.0))
    assert pushed == pytest.approx(loads, rel=1e-9)


def test_hinges_and_one_way_supports() -> None:
    model = gb.Model(
        gb.Beam(10.0, 1e8),
        gb.Foundation(1e7, 1e6),
        loads=[
            gb.Load.point("100 kN", 2.0),
            gb.Load.point("100 kN", 8.0),
            gb.Load.curvature("1e-4 1/m", 7.0, 10.0),
        ],
        supports=[gb.Support.pinned("10 m", acts="up"), gb.Support.pinned(0, settlement="1 mm")],
        hinges=[gb.Hinge(4.0), gb.Hinge("6 m", "5 MN m/rad")],
    )
    solution = model.solve()
    free, spring = solution.hinges
    assert (free.at, spring.at) == (4.0, 6.0)
    assert free.moment == pytest.approx(0.0, abs=1e-6)
    assert spring.moment == pytest.approx(-5e6 * spring.rotation, rel=1e-9)
    jump = solution.slope(4.0) - solution.slope(4.0, "left")
    assert free.rotation == pytest.approx(jump, rel=1e-9)
    assert solution.deflection(0.0) == pytest.approx(1e-3, rel=1e-9)
    assert solution.reactions[0].force >= 0.0
    loose = gb.Model(
        gb.Beam(10.0, 1e8),
        gb.Foundation(1e7, 1e6),
        loads=[gb.Load.point(1e5, 2.0), gb.Load.point(1e5, 8.0), gb.Load.point(-2e4, 5.0)],
    ).with_hinge(gb.Hinge(5.0))
    with pytest.raises(gb.NoEquilibrium) as caught:
        loose.with_load(gb.Load.point(-2e5, 5.0)).solve()
    assert caught.value.hinges == (-1.0,) and len(caught.value.static_reactions) == 3


def test_a_model_can_be_built_from_a_dictionary() -> None:
    tables: Tables = {
        "title": 'A "quoted" title',
        "beam": {"length": 1, "EI": 1.0},
        "foundation": {"k": 1, "mu": 1},
        "load": [{"point": 1, "at": 0.5}, {"moment": 0.49, "at": "50 cm"}],
    }
    model = gb.Model.from_dict(tables)
    assert model.title == 'A "quoted" title'
    [(start, end)] = model.solve().contact
    # Kikuchi's case IV, in 60-digit arithmetic.
    assert start == pytest.approx(0.811326256449155, abs=1e-14)
    assert end == 1.0


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_every_case_of_the_repository_is_read(path: Path) -> None:
    model = gb.load(path)
    assert model.length > 0.0
    again = pickle.loads(pickle.dumps(model))
    assert again == model and hash(again) == hash(model)


def test_adding_a_part_returns_a_new_model(footing: gb.Model) -> None:
    more = footing.with_load(gb.Load.point("100 kN", "10 m")).with_support(gb.Support.pinned(12))
    assert more != footing
    assert more.solve().deflection(12.0) == pytest.approx(0.0, abs=1e-15)
    of_file = gb.load(REPOSITORY / "docs" / "strip-footing.toml").with_load(gb.Load.point(1e5, 10))
    by_hand = footing.with_load(gb.Load.point(1e5, 10))
    assert of_file.solve().contact == by_hand.solve().contact
    plain = gb.Model.from_toml("[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n")
    assert plain.units == "none"
    assert plain.with_load(gb.Load.point(1.0, 0.5)).solve().units == "none"
    # Additional gap under the lifted part only makes the gap larger; nothing else changes.
    fallen = footing.with_gap(0, 0).with_gap("9 m", 0).with_gap("12 m", "1 mm").solve()
    before = footing.solve()
    assert fallen.gap(12.0) - before.gap(12.0) == pytest.approx(1e-3, rel=1e-6)
    assert fallen.contact[0][1] == pytest.approx(before.contact[0][1], rel=1e-9)


def test_an_error_in_a_file_is_reported_at_its_line() -> None:
    path = REPOSITORY / "cases" / "errors" / "one-slip.toml"
    with pytest.raises(gb.ModelError) as caught:
        gb.load(path)
    error = caught.value
    assert (error.code, error.line, error.column) == ("GB003", 4, 1)
    assert error.hint == "did you mean `length`?"
    assert f"--> {path}:4:1" in str(error) and '4 | lenght = "12 m"' in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.diagnostics) == (str(error), error.diagnostics)


def test_every_error_case_of_the_repository_has_its_code_and_location() -> None:
    count = 0
    for path in sorted((REPOSITORY / "cases" / "errors").glob("*.toml")):
        first = path.read_text("utf-8", "replace").splitlines()[0]
        if not first.startswith("# error: "):
            continue
        code, place = first.removeprefix("# error: ").split(" at ")
        with pytest.raises(gb.ModelError) as caught:
            gb.load(path)
        place, _, _file_beside = place.partition(" in ")
        places = [(d.code, f"{d.line}:{d.column}") for d in caught.value.diagnostics]
        assert (code, place) in places, path.name
        count += 1
    assert count > 20


def test_an_invalid_model_in_code_reports_codes_and_hints() -> None:
    with pytest.raises(gb.ModelError) as caught:
        gb.Model(gb.Beam("12 m", "5 kN"), gb.Foundation(4e7), loads=[gb.Load(piont=1.0, at=2)])
    assert [d.code for d in caught.value.diagnostics] == ["GB015", "GB003"]
    assert 'EI = "5 kN"' in str(caught.value) and "did you mean `point`?" in str(caught.value)
    with pytest.raises(gb.ModelError, match="must be finite|is not a number|not a number"):
        gb.Model(gb.Beam(float("nan"), 1.0), gb.Foundation(1.0))
    with pytest.raises(gb.ModelError, match="true or false"):
        gb.Model(gb.Beam(True, 1.0), gb.Foundation(1.0))
    with pytest.raises((TypeError, ValueError)):
        gb.Model(gb.Beam(object(), 1.0), gb.Foundation(1.0))  # type: ignore[arg-type]


def test_missing_files_and_binary_files_are_refused(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        gb.load(tmp_path / "none.toml")
    (tmp_path / "bytes.toml").write_bytes(b"title = '\xff'")
    with pytest.raises(gb.ModelError) as caught:
        gb.load(tmp_path / "bytes.toml")
    assert caught.value.code == "GB019"


def test_a_beam_that_tips_has_no_equilibrium() -> None:
    model = gb.load(REPOSITORY / "docs" / "tipping.toml")
    assert model.check().verdict == "none"
    with pytest.raises(gb.NoEquilibrium) as caught:
        model.solve()
    why = caught.value
    assert (why.left, why.right) == (0.0, -1.0)
    assert why.work == pytest.approx(65e3, rel=1e-12)
    assert sum(why.static_reactions) == pytest.approx(1020e3, rel=1e-12)
    assert "the beam tips about its left end" in why.sentence and str(why) == why.sentence
    assert model.check().motion == (why.left, why.right, why.work)
    assert pickle.loads(pickle.dumps(why)).work == why.work


def test_a_model_that_the_method_does_not_support_is_refused() -> None:
    compressed = gb.Model(
        gb.Beam(5.0, 1.0, axial_force=-0.5),
        gb.Foundation.winkler(1.0),
        loads=[gb.Load.distributed(1.0)],
    )
    with pytest.raises(gb.ModelError) as caught:
        compressed.solve("uzawa")
    assert caught.value.code == "GB611"


def test_methods_agree(footing: gb.Model) -> None:
    exact, mesh = footing.solve(), footing.solve("active-set", elements=400)
    assert (exact.method, mesh.method) == ("exact", "active-set")
    # On a mesh the contact ends at a node.
    assert mesh.contact[0][1] == pytest.approx(exact.contact[0][1], abs=12.0 / 400)
    with pytest.raises(ValueError, match="exact, active-set, psor, uzawa"):
        footing.solve("exakt")
    with pytest.raises(ValueError, match="at least one element"):
        footing.solve("active-set", elements=0)
