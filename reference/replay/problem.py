"""Reads the problem of a proof from its log: pieces with their polynomials, nodes with loads and supports, and the
claimed bounds."""

from math import comb

from flint import arb, arb_poly

from balls import Checks, NotReplayed, ball, exact, high, largest, low, optional, poly, upper


class Coefficient:
    """One of EI, S, k and μ along a piece, a constant or a polynomial of t. The control values of the polynomial on
    the piece are its bounds."""

    def __init__(self, logged, ends):
        self.along = poly(logged) if isinstance(logged[0], list) else arb_poly([ball(logged)])
        self.even = not isinstance(logged[0], list)
        self.ends = [self.along(t) for t in ends]
        if self.even:
            self.least = self.along[0]
            self.low, self.high = low(self.along[0]), high(self.along[0])
            return
        degree = self.along.degree()
        within = self.along(arb_poly([ends[0], ends[1] - ends[0]]))
        controls = [
            sum((within[j] * comb(i, j) / comb(degree, j) for j in range(i + 1)), arb(0)) for i in range(degree + 1)
        ]
        self.low, self.high = low(controls[0]), high(controls[0])
        for control in controls[1:]:
            self.low, self.high = self.low.min(low(control)), self.high.max(high(control))
        self.least = self.low

    def __mul__(self, field):
        return self.along * field


class Piece:
    """A piece of the beam with the coordinate t = (x − middle)/half and the fields of the claimed answer on this
    piece."""

    def __init__(self, line, x):
        self.middle, self.half = ball(line["middle"]), ball(line["half"])
        self.x, self.h = x, x[1] - x[0]
        self.t = [(end - self.middle) / self.half for end in x]
        self.tau = largest(arb(1), *self.t)
        self.touches = line["touches"]
        self.w, self.phi = poly(line["w"]), optional(line["phi"], poly)
        of = lambda key: Coefficient(line[key], self.t)
        self.bending, self.spring, self.shear = of("EI"), of("k"), of("mu")
        self.stiffness = None if line["S"] is None else of("S")
        self.layered = not (self.shear.even and self.shear.along[0] == 0)
        self.f, self.g, self.kappa0, self.g0 = (poly(line[key]) for key in ("f", "g", "kappa0", "g0"))
        self.q = optional(line["q"], poly)
        self.stored = optional(line["open"], lambda ends: [ball(u) for u in ends])
        self.settlement = optional(line["u"], poly)
        self.even_ground = self.spring.even and self.shear.even
        if (self.stiffness is None) != (self.phi is None):
            raise NotReplayed("a piece has a rotation phi without a shear stiffness S, or S without phi")
        if self.q is not None and not self.layered and not self.spring.even:
            raise NotReplayed("a piece has a load on Winkler ground whose k varies")
        if self.q is not None and not all(q >= 0 or q.contains(0) for q in self.ends(self.q)):
            raise NotReplayed("a load on the ground acts upward")

    def fields(self, force):
        """Computes w′, φ, M, V, T = V + Pw′, p, the residual r of (5) and the residual η = S(w′ − φ) − V on the
        piece."""
        self.slope = self.d(self.w)
        self.rotation = self.slope if self.phi is None else self.phi
        self.moment = self.bending * (self.kappa0 - self.d(self.rotation))
        shear_force = self.d(self.moment) - self.g
        self.transverse = shear_force + self.slope * force
        self.obstacle = self.w - self.g0
        # `free` is q/k, the free-field settlement under the load q on the ground.
        even = self.q is not None and self.spring.even
        self.free = self.q * (1 / self.spring.along[0]) if even else arb_poly([])
        self.above = self.obstacle - self.free
        self.pressure = self.pressure_under(self.obstacle) if self.touches else arb_poly([])
        self.residual = self.f - self.pressure + self.d(self.transverse)
        self.misfit = arb_poly([])
        if self.stiffness is not None:
            self.misfit = self.stiffness * (self.slope - self.rotation) - shear_force

    def pressure_under(self, settlement):
        """Returns ku − q − (μ(w − g₀)′)′, the pressure if the beam were in contact with ground that has the
        settlement u."""
        pressure = self.spring * settlement - self.d(self.shear * self.d(self.obstacle))
        return pressure if self.q is None else pressure - self.q

    def d(self, p):
        """Returns the derivative with respect to x of a polynomial p(t), where t = (x − middle)/half on the piece."""
        return p.derivative() * (1 / self.half)

    def ends(self, p):
        return [p(t) for t in self.t]

    def integral(self, p):
        """Returns ∫p dx over the piece."""
        whole = p.integral()
        return (whole(self.t[1]) - whole(self.t[0])) * self.half

    def size(self, p, skip=0):
        """Returns a bound of a polynomial on the piece, without its first `skip` terms: the sum of its absolute
        coefficients times powers of the largest |t|."""
        return sum((upper(p[j]) * self.tau**j for j in range(skip, p.degree() + 1)), arb(0))

    def load(self):
        """Returns an upper bound on the residual of the transverse equilibrium on this piece of the beam."""
        return self.size(self.residual)

    def steepness(self, coefficient):
        """Returns an upper bound on the derivative of S or μ with respect to x on this piece of the beam."""
        return arb(0) if coefficient.even else self.size(self.d(coefficient.along))

    def bent(self, moment):
        """Returns ε_κ = ε_M/EI, the bound of the curvature error, from the bound ε_M of the moment error."""
        return moment / self.bending.low


class Node:
    """A node between two pieces or at an end of the beam, with the loads and supports at this node."""

    def __init__(self, line):
        self.x, self.force, self.moment = (ball(line[key]) for key in ("x", "F", "M0"))
        self.ground_force = ball(line["Q"])
        self.rigid, self.clamped, self.acts = optional(line["rigid"]), line["clamped"], line["acts"]
        self.spring = optional(line["spring"], lambda both: [ball(x) for x in both])
        self.turning, self.hinge = optional(line["turning"]), optional(line["hinge"])
        self.reaction = [ball(r) for r in line["reaction"]]
        self.hinged, self.free_hinge = self.hinge is not None, self.hinge is not None and self.hinge == 0
        # Weights of the supports in the redistribution of residual forces; any nonnegative weights are valid.
        self.weights = dict(zip(("rigid", "spring", "clamp", "turning"), map(exact, line["weights"])))
        if not all(weight >= 0 for weight in self.weights.values()):
            raise NotReplayed("a support has a negative weight in the redistribution of residual forces")
        if not (self.ground_force >= 0):
            raise NotReplayed("a load on the ground acts upward")

    def towards(self, x):
        """Returns the component of a force or deflection in the direction in which the one-way support at the node
        acts."""
        return -x if self.acts < 0 else x

    def stiff(self):
        """Returns the stiffnesses κ and κ_θ of the translational and the rotational spring at the node."""
        spring = arb(0) if self.spring is None else upper(self.spring[0])
        return spring, arb(0) if self.turning is None else upper(self.turning)


class Problem(Checks):
    """One result of a log, with the problem, the claimed solution and the claimed bounds. The check of each module
    adds its results to this object."""

    def __init__(self, lines):
        super().__init__()
        self.lines = {}
        for line in lines:
            self.lines.setdefault(line["name"], []).append(line)
        if "problem" not in self.lines:
            raise NotReplayed("the log has no proof of this result")
        problem = self.one("problem")
        self.force = optional(problem["P"]) or arb(0)
        if not (self.force >= 0 or self.force < 0):
            raise NotReplayed("the sign of the axial force is unknown")
        self.tension = self.force if self.force > 0 else None
        self.sigma = optional(problem["sigma"], exact)
        if (self.force < 0) != (self.sigma is not None):
            raise NotReplayed(
                "sigma, the fraction of the beam's stiffness that remains under compression, is missing, or it is given "
                "without compression"
            )
        if self.sigma is not None and not 0 < self.sigma < 1:
            raise NotReplayed(
                "sigma, the fraction of the beam's stiffness that remains under compression, is not between 0 and 1"
            )
        self.outside, self.pushed = ([ball(x) for x in problem[key]] for key in ("outside", "pushed"))
        self.cuts, self.carrier = problem["cuts"], exact(problem["carrier"])
        self.units = problem["units"]
        self.nodes = [Node(line) for line in self.all("node")]
        self.x = [node.x for node in self.nodes]
        if len(self.nodes) != len(self.all("piece")) + 1:
            raise NotReplayed("the number of nodes is not the number of pieces plus one")
        ends = zip(self.x, self.x[1:])
        self.pieces = [Piece(line, x) for line, x in zip(self.all("piece"), ends)]
        for piece in self.pieces:
            if not piece.h > 0:
                raise NotReplayed("the length of a piece is not positive")
            piece.fields(self.force)
        admissible = self.all("admissible at a node")
        self.value = [ball(line["w"]) for line in admissible]
        self.touches = [line["touches"] for line in admissible]
        self.energy = exact(self.one("energy")["E"])
        self.s2 = (2 * self.energy).sqrt()
        keys = ("w", "slope", "rotation", "m", "M", "V", "u", "p")
        self.errors = [{key: exact(line[key]) for key in keys} for line in self.all("bounds")]
        for name in ("closing", "pull", "ground", "bounds"):
            self.complete(name, len(self.pieces))
        for name in ("admissible at a node", "tolerance of a force"):
            self.complete(name, len(self.nodes))
        if any(len(line["bounds"]) != len(self.pieces) for line in self.all("round")):
            raise NotReplayed("a `round` line of the log does not have error bounds for every piece")
        self.shears = any(piece.stiffness is not None for piece in self.pieces)

    def all(self, name):
        return self.lines.get(name, [])

    def complete(self, name, count):
        """Checks that the log has one line with this name for each piece or node, in order."""
        found = [line.get("piece", line.get("node")) for line in self.all(name)]
        if found != list(range(count)):
            raise NotReplayed(f"the log does not have one `{name}` line for each piece or node, in order")

    def one(self, name):
        found = self.all(name)
        if len(found) != 1:
            raise NotReplayed(f"the log has {len(found)} `{name}` lines instead of one")
        return found[0]

    def layered(self, node):
        """Returns two truth values: whether the piece on the left of a node, and whether the piece on the right,
        belongs to a shear layer."""
        return [0 <= i < len(self.pieces) and self.pieces[i].layered for i in (node - 1, node)]

    def layers(self):
        """Yields the first and the last node of each maximal run of pieces with μ > 0."""
        first = None
        for i in range(len(self.pieces) + 1):
            inside = i < len(self.pieces) and self.pieces[i].layered
            if inside and first is None:
                first = i
            if not inside and first is not None:
                yield first, i
                first = None

    def parts(self):
        """Returns the parts of the beam between hinges, as ranges of pieces."""
        return self.cut(lambda node: node.hinged)

    def joined_parts(self):
        """Returns the parts of the beam between free hinges, as ranges of pieces."""
        return self.cut(lambda node: node.free_hinge)

    def cut(self, at):
        joints = [i for i in range(1, len(self.pieces)) if at(self.nodes[i])]
        ends = [0, *joints, len(self.pieces)]
        return [range(a, b) for a, b in zip(ends, ends[1:])]

    def obstacles(self):
        """Returns the nodes at the ends of the beam and at rigid supports."""
        last = len(self.pieces)
        return [i for i in range(last + 1) if i in (0, last) or self.nodes[i].rigid is not None]

    def corner(self, node):
        """Returns the jump of the slope of the initial gap g₀ at a node: the slope on the right minus the slope on the
        left."""
        left, right = self.pieces[node - 1], self.pieces[node]
        return right.ends(right.d(right.g0))[0] - left.ends(left.d(left.g0))[1]

    def even(self, node):
        """Returns whether a node lies inside a shear layer, has no hinge and no force on the ground, and has the same
        μ and S on both sides."""
        if self.layered(node) != [True, True] or self.nodes[node].hinged or self.nodes[node].ground_force != 0:
            return False
        left, right = self.pieces[node - 1], self.pieces[node]
        if (left.stiffness is None) != (right.stiffness is None):
            return False
        pairs = [(left.shear, right.shear)]
        if left.stiffness is not None:
            pairs.append((left.stiffness, right.stiffness))
        return all((a.ends[1] - b.ends[0]).contains(0) for a, b in pairs)

    def kinks(self, node):
        """Returns whether a force or a support causes a jump of the slope at a node of a beam with shear
        deformation."""
        here = self.nodes[node]
        beside = [self.pieces[i] for i in (node - 1, node) if 0 <= i < len(self.pieces)]
        forced = here.force != 0 or here.rigid is not None or here.spring is not None
        return forced and any(piece.stiffness is not None for piece in beside)

    def smooth(self, node):
        """Returns whether the exact solution cannot have a point contact force at a node: the node has no corner of
        g₀, no jump of the slope and no other discontinuity."""
        return self.even(node) and self.corner(node).contains(0) and not self.kinks(node)
