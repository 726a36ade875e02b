"""The problem of a proof from its log: pieces with their polynomials, nodes with loads and supports, and the claimed
bounds."""

from math import comb

from flint import arb, arb_poly

from balls import Checks, NotReplayed, ball, exact, high, largest, low, optional, poly, upper


class Coefficient:
    """EI, S, k or μ along a piece: a constant, or a polynomial of t. Its bounds are its control values on the piece."""

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
    """A piece of the beam with t = (x − middle)/half, and the fields of the claimed answer on it."""

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
            raise NotReplayed("a rotation without a shear stiffness, or the reverse")
        if self.q is not None and not self.layered and not self.spring.even:
            raise NotReplayed("a load on Winkler ground whose k varies")
        if self.q is not None and not all(q >= 0 or q.contains(0) for q in self.ends(self.q)):
            raise NotReplayed("a load on the ground acts upward")

    def fields(self, force):
        """w′, φ, M, V, T = V + Pw′, p, the residual r of (5), and η = S(w′ − φ) − V."""
        self.slope = self.d(self.w)
        self.rotation = self.slope if self.phi is None else self.phi
        self.moment = self.bending * (self.kappa0 - self.d(self.rotation))
        shear_force = self.d(self.moment) - self.g
        self.transverse = shear_force + self.slope * force
        self.obstacle = self.w - self.g0
        # q/k: the settlement due to the ground's own loads, far from the beam.
        even = self.q is not None and self.spring.even
        self.free = self.q * (1 / self.spring.along[0]) if even else arb_poly([])
        self.above = self.obstacle - self.free
        self.pressure = self.pressure_under(self.obstacle) if self.touches else arb_poly([])
        self.residual = self.f - self.pressure + self.d(self.transverse)
        self.misfit = arb_poly([])
        if self.stiffness is not None:
            self.misfit = self.stiffness * (self.slope - self.rotation) - shear_force

    def pressure_under(self, settlement):
        """ku − q − (μ(w − g₀)′)′: the pressure if the beam were in contact with ground that has the settlement
        u."""
        pressure = self.spring * settlement - self.d(self.shear * self.d(self.obstacle))
        return pressure if self.q is None else pressure - self.q

    def d(self, p):
        """The derivative with respect to x."""
        return p.derivative() * (1 / self.half)

    def ends(self, p):
        return [p(t) for t in self.t]

    def integral(self, p):
        """∫p dx over the piece."""
        whole = p.integral()
        return (whole(self.t[1]) - whole(self.t[0])) * self.half

    def size(self, p, skip=0):
        """Σ|cⱼ|τʲ, from the constant coefficient or from a later one."""
        return sum((upper(p[j]) * self.tau**j for j in range(skip, p.degree() + 1)), arb(0))

    def load(self):
        """A bound of |r|."""
        return self.size(self.residual)

    def steepness(self, coefficient):
        """A bound of the slope of a coefficient."""
        return arb(0) if coefficient.even else self.size(self.d(coefficient.along))

    def bent(self, moment):
        """ε_κ = ε_M/EI."""
        return moment / self.bending.low


class Node:
    """A node between pieces, or an end of the beam."""

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
            raise NotReplayed("a negative weight")
        if not (self.ground_force >= 0):
            raise NotReplayed("a load on the ground acts upward")

    def towards(self, x):
        """The component of a force or deflection in the direction in which a one-way support acts."""
        return -x if self.acts < 0 else x

    def stiff(self):
        """κ and κ_θ."""
        spring = arb(0) if self.spring is None else upper(self.spring[0])
        return spring, arb(0) if self.turning is None else upper(self.turning)


class Problem(Checks):
    """One result of a log: the problem, the claimed solution, and the claimed bounds. The modules add their
    results."""

    def __init__(self, lines):
        super().__init__()
        self.lines = {}
        for line in lines:
            self.lines.setdefault(line["name"], []).append(line)
        if "problem" not in self.lines:
            raise NotReplayed("nothing is proven of this result")
        problem = self.one("problem")
        self.force = optional(problem["P"]) or arb(0)
        if not (self.force >= 0 or self.force < 0):
            raise NotReplayed("an axial force of unknown sign")
        self.tension = self.force if self.force > 0 else None
        self.sigma = optional(problem["sigma"], exact)
        if (self.force < 0) != (self.sigma is not None):
            raise NotReplayed("a compression without a critical load")
        if self.sigma is not None and not 0 < self.sigma < 1:
            raise NotReplayed("the remaining convexity is not between 0 and 1")
        self.outside, self.pushed = ([ball(x) for x in problem[key]] for key in ("outside", "pushed"))
        self.cuts, self.carrier = problem["cuts"], exact(problem["carrier"])
        self.units = problem["units"]
        self.nodes = [Node(line) for line in self.all("node")]
        self.x = [node.x for node in self.nodes]
        if len(self.nodes) != len(self.all("piece")) + 1:
            raise NotReplayed("the numbers of nodes and pieces do not match")
        ends = zip(self.x, self.x[1:])
        self.pieces = [Piece(line, x) for line, x in zip(self.all("piece"), ends)]
        for piece in self.pieces:
            if not piece.h > 0:
                raise NotReplayed("a piece without length")
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
            raise NotReplayed("a round without bounds for each piece")
        self.shears = any(piece.stiffness is not None for piece in self.pieces)

    def all(self, name):
        return self.lines.get(name, [])

    def complete(self, name, count):
        """The log has one line with this name for each piece or node, in order."""
        found = [line.get("piece", line.get("node")) for line in self.all(name)]
        if found != list(range(count)):
            raise NotReplayed(f"the lines `{name}` are not complete")

    def one(self, name):
        found = self.all(name)
        if len(found) != 1:
            raise NotReplayed(f"{len(found)} lines `{name}`")
        return found[0]

    def layered(self, node):
        """Whether the pieces on the left and on the right of a node belong to a layer."""
        return [0 <= i < len(self.pieces) and self.pieces[i].layered for i in (node - 1, node)]

    def layers(self):
        """The maximal runs of pieces with μ > 0."""
        first = None
        for i in range(len(self.pieces) + 1):
            inside = i < len(self.pieces) and self.pieces[i].layered
            if inside and first is None:
                first = i
            if not inside and first is not None:
                yield first, i
                first = None

    def parts(self):
        """The parts between hinges, as ranges of pieces."""
        return self.cut(lambda node: node.hinged)

    def joined_parts(self):
        """The parts between free hinges."""
        return self.cut(lambda node: node.free_hinge)

    def cut(self, at):
        joints = [i for i in range(1, len(self.pieces)) if at(self.nodes[i])]
        ends = [0, *joints, len(self.pieces)]
        return [range(a, b) for a, b in zip(ends, ends[1:])]

    def obstacles(self):
        """Ends of the beam and rigid supports."""
        last = len(self.pieces)
        return [i for i in range(last + 1) if i in (0, last) or self.nodes[i].rigid is not None]

    def corner(self, node):
        """The jump of g₀′."""
        left, right = self.pieces[node - 1], self.pieces[node]
        return right.ends(right.d(right.g0))[0] - left.ends(left.d(left.g0))[1]

    def even(self, node):
        """Whether μ and S are the same on both sides of a node inside a layer, without hinge and force on the
        ground."""
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
        """Whether a force or a support causes a jump of the slope at a node, on a beam with shear
        deformation."""
        here = self.nodes[node]
        beside = [self.pieces[i] for i in (node - 1, node) if 0 <= i < len(self.pieces)]
        forced = here.force != 0 or here.rigid is not None or here.spring is not None
        return forced and any(piece.stiffness is not None for piece in beside)

    def smooth(self, node):
        """Whether the kind of a node excludes a point contact force of the exact solution at it."""
        return self.even(node) and self.corner(node).contains(0) and not self.kinks(node)
