"""Finds the exact contact intervals from the contact nodes of a mesh, in four steps: guess, solve, check, correct."""

from mpmath import mp, mpf

from . import coarse
from .analytic import Edge, Rejected, Topology, Vanished, newton
from .model import initial_gap
from .verify import sign_report


def anchors(model):
    """Breakpoints where contact may end without tangency: the beam's ends, jumps of mu, convex
    kinks of the initial gap; where mu = 0 also supports that hold w."""
    l = model.length
    out = {0.0, l}
    x = model.breakpoints()
    for a, b, c in zip(x, x[1:], x[2:]):
        mu_left, mu_right = model.ground_at((a + b) / 2)[1], model.ground_at((b + c) / 2)[1]
        slopes = [initial_gap(model, *s, float)[1] for s in ((a, b), (b, c))]
        if mu_left != mu_right:
            out.add(b)
        elif mu_left > 0 and slopes[1] != slopes[0]:
            out.add(b)
        elif mu_left == 0 and any(s.at == b and s.kind != "spring" for s in model.supports):
            out.add(b)
    return out


def from_mesh(model, solution, shortest, least):
    """Returns the topology in which each group of consecutive mesh nodes in contact is one contact interval or contact
    point."""
    x, touching = solution.x, list(solution.touching)
    close_small_openings(model, solution, touching, shortest, least)
    fixed, n = anchors(model), len(x)
    topology = Topology()
    i = 0
    while i < n:
        if not touching[i]:
            i += 1
            continue
        j = i
        while j + 1 < n and touching[j + 1]:
            j += 1
        if i == j and x[i] in fixed and has_layer(model, x[i]):
            topology.points.append(x[i])
        else:
            left, right = x[i], x[j]
            pair = []
            for index, at, other in ((i, left, i - 1), (j, right, j + 1)):
                if (at in fixed and i != j) or not 0 <= other < n:
                    pair.append(Edge(mpf(at), False))
                elif x[other] in fixed and not has_layer(model, x[other]):
                    pair.append(Edge(mpf(x[other]), False))  # fixed at w = 0: contact is undefined
                else:
                    pair.append(Edge((mpf(at) + mpf(x[other])) / 2, True))
            if pair[0].x < pair[1].x:
                topology.intervals.append(pair)
        i = j + 1
    return topology


def has_layer(model, x):
    tiny = model.length * 1e-9
    return any(
        model.ground_at(y)[1] > 0 for y in (x - tiny, x + tiny) if 0 < y < model.length
    )


def close_small_openings(model, solution, touching, shortest, least):
    """Treats openings shorter than `shortest` with a smaller gap than `least` (relative) as contact.

    Pressure lumped at the nodes may open a cell wrongly. If an opening is real, the sign of the pressure reopens
    it later.
    """
    x, n = solution.x, len(touching)
    depth = max(max(abs(v) for v in solution.w), max(abs(v) for v in solution.u))
    i = 0
    while i < n:
        if touching[i]:
            i += 1
            continue
        j = i
        while j + 1 < n and not touching[j + 1]:
            j += 1
        gaps = []
        for m in range(i, j + 1):
            a, b = (x[m], x[m + 1]) if m + 1 < n else (x[m - 1], x[m])
            v, slope = initial_gap(model, a, b, float)
            g0 = v if m + 1 < n else v + slope * (b - a)
            gaps.append(solution.u[m] + g0 - solution.w[m])
        length = x[min(j + 1, n - 1)] - x[max(i - 1, 0)]
        if length < shortest * model.length and max(gaps) < least * depth:
            touching[i : j + 1] = [True] * (j - i + 1)
        i = j + 1


def corrected(model, topology, violation):
    """Returns the topology with the contact corrected at a violation of a sign condition: negative pressure, gap or
    point force."""
    kind, a, b, _ = violation
    fixed = sorted(mpf(x) for x in anchors(model))
    topology = topology.copy()
    if kind == "pressure":  # open there
        for i, pair in enumerate(topology.intervals):
            if pair[0].x <= a and b <= pair[1].x:
                pieces = []
                if a - pair[0].x > (pair[1].x - pair[0].x) * mpf("1e-8"):
                    pieces.append([pair[0], Edge(a, True)])
                if pair[1].x - b > (pair[1].x - pair[0].x) * mpf("1e-8"):
                    pieces.append([Edge(b, True), pair[1]])
                topology.intervals[i : i + 1] = pieces
                break
    elif kind == "gap":  # touch there
        topology = with_contact(topology, a, b, fixed)
    elif kind == "atom":
        if float(a) in topology.points:
            topology.points.remove(float(a))
        else:
            for i, pair in enumerate(topology.intervals):
                length = pair[1].x - pair[0].x
                if pair[0].x == a and not pair[0].free:
                    pair[0] = Edge(a + length / 50, True)
                    break
                if pair[1].x == a and not pair[1].free:
                    pair[1] = Edge(a - length / 50, True)
                    break
                if pair[0].x < a < pair[1].x:  # inside: open around it
                    small = min(a - pair[0].x, pair[1].x - a) / 50
                    left = [pair[0], Edge(a - small, True)]
                    right = [Edge(a + small, True), pair[1]]
                    topology.intervals[i : i + 1] = [left, right]
                    break
    return topology


def with_contact(topology, a, b, fixed):
    """Adds [a, b] to the contact and merges it with contact intervals that overlap it or are next to it."""
    reach = (b - a) * mpf("1e-3")
    if a == b and a in fixed:
        topology.points.append(float(a))
        return topology
    left, right = Edge(a, True), Edge(b, True)
    for x in fixed:  # an interval that all but reaches an anchor begins there
        if abs(a - x) <= reach:
            left = Edge(x, False)
        if abs(b - x) <= reach:
            right = Edge(x, False)
    rest = []
    for pair in topology.intervals:
        if pair[1].x < left.x - reach or pair[0].x > right.x + reach:
            rest.append(pair)
            continue
        if pair[0].x < left.x:
            left = pair[0]
        if pair[1].x > right.x:
            right = pair[1]
    rest.append([left, right])
    rest.sort(key=lambda pair: pair[0].x)
    points = [x for x in topology.points if not left.x <= x <= right.x]
    return Topology(rest, points)


class Solution:
    """A solved system that satisfies all sign conditions, with the scales of its fields, the number of corrections of
    the contact intervals and the mesh solution."""

    def __init__(self, system, scales, worst, corrections, mesh):
        self.system, self.scales, self.worst = system, scales, worst
        self.corrections, self.mesh = corrections, mesh


def solve(model, digits=100, elements=80, log=None):
    """Returns the verified solution of `model`. Raises `Rejected` if no topology satisfies all sign conditions."""
    say = log or (lambda text: None)
    reasons = []
    for n in (elements, 3 * elements):
        x = coarse.graded_mesh(model, n)
        for _ in range(3):
            mesh = coarse.solve_on_mesh(model, x)
            x = coarse.refined(x, mesh.touching, model.breakpoints(), model.length)
        tried = []
        for shortest, least in ((2e-3, 1e-7), (1.5 / n, 1e-4), (3 / n, 1e-2)):
            topology = from_mesh(model, mesh, shortest, least)
            if describe(topology) in tried:
                continue
            tried.append(describe(topology))
            try:
                return exact(model, topology, digits, mesh, say)
            except Rejected as why:
                reasons.append(f"{n} elements: {why}")
                say(reasons[-1])
    raise Rejected("; ".join(reasons))


def exact(model, topology, digits, mesh, say, rounds=12):
    with mp.workdps(digits):
        for corrections in range(rounds):
            say(describe(topology))
            try:
                system = newton(model, topology, digits - 20)
            except Vanished as gone:  # touched without force, at a support for instance
                say(str(gone))
                topology = gone.topology
                continue
            bad, scales, worst = sign_report(system)
            if not bad:
                return Solution(system, scales, worst, corrections, mesh)
            worst_one = min(bad, key=lambda v: v[3])
            say(f"violated sign condition: {worst_one[0]} {mp.nstr(worst_one[1:], 8)}")
            topology = corrected(model, system.topology, worst_one)
    raise Rejected("no topology satisfies all sign conditions")


def describe(topology):
    mark = lambda e: mp.nstr(e.x, 10) + ("" if e.free else "|")
    spans = [f"[{mark(a)}, {mark(b)}]" for a, b in topology.intervals]
    return "contact " + " ".join(spans + [f"point {x}" for x in topology.points])
