"""Tests studies on a Dask cluster: the same bytes as on one machine, and never results of another study."""

from __future__ import annotations

import os
import shutil
import signal
import threading
import time
from pathlib import Path
from typing import Iterator, NoReturn

import distributed
import groundbeam as gb
import groundbeam.dask
import pytest
from groundbeam.dask import run
from test_study import STUDY, study, with_survey

__all__ = ["study"]


@pytest.fixture(scope="module")
def client() -> Iterator[distributed.Client]:
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        yield client


def alone(study: gb.Study, out: Path) -> bytes:
    study.run(out)
    return out.read_bytes()


def run_without_merge(
    client: distributed.Client, study: gb.Study, out: Path, shards: int, monkeypatch: pytest.MonkeyPatch
) -> list[Path]:
    """Stops a run before it merges. Returns its shards."""

    def stop(*_: object) -> NoReturn:
        raise KeyboardInterrupt

    with monkeypatch.context() as stopped:
        stopped.setattr(groundbeam.dask, "merge", stop)
        with pytest.raises(KeyboardInterrupt):
            run(client, study, out, shards=shards)
    return sorted(out.with_name(out.name + ".shards").iterdir())


def test_an_edited_study_reuses_no_old_shards(
    client: distributed.Client,
    study: gb.Study,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    out = tmp_path / "cluster.parquet"
    assert len(run_without_merge(client, study, out, 3, monkeypatch)) == 3
    study.path.write_text(STUDY.replace("cov = 0.2", "cov = 0.1"))
    edited = gb.Study(study.path)
    run(client, edited, out, shards=3)
    assert out.read_bytes() == alone(edited, tmp_path / "alone.parquet")
    assert not (tmp_path / "cluster.parquet.shards").exists()


def test_valid_shards_are_reused(
    client: distributed.Client,
    study: gb.Study,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    out = tmp_path / "cluster.parquet"
    one, two, *others = run_without_merge(client, study, out, 4, monkeypatch)
    shutil.copyfile(one, two)
    others[0].write_bytes(b"not Parquet")
    submitted: list[object] = []
    submit = client.submit

    def counted(*arguments: object, **more: object) -> object:
        submitted.append(arguments)
        return submit(*arguments, **more)

    monkeypatch.setattr(client, "submit", counted)
    run(client, study, out, shards=4)
    assert len(submitted) == 2
    assert out.read_bytes() == alone(study, tmp_path / "alone.parquet")


def test_existing_results_are_kept_without_restart(
    client: distributed.Client, study: gb.Study, tmp_path: Path
) -> None:
    out = tmp_path / "r.parquet"
    before = alone(study, out)
    assert run(client, study, out).samples == 600
    study.path.write_text(STUDY.replace("cov = 0.2", "cov = 0.1"))
    edited = gb.Study(study.path)
    with pytest.raises(ValueError, match="another study"):
        run(client, edited, out)
    assert out.read_bytes() == before
    run(client, edited, out, restart=True)
    assert out.read_bytes() == alone(edited, tmp_path / "alone.parquet")


def test_workers_get_every_file_with_the_content_that_was_read(
    client: distributed.Client, tmp_path: Path
) -> None:
    study = with_survey(tmp_path)
    expected = alone(study, tmp_path / "alone.parquet")
    shutil.rmtree(tmp_path / "models")
    shutil.rmtree(tmp_path / "studies")
    run(client, study, tmp_path / "cluster.parquet", shards=3)
    assert (tmp_path / "cluster.parquet").read_bytes() == expected


def test_a_study_survives_the_death_of_a_worker(study: gb.Study, tmp_path: Path) -> None:
    many = gb.Study(study.path, samples=8_000)
    many.run(tmp_path / "alone.parquet")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        pids = list(client.run(_pid).values())
        killer = _kill_soon(pids[0])
        summary = run(client, many, tmp_path / "cluster.parquet", shards=12)
        killer.join()
    assert summary.samples == 8_000
    assert (tmp_path / "cluster.parquet").read_bytes() == (tmp_path / "alone.parquet").read_bytes()
    assert not (tmp_path / "cluster.parquet.shards").exists()


def _pid() -> int:
    return os.getpid()


def _kill_soon(pid: int) -> threading.Thread:
    def kill() -> None:
        time.sleep(0.3)
        os.kill(pid, signal.SIGKILL)

    thread = threading.Thread(target=kill)
    thread.start()
    return thread
