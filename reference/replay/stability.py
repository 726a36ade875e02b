"""Checks the fraction σ of the convexity of the beam's energy that remains under a compression N, so that N∫z′² ≤ (1
− σ)a₀(z, z). The proof uses spans or elements."""

from flint import arb

from balls import high, low

PI = arb.pi()
ELEMENTS = (16, 4, 1)


def check(r):
    """Checks that σ is at most its value from the spans between rigid supports, or that the elements are stable under
    N₁ = N/(1 − σ)."""
    if r.sigma is None:
        return
    compression = high(-r.force)
    left = of_spans(r, compression)
    if left is not None and r.sigma <= left * (1 + r.ROUNDING):
        r.count += 1
        return
    load = compression / (1 - r.sigma)
    stable = not r.shears and any(is_stable(r, load, count) for count in ELEMENTS)
    r.shows("it is not proven that the beam keeps at least the fraction sigma of its stiffness under the compression", stable)


def is_rigid(node):
    return node.rigid is not None and node.acts == 0


def of_spans(r, compression):
    """Returns σ = 1 − N max(L²/(π²EI) + 1/S) over the spans, or `None` if the supports do not allow it. For a beam
    held by one clamp at an end, 2L takes the place of L, and shear deformation is not covered."""
    last = len(r.pieces)
    rigid = [i for i, node in enumerate(r.nodes) if is_rigid(node)]
    if any(node.hinged for node in r.nodes) or not rigid:
        return None
    if rigid[0] == 0 and rigid[-1] == last and last > 0 and len(rigid) > 1:
        spans = [(a, b, r.x[b] - r.x[a]) for a, b in zip(rigid, rigid[1:])]
    elif len(rigid) == 1 and rigid[0] in (0, last) and r.nodes[rigid[0]].clamped and not r.shears:
        spans = [(0, last, 2 * (r.x[-1] - r.x[0]))]
    else:
        return None
    most = arb(0)
    for a, b, length in spans:
        bent, slid = arb(0), arb(0)
        for piece in r.pieces[a:b]:
            bent = bent.max(1 / piece.bending.low)
            slid = slid.max(arb(0) if piece.stiffness is None else 1 / piece.stiffness.low)
        most = most.max(length**2 * bent / PI**2 + slid)
    return low(1 - compression * most)


def elements(r, count):
    """Yields the length and the smallest EI of each element between supports, hinges and jumps of EI, and the node at
    the right end of the element, if any."""
    first = 0
    for i in range(1, len(r.nodes)):
        node = r.nodes[i]
        bare = not is_rigid(node) and node.spring is None and node.turning is None and not node.hinged
        if bare and i < len(r.pieces):
            beside = [r.pieces[first].bending, r.pieces[i].bending]
            if all(c.even for c in beside) and (beside[0].along[0] - beside[1].along[0]).contains(0):
                continue
        length = r.x[i] - r.x[first]
        bending = min((low(piece.bending.low) for piece in r.pieces[first:i]), key=float)
        parts = min(max(1, int(float((count * length / (r.x[-1] - r.x[0])).mid()) + 0.999)), count)
        for j in range(parts):
            yield length / parts, bending, i if j + 1 == parts else None
        first = i


def is_stable(r, load, count):
    """Returns whether the matrix K_bend + springs − Σ N₁/(1 − N₁h²/(4π²EI)) K_geo is positive definite, with the
    bending and geometric stiffness matrices K_bend and K_geo of the elements."""
    matrix, free = {}, []

    def unknown(is_free):
        free.append(is_free)
        return len(free) - 1

    def add(i, j, value):
        i, j = min(i, j), max(i, j)
        if free[i] and free[j]:
            matrix[i, j] = matrix.get((i, j), arb(0)) + value

    def joint(node):
        """Adds the unknowns z and z′ at a node with the supports and springs of the node, and returns the indices of
        both unknowns."""
        place, turn = unknown(not is_rigid(node)), unknown(not node.clamped)
        if node.acts == 0 and node.spring is not None:
            add(place, place, node.spring[0])
        if node.turning is not None:
            add(turn, turn, node.turning)
        return place, turn

    ends = joint(r.nodes[0])
    for h, bending, node in elements(r, count):
        share = 1 - load * h**2 / (4 * PI**2 * bending)
        if not share > 0:
            return False
        drawn = load / share / (30 * h)
        if node is None:
            far = unknown(True), unknown(True)
        else:
            far = joint(r.nodes[node])
        all_four, signs = [*ends, *far], [1, h, 1, h]
        bent = [[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]]
        geometric = [[36, 3, -36, 3], [3, 4, -3, -1], [-36, -3, 36, -3], [3, -1, -3, 4]]
        for a in range(4):
            for b in range(a, 4):
                value = (bending / h**3 * bent[a][b] - drawn * geometric[a][b]) * signs[a] * signs[b]
                add(all_four[a], all_four[b], value)
        ends = far
        if node is not None and r.nodes[node].hinged:
            ends = far[0], unknown(True)
            spring = r.nodes[node].hinge
            for a, b, value in ((far[1], far[1], spring), (ends[1], ends[1], spring), (far[1], ends[1], -spring)):
                add(a, b, value)
    return is_positive(matrix, [i for i, is_free in enumerate(free) if is_free])


def is_positive(matrix, unknowns):
    """Returns whether a symmetric matrix is positive definite, by elimination in balls. Each unknown is coupled only
    with the next seven."""
    for place, i in enumerate(unknowns):
        pivot = matrix.get((i, i), arb(0))
        if not pivot > 0:
            return False
        later = [j for j in unknowns[place + 1 : place + 8] if (i, j) in matrix]
        for a in later:
            for b in later:
                if a <= b:
                    matrix[a, b] = matrix.get((a, b), arb(0)) - matrix[i, a] * matrix[i, b] / pivot
    return True
