"""Constructs a pressure in exact equilibrium: residuals (5), the moment δ of the cells, the system (6) of the factors
λ, and the moments and forces that the factors λ add (7)."""

from flint import arb, arb_poly

from balls import below, exact, largest, positive_part, upper
from deflection import at_support


def check(r):
    pulls(r)
    residuals(r)
    solve(r)


def pulls(r):
    """Checks on each touching piece that the pressure p is at least −η, and that p < 0 only on a set of measure at
    most ω."""
    r.depth, r.width = [], []
    for i, (piece, line) in enumerate(zip(r.pieces, r.all("pull"))):
        r.depth.append(exact(line["depth"]))
        r.width.append(exact(line["width"]))
        if piece.touches:
            deepest, measure = below(piece.pressure, piece.t)
            r.holds(f"depth of pulls on piece {i}", deepest, r.depth[i])
            r.holds(f"width of pulls on piece {i}", (measure * piece.half).min(piece.h), r.width[i])


def pull(r, i):
    return r.depth[i] * r.width[i] if r.pieces[i].touches else arb(0)


def pushes(r, i):
    """Returns the force of a one-way support in its direction: the claimed reaction of a rigid support, or κ(w̄ − δ)⁺
    of a spring."""
    node = r.nodes[i]
    if node.acts == 0:
        return arb(0)
    if node.spring is not None:
        return positive_part(node.towards(node.spring[0] * r.value[i] - node.spring[1]))
    force = node.towards(node.reaction[0])
    r.shows(f"the reaction of the one-way support at node {i} acts against its direction", force >= 0)
    return force


def residuals(r):
    """Computes the residuals of force and moment at the nodes, equation (5) of docs/proof.md."""
    r.pushing = [pushes(r, i) for i in range(len(r.nodes))]
    r.at_node = []
    for i, node in enumerate(r.nodes):
        force = node.force - positive_part(r.jump[i]) - node.reaction[0]
        moment = node.moment - node.reaction[1]
        if i > 0:
            left = r.pieces[i - 1]
            force -= left.ends(left.transverse)[1]
            moment += left.ends(left.moment)[1]
        if i < len(r.pieces):
            right = r.pieces[i]
            force += right.ends(right.transverse)[0]
            moment -= right.ends(right.moment)[0]
        w, slope = at_support(r, i)
        if node.spring is not None:
            force -= node.towards(r.pushing[i]) if node.acts else node.spring[0] * w - node.spring[1]
        if node.turning is not None:
            moment -= node.turning * slope
        r.at_node.append([force, moment])


def carried(r, i):
    weights = r.nodes[i].weights
    return positive_part(r.jump[i]) + weights["rigid"] + weights["spring"] + r.pushing[i]


def turned_in(r, a, b):
    inside = r.nodes[a : b + (1 if b == len(r.pieces) else 0)]
    return sum((node.weights["clamp"] + node.weights["turning"] for node in inside), arb(0))


def gamma(r, i):
    """Returns γ, the largest |λ| on a piece. The claimed pressure times 1 + λ is in equilibrium with the loads."""
    return largest(r.factor[i], r.factor[i + 1])


def solve(r):
    """Solves the system (6) for λ, the relative change of the pressure, at the cuts. Checks that all pivots are
    positive."""
    count, cuts = len(r.pieces), r.cuts
    inner_hinges = [i for i in range(1, count) if r.nodes[i].free_hinge]
    r.shows(
        "the cuts of the beam are not sorted, or an end of the beam or a free hinge is not a cut",
        {0, count, *inner_hinges} <= set(cuts) and cuts == sorted(cuts),
    )
    r.delta, r.delta_slope = [None] * count, [None] * count
    diagonal = [carried(r, node) for node in cuts]
    right = [r.at_node[node][0] for node in cuts]
    beside = [arb(0)] * (len(cuts) - 1)
    for j, (a, b) in enumerate(zip(cuts, cuts[1:])):
        shears = cell(r, a, b)
        right[j] -= shears[0]
        right[j + 1] += shears[1]
        terms, widened = masses(r, a, b)
        diagonal[j] += terms[0] + widened
        beside[j] += terms[1] + widened
        diagonal[j + 1] += terms[2] + widened
        right[j] += widened
        right[j + 1] += widened
    for j in range(len(cuts)):
        r.shows(f"(6) pivot {j} is not positive", diagonal[j] > 0)
        if j + 1 < len(cuts):
            factor = beside[j] / diagonal[j]
            diagonal[j + 1] -= factor * beside[j]
            right[j + 1] -= factor * right[j]
    for j in reversed(range(len(cuts))):
        if j + 1 < len(cuts):
            right[j] -= beside[j] * right[j + 1]
        right[j] /= diagonal[j]
    give_back(r, right)


def masses(r, a, b):
    """Returns the three entries of the matrix of (6) from one cell: ∫φ_jφ_k p plus the terms of inner nodes, clamps
    and tension. Also returns the radius by which negative pressures widen these entries."""
    ends = [r.x[a], r.x[b]]
    per_length = 1 / (ends[1] - ends[0])
    points = [(turned_in(r, a, b) + r.carrier * (ends[1] - ends[0]), [-per_length, per_length])]
    for i in range(a + 1, b):
        points.append((carried(r, i), [(ends[1] - r.x[i]) * per_length, (r.x[i] - ends[0]) * per_length]))
    terms = [arb(0), arb(0), arb(0)]
    for mass, (p, q) in points:
        for k, product in enumerate((p * p, p * q, q * q)):
            terms[k] += mass * product
    pulled = arb(0)
    for i in range(a, b):
        piece = r.pieces[i]
        if not piece.touches:
            continue
        slope = piece.half * per_length
        hats = [
            arb_poly([(ends[1] - piece.middle) * per_length, -slope]),
            arb_poly([(piece.middle - ends[0]) * per_length, slope]),
        ]
        for k, product in enumerate((hats[0] * hats[0], hats[0] * hats[1], hats[1] * hats[1])):
            terms[k] += piece.integral(product * piece.pressure)
        pulled += pull(r, i)
    return terms, arb(0, upper(pulled))


def cell(r, a, b):
    """Computes the moment δ that balances the residuals of a cell, and returns −δ′ at both ends of the cell."""
    ends = [r.at_node[a][1], arb(0)]
    if r.nodes[a].free_hinge:
        ends[0] = -r.pieces[a].ends(r.pieces[a].moment)[0]
    if r.nodes[b].free_hinge:
        ends[1] = -r.pieces[b - 1].ends(r.pieces[b - 1].moment)[1]
    elif b == len(r.pieces):
        ends[1] = -r.at_node[b][1]
    inner = {i: r.at_node[i] for i in range(a + 1, b)}
    loads = []
    moment = ends[0] - ends[1]
    for i in range(a, b):
        piece = r.pieces[i]
        whole = piece.integral(piece.residual)
        turned = piece.integral(piece.residual * arb_poly([0, 1]))
        about_right = (piece.t[1] * whole - turned) * piece.half
        loads.append((whole, about_right))
        force, turn = inner.get(i, [arb(0), arb(0)])
        levers = [r.x[b] - r.x[i], r.x[b] - r.x[i + 1]]
        moment += turn - force * levers[0] - about_right - whole * levers[1]
    first = moment / (r.x[b] - r.x[a])
    shear, delta = first, ends[0]
    for i, (whole, about_right) in zip(range(a, b), loads):
        force, turn = inner.get(i, [arb(0), arb(0)])
        shear, delta = shear + force, delta + turn
        after = delta - shear * r.pieces[i].h - about_right
        r.delta[i] = [delta, after]
        r.delta_slope[i] = [shear, shear + whole]
        shear, delta = shear + whole, after
    return first, shear


def give_back(r, factors):
    """Computes λ at the nodes and (7), the moment and the shear force of the distributed forces. Checks |λ| < ½ for
    all contact forces."""
    count = len(r.pieces)
    r.factor = [arb(0)] * (count + 1)
    r.added, r.added_shear, r.steep = [None] * count, [None] * count, [None] * count
    for j, (a, b) in enumerate(zip(r.cuts, r.cuts[1:])):
        length = r.x[b] - r.x[a]
        slope = (factors[j + 1] - factors[j]) / length
        for i in range(a, b + 1):
            hats = [(r.x[b] - r.x[i]) / length, (r.x[i] - r.x[a]) / length]
            r.factor[i] = hats[0] * factors[j] + hats[1] * factors[j + 1]
        load = arb(0)
        for i in range(a, b):
            load += gamma(r, i) * upper(r.pieces[i].integral(r.pieces[i].pressure)) + (1 + gamma(r, i)) * pull(r, i)
            if i > a:
                load += upper(r.factor[i]) * upper(carried(r, i))
        couple = upper(turned_in(r, a, b)) * upper(slope)
        for i in range(a, b):
            r.added[i] = length * load / 4 + couple
            r.added_shear[i] = load + couple / length
            r.steep[i] = upper(slope)
    # `drawn` is |β| on each piece. The tension P exerts the transverse force Pw′ + β, with β proportional to the slope
    # of λ.
    r.drawn = [r.carrier * steep for steep in r.steep]
    if r.carrier > 0:
        r.shows("the axial force carries a part of the transverse loads, but it is not tensile", r.tension is not None)
    for i, piece in enumerate(r.pieces):
        if piece.touches:
            r.shows(f"the relative pressure change |lambda| on piece {i} is not below 1/2", gamma(r, i) < arb("0.5"))
    for i in range(count + 1):
        if not positive_part(r.jump[i]) == 0 or not r.pushing[i] == 0:
            r.shows(f"the relative force change |lambda| at node {i} is not below 1/2", upper(r.factor[i]) < arb("0.5"))
