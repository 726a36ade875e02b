"""Verifies a solution: signs at many points, differential equations, balances and energies by quadrature.

The problem is convex, so a field that satisfies the equations and all sign conditions is the solution. The energy
identity a(w, w) + b(u, u) = F(w) - <p, g0> tests the complete weak form: every jump condition, support and point
contact force contributes to it, while the quadrature does not use these conditions.
"""

from functools import lru_cache

from mpmath import mp, mpf

# Tolerance of sign checks, relative to the field's largest value.
SIGN_TOLERANCE = mpf("1e-40")


def samples(piece):
    """Sample points inside a stretch: Chebyshev points, and points in geometric progression towards both ends."""
    h = piece.b - piece.a
    n = int(min(400, max(48, 6 * piece.fastest() * h)))
    t = {(1 - mp.cos(mp.pi * (2 * i + 1) / (2 * n))) / 2 for i in range(n)}
    for j in range(2, 34, 2):
        t.update((mpf(2) ** -j, 1 - mpf(2) ** -j))
    return [piece.a + h * v for v in sorted(t)]


def sign_report(system):
    """Returns the violations of sign conditions, the scales of the fields, and the smallest value of each kind. A violation
    is (kind, x from, x to, size relative to the scale)."""
    fields = {}
    scales = {name: mpf(0) for name in ("deflection", "slope", "moment", "shear_force",
                                        "settlement", "gap", "pressure")}  # fmt: skip
    for piece in system.pieces:
        points = [piece.a] + samples(piece) + [piece.b]
        fields[id(piece)] = [(x, piece.fields(x)) for x in points]
        for _, f in fields[id(piece)]:
            for name in scales:
                scales[name] = max(scales[name], abs(f[name]))
    depth = max(scales["deflection"], scales["settlement"], scales["gap"])
    scales["depth"] = depth
    bad = []
    worst = {"pressure": mp.inf, "gap": mp.inf, "atom": mp.inf}
    force = total_force(system)
    for piece in system.pieces:
        name = "pressure" if piece.contact else "gap"
        scale = scales["pressure"] if piece.contact else depth
        if scale == 0:
            continue
        run = None
        for x, f in fields[id(piece)][1:-1]:
            v = f[name] / scale
            worst[name] = min(worst[name], v)
            if v < -SIGN_TOLERANCE:
                run = [x, x, v] if run is None else [run[0], x, min(run[2], v)]
            elif run:
                bad.append((name, *run))
                run = None
        if run:
            bad.append((name, *run))
    for node in system.nodes:
        if node.touching and not node.edge:
            v = node.atom() / force if force else mpf(0)
            worst["atom"] = min(worst["atom"], v)
            if v < -SIGN_TOLERANCE:
                bad.append(("atom", node.x, node.x, v))
        elif node.layers and not node.touching:
            for piece in node.layers:
                v = piece.fields(node.x)["gap"] / depth if depth else mpf(0)
                worst["gap"] = min(worst["gap"], v)
                if v < -SIGN_TOLERANCE:
                    bad.append(("gap", node.x, node.x, v))
    return bad, scales, worst


def margins(system, scales):
    """How clearly the zones can be distinguished: the smallest of the largest gaps over all openings,
    and the smallest of the largest pressures or forces over all zones; both relative."""
    force, out = total_force(system), {}
    runs = []  # [contact?, size]
    for i, p in enumerate(system.pieces):
        name, scale = ("pressure", "pressure") if p.contact else ("gap", "depth")
        values = [p.fields(p.a + (p.b - p.a) * j / 8)[name] for j in range(9)]
        size = max(values) / scales[scale] if scales[scale] else mpf(0)
        if p.contact and force:
            size = max([size] + [n.atom() / force for n in system.nodes[i : i + 2]])
        # The openings on the two sides of a contact point count as two openings.
        alone = not p.contact and system.nodes[i].touching
        if runs and runs[-1][0] == p.contact and not alone:
            runs[-1][1] = max(runs[-1][1], size)
        else:
            runs.append([p.contact, size])
    lone = [n.atom() / force for n in system.nodes if n.touching and force
            and not any(p.contact for p in (n.left, n.right) if p)]  # fmt: skip
    openings = [size for contact, size in runs if not contact]
    regions = [size for contact, size in runs if contact] + [v for v in lone if v > SIGN_TOLERANCE]
    if openings:
        out["opening"] = min(openings)
    if regions:
        out["region"] = min(regions)
    return out


def total_force(system):
    """A scale for forces: the sum of the loads' magnitudes, with moments divided by the length."""
    l = mpf(system.model.length)
    size = mp.fsum(abs(n.force) + abs(n.moment) / l for n in system.nodes)
    for p in system.pieces:
        h = p.b - p.a
        for (v, m), unit in ((p.force, 1), (p.moment, l)):
            size += (abs(v) + abs(v + m * h)) / 2 * h / unit
    if size == 0:
        size = max((abs(p.k * p.gap_at(p.a)) * l for p in system.pieces), default=mpf(0))
    return size


@lru_cache(maxsize=None)
def gauss(n, digits):
    """Gauss-Legendre points and weights on [0, 1]."""
    with mp.workdps(digits + 10):
        rule = []
        for i in range(n):
            x = mp.cos(mp.pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
            for _ in range(100):
                p0, p1 = mpf(1), x
                for j in range(2, n + 1):
                    p0, p1 = p1, ((2 * j - 1) * x * p1 - (j - 1) * p0) / j
                slope = n * (x * p1 - p0) / (x * x - 1)
                dx = p1 / slope
                x -= dx
                if abs(dx) < mpf(10) ** (-digits - 5):
                    break
            rule.append(((1 - x) / 2, 1 / ((1 - x * x) * slope**2)))
        return tuple(rule)


def integrals(system, digits=45):
    """Computes energies, work, and the resultants of loads and ground pressure by quadrature."""
    total = {name: mpf(0) for name in ("beam", "ground", "work", "gap", "force", "first",
                                       "loads", "load first")}  # fmt: skip
    rule = gauss(40, 60)
    with mp.workdps(max(60, digits + 15)):
        for p in system.pieces:
            h = p.b - p.a
            parts = int(mp.ceil(p.fastest() * h / 3)) or 1
            for part in range(parts):
                for s, weight in rule:
                    t = h * (part + s) / parts
                    x, dx = p.a + t, weight * h / parts
                    w = [p.value("w", x, m) for m in range(3)]
                    if p.contact or p.layer:
                        u, du = p.value("u", x), p.value("u", x, 1)
                    else:
                        u, du = mpf(0), mpf(0)
                    f, g = p.force[0] + p.force[1] * t, p.moment[0] + p.moment[1] * t
                    total["beam"] += dx * (p.EI * w[2] ** 2 + p.P * w[1] ** 2)
                    total["ground"] += dx * (p.mu * du**2 + p.k * u**2)
                    total["work"] += dx * (f * w[0] + g * w[1])
                    total["loads"] += dx * f
                    total["load first"] += dx * (f * x + g)
                    if p.contact:
                        pressure = p.k * u - p.mu * w[2]
                        total["gap"] += dx * pressure * p.gap_at(x)
                        total["force"] += dx * pressure
                        total["first"] += dx * pressure * x
                p.seen.clear()
        for n in system.nodes:
            piece = n.right or n.left
            w, slope = piece.value("w", n.x), piece.value("slope", n.x)
            total["work"] += n.force * w + n.moment * slope
            total["loads"] += n.force
            total["load first"] += n.force * n.x + n.moment
            atom = n.atom()
            total["force"] += atom
            total["first"] += atom * n.x
            # The initial gap is continuous, so the piece on either side gives the same gap.
            total["gap"] += atom * piece.gap_at(n.x)
            if n.support:
                s = n.support
                total["beam"] += mpf(s.spring) * w**2 + mpf(s.rotational) * slope**2
                up, turn = n.reaction()
                total["force"] += up
                total["first"] += up * n.x + turn
            if n.is_end and n.layers:
                total["ground"] += n.outer * piece.value("u", n.x) ** 2  # outside, closed form
    return total


def balance_report(system):
    """Relative residuals of force, moment and energy balance, and the primal energy."""
    total = integrals(system)
    l, force = mpf(system.model.length), total_force(system)
    first, last = system.pieces[0], system.pieces[-1]
    axial = mpf(system.model.P) * (last.value("w", last.b) - first.value("w", first.a))
    stored = total["beam"] + total["ground"]
    energy = stored / 2 - total["work"]
    clapeyron = -(total["work"] + total["gap"]) / 2
    size = abs(total["beam"]) + total["ground"] + abs(total["work"]) + abs(total["gap"])
    relative = lambda v, scale: abs(v) / scale if scale else abs(v)
    return {
        "energy": energy,
        "force_balance": relative(total["force"] - total["loads"], force),
        # The axial force P exerts the moment P (w(l) - w(0)). At a free end,
        # the transverse force is zero, but the shear force can be nonzero.
        "moment_balance": relative(total["first"] + axial - total["load first"], force * l),
        "energy_balance": relative(energy - clapeyron, size),
    }


def equation_residual(system, scales):
    """Largest relative residual of the differential equations of beam and shear layer at sample points."""
    worst = mpf(0)
    for p in system.pieces:
        for s in (mpf("0.113"), mpf("0.5"), mpf("0.901")):
            x = p.a + s * (p.b - p.a)
            t = x - p.a
            q = p.force[0] + p.force[1] * t - p.moment[1]
            bend, pull = p.EI * p.value("w", x, 4), p.P * p.value("w", x, 2)
            pressure = p.fields(x)["pressure"]
            size = abs(bend) + abs(pull) + abs(pressure) + abs(q)
            if size:
                worst = max(worst, abs(bend - pull + pressure - q) / size)
            if p.layer:
                v, d = p.k * p.value("u", x), p.mu * p.value("u", x, 2)
                if v:
                    worst = max(worst, abs(v - d) / (abs(v) + abs(d)))
    return worst
