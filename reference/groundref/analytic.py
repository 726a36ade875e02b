"""Solves a linear system for the coefficients of all stretches, and finds the edges by Newton's method.

For assumed contact intervals (`Topology`), every unknown except the edge positions c enters linearly, A(c) y =
b(c). At each free edge one more condition remains, t(y, c) = 0:

    u'(c) = w'(c) - g0'(c)  seen from the open side (mu > 0),   or   w(c) = g0(c)  (mu = 0).

Newton's method runs on t(y(c), c) with the exact derivative dy/dc_j = -A^-1 dr/dc_j, where dr/dc_j
shifts the derivative order of the conditions at edge j by one.
"""

from dataclasses import dataclass, field

from mpmath import mp, mpf

from .model import initial_gap, linear_load, point_actions, support_at
from .pieces import Piece


class Rejected(Exception):
    """Error: the assumed contact set is wrong. The message gives the reason."""


class Vanished(Rejected):
    """Error: a contact interval vanished. `topology` is the contact set without this interval."""

    def __init__(self, topology):
        super().__init__("a contact interval vanished")
        self.topology = topology


@dataclass
class Edge:
    """A contact edge: one end of a contact interval. A fixed edge stays at a breakpoint of the model."""

    x: mpf
    free: bool


@dataclass
class Topology:
    intervals: list = field(default_factory=list)  # [left Edge, right Edge], in order
    points: list = field(default_factory=list)  # breakpoints with point contact

    def copy(self):
        pairs = [[Edge(e.x, e.free) for e in pair] for pair in self.intervals]
        return Topology(pairs, list(self.points))

    def free_edges(self):
        return [e for pair in self.intervals for e in pair if e.free]

    def touches(self, x):
        return any(a.x < x < b.x for a, b in self.intervals)


class Node:
    """A node between two stretches, or an end of the beam."""

    def __init__(self, model, x, left, right, edge, point_contact):
        self.x, self.left, self.right, self.edge = x, left, right, edge
        forces, moments = ([], []) if edge else point_actions(model, x)
        self.force, self.moment = mp.fsum(map(mpf, forces)), mp.fsum(map(mpf, moments))
        self.support = None if edge else support_at(model, x)
        self.hinge = next((spring for at, spring in model.hinges if at == x), None)
        sides = [p for p in (left, right) if p]
        self.layers = [p for p in sides if p.mu > 0]
        # True if the shear layer touches the beam at this node.
        self.touching = any(p.contact for p in self.layers) or (
            point_contact and bool(self.layers)
        )

    @property
    def outer(self):
        """Stiffness sqrt(k mu) of the ground outside the end of the beam."""
        piece = self.right if self.left is None else self.left
        return mp.sqrt(piece.k * piece.mu)

    @property
    def is_end(self):
        return self.left is None or self.right is None

    def equations(self):
        """Equations at this node: each is a list of (piece, field, factor) and a constant,
        with sum of factor * field + constant = 0. Factors on the left side change their sign."""
        L, R, rows = self.left, self.right, []
        some = R or L

        def jump(name):
            return ([(R, name, 1)] if R else []) + ([(L, name, -1)] if L else [])

        s = self.support
        held = s is not None and s.kind in ("pinned", "fixed")
        clamped = s is not None and s.kind == "fixed"
        if not self.is_end:
            rows.append((jump("w"), 0))
            if self.hinge is None:
                rows.append((jump("slope"), 0))
            else:  # M + rotational spring * [w'] = 0
                turned = [(p, "slope", f * mpf(self.hinge)) for p, _, f in jump("slope")]
                rows.append(([(some, "moment", 1)] + turned, 0))
        if clamped:
            rows.append(([(some, "slope", 1)], 0))
        else:  # [M] = M0 - rotational spring * w'
            row = jump("moment")
            if s is not None and s.rotational:
                row.append((some, "slope", mpf(s.rotational)))
            rows.append((row, -self.moment))
        if held:
            rows.append(([(some, "w", 1)], 0))
        else:  # [T] = atom - F + spring * w, atom = -[mu u']
            row = jump("axial shear")
            if s is not None and s.spring:
                row.append((some, "w", -mpf(s.spring)))
            if self.touching:
                row += self.flux_jump()
            rows.append((row, self.force))
        open_layers = [p for p in self.layers if not p.contact]
        if self.touching:
            for p in open_layers:
                rows.append(([(p, "u", 1), (p, "w", -1), (p, "gap", 1)], 0))
        elif len(self.layers) == 2:
            rows.append(([(R, "u", 1), (L, "u", -1)], 0))
            rows.append(([(R, "flux", 1), (L, "flux", -1)], 0))
        elif self.layers:
            rows.append((self.flux_jump(), 0))
        return rows

    def flux_jump(self):
        """Jump [mu u'] of the flux, including the ground outside the ends of the beam. The flux is zero where mu = 0."""
        row = []
        if self.right and self.right.mu > 0:
            row.append((self.right, "flux", 1))
        if self.left and self.left.mu > 0:
            row.append((self.left, "flux", -1))
        if self.left is None and self.layers:  # u = u(0) exp(+b x) on the left
            row.append((self.right, "u", -self.outer))
        if self.right is None and self.layers:
            row.append((self.left, "u", -self.outer))
        return row

    def tangency(self):
        """The condition that determines the position of a free edge."""
        shut, opened = (self.left, self.right) if self.left.contact else (self.right, self.left)
        if opened.mu > 0:
            return ([(opened, "u slope", 1), (opened, "slope", -1), (opened, "gap slope", 1)], 0)
        return ([(opened, "w", 1), (opened, "gap", -1)], 0)

    def atom(self):
        """Point contact force on the beam at this node."""
        if not self.touching:
            return mpf(0)
        return -evaluate((self.flux_jump(), 0), self.x)

    def reaction(self):
        """Upward force and moment of the support on the beam."""
        T, M = self.jump_value("axial shear"), self.jump_value("moment")
        return T - self.atom() + self.force, self.moment - M

    def jump_value(self, name):
        total = self.right.value(name, self.x) if self.right else mpf(0)
        return total - (self.left.value(name, self.x) if self.left else mpf(0))


def evaluate(equation, x, shift=0):
    """Evaluates the left side of a boundary, joint or edge condition at the position x, with the current solution on
    each stretch."""
    terms, constant = equation
    total = mpf(constant) if shift == 0 else mpf(0)
    for piece, name, factor in terms:
        if name in ("gap", "gap slope"):
            total += factor * piece.form(name, x, shift)[1]
        else:
            total += factor * piece.value(name, x, shift)
    return total


class System:
    """Nodes and stretches of a model with given contact intervals, and the linear equations for the coefficients of the
    solution on the stretches."""

    def __init__(self, model, topology):
        self.model, self.topology = model, topology
        edges = {}
        for pair in topology.intervals:
            for e in pair:
                if e.free:
                    if e.x in edges:
                        raise Rejected("two edges at one position")
                    edges[e.x] = e
        xs = sorted(set(mpf(x) for x in model.breakpoints()) | set(edges))
        self.pieces = [self.make_piece(a, b) for a, b in zip(xs, xs[1:])]
        around = [None] + self.pieces + [None]
        points = set(mpf(x) for x in topology.points)
        self.nodes = [
            Node(model, x, around[i], around[i + 1], edges.get(x), x in points)
            for i, x in enumerate(xs)
        ]
        self.offset, n = {}, 0
        for p in self.pieces:
            self.offset[id(p)] = n
            n += p.size
        self.n = n

    def make_piece(self, a, b):
        middle = (a + b) / 2
        k, mu = self.model.ground_at(middle)
        return Piece(
            a, b, mpf(self.model.EI_at(middle)), mpf(self.model.P), mpf(k), mpf(mu),
            linear_load(self.model, "distributed", a, b, mpf),
            linear_load(self.model, "distributed_moment", a, b, mpf),
            initial_gap(self.model, a, b, mpf),
            self.topology.touches(middle),
        )  # fmt: skip

    def row(self, equation, x):
        """Returns the left side of an equation as {unknown: factor}, and its right side."""
        terms, constant = equation
        columns, total = {}, mpf(constant)
        for piece, name, factor in terms:
            coefficients, value = piece.form(name, x)
            total += factor * value
            if name in ("gap", "gap slope"):
                continue
            base = self.offset[id(piece)]
            for i, v in enumerate(coefficients):
                if v:
                    columns[base + i] = columns.get(base + i, 0) + factor * v
        return columns, -total

    def solve(self):
        """Solves for the coefficients with the current edges c. Returns the residuals t of the conditions at the free
        edges, and their derivatives dt/dc."""
        rows, right, of_edge = [], [], []
        free = [n for n in self.nodes if n.edge]
        for node in self.nodes:
            for equation in node.equations():
                columns, value = self.row(equation, node.x)
                rows.append(columns)
                right.append([value])
                of_edge.append((free.index(node), equation, node.x) if node.edge else None)
        if len(rows) != self.n:
            raise AssertionError("the number of equations differs from the number of unknowns")
        factors = Elimination(rows, self.n)
        y = factors.solve([r[0] for r in right])
        self.use(y)
        if not free:
            return [], None
        m = len(free)
        dy = []
        for j in range(m):
            r = [
                -evaluate(e[1], e[2], 1) if e is not None and e[0] == j else mpf(0)
                for e in of_edge
            ]
            dy.append(factors.solve(r))
        t, J = [], mp.matrix(m, m)
        for i, node in enumerate(free):
            equation = node.tangency()
            t.append(evaluate(equation, node.x))
            columns, _ = self.row(equation, node.x)
            for j in range(m):
                J[i, j] = mp.fsum(v * dy[j][c] for c, v in columns.items())
            J[i, i] += evaluate(equation, node.x, 1)
        return t, J

    def use(self, y):
        for p in self.pieces:
            base = self.offset[id(p)]
            p.solve_with(y[base : base + p.size])


class Elimination:
    """Sparse Gaussian elimination with scaled row pivoting; the system is nearly banded."""

    def __init__(self, rows, n):
        self.n = n
        self.scale = [1 / max(abs(v) for v in r.values()) for r in rows]
        work = [{c: v * s for c, v in r.items()} for r, s in zip(rows, self.scale)]
        alive = set(range(n))
        by_column = [set() for _ in range(n)]
        for i, r in enumerate(work):
            for c in r:
                by_column[c].add(i)
        self.steps = []
        for c in range(n):
            candidates = [i for i in by_column[c] if i in alive]
            if not candidates:
                raise Rejected("singular system")
            pivot = max(candidates, key=lambda i: (abs(work[i][c]), -i))
            head = work[pivot]
            if head[c] == 0:
                raise Rejected("singular system")
            alive.discard(pivot)
            below = []
            for i in sorted(candidates):
                if i == pivot:
                    continue
                factor = work[i].pop(c) / head[c]
                if factor == 0:
                    continue
                below.append((i, factor))
                target = work[i]
                for col, v in head.items():
                    if col != c:
                        if col in target:
                            target[col] -= factor * v
                        else:
                            target[col] = -factor * v
                            by_column[col].add(i)
            self.steps.append((c, pivot, head, below))

    def solve(self, right):
        r = [v * s for v, s in zip(right, self.scale)]
        for c, pivot, head, below in self.steps:
            v = r[pivot]
            if v:
                for i, factor in below:
                    r[i] -= factor * v
        y = [mpf(0)] * self.n
        for c, pivot, head, _ in reversed(self.steps):
            total = r[pivot]
            for col, v in head.items():
                if col != c:
                    total -= v * y[col]
            y[c] = total / head[c]
        return y


def newton(model, topology, tolerance_digits, limit=60):
    """Moves the free edges until the tangency conditions hold. Returns the solved System.

    No step may move an edge past its neighbours or off the beam; such a step is shortened.
    """
    l = mpf(model.length)
    topology = topology.copy()
    target = l * mpf(10) ** (-tolerance_digits)
    last = None
    for iteration in range(limit):
        system = System(model, topology)
        t, J = system.solve()
        if not t:
            return system
        step = mp.lu_solve(J, -mp.matrix(t))
        free = topology.free_edges()
        ends = [e for pair in topology.intervals for e in pair]
        factor = mpf(1)
        for edge, d in zip(free, step):
            available_left, available_right = edge.x, l - edge.x
            for other in ends:
                if other is not edge:
                    # Two free edges may each move by less than half the distance between them.
                    share = mpf("0.4") if other.free else mpf("0.9")
                    if other.x < edge.x:
                        available_left = min(available_left, share * (edge.x - other.x))
                    else:
                        available_right = min(available_right, share * (other.x - edge.x))
            available = available_right if d > 0 else available_left
            if abs(d) > available:
                factor = min(factor, mpf("0.9") * available / abs(d))
        for edge, d in zip(free, step):
            edge.x += factor * d
            if edge.x <= 0 or edge.x >= l:
                raise Rejected("an edge left the beam")
        size = max(abs(d) for d in step)
        if factor == 1 and size < target:
            final = System(model, topology)
            final.solve()
            final.edge_step = size
            final.iterations = iteration + 1
            return final
        lasting = [p for p in topology.intervals if p[1].x - p[0].x > l * mpf("1e-10")]
        if len(lasting) < len(topology.intervals):
            raise Vanished(Topology(lasting, list(topology.points)))
        last = size
    raise Rejected(f"Newton's method did not converge; its last step is {mp.nstr(last, 5)}")
