"""A study on the workers of a Dask cluster.

>>> import distributed, groundbeam as gb
>>> from groundbeam.dask import run
>>> with distributed.Client() as client:  # doctest: +SKIP
...     summary = run(client, gb.Study("study.toml"), "results.parquet")

The workers need only the package, no shared disk: the study carries the contents of its files. Each finished shard
is sent back as the bytes of its file and saved at once, so that a killed run can be resumed. If a worker fails,
another one solves its shard.
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
"""Default number of samples per shard. A shard takes a few seconds and has a few megabytes of results."""


def run(
    client: distributed.Client,
    study: Study,
    out: File,
    *,
    shards: Optional[int] = None,
    retries: int = 3,
    restart: bool = False,
) -> Summary:
    """Solves the samples of a study on a cluster and saves them in one local Parquet file.

    The file is the same, to the last byte, as that of ``study.run(out)``. ``shards`` is the number of parts of the
    work. Each part is repeated up to ``retries`` times if a worker fails. If ``out`` contains results of another
    study, a ``ValueError`` is raised; ``restart`` deletes all existing results.
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
        # Raises an error if the worker has another version of the package, because its results could differ.
        study._inner.is_done(unfinished, (i, count))
        os.replace(unfinished, names[i])
        # The results are stored locally, so the cluster can delete its copy.
        future.release()
    merge(list(names.values()), out)
    shutil.rmtree(folder)
    return study.summary(out)


def _is_kept(study: Study, name: Path, shard: Tuple[int, int]) -> bool:
    """Whether an earlier run has saved this shard. A file with other contents does not count."""
    try:
        return study._inner.is_done(name, shard)
    except ValueError:
        return False


def _shard(study: Study, number: int, of: int) -> bytes:
    """Solves one shard on a worker."""
    with tempfile.TemporaryDirectory() as place:
        out = Path(place) / "shard.parquet"
        study.run(out, shard=(number, of), threads=1)
        return out.read_bytes()
