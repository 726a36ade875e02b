"""Computes bounds of the error of the shear force (15), and of the slope with shear deformation, from the contact set
(section 6)."""

from flint import arb, arb_poly

from balance import gamma
from balls import INFINITE, largest, least_of_halves, low, upper
from points import parts_of_pressure, pressure

REACHES = (0, 1, 3, 7, 15)


def bounds(r, contact):
    """Returns the error bounds of shear force and slope on each piece. `contact` contains the contact set and the error
    bounds of the other quantities."""
    errors = contact.errors
    spread, edges = load_errors(r, contact)
    nodes = [node_error(r, contact, i) for i in range(len(r.nodes))]
    found, stops = [None] * len(r.pieces), r.obstacles()
    for a, b in zip(stops, stops[1:]):
        for i in range(a, b):
            rest = upper(r.force) * errors[i]["rotation"] + balancing(r, i) + r.drawn[i]
            least, direct = INFINITE, INFINITE
            if contact.edges and r.pieces[i].stiffness is not None:
                beside = edges_of_piece(contact, i)
                if beside:
                    steady = mean(r, errors, spread, i, i + 1, arb("0.5"), arb(0))
                    least = beside_edges(r, errors, i, beside, steady, rest + slid(r, i))
            for reach in REACHES:
                first, end = max(i - reach, a), min(i + 1 + reach, b)
                forces = sum((edges[j] for j in range(first, end)), arb(0))
                forces += sum((nodes[j][0] for j in range(first + 1, end)), arb(0))
                couples = sum((nodes[j][1] for j in range(first + 1, end)), arb(0))
                least = least.min(mean(r, errors, spread, first, end, arb(1), couples) + forces)
                direct = direct.min(directly(r, errors, spread, first, end, couples) + forces)
                if (first, end) == (a, b):
                    break
            direct += balancing(r, i) + r.drawn[i]
            found[i] = on_piece(r, errors[i], i, (least + rest).min(direct))
    return found


def directly(r, errors, spread, first, end, couples):
    """Returns min_h {(2s₂K + Σs₂√κ_θ)/h + ½h(q + |P| max|e″|)} + 2|P| max|c′| + max|β|, the part of (15a) from a
    window of pieces. It is infinite if the window has a hinge or shear deformation."""
    window = range(first, end)
    hinged = any(r.nodes[node].hinged for node in range(first + 1, end))
    if r.force == 0 or hinged or any(r.pieces[i].stiffness is not None for i in window):
        return INFINITE
    most = lambda of: max((of(i) for i in window), key=float)
    change = 2 * most(lambda i: errors[i]["m"]) + couples
    load = most(lambda i: spread[i] + upper(r.force) * (r.pieces[i].bent(errors[i]["M"]) + r.c[i][2]))
    if not change.is_finite() or not load.is_finite():
        return INFINITE
    least = least_of_halves(r.x[end] - r.x[first], lambda h: change / h + h * load / 2)
    return least + 2 * upper(r.force) * most(lambda i: r.c[i][1]) + most(lambda i: upper(r.drawn[i]))


def on_piece(r, error, i, total):
    """Returns ε_V and, on a beam with shear deformation, ε_θ = ε_φ + (ε_V + |η|)/S. `total` is ε_T + |δ′| + |P|ε_φ +
    |β|."""
    piece = r.pieces[i]
    if piece.stiffness is None:
        return error["V"].min(total), error["slope"]
    force = error["V"].min((total + slid(r, i)) / stiffened(r, piece))
    return force, error["slope"].min(error["rotation"] + (force + piece.size(piece.misfit)) / piece.stiffness.low)


def slid(r, i):
    """Returns |P||η|/S, the contribution of the residual η = S(w′ − φ) − V to the error of the shear force V. P is the
    axial force, S the shear stiffness of the beam, w′ its slope and φ its rotation."""
    piece = r.pieces[i]
    return arb(0) if piece.stiffness is None else upper(r.force) * piece.size(piece.misfit) / piece.stiffness.low


def stiffened(r, piece):
    """Returns a lower bound of 1 + P/S on a piece, with the axial force P and the shear stiffness S of the beam."""
    return low(1 + r.force / (piece.stiffness.high if r.force > 0 else piece.stiffness.low))


def balancing(r, i):
    """Returns an upper bound on |δ′| on one piece of the beam. δ is the bending moment in equilibrium with the residual
    loads, and δ′ its derivative with respect to x."""
    piece = r.pieces[i]
    return largest(*r.delta_slope[i]) + piece.h * piece.size(piece.residual, 1) + r.added_shear[i]


def swing(r, moved):
    return arb(0) if r.force == 0 else upper(r.force) * moved


def mean(r, errors, spread, first, end, part, couples):
    """Returns min_h {(2s₂K + 2|P|ε_w + Σs₂√κ_θ)/h + ½hq} + |P| max|c′| + max|β|, the part of (15) from a window of
    pieces."""
    window = range(first, end)
    most = lambda of: max((of(i) for i in window), key=float)
    change = 2 * most(lambda i: errors[i]["m"]) + couples
    change += 2 * swing(r, most(lambda i: errors[i]["w"]))
    load, turned = most(lambda i: spread[i]), most(lambda i: r.c[i][1])
    if not change.is_finite() or not load.is_finite():
        return INFINITE
    least = least_of_halves(part * (r.x[end] - r.x[first]), lambda h: change / h + h * load / 2)
    return least + upper(r.force) * turned + most(lambda i: upper(r.drawn[i]))


def load_errors(r, contact):
    """Returns two bounds for each piece: q, the error of the pressure of the answer, and the force on the parts where
    only one of the two solutions is in contact."""
    errors, spread, edges = contact.errors, [], [arb(0)] * len(r.pieces)
    for i, piece in enumerate(r.pieces):
        given_back = gamma(r, i) * piece.size(piece.pressure) + (1 + gamma(r, i)) * r.depth[i]
        spread.append(errors[i]["p"] + given_back if piece.touches or not piece.layered else arb(0))
    for edge in contact.edges:
        outer, inner = (edge.node - 1, edge.node) if edge.side == 0 else (edge.node, edge.node - 1)
        if edge.outside > 0 and 0 <= outer < len(r.pieces):
            beside = open_pressure_beside(r, outer, 1 - edge.side, edge.outside)
            edges[outer] += edge.outside * (beside + errors[outer]["p"])
        if edge.inside > 0 and 0 <= inner < len(r.pieces):
            piece = r.pieces[inner]
            beside = size_beside(piece, piece.pressure, edge.side, edge.inside)
            edges[inner] += edge.inside * (1 + gamma(r, inner)) * beside
    return spread, edges


def open_pressure(r, i):
    """Returns a bound of |ku − q − (μ(w − g₀)′)′| on a piece out of contact. This is the pressure if the piece were in
    contact with ground that has the settlement u."""
    piece = r.pieces[i]
    if r.along[i] is not None:
        return piece.size(piece.pressure_under(r.along[i]))
    settled = largest(*(u - q for u, q in zip(r.u[i : i + 2], piece.ends(piece.free))))
    return piece.spring.high * settled + piece.shear.high * piece.size(piece.d(piece.d(piece.w)))


def size_beside(piece, p, side, distance):
    """Returns a bound of the absolute value of the polynomial p on the part of a piece that lies within `distance` of
    the end `side`."""
    part = upper(distance / piece.half)
    if not part < 1:
        return piece.size(p)
    middle = piece.t[side] + (1 - 2 * side) * part / 2
    about = p(arb_poly([middle, 1]))
    size = sum((upper(about[j]) * (part / 2) ** j for j in range(about.degree() + 1)), arb(0))
    return upper(size).min(piece.size(p))


def open_pressure_beside(r, i, side, distance):
    """Returns the bound of `open_pressure` for the part of the piece that lies within `distance` of the end `side`. On
    this part u − q/k changes by at most its largest slope times `distance`."""
    piece = r.pieces[i]
    if r.along[i] is not None:
        return size_beside(piece, piece.pressure_under(r.along[i]), side, distance)
    free = piece.ends(piece.free)
    above = [u - q for u, q in zip(r.u[i : i + 2], free)]
    drawn = piece.shear.least * piece.ends(piece.d(piece.free))[0]
    slope = largest(*(upper(flux - drawn) for flux in r.flux[i])) / piece.shear.low
    at_end = piece.spring.along * above[side] - piece.shear.along * piece.d(piece.d(piece.w))
    near = size_beside(piece, at_end, side, distance) + piece.spring.high * slope * distance
    return near.min(open_pressure(r, i))


def node_error(r, contact, i):
    """Returns the error bound of the forces at a node, and the error bound of the moment of its rotational spring."""
    spring, turning = (r.test_factor * stiffness.sqrt() for stiffness in r.nodes[i].stiff())
    if r.touches[i]:
        size = upper(r.jump[i])
        spring += (size if r.smooth(i) else contact.tolerance[i]) + upper(r.factor[i]) * size
    return spring, turning


def edges_of_piece(contact, i):
    """Returns the distance θ and the flux bound Φ₀ of the contact edges at both ends of a piece. Edges with θ = 0 are
    omitted."""
    piece, found = contact.r.pieces[i], []
    for end in (0, 1):
        edge = contact.at.get((i + end, end if piece.touches else 1 - end))
        if edge is not None:
            theta, beyond = (edge.inside, edge.beyond[1]) if piece.touches else (edge.outside, edge.beyond[0])
            if theta > 0:
                found.append((theta, beyond))
    return found


def beside_edges(r, errors, i, edges, steady, rest):
    """Returns the bound ε_T ≤ A₅/(1 − χ) next to contact edges. It is in closed form and needs no iteration with the
    bound of the slope."""
    piece = r.pieces[i]
    if not piece.stiffness.even or not piece.shear.even:
        return INFINITE
    stiffness, layer = piece.stiffness.along[0], piece.shear.along[0]
    whole = stiffness + r.force
    if not whole > 0 or not steady.is_finite():
        return INFINITE
    slope = errors[i]["rotation"] + (stiffness / whole * rest + piece.size(piece.misfit)) / stiffness
    kept, most = 1 + gamma(r, i) if piece.touches else arb(1), arb(0)
    for theta, beyond in edges:
        if not theta < arb("0.49") * piece.h or not beyond.is_finite():
            return INFINITE
        missed = (beyond + layer * slope) / (1 + layer / whole)
        most = most.max(kept * (missed + errors[i]["p"] * theta))
    share = kept * layer / (whole + layer)
    return (steady + most) / (1 - share) if share < 1 else INFINITE


def first_slopes(r):
    """Returns the bounds before the contact set is proven. Where S or μ of a shear layer varies, the bound of the
    slope follows from a single piece."""
    found = []
    for i, error in enumerate(r.errors):
        piece = r.pieces[i]
        first = {**error, "V": INFINITE}
        if piece.stiffness is not None:
            first["slope"] = INFINITE
            if piece.layered and not (piece.stiffness.even and piece.shear.even):
                first["slope"] = first_slope(r, i)
            first["p"] = pressure(r, i, first)
        found.append(first)
    return found


def first_slope(r, i):
    """Returns the bound of the slope error that follows from ε_T ≤ (A₁/h + A₂ + ½h(p₀ + A₃))/(1 − ½hA₄) on one
    piece."""
    piece, error = r.pieces[i], r.errors[i]
    misfit, axial = piece.size(piece.misfit), upper(r.force)
    other = balancing(r, i) + r.drawn[i] + axial * error["rotation"] + axial * misfit / piece.stiffness.low
    resting = error["rotation"] + (other / stiffened(r, piece) + misfit) / piece.stiffness.low
    by_force = 1 / stiffened(r, piece) / piece.stiffness.low
    fixed, turned = parts_of_pressure(r, i, error)
    if piece.touches:
        alone = (1 + gamma(r, i)) * (piece.size(piece.pressure) + r.depth[i])
    else:
        alone = open_pressure(r, i)
    spread, again = alone + fixed + turned * resting, turned * by_force
    change = 2 * error["m"] + 2 * swing(r, error["w"])
    closed = axial * r.c[i][1] + r.drawn[i]

    def bound(h):
        kept = 1 - h * again / 2
        return (change / h + closed + h * spread / 2) / kept if kept > 0 else INFINITE

    return resting + least_of_halves(piece.h, bound) * by_force
