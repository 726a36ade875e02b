"""Estimates the contact set with finite elements and an interior-point method.

    minimise  1/2 z'H z - f'z   subject to   s = u + g0 - w >= 0  at the nodes

with z = (w, w', u) at the nodes, cubic Hermite elements for the beam and, for the ground, the
exact elements sqrt(k mu) [[coth bh, -csch bh], [-csch bh, coth bh]] (lumped springs where mu = 0).
A primal-dual interior-point method (Mehrotra's predictor and corrector) cannot cycle. 200-bit numbers compensate
for the 1/h^4 conditioning of Hermite elements. The reference values do not depend on this solution: it only gives
the contact nodes, and later a check of the sign conventions.
"""

import gmpy2
from gmpy2 import mpfr

from .model import initial_gap, linear_load, point_actions, support_at

BITS = 200
HALF_BAND = 5  # three unknowns a node, neighbours only

GAUSS = [  # four points on [0, 1]; exact for a linear load on a cubic shape function
    (0.0694318442029737124, 0.1739274225687269287),
    (0.3300094782075718676, 0.3260725774312730713),
    (0.6699905217924281324, 0.3260725774312730713),
    (0.9305681557970262876, 0.1739274225687269287),
]


class CoarseSolution:
    """Solution on a mesh: nodes x, deflection w, slope, settlement u, nodal contact force, and contact flags."""

    def __init__(self, x, w, slope, u, force, touching):
        self.x, self.w, self.slope, self.u = x, w, slope, u
        self.force, self.touching = force, touching


def graded_mesh(model, elements, finest=1e-4):
    """Creates a mesh of all breakpoints, equidistant nodes, and further nodes whose distances from the nearest
    breakpoint form a geometric progression."""
    l = model.length
    fixed = model.breakpoints()
    points = set(fixed)
    points.update(l * i / elements for i in range(1, elements))
    for x in fixed:
        d = l / elements / 2
        smallest = 1e-8 * l if x in (0.0, l) else finest * l
        while d > smallest:
            points.update(y for y in (x - d, x + d) if 0 < y < l)
            d /= 3
    return thinned(sorted(points), fixed, l)


def thinned(points, fixed, l):
    """Removes nodes that are too close to the previous node, except breakpoints."""
    keep = set(fixed)
    out = []
    for x in points:
        if x in keep:
            while out and out[-1] not in keep and x - out[-1] < 1e-9 * l:
                out.pop()
            out.append(x)
        elif not out or x - out[-1] > 1e-9 * l:
            out.append(x)
    return out


def refined(x, touching, fixed, l, parts=6):
    """Refines the mesh where contact begins or ends."""
    points = set(x)
    for i in range(len(x) - 1):
        if touching[i] != touching[i + 1]:
            for j in (i - 1, i, i + 1):
                if 0 <= j < len(x) - 1:
                    h = x[j + 1] - x[j]
                    points.update(x[j] + h * m / parts for m in range(1, parts))
    return thinned(sorted(points), fixed, l)


def solve_on_mesh(model, x):
    with gmpy2.local_context(gmpy2.get_context(), precision=BITS):
        return _solve(model, x)


def _assemble(model, x):
    """Assembles the banded matrix H (rows of the lower triangle), the load vector f and the initial gap g0 at the nodes.
    Also returns the unknowns that supports fix."""
    n = len(x)
    H = [[mpfr(0)] * (HALF_BAND + 1) for _ in range(3 * n)]  # H[i][d] = H(i, i - d)
    f = [mpfr(0)] * (3 * n)
    g0 = [mpfr(0)] * n

    def add(i, j, v):
        if i < j:
            i, j = j, i
        H[i][i - j] += v

    for e in range(n - 1):
        a, b = mpfr(x[e]), mpfr(x[e + 1])
        h = b - a
        middle = (x[e] + x[e + 1]) / 2
        EI, P = mpfr(model.EI_at(middle)), mpfr(model.P)
        k, mu = (mpfr(v) for v in model.ground_at(middle))
        dof = [3 * e, 3 * e + 1, 3 * e + 3, 3 * e + 4]
        bend = [
            [12, 6 * h, -12, 6 * h],
            [6 * h, 4 * h * h, -6 * h, 2 * h * h],
            [-12, -6 * h, 12, -6 * h],
            [6 * h, 2 * h * h, -6 * h, 4 * h * h],
        ]
        pull = [
            [36, 3 * h, -36, 3 * h],
            [3 * h, 4 * h * h, -3 * h, -h * h],
            [-36, -3 * h, 36, -3 * h],
            [3 * h, -h * h, -3 * h, 4 * h * h],
        ]
        for i in range(4):
            for j in range(i + 1):
                add(dof[i], dof[j], EI / h**3 * bend[i][j] + P / (30 * h) * pull[i][j])
        u = [3 * e + 2, 3 * e + 5]
        if mu > 0:
            c, bh = gmpy2.sqrt(k * mu), gmpy2.sqrt(k / mu) * h
            add(u[0], u[0], c * gmpy2.coth(bh))
            add(u[1], u[1], c * gmpy2.coth(bh))
            add(u[1], u[0], -c * gmpy2.csch(bh))
        else:
            add(u[0], u[0], k * h / 2)
            add(u[1], u[1], k * h / 2)
        f_a, f_s = linear_load(model, "distributed", a, b, mpfr)
        m_a, m_s = linear_load(model, "distributed_moment", a, b, mpfr)
        if f_a or f_s or m_a or m_s:
            for s, weight in GAUSS:
                shape = [
                    1 - 3 * s**2 + 2 * s**3,
                    h * (s - 2 * s**2 + s**3),
                    3 * s**2 - 2 * s**3,
                    h * (s**3 - s**2),
                ]
                slope = [
                    (6 * s**2 - 6 * s) / h,
                    1 - 4 * s + 3 * s**2,
                    (6 * s - 6 * s**2) / h,
                    3 * s**2 - 2 * s,
                ]
                t = s * h
                for i in range(4):
                    f[dof[i]] += weight * h * (f_a + f_s * t) * shape[i]
                    f[dof[i]] += weight * h * (m_a + m_s * t) * slope[i]
        g_a, g_s = initial_gap(model, a, b, mpfr)
        g0[e], g0[e + 1] = g_a, g_a + g_s * h

    for i, side in ((0, (x[0] + x[1]) / 2), (n - 1, (x[-2] + x[-1]) / 2)):
        k, mu = (mpfr(v) for v in model.ground_at(side))
        add(3 * i + 2, 3 * i + 2, gmpy2.sqrt(k * mu))  # the ground outside
    for i in range(n):
        forces, moments = point_actions(model, x[i])
        f[3 * i] += sum(forces)
        f[3 * i + 1] += sum(moments)
        s = support_at(model, x[i])
        if s:
            add(3 * i, 3 * i, mpfr(s.spring))
            add(3 * i + 1, 3 * i + 1, mpfr(s.rotational))
    held = []
    for i in range(n):
        s = support_at(model, x[i])
        if s and s.kind != "spring":
            held += [3 * i] + ([3 * i + 1] if s.kind == "fixed" else [])
    for i in held:
        for d in range(1, HALF_BAND + 1):
            if i - d >= 0:
                H[i][d] = mpfr(0)
            if i + d < 3 * n:
                H[i + d][d] = mpfr(0)
        f[i] = mpfr(0)
    return H, f, g0, set(held)


def _cholesky(H):
    """Computes the Cholesky factor L with L L' = H. L is stored like H, but with 1/L(i, i) in place of its diagonal
    entries L(i, i)."""
    n, b = len(H), HALF_BAND
    L = [row[:] for row in H]
    for i in range(n):
        Li = L[i]
        for j in range(max(0, i - b), i):
            Lj = L[j]
            v = Li[i - j]
            for m in range(max(0, i - b), j):
                v -= Li[i - m] * Lj[j - m]
            Li[i - j] = v * Lj[0]
        d = Li[0]
        for m in range(max(0, i - b), i):
            d -= Li[i - m] * Li[i - m]
        if not d > 0:
            raise ArithmeticError("the stiffness matrix of the mesh is not positive definite")
        Li[0] = 1 / gmpy2.sqrt(d)
    return L


def _substitute(L, r):
    n, b = len(L), HALF_BAND
    y = r[:]
    for i in range(n):
        Li, v = L[i], y[i]
        for j in range(max(0, i - b), i):
            v -= Li[i - j] * y[j]
        y[i] = v * Li[0]
    for i in range(n - 1, -1, -1):
        v = y[i] * L[i][0]
        y[i] = v
        Li = L[i]
        for j in range(max(0, i - b), i):
            y[j] -= Li[i - j] * v
    return y


def _times(H, z):
    n, b = len(H), HALF_BAND
    y = [H[i][0] * z[i] for i in range(n)]
    for i in range(n):
        Hi = H[i]
        for j in range(max(0, i - b), i):
            y[i] += Hi[i - j] * z[j]
            y[j] += Hi[i - j] * z[i]
    return y


def _solve(model, x):
    n = len(x)
    H, f, g0, held = _assemble(model, x)
    rows = [i for i in range(n)]

    def gap_of(z):
        return [z[3 * i + 2] - z[3 * i] + g0[i] for i in rows]

    # The scales of the forces and of the deflections define the starting point of the iteration.
    force = max(max(abs(v) for v in f), mpfr("1e-50"))
    k = mpfr(max([model.k] + [s[2] for s in model.ground_segments]))
    depth = max(force / (k * model.length), max(abs(v) for v in g0))
    z = [mpfr(0)] * (3 * n)
    s, p = [depth] * n, [force / n] * n
    target = mpfr("1e-34") * depth * force / n

    for iteration in range(150):
        average = sum(si * pi for si, pi in zip(s, p)) / n
        rd = [b - a for a, b in zip(_times(H, z), f)]  # f - Hz + C'p
        for i in rows:
            rd[3 * i + 2] += p[i]
            if 3 * i not in held:
                rd[3 * i] -= p[i]
        for i in held:
            rd[i] = mpfr(0)
        rp = [g - si for g, si in zip(gap_of(z), s)]  # Cz + g0 - s
        if average < target and max(map(abs, rp)) < depth * mpfr("1e-25"):
            break
        K = [row[:] for row in H]
        for i in rows:
            d = p[i] / s[i]
            K[3 * i + 2][0] += d
            if 3 * i not in held:
                K[3 * i][0] += d
                K[3 * i + 2][2] -= d
        L = _cholesky(K)

        def step(rc):
            """Computes the Newton step. rc is the residual of the complementarity condition of gap s and force p."""
            r = rd[:]
            for i in rows:
                v = rc[i] / s[i] - p[i] / s[i] * rp[i]
                r[3 * i + 2] += v
                if 3 * i not in held:
                    r[3 * i] -= v
            dz = _substitute(L, r)
            ds = [dz[3 * i + 2] - (0 if 3 * i in held else dz[3 * i]) + rp[i] for i in rows]
            dp = [(rc[i] - p[i] * ds[i]) / s[i] for i in rows]
            return dz, ds, dp

        def longest(v, dv):
            ratios = [-vi / di for vi, di in zip(v, dv) if di < 0]
            return min(ratios) if ratios else mpfr(1e9)

        dz, ds, dp = step([-si * pi for si, pi in zip(s, p)])
        alpha = min(mpfr(1), longest(s, ds), longest(p, dp))
        after = sum((s[i] + alpha * ds[i]) * (p[i] + alpha * dp[i]) for i in rows) / n
        sigma = (after / average) ** 3
        rc = [sigma * average - s[i] * p[i] - ds[i] * dp[i] for i in rows]
        dz, ds, dp = step(rc)
        alpha = min(mpfr(1), mpfr("0.995") * min(longest(s, ds), longest(p, dp)))
        z = [a + alpha * b for a, b in zip(z, dz)]
        s = [a + alpha * b for a, b in zip(s, ds)]
        p = [a + alpha * b for a, b in zip(p, dp)]
    else:
        raise ArithmeticError("the interior-point method did not converge")

    p_scale, s_scale = max(p), max(s)
    touching = [p[i] * s_scale > s[i] * p_scale for i in rows]
    if p_scale < force * mpfr("1e-30"):
        touching = [False] * n
    parts = ([z[3 * i + j] for i in rows] for j in range(3))
    w, slope, u = parts
    return CoarseSolution(list(x), w, slope, u, p, touching)
