"""Computes bounds of the deflection error |w − w*| on each part of the beam from anchors, the positions where this
error has a bound (12)."""

from flint import arb

from balance import gamma
from balls import INFINITE, high, low, upper
from ground import root_g_at

REACHES = (0.9, 0.5, 0.25, 0.0625)


class Anchor:
    """A position x with an upper bound of the deflection error |e| or of the rotation error |e_φ|."""

    def __init__(self, x, bound):
        self.x, self.bound = x, bound


def flexure(r, part):
    """Returns s = s₂/√EI_min and s_γ = s₂/√S_min, bounds of the L² norms of the errors of curvature and shear strain
    on a part of the beam. s_γ = 0 without shear deformation."""
    spans = [r.pieces[i] for i in part]
    bent = min((low(piece.bending.low) for piece in spans), key=float)
    stiff = [low(piece.stiffness.low) for piece in spans if piece.stiffness is not None]
    slid = (2 * r.beam_energy / min(stiff, key=float)).sqrt() if stiff else arb(0)
    return (2 * r.beam_energy / bent).sqrt(), slid


def least_pressure(r, i, reach):
    """Returns a lower bound of (1 − γ)p for |t| ≤ reach on a touching piece, with the pressure p and γ = max|λ|.
    Returns zero if the bound is not positive or 1 − γ ≤ ½."""
    least = low(r.pieces[i].pressure(arb(0, reach)))
    kept = 1 - gamma(r, i)
    return least * kept if kept > arb("0.5") and least > 0 else arb(0)


def at_nodes(r, part):
    found = []
    for i in range(part.start, part.stop + 1):
        node, x = r.nodes[i], r.x[i]
        if node.acts:
            bound = pushed(r, i)
            if bound is not None:
                found.append(Anchor(x, bound))
        else:
            if node.rigid is not None:
                found.append(Anchor(x, arb(0)))
            if node.spring is not None:
                found.append(Anchor(x, (2 * r.beam_energy / low(node.spring[0])).sqrt()))
        force = (1 - upper(r.factor[i])) * low(r.jump[i])
        if r.touches[i] and force > 0:
            found.append(Anchor(x, r.s2 * root_g_at(r, i) + r.energy / low(force)))
    return found


def held_slopes(r, part):
    """Returns the positions where the rotation error e_φ has a bound: clamps with e_φ = 0, and rotational springs
    with ½κ_θe_φ² ≤ E."""
    found = []
    for i in range(part.start, part.stop + 1):
        if r.nodes[i].clamped:
            found.append(Anchor(r.x[i], arb(0)))
        if r.nodes[i].turning is not None:
            found.append(Anchor(r.x[i], (2 * r.beam_energy / low(r.nodes[i].turning)).sqrt()))
    return found


def pushed(r, i):
    """Returns the bound of |e| at an active one-way support: E/ρ̄ for a rigid support, (2E/κ)^½ for a spring with κv̄
    > (2κE)^½."""
    pushing, node = r.pushing[i], r.nodes[i]
    if node.spring is not None:
        acts = pushing > (2 * high(node.spring[0]) * r.energy).sqrt()
        return (2 * r.energy / low(node.spring[0])).sqrt() if acts else None
    kept = (1 - upper(r.factor[i])) * low(pushing)
    return r.energy / low(kept) if kept > 0 else None


def pressing(r, i, flexible):
    """Returns the anchors (12) at both ends of an interval of a touching piece on which the pressure p̄ is at least
    p_m > 0."""
    piece, (s, slid), best = r.pieces[i], flexible, None
    for reach in REACHES:
        least = least_pressure(r, i, reach)
        if not least > 0:
            continue
        half = reach * piece.half
        curved, slipped = s * half * half.sqrt(), slid * half.sqrt()
        if piece.layered:
            settled = r.s2 * r.root_g[i]
        else:
            settled = (2 * r.energy / (piece.spring.low * 2 * half)).sqrt()
        mean = settled + r.energy / (least * 2 * half) + arb("0.2310") * curved + arb("0.6667") * slipped
        bound = arb("2.4143") * mean + arb("0.5774") * curved + slipped
        if best is None or bound < best[0]:
            best = (bound, half)
    if best is None:
        return []
    return [Anchor(piece.middle + side * best[1], best[0]) for side in (-1, 1)]


def along(r, part, anchors, slopes, kinks):
    """Returns the bound of |e| on a part of the beam whose slope jumps add up to at most `kinks`. It is the largest
    of the bounds between the anchors and on the overhangs; a bound of the slope can lower the latter."""
    s, slid = flexure(r, part)
    anchors = sorted((a for a in anchors if a.bound.is_finite()), key=lambda anchor: float(anchor.x.mid()))
    if not anchors:
        return INFINITE
    most = anchors[0].bound.max(anchors[-1].bound)
    for a, b in zip(anchors, anchors[1:]):
        gap = upper(b.x - a.x)
        most = most.max(a.bound.max(b.bound) + s * (gap**3 / 48).sqrt() + slid * gap.sqrt() / 2 + kinks * gap / 4)
    for near, end in ((anchors[0], r.x[part.start]), (anchors[-1], r.x[part.stop])):
        if (near.x - end).contains(0):
            continue
        over, least = upper(near.x - end), INFINITE
        for slope in slopes:
            bend = s * over * (upper(slope.x - near.x) + over / 3).sqrt() + slid * over.sqrt()
            least = least.min(near.bound + slope.bound * over + bend)
        for far in anchors:
            gap = abs(far.x - near.x)
            if gap > 0:
                bend = s * (over**2 * (gap + over) / 3).sqrt() + slid * (over * (gap + over) / gap).sqrt()
                least = least.min(near.bound + (near.bound + far.bound) * over / gap + bend)
        most = most.max(least + kinks * over)
    return most


def best_along(r, part, anchors, slopes, kinks=arb(0)):
    """Returns the smallest bound of |e| on a part over several sets of anchors. Each set contains the anchors whose
    own bounds are at most a level."""
    anchors = sorted(anchors, key=lambda anchor: float(anchor.bound.mid()))
    least, count = along(r, part, anchors, slopes, kinks), 1
    while count < len(anchors):
        level = 16 * anchors[count - 1].bound
        while count < len(anchors) and anchors[count].bound <= level:
            count += 1
        least = least.min(along(r, part, anchors[:count], slopes, kinks))
        count += 1
    return least


def kink(r, i):
    """Returns the bound of the error of the hinge rotation |[e_φ]| at an elastic hinge, from ½k_φ[e_φ]² ≤ E; zero at
    a node without hinge."""
    spring = r.nodes[i].hinge
    return arb(0) if spring is None else (2 * r.beam_energy / low(spring)).sqrt()


def deflections(r):
    """Returns the bound of sup|e| on each part. The bound of a part is also an anchor of its neighbours at the common
    hinges. Parts connected by elastic hinges are also bounded together. Under tension one anchor is enough for the
    whole beam."""
    parts = r.parts()
    anchors, slopes = [], [held_slopes(r, part) for part in parts]
    for part in parts:
        flexible = flexure(r, part)
        touching = [i for i in part if r.pieces[i].touches]
        anchors.append(at_nodes(r, part) + [a for i in touching for a in pressing(r, i, flexible)])
    found, used = [INFINITE] * len(parts), [0] * len(parts)
    order = list(range(len(parts)))

    def hand_on(j):
        if found[j].is_finite():
            if j > 0:
                anchors[j - 1].append(Anchor(r.x[parts[j].start], found[j]))
            if j + 1 < len(parts):
                anchors[j + 1].append(Anchor(r.x[parts[j].stop], found[j]))

    for _ in range(2):
        for j in order + order[::-1]:
            count = len(anchors[j]) + len(slopes[j])
            if count != used[j]:
                found[j], used[j] = found[j].min(best_along(r, parts[j], anchors[j], slopes[j])), count
                hand_on(j)
        for joined in r.joined_parts():
            members = [j for j in order if joined.start <= parts[j].start and parts[j].stop <= joined.stop]
            if len(members) < 2 or all(found[j].is_finite() for j in members):
                continue
            places = [a for j in members for a in anchors[j]]
            turned = [a for j in members for a in slopes[j]]
            kinks = sum((kink(r, i) for i in range(joined.start + 1, joined.stop)), arb(0))
            together = best_along(r, joined, places, turned, kinks)
            for j in members:
                found[j] = found[j].min(together)
                hand_on(j)
    if r.tension is not None:
        bounds = [anchor.bound for part in anchors for anchor in part]
        least = min(bounds, key=lambda b: float(b.mid())) if bounds else INFINITE
        drawn = least + (2 * r.energy / low(r.tension) * (r.x[-1] - r.x[0])).sqrt()
        found = [error.min(drawn) for error in found]
    return found
