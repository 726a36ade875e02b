"""Writes doubtful.json: 60-digit solutions of models whose contact is below the rounding error of doubles.

The models are frozen ones. Three have a stretch whose force or clearance is below the rounding error.
Each of their records has one more key, `doubtful`:

    from, to    the stretch
    touches     whether it is in contact
    force       its contact force if it is bonded, as a fraction of all loads; a negative one opens it
    gap         the smallest and the largest clearance of beam and ground along it

The fourth model is a free beam balanced on one corner of the ground. Its rotation is not unique, so the linear system
is singular. Its moments are zero and the ground is uniform, so it has closed forms (`balance`).

`verification/frozen/README.md` describes the format of the models.

    python doubtful.py          about five minutes
"""

import json
from pathlib import Path

from mpmath import mp, mpf

from groundref import coarse
from groundref.analytic import Edge, Topology, newton
from groundref.model import Load, Model, Support, initial_gap
from groundref.record import Number, make_record, number, position, short, to_json
from groundref.topology import anchors, exact, solve
from groundref.verify import gauss, total_force

HERE = Path(__file__).resolve().parent
FROZEN = HERE.parent / "verification" / "frozen"
DIGITS = 100

LOADS = {
    "point_force": "point",
    "point_moment": "moment",
    "distributed_force": "distributed",
    "distributed_moment": "distributed_moment",
}


# ---- models and answers in verification/frozen ----------------------------------------------------


def lines_of(folder, title):
    """The lines of the record with the given title in verification/frozen, each as a list of words."""
    text = (FROZEN / folder / f"{title.split()[0]}.txt").read_text()
    for record in text.split("\n\n"):
        first, *lines = record.strip().splitlines() or [""]
        if first == title:
            return [line.split() for line in lines]
    raise KeyError(f"{title} has no record in {FROZEN / folder}")


def numbers(words):
    return [None if word == "-" else float(word) for word in words]


def read(title):
    """Reads a model from verification/frozen. Raises an error if the reference does not support the model."""
    model = Model(0.0, 0.0, 0.0, title=title)
    for key, *words in lines_of("models", title):
        known = True
        if key == "beam":
            model.length, model.EI, shear, model.P = numbers(words)
            known = shear is None
        elif key == "beam_segment":
            known = words[3] == "-"
            model.beam_segments.append(tuple(numbers(words[:3])))
        elif key == "ground":
            model.k, model.mu = numbers(words[:2])
            known = words[2:] == ["endless", "endless"]
        elif key == "ground_segment":
            model.ground_segments.append(tuple(numbers(words)))
        elif key in ("point_force", "point_moment"):
            at, value = numbers(words)
            model.loads.append(Load(LOADS[key], value, at))
        elif key in LOADS:
            start, end, value, end_value = numbers(words)
            model.loads.append(Load(LOADS[key], value, start, end, end_value))
        elif key == "support":
            kind, *springs = words[1].split(":")
            known = words[2:] == ["0.0", "both"]
            model.supports.append(Support(float(words[0]), kind, *numbers(springs)))
        elif key == "gap":
            model.gap.append(tuple(numbers(words)))
        else:
            known = False
        if not known:
            raise NotImplementedError(f"{title}: the reference does not support '{key} {' '.join(words)}'")
    return model


def from_answer(model, title):
    """The contact zones of the answer in verification/frozen, as an initial guess."""
    zones = next(words for words in lines_of("answers", title) if words[0] == "contact")[1:]
    fixed = anchors(model)
    edges = [Edge(mpf(x), x not in fixed) for x in map(float, zones)]
    return Topology([list(pair) for pair in zip(edges[::2], edges[1::2])], [])


# ---- stretches where contact force or clearance is smaller than the rounding error -----------------


def integral(f, a, b):
    return (b - a) * mp.fsum(weight * f(a + (b - a) * s) for s, weight in gauss(40, 60))


def force_within(system, a, b):
    """Contact force on [a, b], the sum of the pressure and the concentrated forces."""
    total = mp.fsum(n.atom() for n in system.nodes if a <= n.x <= b)
    for p in system.pieces:
        left, right = max(a, p.a), min(b, p.b)
        if p.contact and left < right:
            total += integral(lambda x: p.fields(x)["pressure"], left, right)
    return total


def clearances(system, a, b):
    places = lambda p: [max(a, p.a), (max(a, p.a) + min(b, p.b)) / 2, min(b, p.b)]
    values = [p.fields(x)["gap"] for p in system.pieces if p.a < b and a < p.b for x in places(p)]
    return [short(min(values)), short(max(values))]


def unloaded(model, a, b):
    """Solves a model whose stretch [a, b] beside a fixed support has zero deflection. The stretch is open in the
    solution, and bonded in a second system for comparison."""
    solution = solve(model, DIGITS, elements=400)  # fine enough for the shear layer

    def bonded():
        pairs = [[Edge(mpf(a), False), Edge(mpf(b), False)]] + solution.system.topology.copy().intervals
        pairs.sort(key=lambda pair: pair[0].x)
        return newton(model, Topology(pairs, []), DIGITS - 20)

    return solution, bonded


def under_support(model, title):
    """Solves a model with a stretch of contact around a fixed support. Deflection and pressure are zero at the support."""
    mesh = coarse.solve_on_mesh(model, coarse.graded_mesh(model, 80))
    solution = exact(model, from_answer(model, title), DIGITS, mesh, lambda text: None)
    return solution, lambda: solution.system


def record(title):
    model = Model.from_toml(read(title).to_toml())
    at, l = next(s.at for s in model.supports if s.kind == "fixed"), model.length
    if title == "Extreme 13":
        # One version of the contact iteration returned a stretch without contact, of about the length b - a, at the
        # support.
        a, b = at - 4e-11 * l, at + 4e-11 * l
        solution, bonded = under_support(model, title)
    else:
        a, b = (0.0, at) if title == "Supported 1303" else (at, l)
        solution, bonded = unloaded(model, a, b)
    name = title.lower().replace(" ", "-")
    out = make_record(name, "frozen", None, model, solution, DIGITS)
    with mp.workdps(DIGITS):
        system = solution.system
        out["doubtful"] = {
            "from": position(a),
            "to": position(b),
            "touches": bool(system.topology.touches((mpf(a) + mpf(b)) / 2)),
            "force": short(force_within(bonded(), mpf(a), mpf(b)) / total_force(system)),
            "gap": clearances(system, mpf(a), mpf(b)),
        }
    print(title, out["contact"], out["doubtful"], out["margins"], out["checks"], flush=True)
    return out


# ---- a free beam balanced on one corner of the ground ----------------------------------------------


def balance(title):
    """A free, straight beam that one force presses on the corner of the ground below it.

    u = F exp(-b|x - c|)/(2 sqrt(k mu)), w = u(c) + g0(c) + s (x - c), and u + g0 - w >= 0 bounds the slope s. On either
    side of c, between two corners of the gap, (u + g0 - w(c))/(x - c) is extreme at the ends of the stretch or where its
    derivative vanishes.
    """
    model = Model.from_toml(read(title).to_toml())
    (force,) = model.loads
    c, l, k, mu = force.start, mpf(model.length), mpf(model.k), mpf(model.mu)
    if model.supports or model.P or model.beam_segments or model.ground_segments:
        raise NotImplementedError(title)
    b, F = mp.sqrt(k / mu), mpf(force.value)
    settled = F / (2 * mp.sqrt(k * mu))
    places = model.breakpoints()
    lines = [(mpf(x), mpf(y), *initial_gap(model, x, y, mpf)) for x, y in zip(places, places[1:])]
    corner = next(value for x, _, value, _ in lines if x == c)
    deflection = settled + corner
    low, high = [], []
    for x, y, value, slope in lines:
        right = x >= c
        near, far = (x, y) if right else (y, x)
        height = lambda t: value + slope * (t - x) + settled * mp.exp(-b * abs(t - c)) - deflection
        tangent = lambda t: slope - (1 if right else -1) * b * settled * mp.exp(-b * abs(t - c))
        ratio = lambda t: height(t) / (t - c) if t != c else tangent(t)
        # `stationary` is zero where the derivative of `ratio` is zero. It is monotonic on each side of c, because the
        # sign of height'' is constant.
        stationary = lambda t: tangent(t) * (t - c) - height(t)
        values = [ratio(near), ratio(far)]
        if near != c and stationary(near) * stationary(far) < 0:
            values.append(ratio(mp.findroot(stationary, (near, far), solver="anderson")))
        (high if right else low).extend(values)
    if max(low) > min(high):
        raise ArithmeticError(f"{title}: no slope is free")
    return {
        "name": title.lower().replace(" ", "-"),
        "model": model.to_toml(),
        "at": position(mpf(c)),
        "force": number(F),
        "deflection": number(deflection),
        "settlement": number(settled),
        "slopes": [number(max(low)), number(min(high))],
    }


def main():
    records = to_json([record(title) for title in ("Supported 973", "Supported 1303", "Extreme 13")])
    with mp.workdps(DIGITS):
        one = balance("Gap 738")
    write = lambda v: str(v) if isinstance(v, Number) else json.dumps(v)
    lines = [f'"{k}": ' + (f"[{', '.join(v)}]" if isinstance(v, list) else write(v)) for k, v in one.items()]
    body = ",\n".join(lines)
    (HERE / "doubtful.json").write_text(f'{{"zones": {records},\n"balance": {{\n{body}\n}}}}\n')


if __name__ == "__main__":
    main()
