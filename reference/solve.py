"""Solves models with the multiprecision reference, and writes the files in `answers/`.

    python solve.py model.toml              print the record of one model (plain numbers)
    python solve.py --kikuchi               answers/kikuchi.json
    python solve.py --limits                answers/limits.json
    python solve.py --family plain 0 20     answers/plain-000.json, models 0 to 19
    python solve.py --all                   everything; about half an hour
"""

import argparse
import sys
import time
from pathlib import Path

import limits
import random_models
from groundref.analytic import Rejected
from groundref.model import Load, Model
from groundref.record import make_record, number, short, to_json
from groundref.topology import solve

HERE = Path(__file__).resolve().parent
DIGITS = 100


def record_of(name, family, seed, model, note=None, log=None):
    # The model is read back from its text, so the solved model is exactly the recorded model.
    model = Model.from_toml(model.to_toml())
    return make_record(name, family, seed, model, solve(model, DIGITS, log=log), DIGITS, note)


def kikuchi():
    """Yields the models of the paper's example, cases I to IV."""
    for case, moment in (("I", 0.1), ("II", 0.3), ("III", 0.4), ("IV", 0.49)):
        loads = [Load("point", 1.0, 0.5), Load("moment", moment, 0.5)]
        title = f"Kikuchi 1980, case {case}"
        note = None
        if case in ("III", "IV"):  # off contact the beam is straight and u decays as exp(x - c)
            note = "exact values at the left end: w(0) = (1 - c) w(c) and u(0) = w(c) exp(-c), with the left contact edge c"
        yield f"kikuchi-{case}", Model(1.0, 1.0, 1.0, 1.0, title=title, loads=loads), note


def write(path, records):
    path.parent.mkdir(exist_ok=True)
    path.write_text(to_json(records))
    print(f"{path.name}: {len(records)} records, {path.stat().st_size / 1e3:.0f} kB")


def solve_kikuchi(log):
    records = [record_of(n, "kikuchi", None, m, note, log) for n, m, note in kikuchi()]
    write(HERE / "answers" / "kikuchi.json", records)


def solve_limits(log):
    records = []
    for name, model, note, checks in limits.all_limits():
        model.title = name
        record = record_of(name, "limits", None, model, note, log)
        record["closed_forms"] = [
            {"what": what, "value": number(value), "relative_difference": short(off)}
            for what, value, off in limits.compare(record, checks)
        ]
        records.append(record)
        print(f"{name}: {len(record['closed_forms'])} closed-form results agree with the solution", flush=True)
    write(HERE / "answers" / "limits.json", records)


def solve_family(family, first, last, log):
    records = []
    for index in range(first, last):
        model, seed, thrown = random_models.make(family, index)
        begin = time.time()
        name, note = f"{family}-{index:03d}", random_models.NOTES.get((family, index))
        try:
            records.append(record_of(name, family, seed, model, note, log))
            checks = ", ".join(f"{k} {v}" for k, v in records[-1]["checks"].items())
            outcome = f"{len(records[-1]['contact'])} regions, {checks}"
        except (Rejected, ArithmeticError) as why:
            outcome = f"REJECTED: {why}"
        print(f"{name} {time.time() - begin:5.1f} s, {thrown} draws discarded, {outcome}", flush=True)
    write(HERE / "answers" / f"{family}-{first:03d}.json", records)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", nargs="?", help="a model file in plain numbers")
    parser.add_argument("--kikuchi", action="store_true", help="the paper's four cases")
    parser.add_argument("--limits", action="store_true", help="models with closed forms")
    parser.add_argument("--family", nargs=3, metavar=("NAME", "FROM", "TO"))
    parser.add_argument("--all", action="store_true", help="every file in answers/")
    parser.add_argument("--verbose", action="store_true")
    args = parser.parse_args()
    log = (lambda text: print("   ", text, flush=True)) if args.verbose else None
    if args.file:
        model = Model.from_toml(Path(args.file).read_text())
        print(to_json([record_of(Path(args.file).stem, "file", None, model, log=log)]))
    if args.kikuchi or args.all:
        solve_kikuchi(log)
    if args.limits or args.all:
        solve_limits(log)
    if args.family:
        solve_family(args.family[0], int(args.family[1]), int(args.family[2]), log)
    if args.all:
        for family, (count, _) in random_models.FAMILIES.items():
            for first in range(0, count, 20):
                solve_family(family, first, min(first + 20, count), log)


if __name__ == "__main__":
    sys.exit(main())
