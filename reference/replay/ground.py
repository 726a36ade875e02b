"""Computes the settlement ū of the ground, the point forces of shear layers and the residual of ū in the equation of
the ground (4a), and checks the bounds of √g."""

from flint import arb, arb_poly

from balls import exact, high, low, negative_part, upper


def check(r):
    """Solves the open ground between touching nodes, computes the jumps of the flux μu′, and checks the logged bounds
    of √g."""
    count = len(r.pieces)
    r.u = [None] * (count + 1)
    # On open pieces where k or μ varies, `along` is the settlement u, and `missed` is a bound of |ku − (μu′)′ − q| for
    # the ground load q.
    r.along, r.missed = [None] * count, [arb(0)] * count
    # `flux` is the flux μu′ at both ends of each open piece.
    r.flux = [None] * count
    r.jump = [arb(0)] * (count + 1)
    r.root_g = [exact(line["root_g"]) for line in r.all("ground")]
    r.unclaimed = arb(0)
    for side in (0, 1):
        r.shows(
            f"the loads on the ground outside the beam, side {side}: they act upward",
            r.pushed[side] >= 0 or r.pushed[side].contains(0),
        )
    for i, piece in enumerate(r.pieces):
        if piece.layered and piece.touches:
            r.shows(f"piece {i} touches the ground, but one of its nodes does not", r.touches[i] and r.touches[i + 1])
    for first, end in r.layers():
        flexibility(r, first, end)
        layer(r, first, end)


def link(piece):
    """Returns the two stiffnesses (4) of the ground under an open piece, for the smallest k and μ of the piece. K₁ acts
    between the ends of the piece, and K₂ at each of these ends."""
    spring, shear = piece.spring.least, piece.shear.least
    z, root = (spring / shear).sqrt() * piece.h, (spring * shear).sqrt()
    return root / z.sinh(), root * (z / 2).tanh()


def flexibility(r, first, end):
    """Checks the logged bound of √g on each piece. It must be at least the root of the smaller of 1/(least K₋ + least
    K₊) and coth(bL)/√(kμ), the latter with the least k and μ of the layer."""
    stiffness = [behind(r, first, end, 0), behind(r, first, end, 1)]
    spans = r.pieces[first:end]
    spring, shear = (min((low(c.least) for c in of), key=float) for of in zip(*((p.spring, p.shear) for p in spans)))
    rate = (spring / shear).sqrt() * (r.x[end] - r.x[first])
    whole = (spring * shear).sqrt() * rate.tanh()
    for i in range(first, end):
        least = sum((low(s[i - first]).min(low(s[i - first + 1])) for s in stiffness), arb(0))
        r.holds(f"sqrt(g) on piece {i}", (1 / least).min(1 / whole).sqrt(), r.root_g[i])


def behind(r, first, end, side):
    """Returns the stiffness of the shear layer on one side of each node, as if the whole layer were out of
    contact."""
    at_end = first == 0 if side == 0 else end == len(r.pieces)
    stiffness = [r.outside[side] if at_end else arb(0)]
    for i in range(first, end) if side == 0 else reversed(range(first, end)):
        across, own = link(r.pieces[i])
        inner = stiffness[-1]
        stiffness.append(across * (inner + own) / (inner + own + across) + own)
    return stiffness if side == 0 else stiffness[::-1]


def layer(r, first, end):
    """Computes u at the nodes of one layer, one run of open pieces after another, and the forces at the touching
    nodes."""
    nodes = range(first, end + 1)
    for i in nodes:
        if r.touches[i]:
            piece, side = (r.pieces[i], 0) if i < end else (r.pieces[i - 1], 1)
            r.u[i] = r.value[i] - piece.ends(piece.g0)[side]
    i = first
    while i < end:
        a = i
        i += 1
        if r.pieces[a].touches:
            continue
        while i < end and not r.touches[i]:
            i += 1
        run(r, first, end, a, i)
    for i in nodes:
        if r.touches[i]:
            r.jump[i] = jump(r, first, end, i)
            r.unclaimed += negative_part(r.jump[i]) * root_g_at(r, i)


def run(r, first, end, a, b):
    """Computes u and the flux on the open pieces from a to b − 1. If k and μ are constant, u is solved; otherwise the
    stored u is used."""
    if all(piece.even_ground for piece in r.pieces[a:b]):
        solve(r, first, end, a, b)
        return
    open_nodes = [i for i in range(a, b + 1) if not r.touches[i]]
    for i in open_nodes:
        stored = [r.pieces[j].stored[side] for j, side in ((i - 1, 1), (i, 0)) if first <= j < end and r.pieces[j].stored]
        r.u[i] = stored[0] if stored else arb(0)
    missed = arb(0)
    for i in range(a, b):
        piece = r.pieces[i]
        if piece.even_ground:
            free = free_fluxes(piece)
            r.flux[i] = [elastic + more for elastic, more in zip(fluxes(piece, *r.u[i : i + 2]), free)]
            continue
        r.along[i] = with_ends(piece, r.u[i : i + 2])
        surface = piece.d(r.along[i])
        r.flux[i] = [mu * slope for mu, slope in zip(piece.shear.ends, piece.ends(surface))]
        rest = piece.spring * r.along[i] - piece.d(piece.shear * surface)
        r.missed[i] = piece.size(rest if piece.q is None else rest - piece.q)
        missed += piece.h * r.missed[i] ** 2 / piece.spring.low
    r.unclaimed += missed.sqrt()
    for i in open_nodes:
        r.unclaimed += upper(jump(r, first, end, i)) * root_g_at(r, i)


def with_ends(piece, ends):
    """Returns the sum of the stored settlement and the linear function that makes it equal to `ends` at both ends of
    the piece."""
    stored = arb_poly([]) if piece.settlement is None else piece.settlement
    missed = [u - s for u, s in zip(ends, piece.ends(stored))]
    slope = (missed[1] - missed[0]) / (piece.t[1] - piece.t[0])
    return stored + arb_poly([missed[0] - slope * piece.t[0], slope])


def free_fluxes(piece):
    """Returns the flux at both ends of an open piece due to its load q, if u = 0 at both ends. It is the flux (4) of
    v = u − q/k, plus μq′/k."""
    across, own = link(piece)
    (a, b), slope = piece.ends(piece.free), (piece.shear.along * piece.d(piece.free))[0]
    return [slope - across * (b - a) + own * a, slope - across * (b - a) - own * b]


def fluxes(piece, left, right):
    """Returns the flux μu′ at both ends of a piece that is out of contact and without load on the ground, by (4) of
    docs/proof.md."""
    across, own = link(piece)
    return [across * (right - left) - own * left, across * (right - left) + own * right]


def rise(r, i):
    """Returns the increase of w̄ − g₀ from the left to the right end of a piece, computed without the constant
    coefficient."""
    left, right = r.pieces[i].ends(r.pieces[i].obstacle + r.closing[i] - (r.pieces[i].obstacle + r.closing[i])[0])
    return right - left


def solve(r, first, end, a, b):
    """Solves the tridiagonal system for u at the nodes between a and b. At each of these nodes the flux jumps by the
    load Q on the ground.

    u = Au_a + Bρ + G with ρ = u_b − u_a, or Au_b + G where a does not touch: the columns A, B and G lose no digits
    if a short piece gives a large flux for a small difference."""
    nodes = list(range(a + r.touches[a], b + 1 - r.touches[b]))
    known = {a: (arb(1), arb(0), arb(0)), b: (arb(1), arb(r.touches[a]), arb(0))}
    diagonal, beside, right = [], [], []
    for i in nodes:
        total, load = arb(0), [arb(0), arb(0), r.nodes[i].ground_force]
        for side, j in ((0, i - 1), (1, i)):
            if not first <= j < end:
                if i == (0, len(r.pieces))[side]:
                    total += r.outside[side]
                    load[2] += r.pushed[side]
                continue
            across, own = link(r.pieces[j])
            total += across + own
            load[2] += free_fluxes(r.pieces[j])[1 - side] * (-1 if side == 0 else 1)
            other = j if side == 0 else j + 1
            if other not in nodes:
                load = [x + across * u for x, u in zip(load, known[other])]
            elif side == 1:
                beside.append(-across)
        diagonal.append(total)
        right.append(load)
    for i in range(1, len(diagonal)):
        factor = beside[i - 1] / diagonal[i - 1]
        diagonal[i] -= factor * beside[i - 1]
        right[i] = [x - factor * y for x, y in zip(right[i], right[i - 1])]
    found = dict(known)
    for i in reversed(range(len(diagonal))):
        if i + 1 < len(diagonal):
            right[i] = [x - beside[i] * y for x, y in zip(right[i], found[nodes[i + 1]])]
        found[nodes[i]] = [x / diagonal[i] for x in right[i]]
    base = r.u[a] if r.touches[a] else r.u[b] if r.touches[b] else arb(0)
    risen = sum((rise(r, i) for i in range(a, b)), arb(0)) if r.touches[a] and r.touches[b] else arb(0)
    value = lambda columns: columns[0] * base + columns[1] * risen + columns[2]
    for i in nodes:
        r.u[i] = value(found[i])
    for i in range(a, b):
        columns = zip(*(fluxes(r.pieces[i], left, right) for left, right in zip(found[i], found[i + 1])))
        r.flux[i] = [value(list(each)) + free for each, free in zip(columns, free_fluxes(r.pieces[i]))]


def jump(r, first, end, node):
    """Returns the jump of the flux at a node, the left value minus the right value, minus the force on the ground at
    this node."""
    return flux(r, first, end, node, 0) - flux(r, first, end, node, 1) - r.nodes[node].ground_force


def flux(r, first, end, node, side):
    """Returns the flux μu′ on one side of a node."""
    j = node - 1 if side == 0 else node
    if not first <= j < end:
        if node != (0, len(r.pieces))[side]:
            return arb(0)
        outward = r.outside[side] * r.u[node] - r.pushed[side]
        return outward if side == 0 else -outward
    piece = r.pieces[j]
    if piece.touches:
        return piece.shear.ends[1 - side] * piece.ends(piece.d(piece.obstacle))[1 - side]
    return r.flux[j][1 - side]


def root_g_at(r, node):
    """Returns the smaller of the bounds of √g in the log for the two pieces next to a node, where g is the settlement
    of the ground under a unit force."""
    beside = [r.root_g[i] for i in (node - 1, node) if 0 <= i < len(r.pieces)]
    return min((high(x) for x in beside), key=float)


def arc(r, i, t):
    """Returns the settlement u of the ground and its slope u′ at the position t of a piece of a shear layer that is out
    of contact."""
    piece = r.pieces[i]
    if r.along[i] is not None:
        return r.along[i](t), piece.d(r.along[i])(t)
    rate = (piece.spring.least / piece.shear.least).sqrt()
    x, z = (t - piece.t[0]) * piece.half, rate * piece.h
    left, right = (u - q for u, q in zip(r.u[i : i + 2], piece.ends(piece.free)))
    value = (left * (z - rate * x).sinh() + right * (rate * x).sinh()) / z.sinh()
    slope = rate * (right * (rate * x).cosh() - left * (z - rate * x).cosh()) / z.sinh()
    return value + piece.free(t), slope + piece.d(piece.free)(t)


def clearance(r, i, t, bar=None):
    """Returns the clearance C and its derivatives C′ and C″ at the position t of an open piece of a shear layer. If
    `bar` is the closing deflection c, it returns those of C̄ = C − c."""
    piece = r.pieces[i]
    obstacle = piece.obstacle if bar is None else piece.obstacle + bar
    first = piece.d(obstacle)
    u, slope = arc(r, i, t)
    if r.along[i] is not None:
        curved = piece.d(piece.d(r.along[i]))(t)
    else:
        curved = piece.spring.least / piece.shear.least * (u - piece.free(t))
    return u - obstacle(t), slope - first(t), curved - piece.d(first)(t)


def least(r, i, t, order, bar=None, sign=1):
    """Returns a lower bound of C, or with `order` 1 of ±C′, on an interval of t. The bound follows from the value at
    the midpoint and from the largest next derivative."""
    middle, reach = arb(t.mid()), arb(t.rad())
    steep = upper(clearance(r, i, t, bar)[order + 1]) * r.pieces[i].half
    return clearance(r, i, middle, bar)[order] * sign - steep * reach
