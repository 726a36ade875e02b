"""Studies: solve one model for many samples of random ground and loads, and estimate probabilities of events."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Sequence, Tuple, Union

from . import _native
from ._along import Along, Points, Steps
from ._batch import Progress, _Bar
from ._solution import Array
from ._threads import number_of

if TYPE_CHECKING:
    import pandas

File = Union[str, "os.PathLike[str]"]


class Estimate(NamedTuple):
    """Estimated probability of an event."""

    name: str
    happened: int
    """Number of samples in which the event occurs."""
    probability: float
    interval: Tuple[float, float]
    """95 % confidence interval of the probability."""


class Spread(NamedTuple):
    """Distribution of the values in a column of the results. Samples without a value in this column are left out."""

    mean: float
    deviation: float
    quantiles: Tuple[float, float, float, float, float]
    """Minimum, 5 %, 50 % and 95 % quantile, and maximum."""
    histogram: Tuple[int, ...]
    """Histogram: number of samples in equal intervals from the minimum to the maximum."""


class Summary:
    """Statistics of all samples of a study."""

    samples: int
    solved: int
    """Number of samples with a certified result."""
    without_equilibrium: int
    not_converged: int
    wrong: int
    """Number of samples with an invalid model; the column ``message`` of the results has the reason."""
    largest_gap: float
    """Largest error bound of all certificates, relative to the strain energy."""
    events: dict[str, Estimate]
    """Events by name; ``no equilibrium`` and ``some of the beam lifts off`` are always included."""
    spreads: dict[str, Spread]
    """The distribution of each column of the results, keyed by the name of the column."""

    def __init__(self, document: dict[str, Any], picture: str) -> None:
        self._picture = picture
        self.samples = document["samples"]
        self.solved = document["solved"]
        self.without_equilibrium = document["without_equilibrium"]
        self.not_converged = document["not_converged"]
        self.wrong = document["wrong"]
        self.largest_gap = document["largest_gap"]
        self.events = {
            event["name"]: Estimate(
                event["name"], event["count"], event["probability"], tuple(event["interval"]["bounds"])
            )
            for event in document["events"]
        }
        self.spreads = {
            spread["name"]: Spread(
                spread["mean"],
                spread["deviation"],
                tuple(spread["quantiles"]),
                tuple(spread["histogram"]),
            )
            for spread in document["spreads"]
        }

    def to_svg(self) -> str:
        """The picture of the study: probabilities of events, and histograms of random numbers and results."""
        return self._picture

    def _repr_html_(self) -> str:
        return f'<div style="max-width: 60em">{self._picture}</div>'

    def __repr__(self) -> str:
        return f"<groundbeam.Summary: {self.solved} of {self.samples} solved>"


class Study:
    """A study file: a model, its random numbers, and the requested results.

    ``samples`` and ``seed`` replace those of the file. The random numbers of a sample depend only on the seed and
    on its index.
    """

    def __init__(
        self, path: File, *, samples: Optional[int] = None, seed: Optional[int] = None
    ) -> None:
        self.path = Path(path)
        self._inner = _native.Study(self.path, samples, seed, None)

    @classmethod
    def _of(cls, path: str, samples: int, seed: int, files: Sequence[Tuple[str, str]]) -> Study:
        study = cls.__new__(cls)
        study.path = Path(path)
        study._inner = _native.Study(path, samples, seed, files)
        return study

    def __reduce__(self) -> Tuple[object, Tuple[str, int, int, Sequence[Tuple[str, str]]]]:
        # The pickled study includes its files, which may be missing on another machine.
        return Study._of, (os.fspath(self.path), self.samples, self.seed, self._inner.files)

    @property
    def title(self) -> Optional[str]:
        """The title of the study."""
        return self._inner.title

    @property
    def samples(self) -> int:
        """Number of samples."""
        return self._inner.samples

    @property
    def seed(self) -> int:
        """Seed of all random numbers."""
        return self._inner.seed

    @property
    def model_path(self) -> Path:
        """The file of the model."""
        return self._inner.model_path

    def draw(self, first: int = 0, count: Optional[int] = None) -> dict[str, Array]:
        """The random numbers of consecutive samples, and the random fields as arrays of samples by points."""
        count = self.samples - first if count is None else count
        if first < 0 or count < 0 or first + count > self.samples:
            raise IndexError(f"a sample is out of range: the study has {self.samples} samples")
        return self._inner.draw(first, count)

    def parameters(
        self, first: int = 0, count: Optional[int] = None
    ) -> dict[str, Union[Array, Along]]:
        """The result of ``draw`` as parameters of ``solve_many``; random fields become ``Points`` or ``Steps``."""
        shape: type[Along] = {"Points": Points, "Steps": Steps}[self._inner.shape]
        drawn = self.draw(first, count)
        return {name: shape(each) if each.ndim == 2 else each for name, each in drawn.items()}

    def run(
        self,
        out: File,
        *,
        shard: Tuple[int, int] = (1, 1),
        restart: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Optional[Summary]:
        """Solves the remaining samples and saves them in a Parquet file, one row per sample.

        After an interruption, the next call continues; the file is the same to the last byte. ``shard=(3, 8)``
        solves the third of eight equal parts, which :func:`merge` merges; then there is no summary yet.
        """
        if not 1 <= shard[0] <= shard[1]:
            raise ValueError("shard must be (i, n) for part i of n equal parts, with i from 1 to n")
        bar = _Bar() if progress is True else progress or None
        self._inner.run(out, shard, restart, number_of(threads), bar)
        return self.summary(out) if shard[1] == 1 else None

    def summary(self, out: File) -> Summary:
        """Statistics of the results of all samples."""
        document, picture = self._inner.summary(out)
        return Summary(json.loads(document), picture)

    def to_pandas(self, out: File) -> pandas.DataFrame:
        """The results as a table, after a check of their checksums; needs pyarrow.

        A damaged file raises ``ValueError``.
        """
        import pandas

        self._inner.verify(out)
        return pandas.read_parquet(out)

    def __repr__(self) -> str:
        return f"<groundbeam.Study: {self.samples} samples of {self.model_path.name}>"


def merge(files: Sequence[File], out: File) -> int:
    """Merges the shards of a study and returns the number of samples.

    The file is the same, to the last byte, as that of a single machine. Missing or repeated shards, and shards of
    another study, raise ``ValueError``.
    """
    return _native.merge(list(files), out)
