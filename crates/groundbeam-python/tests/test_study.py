"""Tests that a study solves the samples that it draws, and that the bytes do not depend on the order of the
work."""

from __future__ import annotations

import pickle
import shutil
from pathlib import Path

import groundbeam as gb
import numpy as np
import pandas
import pytest

MODEL = """
[beam]
length = 12
EI = 1.28e9
[foundation]
k = 40e6
mu = 9e6
[[load]]
point = 900e3
at = 1.5
[[load]]
distributed = 10e3
"""
STUDY = """
model = "footing.toml"
samples = 600
seed = 3
[[random]]
what = "load[0]"
distribution = "gumbel"
cov = 0.2
[[random]]
what = "load[0].at"
distribution = "uniform"
from = 1.0
to = 6.0
[[correlated]]
what = ["load[0]", "load[0].at"]
rho = -0.5
[field]
k = { cov = 0.3 }
mu = { cov = 0.2 }
rho = 0.6
length = 3
points = 9
[keep]
extremes = ["moment"]
fields = ["deflection"]
at = [0, 12]
[[event]]
name = "heavy"
quantity = "moment.max"
above = 500e3
"""


@pytest.fixture
def study(tmp_path: Path) -> gb.Study:
    (tmp_path / "footing.toml").write_text(MODEL)
    (tmp_path / "study.toml").write_text(STUDY)
    return gb.Study(tmp_path / "study.toml")


def test_the_drawn_parameters_are_the_solved_ones(study: gb.Study, tmp_path: Path) -> None:
    out = tmp_path / "r.parquet"
    summary = study.run(out)
    assert summary is not None and summary.solved == 600 and summary.largest_gap < 1e-9
    table = study.to_pandas(out)
    drawn = study.draw()
    assert drawn["k"].shape == (600, 9)
    np.testing.assert_array_equal(table["load[0]"], drawn["load[0]"])
    batch = gb.solve_many(
        gb.load(study.model_path), study.parameters(), at=[0, 12], extremes=["moment"]
    )
    np.testing.assert_array_equal(table["moment_max"], batch.extremes["moment"].max)
    np.testing.assert_array_equal(table["deflection@12"], batch["deflection"][:, 1])
    np.testing.assert_array_equal(table["lifted_share"], batch.lifted_share)
    heavy = summary.events["heavy"]
    assert heavy.happened == int((table["moment_max"] > 500e3).sum())
    assert heavy.interval[0] < heavy.probability < heavy.interval[1]
    spread = summary.spreads["moment_max"]
    assert spread.mean == pytest.approx(table["moment_max"].mean(), rel=1e-12)
    assert spread.deviation == pytest.approx(table["moment_max"].std(), rel=1e-12)
    assert spread.quantiles[3] == pytest.approx(np.quantile(table["moment_max"], 0.95), rel=1e-12)
    counts = np.histogram(table["moment_max"], bins=len(spread.histogram))[0]
    np.testing.assert_allclose(spread.histogram, counts, atol=1)
    assert sum(spread.histogram) == 600 and len(spread.histogram) > 5
    assert summary.to_svg().startswith("<svg") and "heavy" in summary._repr_html_()


def test_a_field_of_steps_is_solved_as_steps(study: gb.Study, tmp_path: Path) -> None:
    study.path.write_text(STUDY.replace("points = 9", 'points = 9\nbetween = "steps"'))
    steps = gb.Study(study.path, samples=20)
    steps.run(tmp_path / "r.parquet")
    table = steps.to_pandas(tmp_path / "r.parquet")
    parameters = steps.parameters()
    assert isinstance(parameters["k"], gb.Steps)
    batch = gb.solve_many(gb.load(steps.model_path), parameters, at=[12])
    np.testing.assert_array_equal(table["deflection@12"], batch["deflection"][:, 0])


def test_moments_and_correlations_of_the_drawn_parameters(study: gb.Study) -> None:
    many = gb.Study(study.path, samples=20_000)
    drawn = many.draw()
    force, at = drawn["load[0]"], drawn["load[0].at"]
    # Five standard errors each.
    assert abs(force.mean() - 900e3) < 5 * 180e3 / np.sqrt(20_000)
    assert abs(force.std() / 180e3 - 1) < 0.05
    assert 1.0 < at.min() and at.max() < 6.0
    # Rank correlation of normal scores: 6/pi asin(rho/2), Pearson 1907.
    ranks = pandas.DataFrame({"f": force, "a": at}).rank()
    assert abs(ranks["f"].corr(ranks["a"]) - 6 / np.pi * np.arcsin(-0.25)) < 0.035
    k, mu = drawn["k"], drawn["mu"]
    assert abs(k[:, 4].mean() / 40e6 - 1) < 0.015
    z, y = np.log(k[:, 4]), np.log(mu[:, 4])
    assert abs(np.corrcoef(z, y)[0, 1] - 0.6) < 0.03
    # Three metres are one correlation length: two of nine points on 12 m.
    assert abs(np.corrcoef(z, np.log(k[:, 6]))[0, 1] - np.exp(-1)) < 0.04
    np.testing.assert_array_equal(many.draw(100, 3)["k"], k[100:103])
    np.testing.assert_array_equal(study.draw()["k"], k[:600])


def test_shards_and_threads_do_not_change_the_bytes(study: gb.Study, tmp_path: Path) -> None:
    study.run(tmp_path / "whole.parquet", threads=1)
    names = [tmp_path / f"{i}.parquet" for i in (1, 2, 3)]
    for i, name in enumerate(names):
        assert study.run(name, shard=(i + 1, 3), threads=2) is None
    assert gb.merge(names, tmp_path / "all.parquet") == 600
    assert (tmp_path / "all.parquet").read_bytes() == (tmp_path / "whole.parquet").read_bytes()
    with pytest.raises(ValueError, match="missing"):
        gb.merge(names[:2], tmp_path / "bad.parquet")


def test_damaged_results_are_refused(study: gb.Study, tmp_path: Path) -> None:
    out = tmp_path / "r.parquet"
    study.run(out)
    # Other programs read the file as any Parquet file.
    assert len(pandas.read_parquet(out)) == len(study.to_pandas(out)) == 600
    whole = out.read_bytes()
    for at in range(0, len(whole), 997):
        out.write_bytes(whole[:at] + bytes([whole[at] ^ 16]) + whole[at + 1 :])
        for read in (study.to_pandas, study.summary, study.run):
            with pytest.raises(ValueError, match="r.parquet: .*delete"):
                read(out)
    out.unlink()
    study.run(out)
    assert out.read_bytes() == whole


def test_invalid_studies_are_refused(study: gb.Study, tmp_path: Path) -> None:
    study.path.write_text(STUDY.replace("gumbel", "gumble").replace("rho = 0.6", "rho = 6"))
    with pytest.raises(gb.ModelError) as caught:
        gb.Study(study.path)
    assert [each.line for each in caught.value.diagnostics] == [7, 20]
    assert "did you mean `gumbel`?" in str(caught.value)
    with pytest.raises(FileNotFoundError):
        gb.Study(tmp_path / "none.toml")
    with pytest.raises(ValueError, match="shard must be"):
        study.run(tmp_path / "r.parquet", shard=(3, 2))
    study.run(tmp_path / "r.parquet")
    study.path.write_text(STUDY)
    with pytest.raises(ValueError, match="another study"):
        gb.Study(study.path, seed=4).run(tmp_path / "r.parquet")


def test_a_study_stopped_by_its_progress_can_be_resumed(study: gb.Study, tmp_path: Path) -> None:
    many = gb.Study(study.path, samples=10_000)

    def stop(done: int, of: int) -> None:
        assert of == 10_000
        if done > 0:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        many.run(tmp_path / "r.parquet", progress=stop)
    assert not (tmp_path / "r.parquet").exists()
    begun: list[int] = []
    many.run(tmp_path / "r.parquet", progress=lambda done, of: begun.append(done))
    assert begun[0] > 0 and begun[-1] == 10_000
    many.run(tmp_path / "whole.parquet")
    assert (tmp_path / "r.parquet").read_bytes() == (tmp_path / "whole.parquet").read_bytes()


SURVEY = "x [m];clearance [mm]\n0;0\n6;2\n12;1\n"


def with_survey(place: Path) -> gb.Study:
    """A study with its model in another folder, and the model's survey in a subfolder without the extension
    `.csv`."""
    (place / "studies" / "own").mkdir(parents=True)
    (place / "models" / "levels").mkdir(parents=True)
    (place / "models" / "levels" / "seabed.txt").write_text(SURVEY)
    survey = "[gap_survey]\nfile = 'levels/seabed.txt'\nclearance = 'clearance'\n"
    (place / "models" / "footing.toml").write_text(WITH_UNITS + survey)
    path = place / "studies" / "own" / "study.toml"
    path.write_text(OF_SURVEY)
    return gb.Study(path)


WITH_UNITS = """
[beam]
length = "12 m"
EI = "1.28 GN m^2"
[foundation]
k = "40 MN/m^2"
mu = "9 MN"
[[load]]
point = "900 kN"
at = "1.5 m"
"""
OF_SURVEY = """
model = "../../models/footing.toml"
samples = 300
seed = 3
[[random]]
what = "load[0]"
distribution = "gumbel"
cov = 0.2
"""


def test_results_of_a_changed_survey_belong_to_another_study(tmp_path: Path) -> None:
    study = with_survey(tmp_path)
    out = tmp_path / "r.parquet"
    study.run(out)
    survey = tmp_path / "models" / "levels" / "seabed.txt"
    survey.write_text(SURVEY.replace("6;2", "6;30"))
    with pytest.raises(ValueError, match="another study"):
        gb.Study(study.path).run(out)
    before = out.read_bytes()
    gb.Study(study.path).run(out, restart=True)
    assert out.read_bytes() != before


def test_a_study_and_a_model_can_be_pickled_with_their_files(tmp_path: Path) -> None:
    study = with_survey(tmp_path)
    model = gb.load(study.model_path)
    study.run(tmp_path / "before.parquet")
    deflection = model.solve().deflection(6.0)
    kept = pickle.dumps((study, model))
    shutil.rmtree(tmp_path / "models")
    shutil.rmtree(tmp_path / "studies")
    study, same = pickle.loads(kept)
    assert same == model and same.solve().deflection(6.0) == deflection
    assert same.with_load(gb.Load.point("1 kN", at="2 m")).solve().deflection(6.0) != deflection
    study.run(tmp_path / "after.parquet")
    assert (tmp_path / "after.parquet").read_bytes() == (tmp_path / "before.parquet").read_bytes()


def test_a_missing_study_is_named() -> None:
    with pytest.raises(FileNotFoundError, match="nope.toml: "):
        gb.Study("nope.toml")


def test_foreign_results_have_a_remedy_that_python_has(study: gb.Study, tmp_path: Path) -> None:
    out = tmp_path / "all.parquet"
    study.run(out)
    with pytest.raises(ValueError, match="start again with the option `restart`"):
        gb.Study(study.path, seed=study.seed + 1).run(out)
