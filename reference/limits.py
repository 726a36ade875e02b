"""Models with closed-form solutions: (name, model, note, checks).

A check is (what, value, field, place, tolerance): `field` names a column of the stations, read at
`place`, or is "from" / "to" / "left" / "right" for the first contact region and the end forces.
The tolerance is relative. If it is not tiny, the closed form is a limit (a rigid beam).
"""

from mpmath import mp, mpf

from groundref.model import Load, Model, Support

TIGHT = 1e-25
RIGID = 1e12


def weightless_winkler():
    """C01 to C03: a long weightless beam under one force on tensionless springs. Outside the
    contact it is straight, so its length does not matter."""
    EI, k, F, middle = 1.0, 4.0, 1.0, 5.0
    model = Model(10.0, EI, k, loads=[Load("point", F, middle)])
    half, beta = mp.pi / 2, mpf(1)
    checks = [
        ("contact from 5 - pi/2", middle - half, "from", None, TIGHT),
        ("contact to 5 + pi/2", middle + half, "to", None, TIGHT),
        ("w under the force, (F b/2k) coth(pi/2)", beta / 8 * mp.coth(half), "deflection", 5.0, TIGHT),
        ("M under the force, (F/4b) coth(pi/2)", mp.coth(half) / 4, "moment", 5.0, TIGHT),
        ("slope off contact, (F b^2/k)/sinh(pi/2)", 1 / (4 * mp.sinh(half)), "slope", 0.0, TIGHT),
    ]
    return "weightless-winkler", model, "long weightless beam, tensionless Winkler", checks


def weightless_pasternak(mu):
    """C04, C05: the same beam on Pasternak ground; g = mu / (2 sqrt(k EI))."""
    EI, k = 1.0, 4.0
    model = Model(10.0, EI, k, mu, loads=[Load("point", 1.0, 5.0)])
    g = mpf(mu) / 4
    if g < 1:
        X = mp.acos(mp.sqrt(g)) / mp.sqrt(1 - g)
    elif g > 1:
        X = mp.acosh(mp.sqrt(g)) / mp.sqrt(g - 1)
    else:
        X = mpf(1)
    w0 = {0.4: "0.5101959460339647", 2.0: "0.4229088659455404",
          4.0: "0.3607975830140822", 8.0: "0.29144176549724515"}[mu]  # fmt: skip
    checks = [
        ("w under the force", mpf(w0) / 4, "deflection", 5.0, 1e-14),
        ("M under the force, sqrt(k EI) w", mpf(w0) / 2, "moment", 5.0, 1e-14),
        ("contact from 5 - X", 5 - X, "from", None, TIGHT),
        ("contact to 5 + X", 5 + X, "to", None, TIGHT),
    ]
    note = f"long weightless beam, tensionless Pasternak, g = mu/(2 sqrt(k EI)) = {mu / 4}; "
    note += "b X = arccos(sqrt g)/sqrt(1-g), or arccosh(sqrt g)/sqrt(g-1); M0 = w0 sqrt(k EI)"
    return f"weightless-pasternak-{mu / 4}", model, note, checks


def rigid_winkler(e):
    """B16: a rigid beam under an eccentric force, contact length 3 (l/2 - e)."""
    at = 0.5 + e
    model = Model(1.0, RIGID, 1.0, loads=[Load("point", 1.0, at)])
    c = 3 * (1 - mpf(at))
    checks = [
        ("contact from l - 3 (l/2 - e)", 1 - c, "from", None, 1e-11),
        ("w at the loaded end, 2 F/(k c)", 2 / c, "deflection", 1.0, 1e-11),
    ]
    return f"rigid-winkler-{e}", model, "rigid beam (limit), outside the middle third", checks


def rigid_pasternak(m):
    """C13: a rigid beam with the contact length m from the loaded end."""
    k, mu = mpf(1), mpf("0.25")
    lam, m = mp.sqrt(mu / k), mpf(m)
    d = m**2 * (m + 3 * lam) / (3 * (m + 2 * lam) ** 2)
    at = float(1 - d)  # rounded to a double: no more than 1e-16 from the formula
    model = Model(1.0, RIGID, 1.0, 0.25, loads=[Load("point", 1.0, at)])
    phi = 2 / (k * (m + 2 * lam) ** 2)
    checks = [
        ("contact from l - m", 1 - m, "from", None, 1e-10),
        ("w at the loaded end, phi (m + lam)", phi * (m + lam), "deflection", 1.0, 1e-10),
        ("end force k phi lam (m + 2 lam)", k * phi * lam * (m + 2 * lam), "right", None, 1e-10),
    ]
    note = "rigid beam (limit) on Pasternak, force d = m^2 (m + 3 lam)/(3 (m + 2 lam)^2) from its end, "
    note += "lam = sqrt(mu/k), phi = 2 F/(k (m + 2 lam)^2) its slope"
    return f"rigid-pasternak-{mp.nstr(m, 3)}", model, note, checks


def rigid_kikuchi(offset):
    """C14: M0 at the first lift-off of a rigid beam is 1/2 - 4/27."""
    moment = float(mpf(1) / 2 - mpf(4) / 27) + offset
    loads = [Load("point", 1.0, 0.5), Load("moment", moment, 0.5)]
    model = Model(1.0, RIGID, 1.0, 1.0, loads=loads)
    note = "rigid beam (limit); the left end leaves the ground at M0 = 1/2 - 4/27 = 0.351851..."
    checks = [("end force 0 at first lift-off", mpf(0), "left", None, 1e-11)] if offset == 0 else []
    return f"rigid-kikuchi{offset:+g}" if offset else "rigid-kikuchi", model, note, checks


def free_winkler(beta_l):
    """B09: free-free, force at the centre, all in contact while b l < pi (Hetenyi)."""
    model = Model(beta_l, 1.0, 4.0, loads=[Load("point", 1.0, beta_l / 2)])
    b = mpf(beta_l)
    s, c = mp.sin, mp.cos
    below = mp.sinh(b) + s(b)
    checks = [
        ("w under the force", (mp.cosh(b) + c(b) + 2) / (8 * below), "deflection", beta_l / 2, TIGHT),
        ("w at the end", mp.cosh(b / 2) * c(b / 2) / (2 * below), "deflection", 0.0, TIGHT),
        ("M under the force", (mp.cosh(b) - c(b)) / (4 * below), "moment", beta_l / 2, TIGHT),
    ]
    note = "free-free Winkler beam, force at the centre, b = 1, F = 1, k = 4: w_c = (ch + c + 2)/(8 (sh + s)), "
    note += "w_e = ch(l/2) c(l/2)/(2 (sh + s)), M_c = (ch - c)/(4 (sh + s))"
    return f"free-winkler-{beta_l:.4g}", model, note, checks


def ends_loaded(beta_l):
    """A14, A15: equal forces at both ends of a weightless beam; its middle lifts off if b l > pi."""
    loads = [Load("point", 1.0, 0.0), Load("point", 1.0, beta_l)]
    model = Model(beta_l, 1.0, 4.0, loads=loads)
    note = "equal forces at both ends, b = 1: the middle lifts off beyond b l = pi"
    checks = []
    if beta_l == 3.0:
        b = mpf(beta_l)
        w = mp.cosh(b / 2) * mp.cos(b / 2) / (mp.sinh(b) + mp.sin(b))
        checks = [("w at the middle", w, "deflection", beta_l / 2, TIGHT)]
        model.loads.append(Load("point", 0.0, beta_l / 2))  # so that the middle is a station
    return f"ends-loaded-{beta_l:g}", model, note, checks


def pinned_winkler():
    """A05: pinned at both ends, force at the centre, b l = 3 pi, tensionless springs."""
    l = float(3 * mp.pi)
    model = Model(l, 1.0, 4.0, loads=[Load("point", 1.0, l / 2)])
    model.supports = [Support(0.0, "pinned"), Support(l, "pinned")]
    checks = [("w at midspan", mpf("0.12607757"), "deflection", l / 2, 1e-7)]
    note = "Pavlovic and Tsikkos 1982, figure 2: w EI b^3/F = 0.1254 read off the figure"
    return "pinned-winkler", model, note, checks


def held_by_tension():
    """P > 0 resists rotation: an equilibrium exists although the static reaction at the left is negative."""
    loads = [Load("point", 1.0, 0.5), Load("moment", 0.7, 0.5)]
    model = Model(1.0, 1.0, 1.0, 1.0, P=2.0, loads=loads)
    note = "P = 2: an equilibrium exists although M0 = 0.7 is beyond the static condition"
    return "held-by-tension", model, note, []


def all_limits():
    with mp.workdps(60):
        yield weightless_winkler()
        for mu in (0.4, 2.0, 4.0, 8.0):
            yield weightless_pasternak(mu)
        for e in (0.2, 0.3, 0.4):
            yield rigid_winkler(e)
        for m in (0.9, 0.5, 0.2):
            yield rigid_pasternak(m)
        for offset in (0.0, -1e-3, 1e-3):
            yield rigid_kikuchi(offset)
        for beta_l in (1.0, 2.0, 3.0, float(mp.pi)):
            yield free_winkler(beta_l)
        for beta_l in (3.0, 5.0):
            yield ends_loaded(beta_l)
        yield pinned_winkler()
        yield held_by_tension()


def compare(record, checks):
    """The checks as data for the record; raises an error if one fails."""
    out = []
    with mp.workdps(40):
        for what, value, field, place, tolerance in checks:
            if field in ("from", "to"):
                got = mpf(record["contact"][0][field == "to"])
            elif field in ("left", "right"):
                got = mpf(record["end_forces"][field])
            else:
                table = record["stations"]
                got = mpf(table[field][[float(x) for x in table["x"]].index(place)])
            off = abs(got - value) / (abs(value) or 1)
            # The record has 20 digits.
            if off > max(tolerance, 1e-19):
                raise AssertionError(f"{record['name']}: {what}: {got}, expected {value}")
            out.append((what, value, off))
    return out
