"""A study on the workers of a Dask cluster.

>>> import distributed, groundbeam as gb
>>> from groundbeam.dask import run
>>> with distributed.Client() as client:  # doctest: +SKIP
...     summary = run(client, gb.Study("study.toml"), "results.parquet")

The workers need the package and nothing else: no shared disk. A shard comes back as the bytes of its file and is kept at
once, so that a run that is killed goes on where it was; a shard on a worker that dies is done again by another.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

from ._study import File, Study, Summary, merge

if TYPE_CHECKING:
    import distributed

__all__ = ["run"]

SAMPLES_A_SHARD = 50_000
"""Unless the caller says otherwise: some seconds of work, some megabytes of results."""


def run(
    client: distributed.Client,
    study: Study,
    out: File,
    *,
    shards: Optional[int] = None,
    retries: int = 3,
) -> Summary:
    """Solves the samples of a study on a cluster and keeps them in one Parquet file here.

    The file is, to the last byte, what ``study.run(out)`` writes. ``shards`` is in how many pieces the work goes to the
    workers; each is begun again up to ``retries`` times where a worker fails.
    """
    import distributed

    out = Path(out)
    count = shards or max(1, -(-study.samples // SAMPLES_A_SHARD))
    folder = out.with_name(out.name + ".shards")
    folder.mkdir(exist_ok=True)
    # Of another division into shards, or of another study, nothing is taken over: the merge would refuse it.
    names = {i: folder / f"{i}-of-{count}-{study.samples}-{study.seed}.parquet" for i in range(1, count + 1)}
    files = _files(study)
    futures = {
        client.submit(
            _shard, files, study.path.name, study.samples, study.seed, i, count, pure=False, retries=retries
        ): i
        for i in names
        if not names[i].exists()
    }
    for future in distributed.as_completed(list(futures)):
        name = names[futures.pop(future)]
        unfinished = name.with_suffix(".unfinished")
        unfinished.write_bytes(future.result())
        os.replace(unfinished, name)
        # The cluster need not keep what is here.
        future.release()
    merge(list(names.values()), out)
    for name in names.values():
        name.unlink()
    if not any(folder.iterdir()):
        folder.rmdir()
    return study.summary(out)


def _files(study: Study) -> dict[str, bytes]:
    """The study's file and those beside it that it needs, by their names from its folder on."""
    folder = study.path.parent
    files = {study.path.name: study.path.read_bytes()}
    model = study.model_path
    files[os.path.relpath(model, folder)] = model.read_bytes()
    # A model may name tables beside itself.
    for other in model.parent.glob("*.csv"):
        files[os.path.relpath(other, folder)] = other.read_bytes()
    return files


def _shard(
    files: dict[str, bytes], name: str, samples: int, seed: int, number: int, of: int, *_: Any
) -> bytes:
    """One shard, on a worker: its files into a folder of its own, its results back."""
    with tempfile.TemporaryDirectory() as place:
        root = Path(place) / "a" / "b" / "c"
        for path, content in files.items():
            target = root / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
        out = Path(place) / "shard.parquet"
        Study(root / name, samples=samples, seed=seed).run(out, shard=(number, of), threads=1)
        return out.read_bytes()
