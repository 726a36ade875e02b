"""Checks the clearance C̄ = ū + g₀ − w̄ over open ground: the height D by which the ground is raised, and the energy
of this correction (10)."""

from flint import arb

from balls import below, exact, high, negative_part, on, sorted_pair
from ground import clearance, least


def check(r):
    """Checks C̄ ≥ −D min(x/d, 1) on open stretches of shear layers, w̄ − g₀ − q/k ≤ η_o on open Winkler ground, and
    the energies of both corrections."""
    line = r.one("clearance")
    r.lifted, r.risen = exact(line["lifted"]), exact(line["risen"])
    r.raised = [exact(ground["raised"]) for ground in r.all("ground")]
    cost = arb(0)
    for i, piece in enumerate(r.pieces):
        if piece.touches or piece.layered:
            continue
        depth, measure = below(-(piece.above + r.closing[i]), piece.t)
        r.holds(f"the penetration on the open piece {i}", depth, r.raised[i])
        cost += piece.spring.high * depth**2 * (measure * piece.half).min(piece.h)
    r.holds("(sum k eta_o^2 omega_o)^1/2", cost.max(arb(0)).sqrt(), r.risen)
    cost = arb(0)
    for first, end in r.layers():
        i = first
        while i < end:
            a = i
            i += 1
            if r.pieces[a].touches:
                continue
            while i < end and not r.touches[i]:
                i += 1
            cost += stretch(r, a, i)
    r.holds("(10) (sum |v|^2)^1/2", cost.sqrt(), r.lifted)


def stretch(r, first, end):
    """Returns ‖v‖_b², twice the energy of the correction v of the ground, for the open pieces between two touching
    nodes, or from a touching node to the end of the layer. Also proves C̄ ≥ −D min(x/d, 1)."""
    depth = min(r.raised[first:end], key=float) * (1 + r.ROUNDING)
    touching = [r.touches[first], r.touches[end]]
    stiffness = arb(0)
    for i in range(first, end):
        piece, interval = r.pieces[i], list(r.pieces[i].t)
        stiffness += piece.spring.high * piece.h
        here = [i == first and touching[0], i + 1 == end and touching[1]]
        for side in (0, 1):
            if not here[side]:
                continue
            reach = ramp(r, i, side, here[1 - side], depth)
            r.shows(
                f"the lower bound of the clearance next to node {i + side} is not proven, see (10) in docs/proof.md",
                reach is not None,
            )
            if reach is not None:
                interval[side] = reach
                stiffness += piece.shear.high / abs((reach - piece.t[side]) * piece.half)
        if interval[0] < interval[1]:
            clear = on(interval, lambda t: least(r, i, t, 0, r.closing[i]) >= -depth)
            r.shows(
                f"the lower bound -D of the clearance on piece {i} is not proven; D is the height by which the proof "
                "raises the ground, see (10) in docs/proof.md",
                clear,
            )
    for side, node in ((0, first), (1, end)):
        if node == (0, len(r.pieces))[side] and not touching[side]:
            stiffness += high(r.outside[side])
    return depth**2 * stiffness


def ramp(r, i, side, both, depth):
    """Returns the farthest position t such that C̄ ≥ −Dx/d is proven between the node and t. The proof uses C̄″ ≥ 0
    between both and C̄′ ≥ −D/d at the node, or C̄′ ≥ −D/d between both."""
    piece, bar, inward = r.pieces[i], r.closing[i], 1 - 2 * side
    end, part = piece.t[side], arb("0.5") if both else arb(1)
    slope = r.flux[i][side] / piece.shear.ends[side] - piece.d(piece.obstacle + bar)(end)
    steep = negative_part(slope * inward)
    for _ in range(60):
        reach = end + inward * (piece.t[1] - piece.t[0]) * part
        distance = abs(reach - end) * piece.half
        interval = sorted_pair(end, reach)
        if steep * distance <= depth and on(interval, lambda t: clearance(r, i, t, bar)[2] >= 0):
            return reach
        if on(interval, lambda t: least(r, i, t, 1, bar, inward) >= -depth / distance):
            return reach
        part /= 2
    return None
