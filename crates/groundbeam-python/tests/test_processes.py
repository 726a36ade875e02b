"""Tests calls with threads in forked and spawned processes, and the number of threads."""

from __future__ import annotations

import multiprocessing
import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any, Callable

import groundbeam as gb
import numpy as np
import pytest
from test_combinations import crane
from test_study import MODEL, study

__all__ = ["study"]

LONGEST = 300.0
"""Seconds after which a call counts as one that never returns."""

METHODS = multiprocessing.get_all_start_methods()


def combinations(_: Path) -> bytes:
    combined = crane(1000e3).solve_combinations()
    return b"".join(each.moment([1.0, 5.0, 9.0]).tobytes() for each in combined.solutions.values())


def many(_: Path) -> bytes:
    model = gb.Model.from_toml(MODEL)
    batch = gb.solve_many(model, {"k": np.linspace(1e7, 1e8, 64)}, at=[1.0, 5.0])
    return batch["moment"].tobytes()


def whole_study(folder: Path) -> bytes:
    out = folder / f"{os.getpid()}.parquet"
    gb.Study(folder / "study.toml").run(out)
    return out.read_bytes()


def merged(folder: Path) -> bytes:
    names = [folder / f"{os.getpid()}-{i}.parquet" for i in (1, 2)]
    for i, name in enumerate(names):
        gb.Study(folder / "study.toml").run(name, shard=(i + 1, 2))
    out = folder / f"{os.getpid()}-all.parquet"
    gb.merge(names, out)
    return out.read_bytes()


def calibrated(_: Path) -> bytes:
    model = gb.Model.from_toml(MODEL)
    x = np.linspace(0.0, 6.0, 5)
    measured = model.solve().deflection(x)
    found = gb.calibrate(model, {"deflection": (x, measured)}, ["k"], start={"k": 1e7})
    return np.float64(found.values["k"]).tobytes()


CALLS = [combinations, many, whole_study, merged, calibrated]


def in_a_process(method: str, call: Callable[[Path], bytes], folder: Path) -> bytes:
    """The result of the call in another process. A call that never returns fails the test."""
    pool: Any
    with multiprocessing.get_context(method).Pool(1) as pool:
        found: bytes = pool.apply_async(call, (folder,)).get(timeout=LONGEST)
    return found


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("call", CALLS)
def test_calls_work_in_a_process_started_after_a_call(
    method: str, call: Callable[[Path], bytes], study: gb.Study, tmp_path: Path
) -> None:
    here = call(tmp_path)
    assert in_a_process(method, call, tmp_path) == here


@pytest.mark.skipif("fork" not in METHODS, reason="processes cannot fork here")
def test_calls_work_in_a_process_forked_during_a_call() -> None:
    model = gb.Model.from_toml(MODEL)
    begun = threading.Event()
    stop = threading.Event()

    def told(done: int, count: int) -> None:
        begun.set()
        if stop.is_set():
            raise KeyboardInterrupt

    def long() -> None:
        with pytest.raises(KeyboardInterrupt):
            gb.solve_many(model, {"k": np.full(2_000_000, 4e7)}, progress=told)

    worker = threading.Thread(target=long)
    worker.start()
    try:
        assert begun.wait(LONGEST)
        for call in (combinations, many):
            assert in_a_process("fork", call, Path()) == call(Path())
    finally:
        stop.set()
        worker.join(LONGEST)
    assert not worker.is_alive()


COUNTED = """
import sys
import groundbeam as gb
import numpy as np

model = gb.Model.from_toml(sys.argv[1])
most = 0

def told(done, count):
    global most
    with open("/proc/self/status") as status:
        now = next(int(line.split()[1]) for line in status if line.startswith("Threads:"))
    most = max(most, now)
    if done > 0:
        raise KeyboardInterrupt

with open("/proc/self/status") as status:
    before = next(int(line.split()[1]) for line in status if line.startswith("Threads:"))
try:
    if sys.argv[2] == "many":
        gb.solve_many(model, {"k": np.full(2_000_000, 4e7)}, threads=eval(sys.argv[3]), progress=told)
    else:
        gb.Study(sys.argv[4], samples=2_000_000).run(sys.argv[5], threads=eval(sys.argv[3]), progress=told)
except KeyboardInterrupt:
    pass
print(most - before)
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="threads are counted by /proc")
@pytest.mark.parametrize("what", ["many", "study"])
@pytest.mark.parametrize("asked, variable, threads", [("3", "2", 3), ("None", "5", 5)])
def test_the_requested_number_of_threads_is_used(
    what: str, asked: str, variable: str, threads: int, study: gb.Study, tmp_path: Path
) -> None:
    arguments = [MODEL, what, asked, str(study.path), str(tmp_path / "r.parquet")]
    done = subprocess.run(
        [sys.executable, "-c", COUNTED, *arguments],
        env={**os.environ, "RAYON_NUM_THREADS": variable},
        capture_output=True,
        text=True,
        check=True,
        timeout=LONGEST,
    )
    assert int(done.stdout) == threads


def test_any_number_of_threads_gives_combinations_the_same_bits() -> None:
    model = crane(1000e3)
    one, *others = (model.solve_combinations(threads=threads) for threads in (1, 2, 8))
    for other in others:
        for name, solution in one.solutions.items():
            again = other.solutions[name]
            assert again.moment([1.0, 5.0]).tobytes() == solution.moment([1.0, 5.0]).tobytes()
    with pytest.raises(ValueError, match="at least one thread"):
        model.solve_combinations(threads=0)


def test_combinations_can_be_interrupted() -> None:
    """The process sends itself the signal of Ctrl-C."""
    code = """
import os, signal, threading
import groundbeam as gb

sets = [gb.Combination(f"n{i}", {"G": 1.0 + i}) for i in range(100)]
load = gb.Load.point(1e5, 1.0, case="G")
model = gb.Model(gb.Beam(12.0, 1.28e9), gb.Foundation(40e6, 9e6), loads=[load], combinations=sets)
signal.signal(signal.SIGINT, signal.default_int_handler)
threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    model.solve_combinations("psor", elements=50, threads=1)
except KeyboardInterrupt:
    print("stopped")
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=LONGEST
    )
    assert done.stdout == "stopped\n"
