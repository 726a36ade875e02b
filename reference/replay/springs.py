"""Proves the exact contact set on Winkler ground from the sign of w − g₀ − q/k, and from the sign of its slope near
contact edges."""

from balls import above, exact, sorted_pair


def logged_zones(r):
    """Reads from the log the lengths of the short zones beside contact edges and supports. The keys are the number of a
    piece and an end of this piece (0 left, 1 right)."""
    return {(line["piece"], line["side"]): exact(line["length"]) for line in r.all("zone")}


def check(r):
    """Checks that w − g₀ − q/k has the claimed sign on every piece of Winkler ground, outside the zones at edges and
    at supports that touch the ground."""
    if not r.shown[1]:
        return
    zones = logged_zones(r)
    for i, piece in enumerate(r.pieces):
        if piece.layered or rests(r, i):
            continue
        field = piece.above if piece.touches else -piece.above
        interval, limit = list(piece.t), r.errors[i]["w"]
        for side in (0, 1):
            theta = zones.get((i, side))
            # At a step of the initial gap g₀ or of a load q on the ground, w − g₀ − q/k jumps, so it can change its
            # sign without being zero. Here w is the deflection and k the subgrade modulus.
            steps = field(piece.t[side]) > limit
            if theta is None:
                r.shows(
                    f"the log has no `zone` line for the contact edge or support at node {i + side}",
                    steps or not needs_zone(r, i, side),
                )
                continue
            interval[side] += (1 - 2 * side) * theta / piece.half
            grows = zone(r, r.errors[i], i, side, field, interval[side], limit)
            r.shows(f"it is not proven that |w - g0| increases with the distance from node {i + side}", grows)
        shown = interval[0] < interval[1] and above(field, interval, limit)
        r.shows(f"the sign of w - g0, deflection minus initial gap, on piece {i} is not proven", shown)


def needs_zone(r, i, side):
    """Returns whether w* − g₀ is zero at an end of a piece because a contact edge or a support that touches the
    ground is at this end."""
    other = i - 1 + 2 * side
    beside = 0 <= other < len(r.pieces) and not r.pieces[other].layered
    return beside and r.pieces[other].touches != r.pieces[i].touches or (stands(r, i, side) and r.pieces[i].q is None)


def stands(r, i, side):
    """Whether a rigid two-way support at an end of a piece holds the beam exactly at the unloaded surface of the ground."""
    piece, node = r.pieces[i], r.nodes[i + side]
    held = node.rigid is not None and node.acts == 0
    return held and (node.rigid - piece.ends(piece.g0)[side]).contains(0)


def rests(r, i):
    """Returns whether a piece belongs to an unloaded part of the beam between two clamps, or between a clamp and an
    end of the beam, on level ground at the height of the clamps."""
    last = len(r.pieces)
    parts = lambda node: node in (0, last) or r.nodes[node].clamped
    a = next(node for node in range(i, -1, -1) if parts(node))
    b = next(node for node in range(i + 1, last + 1) if parts(node))
    clamps = [r.nodes[node] for node in (a, b) if r.nodes[node].clamped]
    if not clamps or any(node.acts or not (node.rigid - clamps[0].rigid).contains(0) for node in clamps):
        return False
    bare = lambda piece: all(p.degree() < 0 or p == 0 for p in (piece.f, piece.g, piece.kappa0))
    level = lambda piece: piece.g0.degree() <= 0 and (piece.g0[0] - clamps[0].rigid).contains(0)
    held = lambda node: not all(x is None for x in (node.rigid, node.spring, node.turning))
    free = lambda node: not held(node) and not node.hinged and node.force == 0 and node.moment == 0
    ends = all(r.nodes[node].clamped or free(r.nodes[node]) for node in (a, b))
    along = all(bare(piece) and level(piece) for piece in r.pieces[a:b])
    return ends and along and all(free(r.nodes[node]) for node in range(a + 1, b))


def lies(r, i, side):
    """Returns whether w* − g₀ and its slope are both zero at an end of a piece. This holds at a clamp of a beam
    without shear deformation on level ground."""
    piece, node = r.pieces[i], r.nodes[i + side]
    return stands(r, i, side) and node.clamped and piece.stiffness is None and piece.g0.degree() <= 0


def leaves_support(r, error, i, side, to):
    """Returns whether g₀ − w* grows from zero next to a rigid support that touches open ground of a shear layer. The
    exact settlement u* is nonnegative on this ground."""
    piece = r.pieces[i]
    limit = error["u"] + error["w"]
    return stands(r, i, side) and zone(r, error, i, side, piece.g0 - piece.w, to, limit)


def zone(r, error, i, side, field, to, limit):
    """Returns whether a field grows inward from an end of a piece faster than the error of its slope, up to a value
    above a limit. At a support that touches the ground the field grows from zero. At a clamp the curvature takes the
    place of the slope."""
    piece, end = r.pieces[i], r.pieces[i].t[side]
    slope = piece.d(field)
    if lies(r, i, side):
        grows, off = piece.d(slope), piece.bent(error["M"])
    else:
        grows, off = slope * (1 - 2 * side), error["slope"]
    inside = piece.t[0] <= to <= piece.t[1] if not end == to else False
    return inside and above(grows, sorted_pair(end, to), off) and field(to) > limit
