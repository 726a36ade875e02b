"""A study on the workers of a Dask cluster.

>>> import distributed, groundbeam as gb
>>> from groundbeam.dask import run
>>> with distributed.Client() as client:  # doctest: +SKIP
...     summary = run(client, gb.Study("study.toml"), "results.parquet")

The workers need the package and nothing else, no shared disk: the study takes its files with it, as they were when it was
read. A shard comes back as the bytes of its file and is kept at once, so that a run that is killed goes on where it was; a
shard on a worker that dies is done again by another.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Optional, Tuple

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
    restart: bool = False,
) -> Summary:
    """Solves the samples of a study on a cluster and keeps them in one Parquet file here.

    The file is, to the last byte, what ``study.run(out)`` writes. ``shards`` is in how many pieces the work goes to the
    workers; each is begun again up to ``retries`` times where a worker fails. If ``out`` holds results of another study,
    that is a ``ValueError``; ``restart`` throws away all results that are there.
    """
    import distributed

    out = Path(out)
    folder = out.with_name(out.name + ".shards")
    if restart:
        shutil.rmtree(folder, ignore_errors=True)
    elif study._inner.is_done(out, (1, 1)):
        return study.summary(out)
    count = shards or max(1, -(-study.samples // SAMPLES_A_SHARD))
    folder.mkdir(exist_ok=True)
    digest = study._inner.digest
    names = {i: folder / f"{i}-of-{count}-{digest}.parquet" for i in range(1, count + 1)}
    futures = {
        client.submit(_shard, study, i, count, pure=False, retries=retries): i
        for i, name in names.items()
        if not _is_kept(study, name, (i, count))
    }
    for future in distributed.as_completed(list(futures)):
        i = futures.pop(future)
        unfinished = names[i].with_suffix(".unfinished")
        unfinished.write_bytes(future.result())
        # A worker with another version of the package makes other results.
        study._inner.is_done(unfinished, (i, count))
        os.replace(unfinished, names[i])
        # The cluster need not keep data that are stored here.
        future.release()
    merge(list(names.values()), out)
    shutil.rmtree(folder)
    return study.summary(out)


def _is_kept(study: Study, name: Path, shard: Tuple[int, int]) -> bool:
    """Whether an earlier run has kept this shard. A file with anything else in it does not count."""
    try:
        return study._inner.is_done(name, shard)
    except ValueError:
        return False


def _shard(study: Study, number: int, of: int) -> bytes:
    """One shard, on a worker."""
    with tempfile.TemporaryDirectory() as place:
        out = Path(place) / "shard.parquet"
        study.run(out, shard=(number, of), threads=1)
        return out.read_bytes()
