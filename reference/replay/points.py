"""Checks the pointwise error bounds of w, rotation, m, M and u on each piece, and of p where both solutions are in
contact; all follow from E (section 4)."""

from flint import arb

import anchors
from balls import INFINITE, largest, low
from test_functions import kinks, prepare


def check(r):
    """Checks the logged bounds of w, rotation, m, M and u, and without shear deformation also the logged bounds of
    slope and p."""
    prepare(r)
    stiffness = kinks(r)
    for i, (piece, error) in enumerate(zip(r.pieces, r.errors)):
        if piece.layered:
            settled = r.s2 * r.root_g[i] + (r.c[i][0] if piece.touches else r.raised[i])
        else:
            settled = error["w"] + (r.depth[i] / piece.spring.low if piece.touches else r.raised[i])
        r.holds(f"eps_u on piece {i}", settled, error["u"])
        r.holds(f"s2 K on piece {i}", r.test_factor * stiffness[i], error["m"])
        delta = largest(*r.delta[i]) + piece.h**2 * piece.load() / 8 + r.added[i]
        r.holds(f"eps_M on piece {i}", error["m"] + delta, error["M"])
    for part, moved in zip(r.parts(), anchors.deflections(r)):
        on_part(r, part, moved)
    for i, (piece, error) in enumerate(zip(r.pieces, r.errors)):
        if piece.stiffness is None:
            r.holds(f"eps_theta on piece {i}", error["rotation"], error["slope"])
            r.holds(f"eps_p on piece {i}", pressure(r, i, error), error["p"])


def on_part(r, part, moved):
    """Checks ε_w = sup|e| + max|c|, and the bound of the rotation that follows from sup|e| on intervals of length
    h."""
    closed = [largest(*(r.c[i][j] for i in part)) for j in (0, 1)]
    curved = largest(*(r.pieces[i].bent(r.errors[i]["M"]) + r.c[i][2] for i in part))
    s, slid = anchors.flexure(r, part)
    h, found = r.x[part.stop] - r.x[part.start], INFINITE
    for _ in range(60):
        found = found.min(2 * moved / h + slid / h.sqrt() + (h * curved / 2).min(s * (h / 3).sqrt()))
        h *= arb("0.7")
    for i in part:
        r.holds(f"(12) eps_w on piece {i}", moved + closed[0], r.errors[i]["w"])
        r.holds(f"eps_phi on piece {i}", found + closed[1], r.errors[i]["rotation"])


def pressure(r, i, error):
    """Returns ε_p, the bound of the error of the pressure. With shear deformation on a shear layer it is (14a) or
    (14b). On open pieces ε_p bounds the error of (μC′)′."""
    piece = r.pieces[i]
    settled, bent = piece.spring.high * error["u"], piece.bent(error["M"])
    if piece.stiffness is None or not piece.layered:
        turned = arb(0) if piece.shear.even else piece.steepness(piece.shear) * error["slope"]
        return settled + turned + piece.shear.high * bent
    load = piece.load() + piece.size(piece.d(piece.misfit))
    if piece.stiffness.even and piece.shear.even:
        stiffness, shear = piece.stiffness.along[0], piece.shear.along[0]
        if not stiffness + r.force > 0:
            return INFINITE
        whole = settled + shear * stiffness / (stiffness + r.force) * (bent + load / stiffness)
        return whole / (1 + shear / (stiffness + r.force)) if piece.touches else whole
    fixed, turned = parts_of_pressure(r, i, error)
    whole = fixed + turned * error["slope"]
    stiffest = piece.stiffness.high + r.force
    return whole / low(1 + piece.shear.low / stiffest) if piece.touches and stiffest > 0 else whole


def parts_of_pressure(r, i, error):
    """Returns the two parts of (14b): the constant part kε_u + α[|S′|ε_φ + Sε_κ + |r| + |η′|], and the factor |α′|(S
    + P) = |μ′ − αS′| of ε_θ."""
    piece = r.pieces[i]
    least = piece.stiffness.low + r.force
    if not least > 0:
        return INFINITE, INFINITE
    factor, steep = piece.shear.high / low(least), piece.steepness(piece.stiffness)
    forces = steep * error["rotation"] + piece.stiffness.high * piece.bent(error["M"])
    forces += piece.load() + piece.size(piece.d(piece.misfit))
    return piece.spring.high * error["u"] + factor * forces, piece.steepness(piece.shear) + factor * steep
