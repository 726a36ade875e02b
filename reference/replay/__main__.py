"""Recomputes the inequalities of proofs in ball arithmetic (python-flint), from logs of `groundbeam verify --log`.

    python reference/replay LOG [RESULT.json]

Each inequality is recomputed from the problem, the pieces of the solution and the closing deflection in the log.
Of the program's intermediate results only the claimed ones (distances, bounds) are used, and each claim is
confirmed. If a document is given, the pieces and bounds in the log are compared with those in the document.
`docs/proof.md` describes the recomputation; numbers in brackets are its formulas. Exit status: 0 all inequalities
hold, 1 one does not hold, 2 a log cannot be replayed.
"""

import json
import sys

import balance
import beside
import clearance
import deflection
import document
import energy
import ground
import points
import reactions
import rounds
import springs
import stability
import uniqueness
from balls import NotReplayed
from problem import Problem

STEPS = (deflection, beside, ground, balance, clearance, energy, stability, points, rounds, springs, reactions, uniqueness)


def results(lines):
    """Splits the lines of a log into results. Returns the name of the load combination and the lines of each
    result."""
    found = []
    for line in lines:
        if line.get("name") == "result":
            found.append((line.get("combination"), []))
        elif found:
            found[-1][1].append(line)
    return found


def replay(lines, combination, claimed):
    """Recomputes all inequalities of one result. The returned problem counts them and lists those that do not
    hold."""
    problem = Problem(lines)
    for step in STEPS:
        step.check(problem)
    if claimed is not None:
        document.check(problem, document.part(claimed, combination))
    return problem


def main(log, result=None):
    with open(log, encoding="utf-8") as file:
        found = results(json.loads(line) for line in file)
    claimed = None
    if result is not None:
        with open(result, encoding="utf-8") as file:
            claimed = json.load(file)
    status = 0 if found else 2
    for combination, lines in found:
        name = f"{combination}: " if combination else ""
        try:
            problem = replay(lines, combination, claimed)
        except NotReplayed as reason:
            print(f"{name}not replayed: {reason}")
            status = 2
            continue
        for failed in problem.failed:
            print(f"{name}{failed}")
        for part, size in problem.energies.items():
            print(f"{name}the term {part} of 2E contributes at most {size.str(3, radius=False)} to the energy bound E")
        if problem.failed:
            status = max(status, 1)
            print(f"{name}{len(problem.failed)} of {problem.count} inequalities do not hold")
        else:
            print(f"{name}{problem.count} inequalities hold")
    return status


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
