"""Computes K² of the test functions z for the errors of the moment and of the reactions (section 4), and the factor
of K: s₂, or its replacement under a compression."""

from flint import arb

from balls import INFINITE, high, largest, least_of_halves, upper
from energy import compression_misfit


def prepare(r):
    """Computes two numbers for the energy norm K of test functions: the factor of K in the error bounds, and the axial
    force that K includes."""
    r.beam_energy = r.energy if r.sigma is None else r.energy / r.sigma
    r.test_factor, r.test_tension = r.s2, arb(0) if r.tension is None else high(r.tension)
    if r.sigma is not None:
        force = high(-r.force)
        r.test_factor = (((r.s2 + compression_misfit(r)) ** 2 + r.s2**2) / r.sigma).sqrt()
        closed = force * (r.sigma * r.turned).sqrt() / r.s2 if r.turned > 0 else arb(0)
        r.test_tension = (((1 - r.sigma) * force).sqrt() + closed) ** 2


def stiffest(r, pieces):
    """Returns the largest EI, P + μ and k on the given pieces, with the axial force P that the energy norm of test
    functions includes."""
    spans = [r.pieces[i] for i in pieces]
    layer = largest(*(piece.shear.high for piece in spans)) + r.test_tension
    return largest(*(piece.bending.high for piece in spans)), layer, largest(*(piece.spring.high for piece in spans))


def held(r, nodes):
    """Returns Σκ and Σκ_θ, the sums of the stiffnesses of the translational and the rotational springs at the given
    nodes."""
    both = [r.nodes[i].stiff() for i in nodes]
    return sum((spring for spring, _ in both), arb(0)), sum((turning for _, turning in both), arb(0))


def kink(stiff, springs, available):
    """Returns the least K² over h of the test function z = t(1 − t/h)² on one side of a position. K² is 4EI/h +
    (2/15)(P + μ)h + kh³/105 + Σκ(4h/27)² + Σκ_θ."""
    (bending, layer, ground), (spring, turning) = stiff, springs
    return least_of_halves(
        available,
        lambda h: 4 * bending / h
        + arb("0.134") * layer * h
        + ground * h**3 / 105
        + spring * (arb("0.1482") * h) ** 2
        + turning,
    )


def kinks(r):
    """Returns the smallest K on each piece for test functions with a unit kink. These functions end between two rigid
    supports, or they are linear up to an end of the beam."""
    least = [INFINITE] * len(r.pieces)
    stops = r.obstacles()
    for a, b in zip(stops, stops[1:]):
        found = kink(stiffest(r, range(a, b)), held(r, range(a, b + 1)), (r.x[b] - r.x[a]) / 2)
        for i in range(a, b):
            least[i] = found
    for side in (0, 1):
        long_kinks(r, side, least)
    return [k.sqrt() for k in least]


def long_kinks(r, side, least):
    """Lowers K² of each piece by the test function z(s) = |s − x| between x and one end of the beam, if no rigid
    support lies between both."""
    count = len(r.pieces)
    layer = ground = arb(0)
    passed = []
    for step in range(count):
        i = step if side == 0 else count - 1 - step
        outer, inner = i + side, i + 1 - side
        if r.nodes[outer].rigid is not None:
            return
        passed.append(outer)
        _, more_layer, more_ground = stiffest(r, [i])
        layer, ground = layer.max(more_layer), ground.max(more_ground)
        long = abs(r.x[inner] - r.x[(0, count)[side]])
        k = layer * long + ground * long**3 / 3 + high(r.outside[side]) * long**2
        for j in passed:
            springs, turning = r.nodes[j].stiff()
            k += springs * (r.x[j] - r.x[inner]) ** 2 + turning
        least[i] = least[i].min(k)


def next_obstacle(r, node, side):
    """Returns the node of the next rigid support on one side of a node, or of the end of the beam, and whether the
    returned node has a rigid support."""
    while node != (0, len(r.pieces))[side]:
        node += 2 * side - 1
        if r.nodes[node].rigid is not None:
            return node, True
    return node, False


def beside(r, node, other):
    """Returns the largest stiffnesses and the sums of the springs between two nodes, and the distance of both nodes.
    Springs at the first node are not included."""
    a, b = min(node, other), max(node, other)
    return stiffest(r, range(a, b)), held(r, [i for i in range(a, b + 1) if i != node]), r.x[b] - r.x[a]


def lifted_side(r, node, side):
    """Returns K² on one side of a rigid support of a test function z with z = 1 at this support. z is 1 − 3τ² + 2τ³
    up to a distance h, or 1 up to the end of the beam."""
    other, stands = next_obstacle(r, node, side)
    if other == node:
        return high(r.outside[side]) if not stands else INFINITE
    (bending, layer, ground), (springs, turning), available = beside(r, node, other)
    least = INFINITE if stands else ground * available + high(r.outside[side]) + springs
    return least.min(
        least_of_halves(
            available,
            lambda h: 12 * bending / h**3
            + arb("1.2") * layer / h
            + arb("0.3715") * ground * h
            + springs
            + turning * (arb("1.5") / h) ** 2,
        )
    )


def turned_side(r, node, side):
    """Returns the least K² over h of the test function z = t(1 − t/h)² on one side of a clamp. K is the energy norm of
    z, and t ≤ h is the distance from the clamp."""
    other, _ = next_obstacle(r, node, side)
    return arb(0) if other == node else kink(*beside(r, node, other))


def straight(r, base, slope):
    """Returns K², the square of the energy norm, of the test function z = (x − base)·slope on the whole beam."""
    _, layer, ground = stiffest(r, range(len(r.pieces)))
    length, z = r.x[-1] - r.x[0], lambda x: upper((x - base) * slope)
    ends = [z(r.x[0]), z(r.x[-1])]
    k = layer * length * upper(slope) ** 2 + ground * length * largest(*ends) ** 2
    for outside, end in zip(r.outside, ends):
        k += high(outside) * end**2
    for node in r.nodes:
        spring, turning = node.stiff()
        k += spring * z(node.x) ** 2 + turning * upper(slope) ** 2
    return k
