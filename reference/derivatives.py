"""Derivatives of results by differences of multiprecision solutions, and the file `derivatives.json`.

    python derivatives.py                   derivatives.json

The contact set of each model is known. Newton's method moves its edges for both changed values of a parameter. The
central difference over the step `STEP` has an error of its square, and the solutions have `DIGITS` digits.
"""

import copy
import json
import time
from pathlib import Path

from groundref.analytic import Edge, Topology, newton
from groundref.model import Model
from groundref.record import number, to_json
from mpmath import mp, mpf

HERE = Path(__file__).resolve().parent
DIGITS = 60
STEP = mpf("1e-18")
"""Change of a parameter, relative to its size. The change of a position is relative to the length of the beam."""

NAMES = (
    "kikuchi-IV",
    "plain-005",
    "tension-003",
    "segments-008",
    "segments-017",
    "winkler-005",
    "supports-005",
    "supports-010",
    "gap-000",
)

# A beam with two hinges that is 10⁵ times stiffer than its ground.
HINGED = """
[beam]
length = 4.953947203050577
EI = 15797.49373960373

[foundation]
k = 0.02135800003387614

[[load]]
distributed = [0.040205188922784484, 0.30797000149534715]
from = 1.3119452658831123
to = 2.4769736015252883

[[load]]
point = -0.3095294451923485
at = 2.4769736015252883

[[load]]
distributed_moment = [0.0003527752620989866, 0.0029130568338380076]
from = 0.0
to = 4.953947203050577

[[load]]
distributed = [0.1865956476123217, 0.24496133004440473]
from = 2.8034197448573397
to = 3.1109300020645834

[[load]]
point = 0.9532027538691115
at = 1.8058490758673171

[[support]]
at = 2.0568977851431742
spring = 0.018972305324729356
rotational_spring = 2858.2562295909606

[[support]]
at = 2.4769736015252883
type = "pinned"

[[support]]
at = 4.4756488561667656
spring = 0.001455504965893391

[[hinge]]
at = 3.3286859980275403

[[hinge]]
at = 2.1392106642794926
"""
HINGED_CONTACT = [[0.0, 2.4769736015252883], [4.759854808229763, 4.953947203050577]]


def topology_of(model, contact):
    """The topology with the given contact regions. A region that ends at a breakpoint of the model has a fixed edge."""
    fixed = {float(x) for x in model.breakpoints()}
    edge = lambda x: Edge(mpf(x), float(x) not in fixed)
    intervals = [[edge(a), edge(b)] for a, b in contact if a != b]
    return Topology(intervals, [float(a) for a, b in contact if a == b])


def parameters(model):
    """Yields for each parameter of a model its name, its size, and a function that adds a given change to the
    parameter."""

    def attribute(name):
        return lambda m, d: setattr(m, name, mpf(getattr(m, name)) + d)

    def entry(name, i, j):
        def add(m, d):
            row = list(getattr(m, name)[i])
            row[j] = mpf(row[j]) + d
            getattr(m, name)[i] = tuple(row)

        return add

    def part(name, i, *keys):
        def add(m, d):
            for key in keys:
                setattr(getattr(m, name)[i], key, mpf(getattr(getattr(m, name)[i], key)) + d)

        return add

    own = lambda name, segments: f"{name}[]" if segments else name
    yield own("k", model.ground_segments), model.k, attribute("k")
    if model.mu > 0:
        yield own("mu", model.ground_segments), model.mu, attribute("mu")
    yield own("EI", model.beam_segments), model.EI, attribute("EI")
    yield "axial_force", max(abs(model.P), 0.1 * model.EI / model.length**2), attribute("P")
    for i, (_, _, EI) in enumerate(model.beam_segments):
        yield f"EI[{i}]", EI, entry("beam_segments", i, 2)
    for i, (_, _, k, mu) in enumerate(model.ground_segments):
        yield f"k[{i}]", k, entry("ground_segments", i, 2)
        if mu > 0:
            yield f"mu[{i}]", mu, entry("ground_segments", i, 3)
    for i, load in enumerate(model.loads):
        if load.is_point:
            yield f"load[{i}]", abs(load.value), part("loads", i, "value")
            alone = sum(load.start in (o.start, o.end) for o in model.loads) == 1
            if alone and 0 < load.start < model.length:
                yield f"load[{i}].at", model.length, part("loads", i, "start")
        else:
            size = max(abs(load.value), abs(load.end_value))
            yield f"load[{i}].start", size, part("loads", i, "value")
            yield f"load[{i}].end", size, part("loads", i, "end_value")
    for i, support in enumerate(model.supports):
        if support.kind == "spring" and support.spring:
            yield f"support[{i}].spring", support.spring, part("supports", i, "spring")
    for i, (_, spring) in enumerate(model.hinges):
        yield f"hinge[{i}]", max(spring, model.EI / model.length), entry("hinges", i, 1)
    depth = max((abs(value) for _, value in model.gap), default=0.0)
    for i, _ in enumerate(model.gap):
        yield f"gap[{i}]", depth, entry("gap", i, 1)


def stations(model, system):
    """The middles of three stretches between nodes: the longest in contact, the longest out of contact, and the last."""
    longest = lambda pieces: max(pieces, key=lambda p: p.b - p.a, default=None)
    shut = longest([p for p in system.pieces if p.contact])
    opened = longest([p for p in system.pieces if not p.contact])
    places = [p for p in (shut, opened, system.pieces[-1]) if p]
    return sorted({float((p.a + p.b) / 2) for p in places})


def results(model, system, places):
    """Yields the name, the position (or None) and the value of each output."""
    for x in places:
        piece = next(p for p in system.pieces if p.a < x < p.b)
        fields = piece.fields(mpf(x))
        for name in ("deflection", "slope", "moment", "shear_force", "settlement", "pressure"):
            yield name, x, fields[name]
    intervals = sorted(system.topology.intervals, key=lambda pair: pair[0].x)
    if not system.topology.points and all(a[1].x < b[0].x for a, b in zip(intervals, intervals[1:])):
        for i, pair in enumerate(intervals):
            for side, edge in zip(("left", "right"), pair):
                if edge.free:
                    yield f"edge[{i}].{side}", None, edge.x
    for side, node in (("left", system.nodes[0]), ("right", system.nodes[-1])):
        if node.layers:
            yield f"end_force.{side}", None, node.atom()
    for i, support in enumerate(model.supports):
        node = next(n for n in system.nodes if n.x == support.at)
        force, moment = node.reaction()
        yield f"support[{i}].force", None, force
        if support.kind == "fixed":
            yield f"support[{i}].moment", None, moment


def differentiate(name, model, contact):
    begin = time.time()
    topology = topology_of(model, contact)
    base = newton(model, topology, DIGITS - 10)
    places = stations(model, base)
    outputs = list(results(model, base, places))
    columns = {}
    for parameter, size, add in parameters(model):
        step = STEP * mpf(size)
        ends = []
        for sign in (1, -1):
            changed = copy.deepcopy(model)
            add(changed, sign * step)
            system = newton(changed, base.topology, DIGITS - 10)
            ends.append([value for _, _, value in results(changed, system, places)])
        columns[parameter] = (size, [(a - b) / (2 * step) for a, b in zip(*ends)])
    print(f"{name}: {len(outputs)} outputs, {len(columns)} parameters, {time.time() - begin:.0f} s", flush=True)
    return {
        "name": name,
        "model": model.to_toml(),
        "parameters": list(columns),
        "units": [number(size) for size, _ in columns.values()],
        "outputs": [
            {
                "name": output,
                **({} if x is None else {"x": number(x)}),
                "value": number(value),
                "derivatives": [number(column[i]) for _, column in columns.values()],
            }
            for i, (output, x, value) in enumerate(outputs)
        ],
    }


def models():
    files = sorted((HERE / "answers").glob("*.json"))
    answers = [answer for file in files for answer in json.loads(file.read_text(), parse_float=str)]
    known = {answer["name"]: answer for answer in answers}
    for name in NAMES:
        answer = known[name]
        yield name, Model.from_toml(answer["model"]), answer["contact"]
    yield "hinged", Model.from_toml(HINGED), HINGED_CONTACT


if __name__ == "__main__":
    with mp.workdps(DIGITS):
        records = [differentiate(*given) for given in models()]
    (HERE / "derivatives.json").write_text(to_json(records))
