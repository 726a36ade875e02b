"""The study of bench/study as a loop over the fastest rival callable from Python; writes a part of bench/RESULTS.md.

    pip install -r bench/requirements.txt ./crates/groundbeam-python
    python bench/rivals_study.py [FOOTINGS]

Both get the same footings, drawn by `groundbeam.Study.draw`. The rival (PIQP, an interior-point method, on the form of the
problem that suits it best; see rivals.py) solves a mesh of 100 elements with the loads at the nearest nodes, on one
thread, and certifies nothing; its time is that of setup and solution, without the assembly in Python. Ours draws, solves
exactly, certifies and writes, on one thread.
"""

import pathlib
import re
import sys
import tempfile
import time

import groundbeam as gb
import numpy as np
import rivals

HERE = pathlib.Path(__file__).parent
ELEMENTS = 100
FORM = rivals.stiffness
HEADING = "\n## A study beside a loop over the fastest rival"


def footing(drawn, i, x):
    """Nodal forces and moments of sample i."""
    force, moment = np.zeros_like(x), np.zeros_like(x)
    h = x[1] - x[0]
    positions = [drawn["load[0].at"][i], 6.0, 11.0]
    for j, at in enumerate(positions):
        force[round(at / h)] += drawn[f"load[{j}]"][i]
    moment[round(11.0 / h)] += drawn["load[3]"][i]
    force += 22e3 * h
    force[[0, -1]] -= 11e3 * h
    return force, moment


def main(count):
    study = gb.Study(HERE / "study" / "footings.toml", samples=count)
    drawn = study.draw()
    x = np.linspace(0.0, 12.0, ELEMENTS + 1)
    spent = failed = 0.0
    worst = 0.0
    stiffness = 30e9 * 1.5 * 0.6**3 / 12
    batch = gb.solve_many(
        gb.load(study.model_path), study.parameters(), at=x, fields=["deflection"], threads=1
    )
    for i in range(count):
        # All forces and stiffnesses are divided by EI, and deflections are in millimetres. Without this scaling, the
        # solver PIQP takes twenty times as long.
        unit = stiffness * drawn["EI_factor"][i]
        rivals.EI, rivals.K, rivals.MU = 1.0, drawn["k"][i] / unit, drawn["mu"][i] / unit
        loads = [1e3 * load / unit for load in footing(drawn, i, x)]
        seconds, w, _, _ = rivals.by_piqp(FORM, x, *loads)
        spent += seconds
        exact = 1e3 * batch["deflection"][i]
        error = np.abs(w - exact).max() / np.abs(exact).max()
        # Loads act at the nearest nodes, and the ground reaction acts at nodes only. The discretisation error of the
        # deflection is therefore a few per cent.
        failed += not error < 0.2
        worst = max(worst, min(error, 1.0))
    with tempfile.TemporaryDirectory() as folder:
        began = time.perf_counter()
        study.run(pathlib.Path(folder, "results.parquet"), threads=1)
        ours = time.perf_counter() - began
    line = (
        f"| **{spent / ours:.0f}** | {count / ours:.0f} | {count / spent:.0f} | {int(failed)} | {worst:.1e} |"
    )
    text = (
        f"{HEADING}\n\n{count} random footings, one thread each.\nMade by `python bench/rivals_study.py`.\n\n"
        "| PIQP / groundbeam, time | groundbeam: drawn, exact, certified, written, a second | PIQP, 100 elements, solved a second "
        "| of these wrong | largest difference in w |\n|---|---|---|---|---|\n" + line + "\n"
    )
    print(text)
    results = HERE / "RESULTS.md"
    before = results.read_text()
    cut = re.split(re.escape(HEADING), before)[0]
    results.write_text(cut.rstrip("\n") + "\n" + text)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 2000)
