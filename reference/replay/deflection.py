"""Computes the admissible deflection w̄ = w + c and rotation φ̄ = φ + c′ from the closing deflection c of the log,
and checks the bounds (3) of c."""

from flint import arb, arb_poly

from balls import ball, exact, largest, upper


def check(r):
    """Checks that w + c has no jumps and satisfies the support conditions, and that |c|, |c′| and |c″| are at most
    the logged bounds."""
    lines = r.all("closing")
    r.c = [[exact(b) for b in line["bounds"]] for line in lines]
    r.c_slope = [[ball(s) for s in line["slopes"]] for line in lines]
    r.closing = [on_piece(r, i) for i in range(len(r.pieces))]
    for i in range(len(r.nodes)):
        at_node(r, i)
    r.felt = [felt(r, i) for i in range(len(r.nodes))]


def on_piece(r, i):
    """Returns the closing deflection c on a piece as a polynomial of t. It is linear if the piece moves rigidly,
    otherwise the cubic with the given values and slopes at both ends."""
    piece, slope, bounds = r.pieces[i], r.c_slope[i], r.c[i]
    a = [r.value[i + side] - w for side, w in enumerate(piece.ends(piece.w))]
    along = arb_poly([-piece.t[0], 1]) * (piece.half / piece.h)
    if bounds[2] == 0:
        r.meets(f"the rigid motion of piece {i}", a[0] + slope[0] * piece.h - a[1])
        r.meets(f"the slope in the rigid motion of piece {i}", slope[0] - slope[1])
        most = [upper(a[0]) + upper(slope[0]) * piece.h, upper(slope[0]), arb(0)]
        closing = a[0] + along * (slope[0] * piece.h)
    else:
        big, steep = largest(*a), largest(*slope)
        most = [
            big + arb("0.3") * steep * piece.h,
            3 * big / piece.h + steep,
            12 * big / piece.h**2 + 6 * steep / piece.h,
        ]
        square, cube = along * along, along * along * along
        values = (1 - 3 * square + 2 * cube) * a[0] + (3 * square - 2 * cube) * a[1]
        turned = (along - 2 * square + cube) * slope[0] + (cube - square) * slope[1]
        closing = values + turned * piece.h
    for name, left, right in zip(("c", "c'", "c''"), most, bounds):
        r.holds(f"(3) |{name}| on piece {i}", left, right)
    return closing


def at_node(r, i):
    """Checks that the rotation φ̄ is continuous except at hinges, and that the conditions of rigid supports and
    clamps hold."""
    node, turn = r.nodes[i], [None, None]
    if i > 0:
        turn[0] = r.pieces[i - 1].ends(r.pieces[i - 1].rotation)[1] + r.c_slope[i - 1][1]
    if i < len(r.pieces):
        turn[1] = r.pieces[i].ends(r.pieces[i].rotation)[0] + r.c_slope[i][0]
    if not node.hinged and None not in turn:
        r.meets(f"rotation at node {i}", turn[0] - turn[1])
    if node.rigid is not None:
        r.meets(f"support at node {i}", r.value[i] - node.rigid)
    if node.clamped:
        r.meets(f"clamp at node {i}", turn[1] if turn[0] is None else turn[0])


def felt(r, i):
    """Returns the piece beside a node with the smaller coefficients of w, and the end of this piece at the node (0
    left, 1 right). The values of this piece at the node determine the forces of springs."""
    size = lambda j: sum((upper(c) for c in r.pieces[j].w.coeffs()), arb(0))
    if i == 0 or i < len(r.pieces) and size(i) < size(i - 1):
        return i, 0
    return i - 1, 1


def at_support(r, i):
    """Returns the claimed w and φ at a node, from the adjacent piece with the smaller coefficients of w (see
    `felt`)."""
    piece, side = r.felt[i]
    return r.pieces[piece].ends(r.pieces[piece].w)[side], r.pieces[piece].ends(r.pieces[piece].rotation)[side]
