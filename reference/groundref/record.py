"""Converts a solved model to a record of plain data, and a list of records to JSON."""

import json
import random

from mpmath import mp, mpf

from .analytic import newton
from .verify import balance_report, equation_residual, margins, total_force

FIELDS = ("deflection", "slope", "moment", "shear_force", "settlement", "gap", "pressure")
DIGITS = 20
ZERO = mpf("1e-50")  # what is smaller than this against its field's largest value is zero


class Number(str):
    """A decimal that is written into the JSON text unchanged."""


def number(v, scale=None):
    v = mpf(v)
    if v == 0 or (scale and abs(v) < ZERO * scale):
        return Number("0.0")
    return Number(mp.nstr(v, DIGITS, min_fixed=-4, max_fixed=18))


def position(x):
    """Formats a position on the beam: a double as its shortest decimal, any other position (a computed contact edge)
    with 25 digits."""
    if mpf(float(x)) == x:
        return Number(repr(float(x)))
    return Number(mp.nstr(x, 25, min_fixed=-4, max_fixed=18))


def station_places(model, system):
    """Chooses stations with short decimals: some over the whole beam, and one in the middle of every contact zone. No
    station is at a node."""
    l = model.length
    draw = random.Random(len(model.breakpoints()) + 1000 * len(model.loads))
    count = 13
    places = {round_to(l * (i + 0.2 + 0.6 * draw.random()) / count, 6) for i in range(count)}
    for a, b in regions(system):
        if a < b:
            places.add(round_to(float((a + b) / 2), 8))
    joints = [n.x for n in system.nodes]
    clear = lambda x: min(abs(mpf(x) - j) for j in joints) > mpf("1e-9") * l
    return sorted(x for x in places if 0 < x < l and clear(x))


def round_to(v, digits):
    return float(f"{v:.{digits}g}")


def regions(system):
    """Contact zones and contact points from left to right. Adjacent zones are merged."""
    out = []
    for p in system.pieces:
        if p.contact:
            if out and out[-1][1] == p.a:
                out[-1][1] = p.b
            else:
                out.append([p.a, p.b])
    force = total_force(system)
    alone = [
        n.x
        for n in system.nodes
        if n.touching and not any(p.contact for p in n.layers) and n.atom() > ZERO * force
    ]
    out += [[x, x] for x in alone if not any(a <= x <= b for a, b in out)]
    return sorted(out)


def station_table(model, system):
    """Rows (x, side, fields) of all stations and nodes. A position at which a field jumps has a row for each side."""
    rows = []
    for x in station_places(model, system):
        piece = next(p for p in system.pieces if p.a < x < p.b)
        rows.append((mpf(x), "", piece.fields(mpf(x))))
    for node in system.nodes:
        sides = [(p.fields(node.x), s) for p, s in ((node.left, "-"), (node.right, "+")) if p]
        if len(sides) == 2:
            same = all(
                abs(sides[0][0][f] - sides[1][0][f])
                <= mpf("1e-35") * (abs(sides[0][0][f]) + abs(sides[1][0][f]) + mpf("1e-60"))
                for f in FIELDS
            )
            if same:
                sides = [(sides[0][0], "")]
        else:
            sides = [(sides[0][0], "")]
        rows += [(node.x, side, values) for values, side in sides]
    rows.sort(key=lambda r: (r[0], {"-": 0, "": 1, "+": 2}[r[1]]))
    return rows


def make_record(name, family, seed, model, solution, digits, note=None):
    """Creates the record of one model. A second solve with more digits shows how many digits are correct."""
    with mp.workdps(digits):
        system, scales = solution.system, solution.scales
        balance = balance_report(system)
        residual = equation_residual(system, scales)
        rows = station_table(model, system)
    with mp.workdps(digits + 35):
        finer = newton(model, system.topology, digits + 15)
        difference = mpf(0)
        for p, q in zip(system.pieces, finer.pieces):
            for s in (mpf("0.25"), mpf("0.75")):
                x = p.a + s * (p.b - p.a)
                x = min(max(x, q.a), q.b)
                f, g = p.fields(x), q.fields(x)
                for name_ in FIELDS:
                    if scales[name_]:
                        difference = max(difference, abs(f[name_] - g[name_]) / scales[name_])
        for a, b in zip(system.topology.free_edges(), finer.topology.free_edges()):
            difference = max(difference, abs(a.x - b.x) / model.length)
    with mp.workdps(digits):
        force = total_force(system)
        spans = regions(system)
        table = {
            "x": [position(x) for x, _, _ in rows],
            "side": [side for _, side, _ in rows],
        }
        for f in FIELDS:
            table[f] = [number(values[f], scales[f]) for _, _, values in rows]
        inner = [n for n in system.nodes if not n.is_end]
        atoms = [(n.x, n.atom()) for n in inner]
        held = [n for n in system.nodes if n.support]
        record = {
            "name": name,
            "family": family,
            "seed": seed,
            "model": model.to_toml(),
            "contact": [[position(v) for v in span] for span in spans],
            "end_forces": {
                "left": number(system.nodes[0].atom(), force),
                "right": number(system.nodes[-1].atom(), force),
            },
            "inner_forces": [
                {"x": position(x), "force": number(v, force)}
                for x, v in atoms
                if abs(v) > ZERO * force
            ],
            "reactions": [reaction_entry(n, force, model.length) for n in held],
            "primal_energy": number(balance["energy"]),
            "largest": {f: number(scales[f]) for f in FIELDS},
            "margins": {k: short(v) for k, v in margins(system, scales).items()},
            "stations": table,
            "checks": {
                "digits_difference": short(difference),
                "equation": short(residual),
                "force_balance": short(balance["force_balance"]),
                "moment_balance": short(balance["moment_balance"]),
                "energy_balance": short(balance["energy_balance"]),
                "mesh_difference": short(mesh_difference(solution)),
            },
        }
        bare = [n.x for n in system.nodes if touches_without_force(n, spans, scales)]
        if bare:
            record["touching_without_force"] = [position(x) for x in bare]
        if note:
            record["note"] = note
    return record


def touches_without_force(node, spans, scales):
    """Whether the gap is zero at a node that is in no contact zone, such as a support."""
    if any(a <= node.x <= b for a, b in spans):
        return False
    gaps = [p.fields(node.x)["gap"] for p in (node.left, node.right) if p]
    return min(gaps) <= ZERO * scales["depth"]


def reaction_entry(node, force, length):
    up, turn = node.reaction()
    return {
        "at": position(node.x),
        "force": number(up, force),
        "moment": number(turn, force * length),
    }


def mesh_difference(solution):
    """Largest relative difference between the deflection on the mesh and the exact deflection."""
    system, mesh = solution.system, solution.mesh
    worst, pieces = mpf(0), iter(system.pieces)
    piece = next(pieces)
    for x, w in zip(mesh.x, mesh.w):
        while x > piece.b:
            piece = next(pieces)
        worst = max(worst, abs(piece.value("w", mpf(x)) - mpf(str(w))))
    depth = solution.scales["depth"]
    return worst / depth if depth else worst


def short(v):
    return Number(mp.nstr(mpf(v), 2) if v else "0.0")


def to_json(records):
    """Formats records as JSON with one key per line and each array on one line, so that the files are small and a diff
    shows the changed values."""

    def write(v):
        if isinstance(v, Number):
            return str(v)
        if isinstance(v, dict):
            return "{" + ", ".join(f"{json.dumps(k)}: {write(x)}" for k, x in v.items()) + "}"
        if isinstance(v, (list, tuple)):
            return "[" + ", ".join(write(x) for x in v) + "]"
        return json.dumps(v)

    blocks = []
    for r in records:
        lines = []
        for k, v in r.items():
            if k == "stations":
                inner = [f"    {json.dumps(c)}: {write(col)}" for c, col in v.items()]
                lines.append(f'  "{k}": {{\n' + ",\n".join(inner) + "\n  }")
            else:
                lines.append(f"  {json.dumps(k)}: {write(v)}")
        blocks.append("{\n" + ",\n".join(lines) + "\n}")
    return "[\n" + ",\n".join(blocks) + "\n]\n"
