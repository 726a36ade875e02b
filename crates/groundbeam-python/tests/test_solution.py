"""Tests results: arrays, contact, reports, pictures."""

from __future__ import annotations

import json
import threading
import time
from pathlib import Path
from typing import Any, Callable

import groundbeam as gb
import numpy as np
import pytest
from conftest import REPOSITORY
from groundbeam._solution import FIELDS

# All reference results except those at the limit of double precision, which `verification/tests/reference.rs`
# judges one by one.
ANSWERS = [
    answer
    for path in sorted((REPOSITORY / "reference" / "answers").glob("*.json"))
    for answer in json.loads(path.read_text())
    if answer["family"] != "hard" and answer["name"] != "supports-012"
]


@pytest.mark.parametrize("answer", ANSWERS, ids=lambda answer: str(answer["name"]))
def test_solutions_agree_with_the_multiprecision_answers(answer: dict[str, Any]) -> None:
    """Fields on both sides of their jumps, contact and forces, from an independent solver."""
    solution = gb.Model.from_toml(answer["model"]).solve()
    expected, largest = answer["stations"], answer["largest"]
    x, sides = np.array(expected["x"]), np.array(expected["side"])
    # At a contact edge the last digit of the position decides on the side.
    edges = np.array(answer["contact"]).reshape(-1)
    apart = np.abs(x[:, None] - edges).min(axis=1, initial=np.inf) > 1e-9 * solution.length
    apart |= (x == 0.0) | (x == solution.length)
    for name in expected.keys() & set(FIELDS):
        field = getattr(solution, name)
        found = np.where(sides == "-", field(x, "left"), field(x, "right"))
        # Fields that vanish relative to the deflection have errors of the size of the deflection's rounding.
        floor = {"gap": 1.0, "settlement": 1e-6}.get(name, 0.0)
        size = max(largest[name], floor * largest["deflection"])
        wanted = np.array(expected[name])
        np.testing.assert_allclose(found[apart], wanted[apart], 0.0, 1e-8 * size, err_msg=name)
    np.testing.assert_allclose(solution.contact, answer["contact"], atol=1e-7 * solution.length)
    ends = [answer["end_forces"]["left"], answer["end_forces"]["right"]]
    np.testing.assert_allclose(solution.end_forces, ends, atol=1e-8 * largest["shear_force"])
    assert 0.0 <= solution.certificate.relative_gap < 1e-9


def test_kikuchis_case_four_has_its_known_solution() -> None:
    model = gb.Model(
        gb.Beam.uniform(1.0, 1.0),
        gb.Foundation.pasternak(1.0, 1.0),
        loads=[gb.Load.point(1.0, 0.5), gb.Load.moment(0.49, 0.5)],
    )
    solution = model.solve()
    [(edge, end)] = solution.contact
    assert edge == pytest.approx(0.811326256449155, abs=1e-14) and end == 1.0
    assert solution.deflection(0.0) == pytest.approx(0.013217803941407, abs=1e-14)
    certificate = solution.certificate
    between = certificate.primal_energy - certificate.dual_energy
    assert certificate.gap == pytest.approx(between, abs=1e-14)


def test_fields_accept_and_return_arrays(footing: gb.Model) -> None:
    solution = footing.solve()
    table = np.array([[0.0, 1.5], [6.0, 12.0]])
    moments = solution.moment(table)
    assert moments.shape == (2, 2) and moments.dtype == np.float64
    assert solution.moment(6) == moments[1, 0] == solution.moment("600 cm")
    assert solution.moment(["6 m", 12.0]).tolist() == moments[1].tolist()
    assert isinstance(solution.moment(6.0), float)
    assert solution.moment([]).shape == (0,)
    assert solution.moment(np.arange(3)).shape == (3,)
    fields = solution.at(table)
    assert isinstance(fields.gap, np.ndarray)
    np.testing.assert_array_equal(fields.moment, moments)
    np.testing.assert_allclose(
        fields.gap, solution.settlement(table) - solution.deflection(table), atol=1e-15
    )
    # The shear force falls by the load.
    jump = solution.shear_force(1.5, "left") - solution.shear_force(1.5, side="right")
    assert jump == pytest.approx(900e3, rel=1e-12)


def test_the_settlement_outside_the_beam_decays_exponentially(footing: gb.Model) -> None:
    solution = footing.solve()
    b = np.sqrt(40e6 / 9e6)
    beside = np.array([-2.0, -1.0, -0.5])
    decayed = solution.settlement(0.0) * np.exp(b * beside)
    np.testing.assert_allclose(solution.settlement(beside), decayed, rtol=1e-14)


@pytest.mark.parametrize("x", [-0.1, 12.1, float("nan"), [1.0, 13.0], float("inf")])
def test_positions_off_the_beam_are_refused(footing: gb.Model, x: float) -> None:
    with pytest.raises(ValueError, match="position"):
        footing.solve().moment(x)


def test_every_field_has_a_method_and_an_attribute(footing: gb.Model) -> None:
    solution = footing.solve()
    at = solution.at(1.0)
    assert sorted(at._fields) == sorted(["x", *FIELDS])
    for name in FIELDS:
        assert getattr(solution, name)(1.0) == getattr(at, name)
        low, high = solution.range(name)
        assert low.value <= getattr(at, name) <= high.value
        assert gb.solve_many(footing, at=[1.0], fields=[name])[name] == getattr(at, name)
    # The beam has no shear deformation.
    assert at.rotation == at.slope


def test_wrong_names_are_refused(footing: gb.Model) -> None:
    solution = footing.solve()
    with pytest.raises(ValueError, match="`left` or `right`"):
        solution.moment(1.0, "middle")
    with pytest.raises(ValueError, match="deflection, slope"):
        solution.range("stress")
    with pytest.raises(gb.ModelError, match="a length is needed"):
        solution.moment("1 kN")


def test_extremes_agree_with_dense_samples(footing: gb.Model) -> None:
    solution = footing.solve()
    x = np.linspace(0.0, 12.0, 20001)
    for field in ("deflection", "slope", "moment", "pressure", "gap"):
        values = getattr(solution, field)(x)
        low, high = solution.range(field)
        size = np.abs(values).max()
        assert low.value <= values.min() + 1e-15 * size
        assert low.value == pytest.approx(values.min(), abs=1e-6 * size)
        assert high.value == pytest.approx(values.max(), abs=1e-6 * size)


def test_the_json_document_contains_the_solution(footing: gb.Model) -> None:
    solution = footing.solve()
    document = json.loads(solution.to_json(at=[0.0, 6.0]))
    assert document["status"] == "solved" and document["units"] == "SI"
    assert document["stations"]["moment"] == solution.moment([0.0, 6.0]).tolist()
    assert document["contact"][0]["to"] == solution.contact[0][1]
    assert document["certificate"]["relative_gap"] == solution.certificate.relative_gap
    assert len(json.loads(solution.to_json())["stations"]["x"]) > 100


def test_tables_contain_the_solution(footing: gb.Model) -> None:
    solution = footing.solve()
    table = solution.to_pandas()
    assert list(table.columns)[:2] == ["x_m", "deflection_m"]
    at_load = table[table["x_m"] == 1.5]
    assert len(at_load) == 2, "both sides of the jump"
    assert at_load["shear_force_N"].tolist() == [
        solution.shear_force(1.5, "left"),
        solution.shear_force(1.5),
    ]
    assert len(solution.to_pandas(at=[0.0, 1.0, 2.0])) >= 3


def test_pictures_and_reports_are_written(footing: gb.Model, tmp_path: Path) -> None:
    solution = footing.solve()
    assert solution.to_svg().startswith("<svg") and solution.to_png().startswith(b"\x89PNG")
    page = solution._repr_html_()
    assert "<svg" in page and "</div>" in page and "Certificate" in page
    assert "Contact" in str(solution) and "contact 0 to 6.98" in repr(solution)
    figure = solution.plot()
    figure.savefig(tmp_path / "figure.png")
    bed, _, moment, _ = figure.axes
    assert bed.yaxis_inverted() and moment.yaxis_inverted()
    drawn = np.asarray(moment.lines[0].get_ydata())
    assert drawn.max() == pytest.approx(solution.range("moment").max.value, rel=1e-12)


def test_titles_are_escaped_in_html() -> None:
    model = gb.Model(
        gb.Beam(1, 1), gb.Foundation(1, 1), loads=[gb.Load.point(1, 0.5)], title="<script>x</script>"
    )
    assert "<script>" not in model.solve()._repr_html_()


def test_other_threads_run_during_a_solve() -> None:
    model = gb.load(REPOSITORY / "docs" / "strip-footing.toml")
    began, done = threading.Event(), threading.Event()

    def solve() -> None:
        began.set()
        model.solve("active-set", elements=50_000)
        done.set()

    thread = threading.Thread(target=solve)
    thread.start()
    began.wait()
    ticks = 0
    while not done.is_set():
        time.sleep(0.001)
        ticks += 1
    thread.join()
    # If a thread kept the lock, this loop would run only once or twice.
    assert ticks > 10


PLAIN = "[beam]\nlength=12\nEI=1280\n[foundation]\nk=40\nmu=9\n[[load]]\npoint=900\nat=1.5\n"


def test_texts_have_the_units_of_the_model(footing: gb.Model) -> None:
    """As on the command line: units are given in all places or in none."""
    plain, solution = gb.Model.from_toml(PLAIN).solve(), footing.solve()
    assert plain.moment("1.5") == plain.moment(1.5)
    with pytest.raises(gb.ModelError, match="has a unit, but the file has no units") as refused:
        plain.moment("1.5 ft")
    assert refused.value.code == "GB016"
    assert solution.moment("1.5 ft") == solution.moment(0.4572)
    with pytest.raises(gb.ModelError, match="has no unit, but the file has units"):
        solution.moment("1.5")


def test_every_call_with_positions_reads_texts_with_the_units_of_the_model(footing: gb.Model) -> None:
    plain = gb.Model.from_toml(PLAIN)
    combined = gb.Model.from_toml(PLAIN + 'case="G"\n[[combination]]\nname="a"\nfactors={G=1}\n')
    rail = gb.Model.from_toml(PLAIN + "[[train]]\naxles=[{at=0,force=9}]\n")
    calls: list[Callable[[list[str]], object]] = [
        lambda at: plain.solve().to_csv(at),
        lambda at: combined.solve_combinations().envelope("moment", at).max.values.tolist(),
        lambda at: rail.solve_trains().envelope("moment", at).max.values.tolist(),
        lambda at: gb.solve_many(plain, at=at)["moment"].tolist(),
        lambda at: gb.calibrate(plain, {"deflection": (at, [20.0])}, ["k"]).values,
    ]
    for call in calls:
        assert call(["1.5"])
        with pytest.raises(gb.ModelError, match="the file has no units"):
            call(["1.5 m"])
    with pytest.raises(gb.ModelError, match="the file has no units"):
        gb.solve_many([footing, plain], at=["1.5 m"])


@pytest.mark.parametrize(
    ("positions", "why"),
    [
        ("1 m, 2 m", r'contains 2 positions: give a list of strings, such as \["1 m", "2 m"\]'),
        ([["1 m"]], r'one list of them, as in \["1 m", "2 m"\]'),
        (1j, "positions are numbers, texts"),
    ],
)
def test_invalid_positions_are_refused_with_a_remedy(footing: gb.Model, positions: Any, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        footing.solve().moment(positions)


def test_no_message_names_an_option_of_the_command_line(footing: gb.Model) -> None:
    with pytest.raises(gb.ModelError) as refused:
        footing.solve("active-set", elements=10**9)
    assert refused.value.code == "GB617" and "--" not in refused.value.hint
    assert "use fewer elements" in refused.value.hint
    [message] = gb.solve_many(footing, method="active-set", elements=10**9).messages
    assert message is not None and "use fewer elements" in message and "--" not in message
