"""Recomputes the inequalities of a proof in ball arithmetic (python-flint), from the log of `groundbeam verify --log`.

    python replay.py LOG

Each inequality is recomputed from the problem, the pieces of the answer and the closing deflection in the log: none of
the program's own intermediate results is used but the ones that are claimed (depths, bounds). `docs/verify.md` tells
what is recomputed; numbers in brackets below are its formulas. Exit status: 0 all hold, 1 one does not, 2 the log cannot be
replayed.
"""

import json
import sys

from flint import arb, arb_poly, ctx

ctx.prec = 320
HALVINGS = 24
SUBDIVISIONS = 20_000
# Radii have 30 bits and depend on the order of operations: a right side may be exceeded by this part of itself.
ROUNDING = arb("1e-5")


class NotReplayed(Exception):
    """A log that cannot be replayed, with the reason."""


def exact(x):
    """A double as a ball of radius zero; a bound that is not finite is written as null."""
    return arb("+inf") if x is None else arb(float(x))


def ball(parts):
    """A ball of the log: middle, correction of the middle, radius."""
    middle, correction, radius = map(float, parts)
    return arb(middle) + arb(correction) + arb(0, radius)


def upper(x):
    """|x| as the ball of its upper bound."""
    return arb(abs(x).upper())


def largest(*values):
    most = arb(0)
    for value in values:
        most = most.max(upper(value))
    return most


def poly(coefficients):
    return arb_poly([ball(c) for c in coefficients])


class Piece:
    def __init__(self, line):
        if any(line[key] is None for key in ("EI", "k", "mu")):
            raise NotReplayed("a coefficient that varies")
        if line["phi"] is not None or line["q"] is not None:
            raise NotReplayed("a beam that shears, or a load on the ground")
        self.middle, self.half = ball(line["middle"]), ball(line["half"])
        self.touches = line["touches"]
        self.w = poly(line["w"])
        self.bending, self.spring, self.shear = (ball(line[key]) for key in ("EI", "k", "mu"))
        self.layered = line["mu"][0] != 0
        self.loads = {key: poly(line[key]) for key in ("f", "g", "kappa0", "g0")}

    def place(self, left, right):
        """Takes its exact ends."""
        self.h = right - left
        self.t = [(x - self.middle) / self.half for x in (left, right)]
        self.tau = largest(arb(1), *self.t)

    def d(self, p):
        """The derivative by x."""
        return p.derivative() * (1 / self.half)

    def fields(self, force):
        """Slope, M, T and p, and the residual r of (5)."""
        self.slope = self.d(self.w)
        curvature = self.d(self.slope)
        self.moment = (self.loads["kappa0"] - curvature) * self.bending
        self.transverse = self.d(self.moment) - self.loads["g"] + self.slope * force
        obstacle = self.w - self.loads["g0"]
        pressure = obstacle * self.spring - curvature * self.shear
        self.pressure = pressure if self.touches else arb_poly([])
        self.obstacle = obstacle
        self.residual = self.loads["f"] - self.pressure + self.d(self.transverse)

    def ends(self, p):
        return [p(t) for t in self.t]

    def integral(self, p):
        """∫p over the piece by x."""
        whole = p.integral()
        return (whole(self.t[1]) - whole(self.t[0])) * self.half

    def size(self, p, skip=0):
        """Σ|cⱼ|τʲ, from the constant coefficient or from a later one."""
        total = arb(0)
        for j in range(skip, p.degree() + 1):
            total += upper(p[j]) * self.tau**j
        return total


class Replay:
    def __init__(self, lines):
        self.lines = {}
        for line in lines:
            self.lines.setdefault(line["name"], []).append(line)
        self.count, self.failed, self.parts = 0, [], {}
        problem = self.one("problem")
        self.force = ball(problem["P"]) if problem["P"] else arb(0)
        if not self.force >= 0:
            raise NotReplayed("compression")
        self.outside = [ball(x) for x in problem["outside"]]
        self.cuts = problem["cuts"]
        self.nodes = self.all("node")
        if not all(node["both"] for node in self.nodes):
            raise NotReplayed("a support that acts in one direction")
        if any(ball(node["Q"]) != 0 for node in self.nodes) or any(ball(x) != 0 for x in problem["pushed"]):
            raise NotReplayed("a load on the ground")
        self.x = [ball(node["x"]) for node in self.nodes]
        self.pieces = [Piece(line) for line in self.all("piece")]
        for i, piece in enumerate(self.pieces):
            piece.place(self.x[i], self.x[i + 1])
            piece.fields(self.force)
        self.value = [ball(line["w"]) for line in self.all("admissible at a node")]
        self.touches = [line["touches"] for line in self.all("admissible at a node")]
        self.energy = exact(self.one("energy")["E"])
        self.s2 = (2 * self.energy).sqrt()

    def all(self, name):
        return self.lines.get(name, [])

    def one(self, name):
        found = self.all(name)
        if len(found) != 1:
            raise NotReplayed(f"{len(found)} lines `{name}`")
        return found[0]

    def holds(self, name, left, right):
        """left ≤ right, but for the rounding of radii. A bound that is infinite claims nothing."""
        if not right.is_finite():
            return
        self.count += 1
        if not left <= right * (1 + ROUNDING):
            self.failed.append(f"{name}: {left.str(20)} <= {right.str(20)} does not hold")

    def meets(self, name, difference):
        """A difference that is zero in exact numbers."""
        self.count += 1
        if not difference.contains(0):
            self.failed.append(f"{name}: the difference {difference.str(10)} is not zero")

    def run(self):
        self.closing()
        self.surface()
        self.pulls()
        self.residuals()
        self.balance()
        self.clearances()
        self.sum()
        self.pointwise()

    # Section 3, deflection.
    def closing(self):
        """(3): c closes the jumps, and its bounds."""
        lines = self.all("closing")
        self.c = [[exact(b) for b in line["bounds"]] for line in lines]
        self.c_slope = [[ball(s) for s in line["slopes"]] for line in lines]
        for i, (piece, slope, bounds) in enumerate(zip(self.pieces, self.c_slope, self.c)):
            a = [self.value[i + side] - w for side, w in enumerate(piece.ends(piece.w))]
            if bounds[2] == 0:
                self.meets(f"piece {i} is carried rigidly", a[0] + slope[0] * piece.h - a[1])
                self.meets(f"piece {i} is carried rigidly, slope", slope[0] - slope[1])
                most = [upper(a[0]) + upper(slope[0]) * piece.h, upper(slope[0]), arb(0)]
            else:
                big, steep = largest(*a), largest(*slope)
                most = [
                    big + arb("0.3") * steep * piece.h,
                    3 * big / piece.h + steep,
                    12 * big / piece.h**2 + 6 * steep / piece.h,
                ]
            for name, left, right in zip(("c", "c'", "c''"), most, bounds):
                self.holds(f"(3) |{name}| on piece {i}", left, right)
        for i, node in enumerate(self.nodes):
            turn = [None, None]
            if i > 0:
                turn[0] = self.pieces[i - 1].ends(self.pieces[i - 1].slope)[1] + self.c_slope[i - 1][1]
            if i < len(self.pieces):
                turn[1] = self.pieces[i].ends(self.pieces[i].slope)[0] + self.c_slope[i][0]
            if node["hinge"] is None and None not in turn:
                self.meets(f"slope at node {i}", turn[0] - turn[1])
            if node["rigid"] is not None:
                self.meets(f"support at node {i}", self.value[i] - ball(node["rigid"]))
            if node["clamped"]:
                self.meets(f"clamp at node {i}", turn[1] if turn[0] is None else turn[0])

    # Section 3, ground.
    def link(self, piece):
        """s₁ and s₂ of (4)."""
        rate = (piece.spring / piece.shear).sqrt()
        z, root = rate * piece.h, (piece.spring * piece.shear).sqrt()
        return root / z.sinh(), root * (z / 2).tanh()

    def layers(self):
        first = None
        for i in range(len(self.pieces) + 1):
            inside = i < len(self.pieces) and self.pieces[i].layered
            if inside and first is None:
                first = i
            if not inside and first is not None:
                yield first, i
                first = None

    def surface(self):
        """The settlement of open ground, the concentrated forces, and √g."""
        count = len(self.pieces)
        self.u = [None] * (count + 1)
        self.jump = [arb(0)] * (count + 1)
        claimed = [exact(line["root_g"]) for line in self.all("ground")]
        self.root_g = claimed
        for first, end in self.layers():
            self.layer(first, end)
            stiffness = [self.behind(first, end, 0), self.behind(first, end, 1)]
            spans = self.pieces[first:end]
            spring = arb(min(piece.spring.lower() for piece in spans))
            shear = arb(min(piece.shear.lower() for piece in spans))
            rate = (spring / shear).sqrt() * (self.x[end] - self.x[first])
            whole = (spring * shear).sqrt() * rate.tanh()
            for i in range(first, end):
                least = sum(arb(min(stiffness[s][i - first + j].lower() for j in (0, 1))) for s in (0, 1))
                bound = (1 / least).min(1 / whole).sqrt()
                self.holds(f"sqrt(g) on piece {i}", bound, claimed[i])

    def behind(self, first, end, side):
        """The stiffness of the layer on one side of each node, as if it were open."""
        at_end = first == 0 if side == 0 else end == len(self.pieces)
        stiffness = [self.outside[side] if at_end else arb(0)]
        order = range(first, end) if side == 0 else reversed(range(first, end))
        for i in order:
            across, own = self.link(self.pieces[i])
            inner = stiffness[-1]
            stiffness.append(across * (inner + own) / (inner + own + across) + own)
        return stiffness if side == 0 else stiffness[::-1]

    def layer(self, first, end):
        """Solves μu″ = ku between the touching nodes and takes the jump of the flux at them."""
        nodes = range(first, end + 1)
        for i in nodes:
            if self.touches[i]:
                piece, side = (self.pieces[i], 0) if i < end else (self.pieces[i - 1], 1)
                self.u[i] = self.value[i] - piece.ends(piece.loads["g0"])[side]
        i = first
        while i <= end:
            if self.touches[i]:
                i += 1
                continue
            last = i
            while last < end and not self.touches[last + 1]:
                last += 1
            self.open_nodes(first, end, i, last)
            i = last + 1
        for i in nodes:
            if self.touches[i]:
                self.jump[i] = self.flux(first, end, i, 0) - self.flux(first, end, i, 1)

    def open_nodes(self, first, end, a, b):
        """The tridiagonal system for u at the open nodes a to b."""
        diagonal, beside, right = [], [], []
        for i in range(a, b + 1):
            total, load = arb(0), arb(0)
            for side, j in ((0, i - 1), (1, i)):
                if not first <= j < end:
                    if i == (0 if side == 0 else len(self.pieces)):
                        total += self.outside[side]
                    continue
                across, own = self.link(self.pieces[j])
                total += across + own
                other = j if side == 0 else j + 1
                if not a <= other <= b:
                    load += across * self.u[other]
                elif side == 1:
                    beside.append(-across)
            diagonal.append(total)
            right.append(load)
        for i in range(1, len(diagonal)):
            factor = beside[i - 1] / diagonal[i - 1]
            diagonal[i] -= factor * beside[i - 1]
            right[i] -= factor * right[i - 1]
        for i in reversed(range(len(diagonal))):
            if i + 1 < len(diagonal):
                right[i] -= beside[i] * right[i + 1]
            right[i] /= diagonal[i]
            self.u[a + i] = right[i]

    def open_fluxes(self, i):
        across, own = self.link(self.pieces[i])
        left, right = self.u[i], self.u[i + 1]
        return [across * (right - left) - own * left, across * (right - left) + own * right]

    def flux(self, first, end, node, side):
        j = node - 1 if side == 0 else node
        if not first <= j < end:
            at_end = node == (0 if side == 0 else len(self.pieces))
            outward = self.outside[side] * self.u[node] if at_end else arb(0)
            return outward if side == 0 else -outward
        piece = self.pieces[j]
        if not piece.touches:
            return self.open_fluxes(j)[1 - side]
        return piece.shear * piece.ends(piece.d(piece.obstacle))[1 - side]

    # Section 3, signs of p.
    def pulls(self):
        """p ≥ −η, and p < 0 on a measure of at most ω."""
        self.depth, self.width = [], []
        for i, (piece, line) in enumerate(zip(self.pieces, self.all("pull"))):
            depth, width = exact(line["depth"]), exact(line["width"])
            self.depth.append(depth)
            self.width.append(width)
            if piece.touches:
                deepest, measure = below(piece.pressure, piece.t)
                self.holds(f"depth of pulls on piece {i}", deepest, depth)
                self.holds(f"width of pulls on piece {i}", (measure * piece.half).min(piece.h), width)

    # Section 3, balance.
    def residuals(self):
        """(5) at the nodes."""
        self.at_node = []
        for i, node in enumerate(self.nodes):
            reaction = [ball(r) for r in node["reaction"]]
            force = ball(node["F"]) - self.jump[i].max(arb(0)) - reaction[0]
            moment = ball(node["M0"]) - reaction[1]
            if i > 0:
                left = self.pieces[i - 1]
                force -= left.ends(left.transverse)[1]
                moment += left.ends(left.moment)[1]
            if i < len(self.pieces):
                right = self.pieces[i]
                force += right.ends(right.transverse)[0]
                moment -= right.ends(right.moment)[0]
            w, slope = self.at_support(i)
            if node["spring"] is not None:
                spring, settled = map(ball, node["spring"])
                force -= spring * w - settled
            if node["turning"] is not None:
                moment -= ball(node["turning"]) * slope
            self.at_node.append([force, moment])

    def at_support(self, i):
        piece, side = (self.pieces[0], 0) if i == 0 else (self.pieces[i - 1], 1)
        return piece.ends(piece.w)[side], piece.ends(piece.slope)[side]

    def carried(self, i):
        rigid, spring, _, _ = self.nodes[i]["weights"]
        return self.jump[i].max(arb(0)) + exact(rigid) + exact(spring)

    def turned_in(self, a, b):
        inside = range(a, b + (1 if b == len(self.pieces) else 0))
        return sum((exact(self.nodes[i]["weights"][2]) + exact(self.nodes[i]["weights"][3]) for i in inside), arb(0))

    def pull(self, i):
        return self.depth[i] * self.width[i] if self.pieces[i].touches else arb(0)

    def is_free(self, i):
        hinge = self.nodes[i]["hinge"]
        return hinge is not None and ball(hinge) == 0

    def balance(self):
        """The cells' moments δ, the system (6), and what the forces given back add (7)."""
        count = len(self.pieces)
        self.delta, self.delta_slope = [None] * count, [None] * count
        cuts = self.cuts
        size = len(cuts)
        diagonal = [self.carried(node) for node in cuts]
        right = [self.at_node[node][0] for node in cuts]
        beside = [arb(0)] * (size - 1)
        for j in range(size - 1):
            a, b = cuts[j], cuts[j + 1]
            shears = self.cell(a, b)
            right[j] -= shears[0]
            right[j + 1] += shears[1]
            ends = [self.x[a], self.x[b]]
            per_length = 1 / (ends[1] - ends[0])
            masses = []
            for i in range(a + 1, b):
                hats = [(ends[1] - self.x[i]) * per_length, (self.x[i] - ends[0]) * per_length]
                masses.append((self.carried(i), hats))
            masses.append((self.turned_in(a, b), [-per_length, per_length]))
            terms = [arb(0), arb(0), arb(0)]
            for mass, (p, q) in masses:
                for k, product in enumerate((p * p, p * q, q * q)):
                    terms[k] += mass * product
            pulls = arb(0)
            for i in range(a, b):
                piece = self.pieces[i]
                if not piece.touches:
                    continue
                slope = piece.half * per_length
                hats = [
                    arb_poly([(ends[1] - piece.middle) * per_length, -slope]),
                    arb_poly([(piece.middle - ends[0]) * per_length, slope]),
                ]
                products = (hats[0] * hats[0], hats[0] * hats[1], hats[1] * hats[1])
                for k, product in enumerate(products):
                    terms[k] += piece.integral(product * piece.pressure)
                pulls += self.pull(i)
            wide = arb(0, upper(pulls))
            diagonal[j] += terms[0] + wide
            beside[j] += terms[1] + wide
            diagonal[j + 1] += terms[2] + wide
            right[j] += wide
            right[j + 1] += wide
        for j in range(size):
            self.holds(f"(6) pivot {j} is positive", arb(0), diagonal[j])
            if j + 1 < size:
                factor = beside[j] / diagonal[j]
                diagonal[j + 1] -= factor * beside[j]
                right[j + 1] -= factor * right[j]
        for j in reversed(range(size)):
            if j + 1 < size:
                right[j] -= beside[j] * right[j + 1]
            right[j] /= diagonal[j]
        self.give_back(right)

    def cell(self, a, b):
        """δ along a cell; −δ′ at its two ends."""
        last = len(self.pieces)
        ends = [self.at_node[a][1], arb(0)]
        if self.is_free(a):
            ends[0] = -self.pieces[a].ends(self.pieces[a].moment)[0]
        if self.is_free(b):
            ends[1] = -self.pieces[b - 1].ends(self.pieces[b - 1].moment)[1]
        elif b == last:
            ends[1] = -self.at_node[b][1]
        inner = {i: self.at_node[i] for i in range(a + 1, b)}
        loads = []
        moment = ends[0] - ends[1]
        for i in range(a, b):
            piece = self.pieces[i]
            whole = piece.integral(piece.residual)
            turned = piece.integral(piece.residual * arb_poly([0, 1]))
            about_right = (piece.t[1] * whole - turned) * piece.half
            loads.append((whole, about_right))
            force, turn = inner.get(i, [arb(0), arb(0)])
            levers = [self.x[b] - self.x[i], self.x[b] - self.x[i + 1]]
            moment += turn - force * levers[0] - about_right - whole * levers[1]
        first = moment / (self.x[b] - self.x[a])
        shear, delta = first, ends[0]
        for i, (whole, about_right) in zip(range(a, b), loads):
            force, turn = inner.get(i, [arb(0), arb(0)])
            shear, delta = shear + force, delta + turn
            after = delta - shear * self.pieces[i].h - about_right
            self.delta[i] = [delta, after]
            self.delta_slope[i] = [shear, shear + whole]
            shear, delta = shear + whole, after
        return first, shear

    def give_back(self, factors):
        """λ at the nodes, |λ| < ½ on what presses, and (7)."""
        count = len(self.pieces)
        self.factor = [arb(0)] * (count + 1)
        self.added, self.added_shear, self.steep = [None] * count, [None] * count, [None] * count
        for j in range(len(self.cuts) - 1):
            a, b = self.cuts[j], self.cuts[j + 1]
            length = self.x[b] - self.x[a]
            slope = (factors[j + 1] - factors[j]) / length
            for i in range(a, b + 1):
                hats = [(self.x[b] - self.x[i]) / length, (self.x[i] - self.x[a]) / length]
                self.factor[i] = hats[0] * factors[j] + hats[1] * factors[j + 1]
            load = arb(0)
            for i in range(a, b):
                gamma, piece = self.gamma(i, self.factor), self.pieces[i]
                load += gamma * upper(piece.integral(piece.pressure)) + (1 + gamma) * self.pull(i)
                if i > a:
                    load += upper(self.factor[i]) * upper(self.carried(i))
            couple = upper(self.turned_in(a, b)) * upper(slope)
            for i in range(a, b):
                self.added[i] = length * load / 4 + couple
                self.added_shear[i] = load + couple / length
                self.steep[i] = upper(slope)
        for i, piece in enumerate(self.pieces):
            if piece.touches:
                self.holds(f"|lambda| on piece {i}", self.gamma(i, self.factor), arb(0.5))
        for i, jump in enumerate(self.jump):
            if jump > 0:
                self.holds(f"|lambda| at node {i}", upper(self.factor[i]), arb(0.5))

    @staticmethod
    def gamma(i, factor):
        return largest(factor[i], factor[i + 1])

    # Section 3, clearance.
    def clearances(self):
        """C̄ ≥ −D on open ground, and what raising the ground by D min(x/d, 1) costs, (10)."""
        line = self.one("clearance")
        self.lifted, self.risen = exact(line["lifted"]), exact(line["risen"])
        self.raised = [exact(ground["raised"]) for ground in self.all("ground")]
        cost = arb(0)
        for i, piece in enumerate(self.pieces):
            if piece.touches or piece.layered:
                continue
            depth, measure = below(-(piece.obstacle + arb_poly([self.c[i][0]])), piece.t)
            self.holds(f"the beam below open springs on piece {i}", depth, self.raised[i])
            cost += piece.spring * depth**2 * (measure * piece.half).min(piece.h)
        self.holds("(sum k eta_o^2 omega_o)^1/2", cost.max(arb(0)).sqrt(), self.risen)

    # Section 3, sum.
    def sum(self):
        """(11) from (8), (9) and the parts of springs and hinges."""
        bent = beam = drawn = arb(0)
        touching = pulled = unclaimed = arb(0)
        for i, piece in enumerate(self.pieces):
            c = self.c[i]
            bent += piece.h * piece.bending * c[2] ** 2
            drawn += piece.h * c[1] ** 2 * self.force
            beam += self.moment_norm(i) ** 2 / piece.bending
            if piece.touches:
                touching += piece.h * (piece.spring * c[0] ** 2 + piece.shear * c[1] ** 2)
                pulled += self.depth[i] * (self.width[i] / piece.spring).sqrt()
        for i, jump in enumerate(self.jump):
            if self.touches[i]:
                unclaimed += (-jump.lower() if jump.lower() < 0 else arb(0)) * self.root_g_at(i)
        missed = touching.sqrt() + unclaimed + pulled
        ground = missed + self.given_back(missed).sqrt() + self.lifted + self.risen
        parts = {
            "(||delta|| + ||c||_beam)^2": (beam.sqrt() + bent.sqrt()) ** 2,
            "springs": self.springs(),
            "hinges": self.hinges(),
            "||c||_P^2": drawn,
            "ground, G^2": ground**2,
        }
        self.parts = {name: upper(part / 2) for name, part in parts.items()}
        self.holds("(11) E", sum(self.parts.values(), arb(0)), self.energy)

    def root_g_at(self, node):
        beside = [self.root_g[i] for i in (node - 1, node) if 0 <= i < len(self.pieces)]
        return arb(min(x.upper() for x in beside))

    def moment_norm(self, i):
        """(9)."""
        piece = self.pieces[i]
        h, (a, b), r = piece.h, self.delta[i], piece.residual[0]
        square = h * (a * a + a * b + b * b) / 3 + r * h**3 * (a + b) / 12 + r * r * h**5 / 120
        rest = piece.size(piece.residual, 1)
        return upper(square).sqrt() + (h**5 / 120).sqrt() * rest + h.sqrt() * self.added[i]

    def given_back(self, missed):
        """(8)."""
        total = arb(0)
        for i, piece in enumerate(self.pieces):
            if not piece.touches:
                continue
            gamma = self.gamma(i, self.factor)
            if piece.layered:
                each = piece.size(piece.obstacle) + self.c[i][0] + self.root_g[i] * missed
            else:
                each = piece.size(piece.pressure) / piece.spring
            total += gamma**2 * (upper(piece.integral(piece.pressure)) + self.pull(i)) * each
        for i, jump in enumerate(self.jump):
            force = jump.max(arb(0))
            if self.touches[i] and force != 0:
                settled = upper(self.u[i]) + self.root_g_at(i) * missed
                total += upper(self.factor[i]) ** 2 * upper(force) * settled
        return total

    def springs(self):
        total = arb(0)
        for i, node in enumerate(self.nodes):
            w, slope = self.at_support(i)
            weights = [exact(x) for x in node["weights"]]
            if node["spring"] is not None:
                spring = ball(node["spring"][0])
                total += (spring * upper(self.value[i] - w) + upper(self.factor[i]) * weights[1]) ** 2 / spring
            if node["turning"] is not None:
                spring = ball(node["turning"])
                piece, side = (0, 0) if i == 0 else (i - 1, 1)
                cell = i if i < len(self.pieces) else i - 1
                turned = upper(self.c_slope[piece][side])
                total += (spring * turned + self.steep[cell] * weights[3]) ** 2 / spring
        return total

    def hinges(self):
        total = arb(0)
        for i, node in enumerate(self.nodes):
            if node["hinge"] is None or self.is_free(i):
                continue
            spring, (left, right) = ball(node["hinge"]), (self.pieces[i - 1], self.pieces[i])
            turn = right.ends(right.slope)[0] + self.c_slope[i][0] - left.ends(left.slope)[1] - self.c_slope[i - 1][1]
            moment = left.ends(left.moment)[1] + self.delta[i - 1][1]
            total += (upper(spring * turn + moment) + self.added[i - 1]) ** 2 / spring
        return total

    # Section 4.
    def pointwise(self):
        """The bounds of u, M, w′ and p on each piece, from E, √g and the bound of w."""
        bounds = self.all("bounds")
        stiffness = self.stiffnesses()
        for i, (piece, line) in enumerate(zip(self.pieces, bounds)):
            w, slope, m, moment, u, p = (exact(line[key]) for key in ("w", "slope", "m", "M", "u", "p"))
            if piece.layered:
                settled = self.s2 * self.root_g[i] + (self.c[i][0] if piece.touches else self.raised[i])
            else:
                settled = w + (self.depth[i] / piece.spring if piece.touches else self.raised[i])
            self.holds(f"eps_u on piece {i}", settled, u)
            self.holds(f"s2 K on piece {i}", self.s2 * stiffness[i], m)
            load = upper(piece.residual[0]) + piece.size(piece.residual, 1)
            delta = largest(*self.delta[i]) + piece.h**2 * load / 8 + self.added[i]
            self.holds(f"eps_M on piece {i}", m + delta, moment)
            pressed = piece.spring * u + piece.shear * moment / piece.bending
            self.holds(f"eps_p on piece {i}", pressed, p)
        self.slopes(bounds)
        self.deflections(bounds)
        self.contact(bounds)
        self.uniqueness()

    def stiffnesses(self):
        """The least K found on each piece: kinks between obstacles, and straight ones to an end of the beam."""
        count = len(self.pieces)
        stops = [i for i in range(count + 1) if i in (0, count) or self.nodes[i]["rigid"] is not None]
        least = [None] * count
        for a, b in zip(stops, stops[1:]):
            spans = self.pieces[a:b]
            bending = largest(*(p.bending for p in spans))
            layer = largest(*(p.shear for p in spans)) + self.force
            ground = largest(*(p.spring for p in spans))
            springs, turning = self.held(range(a, b + 1))
            found = None
            h = (self.x[b] - self.x[a]) / 2
            for _ in range(HALVINGS):
                k = 4 * bending / h + arb("0.134") * layer * h + ground * h**3 / 105
                k += springs * (arb("0.1482") * h) ** 2 + turning
                found = k if found is None else found.min(k)
                h /= 2
            for i in range(a, b):
                least[i] = found
        for side in (0, 1):
            self.long_kinks(side, least)
        return [k.sqrt() for k in least]

    def held(self, nodes):
        springs = turning = arb(0)
        for i in nodes:
            node = self.nodes[i]
            springs += ball(node["spring"][0]) if node["spring"] is not None else 0
            turning += ball(node["turning"]) if node["turning"] is not None else 0
        return springs, turning

    def long_kinks(self, side, least):
        count = len(self.pieces)
        layer = ground = arb(0)
        passed = []
        for step in range(count):
            i = step if side == 0 else count - 1 - step
            outer, inner = i + side, i + 1 - side
            if self.nodes[outer]["rigid"] is not None:
                return
            passed.append(outer)
            layer = layer.max(upper(self.pieces[i].shear) + self.force)
            ground = ground.max(upper(self.pieces[i].spring))
            long = abs(self.x[inner] - self.x[0 if side == 0 else count])
            k = layer * long + ground * long**3 / 3 + self.outside[side] * long**2
            for j in passed:
                springs, turning = self.held([j])
                k += springs * (self.x[j] - self.x[inner]) ** 2 + turning
            least[i] = least[i].min(k)

    def slopes(self, bounds):
        """|w′ − w*′| from sup|e| on each part between hinges."""
        first = 0
        for end in range(1, len(self.pieces) + 1):
            if end < len(self.pieces) and self.nodes[end]["hinge"] is None:
                continue
            part = range(first, end)
            first = end
            if any(bounds[i]["w"] is None for i in part):
                continue
            error = largest(*(exact(bounds[i]["w"]) for i in part))
            curved = largest(*(exact(bounds[i]["M"]) / self.pieces[i].bending + self.c[i][2] for i in part))
            s = self.s2 / arb(min(self.pieces[i].bending.lower() for i in part)).sqrt()
            steepest = largest(*(self.c[i][1] for i in part))
            # ε_w holds max|c|, which sup|e| does not need.
            error -= largest(*(self.c[i][0] for i in part))
            h, found = self.x[end] - self.x[part.start], None
            for _ in range(60):
                slope = 2 * error / h + (h * curved / 2).min(s * (h / 3).sqrt())
                found = slope if found is None else found.min(slope)
                h *= arb("0.7")
            for i in part:
                self.holds(f"eps_theta on piece {i}", found + steepest, exact(bounds[i]["slope"]))


    def parts_of_beam(self):
        """The parts between hinges, as ranges of pieces."""
        joints = [i for i in range(1, len(self.pieces)) if self.nodes[i]["hinge"] is not None]
        ends = [0, *joints, len(self.pieces)]
        return [range(a, b) for a, b in zip(ends, ends[1:])]

    def least_pressure(self, i, part):
        """A lower bound of the balanced pressure on |t| ≤ part."""
        piece = self.pieces[i]
        least = piece.pressure(arb(0, part))
        kept = 1 - self.gamma(i, self.factor)
        return arb(least.lower()) * kept if kept > 0.5 and least > 0 else arb(0)

    def anchors(self, part):
        """Places (left, right) with a bound of |e|, and whether a clamp holds them."""
        found = []
        for i in range(part.start, part.stop + 1):
            node, x = self.nodes[i], self.x[i]
            if node["rigid"] is not None:
                found.append((x, arb(0), node["clamped"]))
            if node["spring"] is not None:
                found.append((x, (2 * self.energy / ball(node["spring"][0])).sqrt(), False))
            force = self.jump[i].max(arb(0)) * (1 - upper(self.factor[i]))
            if self.touches[i] and force > 0:
                found.append((x, self.s2 * self.root_g_at(i) + self.energy / arb(force.lower()), False))
        s = self.bent(part)
        for i in part:
            piece = self.pieces[i]
            if not piece.touches:
                continue
            best = None
            for reach in (0.9, 0.5, 0.25, 0.0625):
                least = self.least_pressure(i, reach)
                if not least > 0:
                    continue
                half = reach * piece.half
                curved = s * half * half.sqrt()
                if piece.layered:
                    settled = self.s2 * self.root_g[i]
                else:
                    settled = (2 * self.energy / (piece.spring * 2 * half)).sqrt()
                mean = settled + self.energy / (least * 2 * half) + arb("0.2310") * curved
                bound = arb("2.4143") * mean + arb("0.5774") * curved
                if best is None or bound < best[0]:
                    best = (bound, half)
            if best is not None:
                found += [(piece.middle + side * best[1], best[0], False) for side in (-1, 1)]
        return found

    def bent(self, part):
        """s = s₂/√EI_min."""
        return self.s2 / arb(min(self.pieces[i].bending.lower() for i in part)).sqrt()

    def along(self, part, anchors):
        """(12) between anchors, beyond them, and beyond a clamp."""
        s = self.bent(part)
        anchors = sorted(anchors, key=lambda anchor: float(anchor[0].mid()))
        if not anchors:
            return arb("+inf")
        most = largest(*(bound for _, bound, _ in anchors[:1] + anchors[-1:]))
        for (x, a, _), (y, b, _) in zip(anchors, anchors[1:]):
            most = most.max(a.max(b) + s * (upper(y - x) ** 3 / 48).sqrt())
        ends = (self.x[part.start], self.x[part.stop])
        for near, end in ((anchors[0], ends[0]), (anchors[-1], ends[1])):
            over = upper(near[0] - end)
            if not (near[0] - end).contains(0):
                least = arb("+inf")
                if near[2]:
                    least = arb("0.5774") * s * over * over.sqrt()
                for far in anchors:
                    gap = abs(far[0] - near[0])
                    if gap > 0:
                        bend = s * (over**2 * (gap + over) / 3).sqrt()
                        least = least.min(near[1] + (near[1] + far[1]) * over / gap + bend)
                most = most.max(least)
        return most

    def best_along(self, part, anchors):
        """The least bound over the anchors that are not worse than a level."""
        anchors = sorted(anchors, key=lambda anchor: float(anchor[1].mid()))
        least, count = arb("+inf"), 1
        while count <= len(anchors):
            level = 16 * anchors[count - 1][1]
            while count < len(anchors) and anchors[count][1] <= level:
                count += 1
            least = least.min(self.along(part, anchors[:count]))
            count += 1
        return least

    def deflections(self, bounds):
        """|w − w*| from the anchors of each part; a part hands its bound on at hinges."""
        parts = self.parts_of_beam()
        anchors = [self.anchors(part) for part in parts]
        found = [arb("+inf")] * len(parts)
        used = [0] * len(parts)
        order = list(range(len(parts)))
        for j in 2 * (order + order[::-1]):
            if len(anchors[j]) == used[j]:
                continue
            found[j], used[j] = found[j].min(self.best_along(parts[j], anchors[j])), len(anchors[j])
            if found[j].is_finite():
                if j > 0:
                    anchors[j - 1].append((self.x[parts[j].start], found[j], False))
                if j + 1 < len(parts):
                    anchors[j + 1].append((self.x[parts[j].stop], found[j], False))
        if self.force > 0:
            length = self.x[-1] - self.x[0]
            bound = [anchor[1] for part in anchors for anchor in part]
            least = min(bound, key=lambda b: float(b.mid())) if bound else arb("+inf")
            drawn = least + (2 * self.energy / self.force * length).sqrt()
            found = [error.min(drawn) for error in found]
        for part, error in zip(parts, found):
            closed = largest(*(self.c[i][0] for i in part))
            for i in part:
                self.holds(f"(12) eps_w on piece {i}", error + closed, exact(bounds[i]["w"]))

    # Section 5.
    def contact(self, bounds):
        """Open stretches, forces, regions and points of all layers."""
        if not self.one("contact set")["shown"][0]:
            return
        self.error = [{key: exact(line[key]) for key in ("w", "slope", "M", "u", "p")} for line in bounds]
        self.edges = {(line["node"], line["side"]): line for line in self.all("edge")}
        self.tolerance = [exact(line["error"]) for line in self.all("tolerance of a force")]
        for first, end in self.layers():
            steep = {}
            i = first
            while i < end:
                if self.pieces[i].touches:
                    i += 1
                    continue
                last = i + 1
                while last < end and not self.pieces[last].touches and not self.touches[last]:
                    last += 1
                self.stretch(i, last, steep)
                i = last
            for node in range(first, end + 1):
                if self.touches[node]:
                    found = sum((self.flux_error(first, end, node, side, steep) for side in (0, 1)), arb(0))
                    self.holds(f"eps_a at node {node}", found, self.tolerance[node])
            node = first
            while node <= end:
                last = node
                if self.touches[node]:
                    while last < end and self.pieces[last].touches:
                        last += 1
                    self.region(node, last)
                node = last + 1

    def smooth(self, node):
        """Whether the exact answer has no concentrated force there, by the kind of the node."""
        if not 0 < node < len(self.pieces):
            return False
        left, right = self.pieces[node - 1], self.pieces[node]
        even = left.layered and right.layered and (left.shear - right.shear).contains(0)
        corner = right.ends(right.d(right.loads["g0"]))[0] - left.ends(left.d(left.loads["g0"]))[1]
        return even and self.nodes[node]["hinge"] is None and corner.contains(0)

    def arc(self, i, t):
        """u and u′ on an open piece."""
        piece = self.pieces[i]
        rate = (piece.spring / piece.shear).sqrt()
        x, z = (t - piece.t[0]) * piece.half, rate * piece.h
        left, right = self.u[i], self.u[i + 1]
        value = left * (z - rate * x).sinh() + right * (rate * x).sinh()
        slope = right * (rate * x).cosh() - left * (z - rate * x).cosh()
        return value / z.sinh(), rate * slope / z.sinh()

    def clearance(self, i, t):
        """C, C′ and C″ at t."""
        piece = self.pieces[i]
        u, slope = self.arc(i, t)
        obstacle = piece.obstacle
        first = piece.d(obstacle)
        bent = piece.spring / piece.shear * u - piece.d(first)(t)
        return u - obstacle(t), slope - first(t), bent

    def least_clearance(self, i, t):
        """A lower bound of C on an interval of t, from its middle and the largest |C′|."""
        middle, reach = arb(t.mid()), arb(t.rad())
        steep = upper(self.clearance(i, t)[1]) * self.pieces[i].half
        return self.clearance(i, middle)[0] - steep * reach

    def least_growth(self, i, t, inward):
        """The same of C′ in one direction, with the largest |C″|."""
        middle, reach = arb(t.mid()), arb(t.rad())
        bent = upper(self.clearance(i, t)[2]) * self.pieces[i].half
        return self.clearance(i, middle)[1] * inward - bent * reach

    @staticmethod
    def on(ends, is_true):
        """Shows a statement on an interval of t by halving; it is given the interval as a ball."""
        todo = [ends]
        for _ in range(SUBDIVISIONS):
            if not todo:
                return True
            a, b = todo.pop()
            middle, reach = (a + b) / 2, (b - a) / 2
            if is_true(arb(middle.mid(), upper(reach))):
                continue
            if not reach > arb(2) ** -70 or not is_true(arb(middle.mid())):
                return False
            todo += [(a, middle), (middle, b)]
        return False

    def stretch(self, first, end, steep):
        """C > ε_u + ε_w up to a reach; from there to θ C falls faster than its slope is off. There μC″ > ε_p."""
        ends = [self.touches[first], self.touches[end]]
        for i in range(first, end):
            piece, error = self.pieces[i], self.error[i]
            interval = list(piece.t)
            here = [i == first and ends[0], i + 1 == end and ends[1]]
            for side in (0, 1):
                if here[side]:
                    reach, found = self.approach(i, side, here[1 - side])
                    self.count += 1
                    if reach is None:
                        self.failed.append(f"the approach to node {i + side} is not shown")
                        continue
                    interval[side] = reach
                    steep[i + side, 1 - side] = found
            limit = error["u"] + error["w"]
            self.count += 1
            if not self.on(interval, lambda t: self.least_clearance(i, t) > limit):
                self.failed.append(f"the clearance on piece {i} is not larger than its error")

    def approach(self, i, side, both):
        """The reach of the least error of the flux for which the approach is shown, and that error."""
        piece, error = self.pieces[i], self.error[i]
        edge = self.edges.get((i + side, 1 - side))
        theta = exact(edge["outside"]) if edge else arb(0)
        end, wide = piece.t[side], piece.t[1] - piece.t[0]
        inward = 1 - 2 * side
        far = end + inward * wide * (arb("0.75") if both else arb(1) - arb("1e-9"))
        part, best = arb("0.25") if both else arb("0.5"), (None, None)
        rate = (piece.spring / piece.shear).sqrt()
        near = end + inward * theta / piece.half
        for _ in range(40):
            reach = end + inward * wide * part
            length = abs(far - reach) * piece.half
            slope = rate / (rate * length / 2).tanh() * error["u"]
            limit = slope + error["slope"]
            falls = self.on(sorted_pair(reach, near), lambda t: self.least_growth(i, t, inward) > limit)
            curved = theta == 0 or (
                self.smooth(i + side)
                and self.on(sorted_pair(near, end), lambda t: piece.shear * self.clearance(i, t)[2] > error["p"])
            )
            clear = self.clearance(i, reach)[0] > error["u"] + error["w"]
            if falls and curved and clear and (best[1] is None or slope * piece.shear < best[1]):
                best = (reach, slope * piece.shear)
            elif best[0] is not None:
                break
            part *= arb("0.7")
        return best

    def flux_error(self, first, end, node, side, steep):
        """The error of μu′ on one side of a touching node."""
        j = node - 1 if side == 0 else node
        if first <= j < end:
            if self.pieces[j].touches:
                return self.pieces[j].shear * self.error[j]["slope"]
            return steep.get((node, side), arb("+inf"))
        if node == (0 if side == 0 else len(self.pieces)):
            return self.outside[side] * self.error[0 if side == 0 else -1]["u"]
        return arb(0)

    def region(self, a, b):
        """p > ε_p on the region, (14) at both edges, a ≥ ε_a at the forces inside; a point has a > ε_a."""
        if a == b:
            self.holds(f"the force at the point {a}", self.tolerance[a], self.jump[a])
            return
        for i in range(a, b):
            piece, error = self.pieces[i], self.error[i]["p"]
            self.count += 1
            if not self.on(tuple(piece.t), lambda t: piece.pressure(t) > error):
                self.failed.append(f"the pressure on piece {i} is not larger than its error")
        inside = []
        for node, side in ((a, 0), (b, 1)):
            edge = self.edges.get((node, side))
            theta = exact(edge["inside"]) if edge else arb(0)
            inside.append(theta)
            missing = self.tolerance[node] - self.jump[node]
            i = node if side == 0 else node - 1
            piece = self.pieces[i]
            if missing > 0:
                x = piece.t[side] + (1 - 2 * side) * theta / piece.half
                whole = (piece.pressure - arb_poly([self.error[i]["p"]])).integral()
                pressed = abs(whole(x) - whole(piece.t[side])) * piece.half
                self.holds(f"(14) at node {node}", missing, pressed)
        self.holds(f"the region from node {a} is longer than its bounds", sum(inside), self.x[b] - self.x[a])
        for node in range(a + 1, b):
            if self.smooth(node):
                continue
            left, right = self.pieces[node - 1], self.pieces[node]
            up = right.ends(right.d(right.loads["g0"]))[0] - left.ends(left.d(left.loads["g0"]))[1]
            same = (left.shear - right.shear).contains(0) and self.nodes[node]["hinge"] is None
            if not (same and up >= 0):
                self.holds(f"the force at node {node}", self.tolerance[node], self.jump[node])

    # Section 7.
    def presses(self, i):
        """Whether a bump shows p* > 0 in both halves of an interval of a piece."""
        piece = self.pieces[i]
        for reach in (0.9, 0.5, 0.25, 0.0625) if piece.touches else ():
            least, h = self.least_pressure(i, reach), reach * piece.half
            norm = (8 * piece.spring * h / 15 + 16 * piece.shear / (3 * h)).sqrt()
            if least > 0 and 2 * h / 3 * least > self.s2 * norm:
                return True
        return False

    def uniqueness(self):
        """Each part is held in two places, or in one and against rotation; a held part holds its neighbours."""
        claim = self.one("unique")
        if not claim["shown"]:
            return
        pressed = claim["pressed"]
        parts, held = self.parts_of_beam(), set()
        counts = []
        for part in parts:
            nodes = range(part.start, part.stop + 1)
            places = sum(
                self.nodes[i]["rigid"] is not None or self.nodes[i]["spring"] is not None or pressed[i] for i in nodes
            )
            places += 2 * any(self.presses(i) for i in part)
            turning = any(self.nodes[i]["clamped"] or self.nodes[i]["turning"] is not None for i in nodes)
            counts.append((places, turning))
        self.count += 1
        if self.force > 0 and any(places for places, _ in counts):
            return
        for _ in parts:
            for j, (places, turning) in enumerate(counts):
                places += (j - 1 in held) + (j + 1 in held)
                if places + turning > 1 and places > 0:
                    held.add(j)
        if len(held) < len(parts):
            self.failed.append("the solution is not shown to be unique")


def sorted_pair(a, b):
    return (a, b) if a < b else (b, a)


def below(p, ends):
    """How far a polynomial falls below zero on an interval, at most, and on how much of it."""
    depth = measure = arb(0)
    todo = [(arb(ends[0].lower()), arb(ends[1].upper()))]
    smallest = arb(2) ** -60
    for _ in range(SUBDIVISIONS):
        if not todo:
            return depth, measure
        a, b = todo.pop()
        middle = (a + b) / 2
        here = p(arb(middle.mid(), ((b - a) / 2).upper()))
        if here >= 0:
            continue
        shifted = p(arb_poly([middle.mid(), 1]))
        reach = (b - a) / 2
        tail = sum((abs(shifted[j]) * reach**j for j in range(1, shifted.degree() + 1)), arb(0))
        least = shifted[0] - tail
        if least >= 0:
            continue
        if b - a < smallest or p(middle.mid()) < 0 and tail < -shifted[0] / 4:
            depth = depth.max(-arb(least.lower()))
            measure += b - a
        else:
            todo += [(a, arb(middle.mid())), (arb(middle.mid()), b)]
    raise NotReplayed("the sign of a polynomial is not decided")


def results(lines):
    """The lines of each result of a log."""
    found = []
    for line in lines:
        if line.get("name") == "result":
            found.append((line.get("combination"), []))
        elif found:
            found[-1][1].append(line)
    return found


def main(path):
    with open(path, encoding="utf-8") as file:
        found = results(json.loads(line) for line in file)
    status = 0 if found else 2
    for combination, lines in found:
        name = f"{combination}: " if combination else ""
        try:
            replay = Replay(lines)
            replay.run()
        except NotReplayed as reason:
            print(f"{name}not replayed: {reason}")
            status = 2
            continue
        for failed in replay.failed:
            print(f"{name}{failed}")
        for part, size in replay.parts.items():
            print(f"{name}{part}/2 is at most {size.str(3, radius=False)}")
        if replay.failed:
            status = 1
            print(f"{name}{len(replay.failed)} of {replay.count} inequalities do not hold")
        else:
            print(f"{name}{replay.count} inequalities hold")
    return status


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
