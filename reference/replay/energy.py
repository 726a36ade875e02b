"""Checks the bound E of the energy of the error (11), a sum of the parts of beam (9), (9a), ground (8), supports and
hinges."""

from flint import arb

from balls import positive_part, upper
from balance import gamma, pull
from deflection import at_support
from ground import root_g_at


def check(r):
    """Checks that the sum (11) of docs/proof.md, a bound of the energy of the error, is at most the bound E in the log.
    Stores the terms of the sum."""
    bent, r.turned, touching, pulled = arb(0), arb(0), arb(0), arb(0)
    bending = misfit = sheared = carried = arb(0)
    for i, piece in enumerate(r.pieces):
        c = r.c[i]
        bent += piece.h * piece.bending.high * c[2] ** 2
        r.turned += piece.h * c[1] ** 2
        bending += moment_norm(r, i) ** 2 / piece.bending.low
        if piece.stiffness is not None:
            misfit += piece.h * piece.size(piece.misfit) ** 2 / piece.stiffness.low
            sheared += shear_norm(r, i) ** 2 / piece.stiffness.low
        if piece.touches:
            touching += piece.h * (piece.spring.high * c[0] ** 2 + piece.shear.high * c[1] ** 2)
            pulled += r.depth[i] * (r.width[i] / piece.spring.low).sqrt()
        if r.tension is not None:
            carried += piece.h * r.drawn[i] ** 2 / r.tension
    missed = touching.sqrt() + r.unclaimed + pulled
    ground = missed + given_back(r, missed).sqrt() + r.lifted + r.risen
    parts = {
        "(||delta|| + ||c||_beam)^2": (bending.sqrt() + bent.sqrt()) ** 2,
        "springs": springs(r),
        "hinges": hinges(r),
    }
    if r.shears:
        parts["(||eta|| + ||delta'||)^2"] = (misfit.sqrt() + sheared.sqrt()) ** 2
    if r.tension is not None:
        parts["(||c||_P + |beta|)^2"] = ((r.turned * r.tension).sqrt() + carried.sqrt()) ** 2
    if r.sigma is not None:
        beam = (sum(parts.values(), arb(0)).sqrt() + compression_misfit(r)) ** 2 / r.sigma
        parts = {"(beam + N_c)^2/sigma": beam}
    parts["ground, G^2"] = ground**2
    r.energies = {name: upper(part / 2) for name, part in parts.items()}
    r.holds("(11) E", sum(r.energies.values(), arb(0)), r.energy)


def compression_misfit(r):
    """Returns N_c, the bound in the energy norm of the transverse force Nc′ from the compression N and the slope c′ of
    the closing deflection. N_c is zero without compression."""
    return arb(0) if r.sigma is None else ((1 - r.sigma) * -r.force * r.turned).sqrt()


def moment_norm(r, i):
    """Returns the bound (9) of docs/proof.md for (∫δ²)^½ on a piece, where δ is the additional moment that balances the
    residuals."""
    piece = r.pieces[i]
    h, (a, b), constant = piece.h, r.delta[i], piece.residual[0]
    square = h * (a * a + a * b + b * b) / 3 + constant * h**3 * (a + b) / 12 + constant * constant * h**5 / 120
    rest = piece.size(piece.residual, 1)
    return upper(square).sqrt() + (h**5 / 120).sqrt() * rest + h.sqrt() * r.added[i]


def shear_norm(r, i):
    """Returns the bound (9a) of docs/proof.md for (∫δ′²)^½ on a piece, where δ is the additional moment that balances
    the residuals."""
    piece, (a, b) = r.pieces[i], r.delta_slope[i]
    h, rest = piece.h, piece.size(piece.residual, 1)
    return upper(h * (a * a + a * b + b * b) / 3).sqrt() + h.sqrt() * (h * rest / 2 + r.added_shear[i])


def given_back(r, missed):
    """Returns the upper bound (8) of docs/proof.md for twice the energy of the ground under the pressure λp, by which
    the claimed pressure p is changed for equilibrium."""
    total = arb(0)
    for i, piece in enumerate(r.pieces):
        if not piece.touches:
            continue
        if piece.layered:
            each = piece.size(piece.obstacle) + r.c[i][0] + r.root_g[i] * missed
        else:
            each = piece.size(piece.pressure) / piece.spring.low
        total += gamma(r, i) ** 2 * (upper(piece.integral(piece.pressure)) + pull(r, i)) * each
    for i, jump in enumerate(r.jump):
        force = positive_part(jump)
        if r.touches[i] and not force == 0:
            settled = upper(r.u[i]) + root_g_at(r, i) * missed
            total += upper(r.factor[i]) ** 2 * upper(force) * settled
    return total


def springs(r):
    """Returns the contribution of spring supports to 2E, twice the bound of the energy of the error."""
    total = arb(0)
    for i, node in enumerate(r.nodes):
        factor = upper(r.factor[i])
        if node.spring is not None:
            spring = node.spring[0]
            missed = factor * upper(r.pushing[i])
            if node.acts == 0:
                missed = spring * upper(r.value[i] - at_support(r, i)[0]) + factor * node.weights["spring"]
            total += missed**2 / spring
        if node.turning is not None:
            piece, side = r.felt[i]
            # The slope of the relative pressure change λ at the node is taken from the piece on the right. At the right
            # end of the beam it is taken from the last piece.
            steep = r.steep[min(i, len(r.pieces) - 1)]
            turned = upper(r.c_slope[piece][side])
            total += (node.turning * turned + steep * node.weights["turning"]) ** 2 / node.turning
    return total


def hinges(r):
    """Returns the contribution of elastic hinges to 2E, twice the bound of the energy of the error."""
    total = arb(0)
    for i, node in enumerate(r.nodes):
        if not node.hinged or node.free_hinge:
            continue
        left, right = r.pieces[i - 1], r.pieces[i]
        turn = right.ends(right.rotation)[0] + r.c_slope[i][0] - left.ends(left.rotation)[1] - r.c_slope[i - 1][1]
        moment = left.ends(left.moment)[1] + r.delta[i - 1][1]
        total += (upper(node.hinge * turn + moment) + r.added[i - 1]) ** 2 / node.hinge
    return total
