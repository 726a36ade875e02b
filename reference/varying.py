"""Computes results for beams and ground that vary along a segment: `answers/varying.json`.

    python varying.py PROGRAM [COUNT] PROGRAM: the binary `groundbeam`, which gives the contact zones

An independent computation of the same results, with 45 digits and in first-order form, so that no coefficient is
differentiated:

    w' = theta,  EI theta' = m,  m' = V + N theta - G,  V' = F - kappa w      beam (N = P + mu, kappa = k in contact)
    mu u' = t,   t' = k u                                                    open ground

Each piece without changes of the data is integrated by Taylor steps that are halved until the last terms are below
1e-42. Continuity, jumps and end conditions give a linear system for the states at the left ends of all pieces. The
remaining condition at each contact edge (u' = w' - g0'; w = g0 without a shear layer) determines the edges by
Newton's method. The contact zones are assumed as the program gives them. The signs of pressure, end forces and gap
are checked here. The problem is convex, so equations and signs together prove the solution.
"""

import json
import random
import subprocess
import sys
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 45
TERMS = 48
SMALL = mpf("1e-42")
FIELDS = ("deflection", "slope", "moment", "shear_force", "settlement", "gap", "pressure")


def bernstein(values, ends, x0):
    """Returns the coefficients of the powers of x - x0 of a polynomial with the given Bernstein coefficients on a
    segment."""
    a, b = (mpf(e) for e in ends)
    n = len(values) - 1
    total = [mpf(0)] * (n + 1)
    for i, value in enumerate(values):
        poly = [mpf(value) * mp.binomial(n, i)]
        for k in range(n):
            left, right = (x0 - a) / (b - a), 1 / (b - a)
            c0, c1 = (left, right) if k < i else (1 - left, -right)
            poly = [
                (poly[j] * c0 if j < len(poly) else 0) + (poly[j - 1] * c1 if j else 0)
                for j in range(len(poly) + 1)
            ]
        total = [s + p for s, p in zip(total, poly)]
    return total


def times(p, q):
    out = [mpf(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


def value(p, h):
    total = mpf(0)
    for c in reversed(p):
        total = total * h + c
    return total


def plus(p, q):
    n = max(len(p), len(q))
    return [(p[i] if i < len(p) else 0) + (q[i] if i < len(q) else 0) for i in range(n)]


class Model:
    """A model with the keys of a model file. EI, k and mu are lists of segments (from, to, Bernstein coefficients)."""

    def __init__(self, **given):
        self.__dict__.update(given)

    def places(self):
        x = {0.0, self.length}
        for kind in (self.EI, self.k, self.mu):
            x |= {e for s in kind for e in s[:2]}
        x |= {at for _, _, at in self.points} | {e for s in self.spread for e in s[1:3]}
        x |= {s["at"] for s in self.supports} | {at for at, _ in self.gap}
        return sorted(mpf(v) for v in x if 0 <= v <= self.length)

    def course(self, stretches, middle, x0):
        a, b, values = next(s for s in stretches if s[0] <= middle <= s[1])
        return bernstein(values, (a, b), x0)

    def initial_gap(self, middle, x0):
        if not self.gap:
            return [mpf(0), mpf(0)]
        points = [(mpf(a), mpf(v)) for a, v in self.gap]
        if middle <= points[0][0]:
            return [points[0][1], mpf(0)]
        if middle >= points[-1][0]:
            return [points[-1][1], mpf(0)]
        (a, u), (b, v) = next(p for p in zip(points, points[1:]) if p[0][0] <= middle <= p[1][0])
        rate = (v - u) / (b - a)
        return [u + rate * (x0 - a), rate]

    def load(self, kind, middle, x0):
        total = [mpf(0), mpf(0)]
        for what, a, b, start, end in self.spread:
            if what == kind and a <= middle <= b:
                rate = (mpf(end) - mpf(start)) / (mpf(b) - mpf(a))
                total = plus(total, [mpf(start) + rate * (x0 - mpf(a)), rate])
        return total

    def toml(self):
        lines = ["[beam]", f"length = {self.length}", "EI = 1.0", f"axial_force = {self.P}"]
        say = lambda v: repr(v[0]) if len(v) == 1 else repr(v)
        for a, b, v in self.EI:
            lines += ["", "[[beam.segment]]", f"from = {a}", f"to = {b}", f"EI = {say(v)}"]
        lines += ["", "[foundation]", "k = 1.0"]
        for (a, b, k), (_, _, mu) in zip(self.k, self.mu):
            lines += ["", "[[foundation.segment]]", f"from = {a}", f"to = {b}"]
            lines += [f"k = {say(k)}", f"mu = {say(mu)}"]
        for what, size, at in self.points:
            lines += ["", "[[load]]", f"{what} = {size}", f"at = {at}"]
        for what, a, b, start, end in self.spread:
            lines += ["", "[[load]]", f"{what} = [{start}, {end}]", f"from = {a}", f"to = {b}"]
        for support in self.supports:
            lines += ["", "[[support]]", f"at = {support['at']}"]
            if support["kind"] == "pinned":
                lines += ['type = "pinned"']
            else:
                lines += [f"spring = {support['spring']}"]
        for at, v in self.gap:
            lines += ["", "[[gap]]", f"at = {at}", f"value = {v}"]
        return "\n".join(lines) + "\n"


class Piece:
    """A stretch of the beam with or without contact, and the linear map from the state at its left end to the state
    at its right end."""

    def __init__(self, model, a, b, contact, winkler):
        self.model, self.a, self.b, self.contact, self.winkler = model, a, b, contact, winkler
        self.size = 4 if contact or winkler else 6
        self.steps = []
        x = a
        unit = [[mpf(i == j) for i in range(self.size)] for j in range(self.size)]
        columns, loaded = unit, [mpf(0)] * self.size
        h = b - a
        while x < b:
            h = min(h, b - x)
            if h < mpf("1e-30"):
                break
            while True:
                series = [self.series(x, y, False) for y in unit] + [self.series(x, [mpf(0)] * self.size, True)]
                if all(self.is_short(s, h) for s in series):
                    break
                h /= 2
            self.steps.append((x, min(x + h, b)))
            ends = [[value(c, h) for c in s] for s in series]
            across = lambda y: [sum(ends[j][i] * y[j] for j in range(self.size)) for i in range(self.size)]
            columns = [across(y) for y in columns]
            loaded = [p + q for p, q in zip(across(loaded), ends[-1])]
            x, h = x + h, 2 * h
        self.columns, self.loaded = columns, loaded

    def is_short(self, series, h):
        last = max(abs(c[-1]) * h ** (TERMS - 1) + abs(c[-2]) * h ** (TERMS - 2) for c in series)
        return last <= SMALL * max(abs(c[j]) * h**j for c in series for j in range(6))

    def courses(self, x0):
        m, middle = self.model, (self.a + self.b) / 2
        EI, k, mu = (m.course(s, middle, x0) for s in (m.EI, m.k, m.mu))
        return EI, k, mu, m.initial_gap(middle, x0), m.load("distributed", middle, x0), m.load("distributed_moment", middle, x0)

    def series(self, x0, y, loaded):
        """Returns the Taylor coefficients at x0 of the state. The state is (w, theta, m, V) in contact, and (w,
        theta, m, V, u, t) without contact."""
        EI, k, mu, gap, f, g = self.courses(x0)
        N, kappa = [mpf(self.model.P)], [mpf(0)]
        if self.contact:
            kappa = k
            N = plus(N, mu)
            f = plus(f, times(k, gap))
            g = plus(g, [c * gap[1] for c in mu])
        zero = [mpf(0)]
        f, g = (f, g) if loaded else (zero, zero)
        w, th, m, v = [y[0]], [y[1]], [y[2]], [y[3]]
        u, t = ([y[4]], [y[5]]) if self.size == 6 else ([], [])
        bend, rise = [], []
        at = lambda p, j: p[j] if j < len(p) else mpf(0)
        conv = lambda p, q, j, first=0: sum((p[i] * q[j - i] for i in range(first, min(j, len(p) - 1) + 1)), mpf(0))
        for j in range(TERMS - 1):
            bend.append((m[j] - conv(EI, bend, j, 1)) / EI[0])
            w.append(th[j] / (j + 1))
            th.append(bend[j] / (j + 1))
            m.append((v[j] + conv(N, th, j) - at(g, j)) / (j + 1))
            v.append((at(f, j) - conv(kappa, w, j)) / (j + 1))
            if u:
                rise.append((t[j] - conv(mu, rise, j, 1)) / mu[0])
                u.append(rise[j] / (j + 1))
                t.append(conv(k, u[: j + 1], j) / (j + 1))
        return [w, th, m, v] + ([u, t] if u else [])

    def settle(self, y):
        """Computes and stores the state along the piece from the state y at its left end."""
        self.known = []
        for x0, x1 in self.steps:
            series = self.series(x0, y, True)
            self.known.append((x0, x1, series))
            y = [value(c, x1 - x0) for c in series]

    def fields(self, x):
        x0, _, series = next((s for s in self.known if s[0] <= x <= s[1]), self.known[-1])
        h = x - x0
        state = [value(c, h) for c in series]
        EI, k, mu, gap, f, g = (value(p, h) for p in self.courses(x0))
        _, _, slope_mu, slope_gap = (value([j * c for j, c in enumerate(p)][1:] or [mpf(0)], h) for p in self.courses(x0)[:4])
        w, th, m, v = state[:4]
        P = mpf(self.model.P)
        if self.contact:
            psi, flux = w - gap, mu * (th - slope_gap)
            u, vb = psi, v + flux
            p = k * psi - slope_mu * (th - slope_gap) - mu * m / EI
        else:
            u, vb, p = (state[4] if self.size == 6 else mpf(0)), v, mpf(0)
        out = dict(deflection=w, slope=th, moment=-m, shear_force=-(vb + P * th - g), settlement=u, gap=u + gap - w, pressure=p)
        out["flux"] = flux if self.contact else (state[5] if self.size == 6 else mpf(0))
        return out


class System:
    """The linear problem of the beam on ground for given contact zones."""

    def __init__(self, model, stretches, cache):
        self.model = model
        self.winkler = all(v == [0.0] for _, _, v in model.mu)
        edges = [e for s in stretches for e in s]
        self.x = []
        for x in sorted(model.places() + edges):
            if not self.x or x - self.x[-1] > mpf("1e-25"):
                self.x.append(x)
        self.pieces = []
        for a, b in zip(self.x, self.x[1:]):
            middle = (a + b) / 2
            touch = any(s[0] < middle < s[1] for s in stretches)
            key = (a, b, touch)
            if key not in cache:
                cache[key] = Piece(model, a, b, touch, self.winkler)
            self.pieces.append(cache[key])
        self.free = [e for e in edges if 0 < e < model.length]
        self.solve()

    def sqrt_ground(self, x):
        m = self.model
        k, mu = (m.course(s, x, x)[0] for s in (m.k, m.mu))
        return mp.sqrt(k * mu)

    def jumps(self, x):
        point = lambda kind: sum((mpf(s) for what, s, at in self.model.points if what == kind and abs(mpf(at) - x) < mpf("1e-25")), mpf(0))
        support = next((s for s in self.model.supports if abs(mpf(s["at"]) - x) < mpf("1e-25")), None)
        return point("point"), point("moment"), support

    def solve(self):
        starts, n = [], 0
        for p in self.pieces:
            starts.append(n)
            n += p.size
        rows, right = [], []

        def add(terms, constant):
            row = [mpf(0)] * n
            for start, coefficients in terms:
                for i, c in enumerate(coefficients):
                    row[start + i] += c
            rows.append(row)
            right.append(constant)

        for i, x in enumerate(self.x):
            force, moment, support = self.jumps(x)
            before = self.pieces[i - 1] if i else None
            after = self.pieces[i] if i < len(self.pieces) else None
            functional = {}
            # Expresses each state variable on both sides of x in terms of the unknowns, as a pair (terms, constant).
            for side, p in (("-", before), ("+", after)):
                if p is None:
                    continue
                j = i - 1 if side == "-" else i
                for q in range(p.size):
                    if side == "-":
                        functional[side, q] = ([(starts[j], [p.columns[c][q] for c in range(p.size)])], p.loaded[q])
                    else:
                        functional[side, q] = ([(starts[j], [mpf(c == q) for c in range(p.size)])], mpf(0))

            def linear(*parts):
                """Returns the linear combination of functionals, given as pairs (factor, functional)."""
                terms, constant = [], mpf(0)
                for factor, (t, c) in parts:
                    terms += [(s, [factor * v for v in row]) for s, row in t]
                    constant += factor * c
                return terms, constant

            def demand(parts, wanted):
                terms, constant = linear(*parts)
                add(terms, wanted - constant)

            def total(side, p):
                """Returns the shear force of the beam minus the flux of the ground, as a linear combination. In
                contact the state V already is this difference."""
                parts = [(mpf(1), functional[side, 3])]
                return parts if p.size == 4 else parts + [(mpf(-1), functional[side, 5])]

            here = before or after
            middle = (here.a + here.b) / 2
            gap = value(self.model.initial_gap(middle, x), mpf(0))
            one = "+" if after else "-"
            held = support is not None and support["kind"] == "pinned"
            spring = mpf(support["spring"]) if support is not None and not held else mpf(0)
            resisted = [(spring, functional[one, 0])] if spring else []
            if before and after:
                for q in (0, 1):
                    demand([(mpf(1), functional["+", q]), (mpf(-1), functional["-", q])], mpf(0))
                demand([(mpf(1), functional["+", 2]), (mpf(-1), functional["-", 2])], -moment)
                if held:
                    demand([(mpf(1), functional["+", 0])], mpf(0))
                else:
                    demand(total("+", after) + [(-f, g) for f, g in total("-", before)] + resisted, force)
                if not self.winkler:
                    if before.size == 6 and after.size == 6:
                        for q in (4, 5):
                            demand([(mpf(1), functional["+", q]), (mpf(-1), functional["-", q])], mpf(0))
                    elif before.size != after.size:
                        open_side, other = ("+", "-") if after.size == 6 else ("-", "+")
                        demand([(mpf(1), functional[open_side, 4]), (mpf(-1), functional[other, 0])], -gap)
                continue
            sign = mpf(1) if after else mpf(-1)
            demand([(mpf(1), functional[one, 2])], -sign * moment)
            spring_ground = mpf(0) if self.winkler else self.sqrt_ground(x)
            if here.size == 4:
                wanted = sign * (force + (spring_ground * gap if here.contact else 0))
                outside = spring_ground if here.contact else mpf(0)
                if held:
                    demand([(mpf(1), functional[one, 0])], mpf(0))
                else:
                    demand([(mpf(1), functional[one, 3]), (sign * outside, functional[one, 0])] + [(sign * f, g) for f, g in resisted], wanted)
            else:
                if held:
                    demand([(mpf(1), functional[one, 0])], mpf(0))
                else:
                    demand([(mpf(1), functional[one, 3])] + [(sign * f, g) for f, g in resisted], sign * force)
                demand([(mpf(1), functional[one, 5]), (-sign * spring_ground, functional[one, 4])], mpf(0))
        scale = [max(abs(v) for v in row) for row in rows]
        matrix = mp.matrix([[v / s for v in row] for row, s in zip(rows, scale)])
        y = mp.lu_solve(matrix, mp.matrix([r / s for r, s in zip(right, scale)]))
        for p, start in zip(self.pieces, starts):
            p.settle([y[start + i] for i in range(p.size)])

    def left_over(self):
        """Returns the residual of the edge condition at each contact edge inside the beam."""
        out = []
        for e in self.free:
            i = self.x.index(min(self.x, key=lambda x: abs(x - e)))
            left, right = (p.fields(self.x[i]) for p in (self.pieces[i - 1], self.pieces[i]))
            out.append(left["deflection"] - value(self.model.initial_gap((self.x[i - 1] + e) / 2, e), mpf(0)) if self.winkler else right["flux"] - left["flux"])
        return out


def solve(model, stretches):
    """Solves the model by Newton's method for the contact edges inside the beam."""
    l = mpf(model.length)
    edges = [mpf(e) for s in stretches for e in s]
    free = [i for i, e in enumerate(edges) if 0 < e < l]
    cache = {}  # positions that are not edges stay fixed
    make = lambda edges: System(model, [edges[i : i + 2] for i in range(0, len(edges), 2)], cache)
    system = make(edges)
    for _ in range(5):
        if not free:
            break
        r = system.left_over()
        delta = mpf("1e-16") * l
        jacobian = mp.matrix(len(free), len(free))
        for j, i in enumerate(free):
            moved = list(edges)
            moved[i] += delta
            for row, (a, b) in enumerate(zip(make(moved).left_over(), r)):
                jacobian[row, j] = (a - b) / delta
        step = mp.lu_solve(jacobian, mp.matrix(r))
        for j, i in enumerate(free):
            edges[i] -= step[j]
        system = make(edges)
        if max(abs(s) for s in step) < mpf("1e-26") * l:
            break
    return system, [edges[i : i + 2] for i in range(0, len(edges), 2)]


def record(name, model, stretches):
    system, stretches = solve(model, stretches)
    l = mpf(model.length)
    samples = []
    for p in system.pieces:
        samples += [(p, p.fields(p.a + (p.b - p.a) * mpf(i) / 24)) for i in range(25)]
    largest = {f: max(abs(s[f]) for _, s in samples) for f in FIELDS}
    ends = []
    for x, p, sign in ((mpf(0), system.pieces[0], 1), (l, system.pieces[-1], -1)):
        here = p.fields(x)
        carries = p.contact and not system.winkler
        ends.append(system.sqrt_ground(x) * here["settlement"] - sign * here["flux"] if carries else mpf(0))
    tiny = mpf("1e-28")
    assert all(s["pressure"] >= -tiny * largest["pressure"] for p, s in samples if p.contact), name
    assert all(s["gap"] >= -tiny * largest["deflection"] for _, s in samples), name
    assert all(e >= 0 for e in ends), name
    work = mpf(0)
    for what, size, at in model.points:
        at = mpf(at)
        p = next(p for p in system.pieces if p.a <= at <= p.b)
        work += mpf(size) * p.fields(at)["deflection" if what == "point" else "slope"]
    for p in system.pieces:
        for x0, x1, series in p.known:
            _, _, _, gap, f, g = p.courses(x0)
            whole = plus(times(f, series[0]), times(g, series[1]))
            work += sum(c * (x1 - x0) ** (j + 1) / (j + 1) for j, c in enumerate(whole))
            if p.contact and model.gap:
                h = x1 - x0
                for s, weight in mp.calculus_rule:
                    x = x0 + h * (1 + s) / 2
                    here = p.fields(x)
                    work += weight * h / 2 * here["pressure"] * value(gap, x - x0)
    if model.gap:
        work += sum(e * value(model.initial_gap(x, x), mpf(0)) for e, x in zip(ends, (mpf(0), l)))
    reactions = []
    for support in model.supports:
        x = mpf(support["at"])
        if support["kind"] == "pinned":
            total = mpf(0)
            for p, sign in [(p, 1) for p in system.pieces if p.a == x] + [(p, -1) for p in system.pieces if p.b == x]:
                here = p.fields(x)
                beam = -here["shear_force"] - mpf(model.P) * here["slope"] + value(p.courses(x)[5], mpf(0))
                at_end = x in (0, l)
                total += sign * (beam if at_end and not p.contact else beam - here["flux"])
                if at_end and p.contact and not system.winkler:
                    total += system.sqrt_ground(x) * here["settlement"]
            force, _, _ = system.jumps(x)
            up = force - total
        else:
            p = next(p for p in system.pieces if p.a <= x <= p.b)
            up = mpf(support["spring"]) * p.fields(x)["deflection"]
        reactions.append(dict(at=support["at"], force=up, moment=mpf(0)))
    draw = random.Random(name)
    places = sorted({float(f"{model.length * (i + 0.2 + 0.6 * draw.random()) / 13:.6g}") for i in range(13)} | {0.0, model.length})
    clear = lambda x: x in (0.0, model.length) or min(abs(mpf(x) - v) for v in system.x) > mpf("1e-9") * l
    places = [x for x in places if clear(x)]
    rows = [next(p for p in system.pieces if p.a <= x <= p.b).fields(mpf(x)) for x in places]
    say = lambda v: float(mp.nstr(v, 17))
    return dict(
        name=name,
        family="varying",
        seed=None,
        model=model.toml(),
        contact=[[say(e) for e in s] for s in stretches],
        end_forces=dict(left=say(ends[0]), right=say(ends[1])),
        reactions=[dict(at=r["at"], force=say(r["force"]), moment=0.0) for r in reactions],
        primal_energy=say(-work / 2),
        largest={f: say(largest[f]) for f in FIELDS},
        stations=dict(x=places, side=[""] * len(places), **{f: [say(r[f]) for r in rows] for f in FIELDS}),
    )


def gauss(n=16):
    """Returns the points and weights of Gauss quadrature on [-1, 1]."""
    rule = []
    for i in range(n):
        x = mp.cos(mp.pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(60):
            p, slope = mp.legendre(n, x), n * (x * mp.legendre(n, x) - mp.legendre(n - 1, x)) / (x * x - 1)
            x, before = x - p / slope, x
            if abs(x - before) < mpf("1e-40"):
                break
        slope = n * (x * mp.legendre(n, x) - mp.legendre(n - 1, x)) / (x * x - 1)
        rule.append((x, 2 / ((1 - x * x) * slope**2)))
    return rule


def drawn(seed):
    """Draws a random model whose numbers are short decimals."""
    r = random.Random(f"varying {seed}")
    short = lambda v: float(f"{v:.3g}")
    decade = lambda low, high: short(10 ** r.uniform(low, high))
    length = short(r.uniform(1, 8))
    cut = short(length * r.uniform(0.3, 0.7))
    halves = [(0.0, cut), (cut, length)] if r.random() < 0.5 else [(0.0, length)]
    ground = [(0.0, cut), (cut, length)] if r.random() < 0.4 else [(0.0, length)]
    curve = lambda most, low, high: [decade(low, high) for _ in range(r.randint(2, most))]
    EI = [(a, b, curve(6, -0.7, 0.7)) for a, b in halves]
    k = [(a, b, curve(3, -0.3, 0.7)) for a, b in ground]
    winkler = r.random() < 0.25
    mu = [(a, b, [0.0] if winkler else curve(3, -0.5, 0.7)) for a, b in ground]
    points = [("point", short(r.uniform(0.3, 2)), short(length * r.uniform(0.05, 0.95))) for _ in range(r.randint(1, 3))]
    if r.random() < 0.6:
        points.append(("moment", short(r.uniform(-0.6, 0.6) * length), short(length * r.uniform(0.1, 0.9))))
    if r.random() < 0.3:
        points.append(("point", -0.2, short(length * r.uniform(0.1, 0.9))))
    spread = []
    if r.random() < 0.5:
        spread.append(("distributed", 0.0, cut, short(r.uniform(0, 0.5)), short(r.uniform(0, 0.5))))
    if r.random() < 0.2:
        spread.append(("distributed_moment", cut, length, short(r.uniform(-0.1, 0.1)), short(r.uniform(-0.1, 0.1))))
    supports = []
    if r.random() < 0.3:
        at = r.choice([0.0, cut, length])
        kind = r.choice(["pinned", "spring"])
        supports.append(dict(at=at, kind=kind, spring=1.5))
    gap = [(0.0, 0.0), (cut, short(r.uniform(0, 0.2))), (length, 0.0)] if r.random() < 0.25 else []
    P = short(r.uniform(0.1, 2)) if r.random() < 0.3 else 0.0
    return Model(length=length, EI=EI, k=k, mu=mu, points=points, spread=spread, supports=supports, gap=gap, P=P)


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 40
    mp.calculus_rule = gauss()
    records, seed = [], 0
    while len(records) < count:
        seed += 1
        model = drawn(seed)
        done = subprocess.run([program, "solve", "-", "--json"], input=model.toml(), capture_output=True, text=True)
        if done.returncode != 0:
            assert done.returncode == 3, done.stderr  # 3: no equilibrium
            continue
        answer = json.loads(done.stdout)
        stretches = [[c["from"], c["to"]] for c in answer["contact"]]
        places = [float(x) for x in model.places()]
        # Omits models with contact points, with point contact forces between the beam ends, or with a contact edge at a
        # load, a support or another position that the model gives.
        inner = [e for s in stretches for e in s if 0 < e < model.length]
        plain = all(a < b for a, b in stretches) and not answer["concentrated_forces"]
        if not stretches or not plain or any(abs(e - x) < 1e-9 for e in inner for x in places):
            continue
        records.append(record(f"varying-{seed:03}", model, stretches))
        print(records[-1]["name"], records[-1]["contact"], flush=True)
        lines = [json.dumps(r) for r in records]
        path = Path(__file__).resolve().parent / "answers" / "varying.json"
        path.write_text("[\n" + ",\n".join(lines) + "\n]\n")


if __name__ == "__main__":
    main()
