"""Closed-form solutions on one stretch with constant EI, k, mu and contact, and polynomial loads.

    in contact    EI w'''' - (P + mu) w'' + k w = q + k g0,   u = w - g0,   p = k u - mu u''
    off contact   EI w'''' - P w'' = q,                       mu u'' = k u  (u = 0 where mu = 0)

with q = f - g', the net transverse load. Each w is a polynomial particular solution plus four basis functions;
each u outside the contact has two. For a stretch that is short relative to its wave length, the basis is the
Taylor series of the Cauchy functions (only the j-th derivative of phi_j at a is nonzero), so that short stretches
are as well conditioned as long ones. For a long stretch, the basis consists of exponentials that decay away from
one of its ends.
"""

from dataclasses import dataclass

from mpmath import mp, mpf

ORDERS = 6  # derivatives 0 .. 5 of everything


class Series:
    """Power series sum c_m t^m / m! with t = x - anchor. The Cauchy function j is scaled by h^-j, so that its terms are
    of order one."""

    def __init__(self, anchor, coefficients):
        self.anchor, self.c = anchor, coefficients

    def derivatives(self, x):
        t = x - self.anchor
        out = []
        for order in range(ORDERS):
            total = mpf(0)
            for m in range(len(self.c) - 1 - order, -1, -1):
                total = total * t / (m + 1) + self.c[m + order]
            out.append(total)
        return out


class Wave:
    """Real or imaginary part of the function t^n exp(z t) with t = x - anchor and n = 0 or 1."""

    def __init__(self, anchor, z, n=0, imaginary=False):
        self.anchor, self.z, self.n, self.imaginary = anchor, mp.mpc(z), n, imaginary

    def derivatives(self, x):
        t, z = x - self.anchor, self.z
        power, before, e = mp.mpc(1), mp.mpc(0), mp.exp(z * t)
        out = []
        for order in range(ORDERS):
            factor = power if self.n == 0 else t * power + order * before
            value = factor * e
            out.append(value.imag if self.imaginary else value.real)
            before, power = power, power * z
        return out


def cauchy_series(a, h, order, recurrence):
    """Returns `order` independent solutions of a linear differential equation as Taylor series about a.

    The derivatives c_m of a solution at a satisfy c_{m+order} = recurrence(c, m).
    """
    functions = []
    for j in range(order):
        c = [mpf(0)] * order
        c[j] = h ** (-j)
        m, small = 0, 0
        while small < order + ORDERS:  # until a whole window of terms is negligible
            c.append(recurrence(c, m))
            m += 1
            term = abs(c[-1]) * h ** (len(c) - 1) / mp.factorial(len(c) - 1)
            small = small + 1 if term < mp.eps / 1000 else 0
        functions.append(Series(a, c))
    return functions


def decaying_pair(a, b, z):
    """Returns exp(-z (x - a)) and exp(z (x - b)), or their real and imaginary parts if z is complex. Re z > 0."""
    out = [Wave(a, -z), Wave(b, z)]
    if mp.im(z) != 0:
        out += [Wave(a, -z, imaginary=True), Wave(b, z, imaginary=True)]
    return out


def oscillating_pair(a, omega, n=0):
    z = mp.mpc(0, omega)
    return [Wave(a, z, n), Wave(a, z, n, imaginary=True)]


def beam_basis(a, b, EI, S, k):
    """Returns four independent solutions of EI w'''' - S w'' + k w = 0 on [a, b]."""
    h = b - a
    fastest = mp.sqrt((abs(S) + mp.sqrt(S * S + 4 * EI * k)) / (2 * EI))
    if fastest * h < 1:
        return cauchy_series(a, h, 4, lambda c, m: (S * c[m + 2] - k * c[m]) / EI)
    if k == 0:
        s = mp.sqrt(abs(S) / EI)
        line = [Series(a, [mpf(1)]), Series(a, [mpf(0), 1 / h])]
        return line + (decaying_pair(a, b, s) if S > 0 else oscillating_pair(a, s))
    D = S * S - 4 * EI * k
    if D < 0:
        return decaying_pair(a, b, mp.sqrt(mp.mpc(S, mp.sqrt(-D)) / (2 * EI)))
    if D > 0:
        r1 = mp.sqrt((abs(S) + mp.sqrt(D)) / (2 * EI))
        r2 = mp.sqrt(2 * k / (abs(S) + mp.sqrt(D)))
        if S > 0:
            return decaying_pair(a, b, r1) + decaying_pair(a, b, r2)
        return oscillating_pair(a, r1) + oscillating_pair(a, r2)
    r = mp.sqrt(abs(S) / (2 * EI))
    if S > 0:
        return decaying_pair(a, b, r) + [Wave(a, -r, 1), Wave(b, r, 1)]
    return oscillating_pair(a, r) + oscillating_pair(a, r, 1)


def layer_basis(a, b, k, mu):
    """Returns two independent solutions of mu u'' = k u on [a, b]."""
    beta, h = mp.sqrt(k / mu), b - a
    if beta * h < 1:
        return cauchy_series(a, h, 2, lambda c, m: k / mu * c[m])
    return decaying_pair(a, b, beta)


@dataclass
class Piece:
    """Solution on one stretch. Its loads and its gap are linear, stored as (value at a, slope). `contact` states whether
    the beam touches the ground on this stretch."""

    a: mpf
    b: mpf
    EI: mpf
    P: mpf
    k: mpf
    mu: mpf
    force: tuple
    moment: tuple
    gap: tuple
    contact: bool

    def __post_init__(self):
        q0, q1 = self.force[0] - self.moment[1], self.force[1]
        zero = mpf(0)
        self.layer = []
        if self.contact:
            self.beam = beam_basis(self.a, self.b, self.EI, self.P + self.mu, self.k)
            line = [q0 / self.k + self.gap[0], q1 / self.k + self.gap[1]]
            self.particular = Series(self.a, line)
        else:
            self.beam = beam_basis(self.a, self.b, self.EI, self.P, zero)
            h = self.b - self.a
            fast = mp.sqrt(abs(self.P) / self.EI) * h >= 1
            if self.P != 0 and fast:
                self.particular = Series(self.a, [zero, zero, -q0 / self.P, -q1 / self.P])
            else:  # EI w'''' = P w'' + q, from zero values at a
                c = [zero] * 4
                m, small = 0, 0
                while small < 12:
                    load = q0 if m == 0 else q1 if m == 1 else zero
                    c.append((self.P * c[m + 2] + load) / self.EI)
                    m += 1
                    size = abs(c[-1]) * h ** (m + 3) / mp.factorial(m + 3)
                    first = (abs(q0) + abs(q1) * h) / self.EI * h**4
                    small = small + 1 if size <= first * mp.eps / 1000 else 0
                self.particular = Series(self.a, c)
            if self.mu > 0:
                self.layer = layer_basis(self.a, self.b, self.k, self.mu)
        self.size = len(self.beam) + len(self.layer)
        self.seen = {}

    def at(self, x):
        """Derivatives at x of each beam function, of the particular solution, and of each layer function."""
        if x not in self.seen:
            beam = [f.derivatives(x) for f in self.beam]
            layer = [f.derivatives(x) for f in self.layer]
            self.seen[x] = beam, self.particular.derivatives(x), layer
        return self.seen[x]

    # ---- linear forms in the unknown coefficients: (factors of the coefficients, constant) ----
    def w(self, x, order):
        beam, particular, _ = self.at(x)
        return [f[order] for f in beam] + [mpf(0)] * len(self.layer), particular[order]

    def u(self, x, order):
        """Settlement of the shear layer; in contact, the deflection minus the initial gap."""
        if self.contact:
            row, constant = self.w(x, order)
            return row, constant - self.gap_at(x, order)
        _, _, layer = self.at(x)
        return [mpf(0)] * len(self.beam) + [f[order] for f in layer], mpf(0)

    def gap_at(self, x, order=0):
        if order == 0:
            return self.gap[0] + self.gap[1] * (x - self.a)
        return self.gap[1] if order == 1 else mpf(0)

    def form(self, name, x, shift=0):
        """A field at x as a linear form in the coefficients. With shift = 1, it is the derivative of the field along x."""
        scaled = lambda row, factor: ([factor * v for v in row[0]], factor * row[1])
        if name == "w":
            return self.w(x, shift)
        if name == "slope":
            return self.w(x, 1 + shift)
        if name == "moment":
            return scaled(self.w(x, 2 + shift), -self.EI)
        if name == "axial shear":  # T = M' + P w' - g; T' = p - f
            bend, pull = self.w(x, 3 + shift), self.w(x, 1 + shift)
            g = self.moment[0] + self.moment[1] * (x - self.a) if shift == 0 else self.moment[1]
            row = [-self.EI * v + self.P * t for v, t in zip(bend[0], pull[0])]
            return row, -self.EI * bend[1] + self.P * pull[1] - g
        if name == "u":
            return self.u(x, shift)
        if name == "u slope":
            return self.u(x, 1 + shift)
        if name == "flux":  # mu u'
            return scaled(self.u(x, 1 + shift), self.mu)
        if name == "gap":
            return mpf(0), self.gap_at(x, shift)
        if name == "gap slope":
            return mpf(0), self.gap_at(x, 1 + shift)
        raise KeyError(name)

    # ---- values once the coefficients are known ----------------------------------------------
    def solve_with(self, coefficients):
        self.coefficients = coefficients

    def value(self, name, x, shift=0):
        row, constant = self.form(name, x, shift)
        return constant + mp.fdot(zip(row, self.coefficients))

    def fields(self, x):
        """Values of all result fields at x, as limits from inside this stretch."""
        d = [self.value("w", x, order) for order in range(5)]
        out = {"deflection": d[0], "slope": d[1]}
        out["moment"], out["shear_force"] = -self.EI * d[2], -self.EI * d[3]
        if self.contact:
            out["settlement"] = d[0] - self.gap_at(x)
            out["gap"] = mpf(0)
            out["pressure"] = self.k * out["settlement"] - self.mu * d[2]
        else:
            out["settlement"] = self.value("u", x) if self.layer else mpf(0)
            out["gap"] = out["settlement"] + self.gap_at(x) - d[0]
            out["pressure"] = mpf(0)
        return out

    def fastest(self):
        """The largest wave number in this stretch, for sampling and quadrature."""
        S = self.P + (self.mu if self.contact else 0)
        k = self.k if self.contact else mpf(0)
        r = mp.sqrt((abs(S) + mp.sqrt(S * S + 4 * self.EI * k)) / (2 * self.EI))
        return max(r, mp.sqrt(self.k / self.mu)) if self.layer else r
