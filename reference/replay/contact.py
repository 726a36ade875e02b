"""Proves the exact contact set on shear layers, with its open stretches, forces, regions and points, from error
bounds and the claimed edges (section 5)."""

from flint import arb

from balls import INFINITE, above, ball_of, exact, high, least_on, negative_part, on, sorted_pair, upper
from ground import clearance, least
from springs import leaves_support, logged_zones, rests


class Edge:
    """A contact edge at the left end (side 0) or right end (side 1) of a contact region. It has the distances θ
    outside and θ′ inside the region, and bounds of the flux at the edge without the slope error."""

    def __init__(self, logged):
        self.node, self.side, outside, inside = logged
        self.outside, self.inside = exact(outside), exact(inside)
        self.beyond = [INFINITE, INFINITE]


class Contact:
    """Proves the contact set where the ground has a shear layer, from error bounds and claimed contact edges. With
    shear deformation of the beam, the proof has several rounds with smaller and smaller bounds."""

    def __init__(self, r, errors, edges):
        self.r, self.errors, self.at = r, errors, {}
        for edge in edges:
            # The first round can log an edge twice, once for each adjacent piece. The larger distances outside and
            # inside the region count.
            other = self.at.setdefault((edge.node, edge.side), edge)
            other.outside, other.inside = other.outside.max(edge.outside), other.inside.max(edge.inside)
        self.edges = list(self.at.values())
        # `tolerance` is the error bound ε_a of the force at each touching node. `pressed` contains the nodes where a
        # positive contact force is proven.
        self.tolerance, self.pressed = [arb(0)] * len(r.nodes), set()
        # `steep` maps (node, side) to the error bound of the shear-layer force μu′ (u: ground surface) where a piece
        # out of contact ends at a touching node.
        self.steep = {}

    def check(self):
        for first, end in self.r.layers():
            self.layer(first, end)

    def layer(self, first, end):
        r = self.r
        i = first
        while i < end:
            a = i
            i += 1
            if r.pieces[a].touches:
                continue
            while i < end and not r.touches[i]:
                i += 1
            self.stretch(a, i)
        for node in range(first, end + 1):
            if r.touches[node]:
                sides = [self.flux_error(node, side) for side in (0, 1)]
                self.tolerance[node] = self.tolerance[node].max(sides[0] + sides[1])
        node = first
        while node <= end:
            last = node
            if r.touches[node]:
                while last < end and r.pieces[last].touches:
                    last += 1
                if last == node:
                    self.point(node)
                else:
                    self.region(node, last)
            node = last + 1

    def stretch(self, first, end):
        """Proves an open stretch. Away from touching nodes the clearance C is larger than ε_u + ε_w. Nearer to a
        touching node, up to the distance θ, C decreases toward the node faster than the error of its slope. Within θ,
        (μC′)′ > ε_p."""
        r, ends, zones = self.r, [self.r.touches[first], self.r.touches[end]], logged_zones(self.r)
        for i in range(first, end):
            if rests(r, i):
                continue
            interval = list(r.pieces[i].t)
            here = [i == first and ends[0], i + 1 == end and ends[1]]
            for side in (0, 1):
                if here[side]:
                    reach, found = self.approach(i, side, here[1 - side])
                    r.shows(f"the decrease of the clearance toward node {i + side} is not proven", reach is not None)
                    if reach is not None:
                        interval[side] = reach
                        self.steep[i + side, 1 - side] = found
                elif (i, side) in zones:
                    interval[side] += (1 - 2 * side) * zones[i, side] / r.pieces[i].half
                    r.shows(
                        f"it is not proven that g0 - w increases from zero with the distance from node {i + side}",
                        leaves_support(r, self.errors[i], i, side, interval[side]),
                    )
            limit = self.errors[i]["u"] + self.errors[i]["w"]
            clear = on(interval, lambda t: least(r, i, t, 0) > limit)
            r.shows(f"the clearance on piece {i} is not larger than its error bound", clear)

    def approach(self, i, side, both):
        """Returns the position t from which C is proven to decrease toward a touching node, and the bound of the flux
        error. Of all such positions it takes the one with the smallest bound."""
        r, piece, error = self.r, self.r.pieces[i], self.errors[i]
        edge = self.at.get((i + side, 1 - side))
        theta = edge.outside if edge else arb(0)
        end, wide, inward = piece.t[side], piece.t[1] - piece.t[0], 1 - 2 * side
        far = end + inward * wide * (arb("0.75") if both else arb(1) - arb("1e-9"))
        near = end + inward * theta / piece.half
        if not theta == 0:
            curved = on(sorted_pair(near, end), lambda t: self.presses(i, t))
            if not (r.smooth(i + side) and curved):
                return None, None
        part, best = arb("0.25") if both else arb("0.5"), (None, None)
        for _ in range(40):
            reach = end + inward * wide * part
            if not abs(reach - end) > abs(near - end):
                break
            found = self.open_flux(i, abs(far - reach) * piece.half)
            limit = found / piece.shear.low + error["slope"]
            falls = on(sorted_pair(reach, near), lambda t: least(r, i, t, 1, None, inward) > limit)
            clear = clearance(r, i, reach)[0] > error["u"] + error["w"]
            if falls and clear and (best[1] is None or found < best[1]):
                best = (reach, found)
            elif best[0] is not None:
                break
            part *= arb("0.7")
        return best

    def open_flux(self, i, length):
        """Returns the bound (13) of the error of the flux μu′ at the end of open ground with a given length, or the
        bound (13a) where k or μ varies."""
        r, piece, error = self.r, self.r.pieces[i], self.errors[i]["u"]
        if r.along[i] is None:
            rate = (piece.spring.least / piece.shear.least).sqrt()
            return piece.shear.high * rate / (rate * length / 2).tanh() * error
        load, stiff = piece.spring.high * error + r.missed[i], piece.shear.high * error
        h = (2 * stiff / load).sqrt().min(length) if load > 0 else length
        return 2 * stiff / h + h * load

    def presses(self, i, t):
        """Returns whether (μC′)′ > ε_p is proven at the position t of an open piece, with the clearance C and the error
        bound ε_p of the pressure."""
        r, piece = self.r, self.r.pieces[i]
        if r.along[i] is None:
            return piece.shear.low * clearance(r, i, t)[2] > self.errors[i]["p"]
        return piece.pressure_under(r.along[i])(t) > self.errors[i]["p"]

    def flux_error(self, node, side):
        """Returns the bound of the error of the flux μu′ on one side of a node at which the beam touches the ground."""
        r, j = self.r, node - 1 if side == 0 else node
        if r.layered(node)[side]:
            if r.pieces[j].touches:
                return r.pieces[j].shear.high * self.errors[j]["slope"]
            return self.steep.get((node, side), INFINITE)
        if node == (0, len(r.pieces))[side]:
            return high(r.outside[side]) * self.errors[0 if side == 0 else -1]["u"]
        return arb(0)

    def point(self, node):
        """Proves contact at a node between open pieces: the force a must be larger than its error bound ε_a."""
        r = self.r
        r.shows(
            f"the point contact force at node {node} is not larger than its error bound",
            r.jump[node] > self.tolerance[node],
        )
        self.pressed.add(node)

    def region(self, a, b):
        """Proves the contact of a region. It requires p > ε_p on all pieces, (14) at both edges, and forces at the
        inner nodes that are at least their error bounds."""
        r = self.r
        for i in range(a, b):
            piece, error = r.pieces[i], self.errors[i]["p"]
            r.shows(
                f"the pressure on piece {i} is not larger than its error bound",
                above(piece.pressure, piece.t, error),
            )
        edges = [self.edge(a, 0), self.edge(b, 1)]
        inside = [edge.inside for edge in edges]
        r.shows(
            f"the intervals of the left and the right edge together cover the contact region that starts at node {a}",
            inside[0] + inside[1] < r.x[b] - r.x[a],
        )
        for node in range(a, b + 1):
            if r.smooth(node):
                continue
            if a < node < b:
                if not self.bends_open(node):
                    r.holds(f"the force at node {node}", self.tolerance[node], r.jump[node])
                far = r.x[node] - r.x[a] > inside[0] and r.x[b] - r.x[node] > inside[1]
                r.shows(f"the log does not exclude a contact edge at node {node}, where a force acts", far)
            known = a < node < b or inside[0 if node == a else 1] == 0
            if known and r.jump[node] > self.tolerance[node]:
                self.pressed.add(node)

    def edge(self, node, side):
        """Checks the claimed edge at an end of a region by (14), or with shear deformation by the convexity of the
        clearance C."""
        r = self.r
        edge = self.at.get((node, side))
        if edge is None:
            r.shows(f"the edge at node {node} is not in the log", False)
            return Edge([node, side, 0, 0])
        i = node if side == 0 else node - 1
        outer = self.flux_error(node, side)
        open_side = (node, side) in self.steep
        steep = arb(0)
        if open_side:
            j = node - 1 if side == 0 else node
            piece = r.pieces[j]
            steep = piece.shear.high * upper(clearance(r, j, piece.t[1 - side])[1])
        else:
            r.shows(
                f"the claimed edge at node {node} can lie beyond the contact region, where no piece is out of contact",
                edge.outside == 0,
            )
        edge.beyond = [outer + steep if open_side else arb(0), negative_part(r.jump[node] - outer)]
        missing = self.tolerance[node] - r.jump[node]
        if not missing <= 0:
            found = self.pressed_by(i, side, edge.inside)
            convex = opened(self, i, side, edge.inside) if r.shears and not found >= missing else False
            if not convex:
                r.holds(f"(14) at node {node}", missing, found)
        return edge

    def pressed_by(self, i, side, theta):
        """Returns ∫(p − ε_p) over the length θ from an end of a piece inward, with the pressure p and its error bound
        ε_p."""
        piece = self.r.pieces[i]
        x = piece.t[side] + (1 - 2 * side) * theta / piece.half
        whole = (piece.pressure - self.errors[i]["p"]).integral()
        return abs(whole(x) - whole(piece.t[side])) * piece.half

    def bends_open(self, node):
        """Returns whether the slope of the clearance C cannot decrease at a node if the beam is out of contact at
        this node. This requires that a corner of g₀ at the node points up and that a force on the beam at the node
        acts downward."""
        r, here = self.r, self.r.nodes[node]
        alone = here.rigid is None and here.spring is None and here.force >= 0
        return (alone or not r.kinks(node)) and r.even(node) and (r.corner(node) >= 0 or r.corner(node).contains(0))


def limit(contact, i):
    """Returns the error bound of the clearance on a piece, the sum of the bounds of settlement and deflection."""
    return contact.errors[i]["u"] + contact.errors[i]["w"]


def opened(contact, i, side, theta):
    """Returns whether a touching piece can be out of contact only within the distance θ from an end. The condition is
    (2ε_Cμ/m)^½ ≤ θ, where m is the least p − ε_p within this distance."""
    piece = contact.r.pieces[i]
    if not theta > 0 or not theta <= piece.h * (1 + contact.r.ROUNDING):
        return False
    ends = sorted_pair(piece.t[side], piece.t[side] + (1 - 2 * side) * theta / piece.half)
    least = least_on(piece.pressure, ball_of(ends)) - contact.errors[i]["p"]
    if not least > 0:
        return False
    return (2 * limit(contact, i) * piece.shear.high / least).sqrt() <= theta * (1 + contact.r.ROUNDING)


def roughly(contact):
    """Checks the edges of the first round on a beam with shear deformation, where the slope has no bound yet. It uses
    C > ε_C on open pieces and the convexity of C on touching pieces."""
    r = contact.r
    for i, piece in enumerate(r.pieces):
        if not piece.layered:
            continue
        if piece.touches:
            error = contact.errors[i]["p"]
            r.shows(
                f"in the first round of the proof the pressure on piece {i} is not larger than its error bound",
                above(piece.pressure, piece.t, error),
            )
            for side in (0, 1):
                theta = contact.at[i + side, side].inside
                whole = theta * (1 + r.ROUNDING) >= piece.h
                r.shows(
                    f"in the first round of the proof the contact edge at node {i + side} is not proven",
                    whole or opened(contact, i, side, theta),
                )
            continue
        interval = list(piece.t)
        for side in (0, 1):
            theta = contact.at[i + side, 1 - side].outside
            interval[side] += (1 - 2 * side) * theta / piece.half
            if not r.touches[i + side]:
                r.shows(
                    f"node {i + side} is a contact edge in the first round of the proof, but it does not touch the ground",
                    theta == 0,
                )
        clear = on(interval, lambda t: least(r, i, t, 0) > limit(contact, i))
        r.shows(
            f"in the first round of the proof the clearance on piece {i} is not larger than its error bound",
            clear,
        )
    for node in range(len(r.nodes)):
        contact.tolerance[node] = INFINITE if r.touches[node] else arb(0)
