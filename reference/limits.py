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
    """A long weightless beam under one force on tensionless springs. Outside the contact zone the beam is
    straight, so its length has no effect."""
    EI, k, F, middle = 1.0, 4.0, 1.0, 5.0
    model = Model(10.0, EI, k, loads=[Load("point", F, middle)])
    half, beta = mp.pi / 2, mpf(1)
    checks = [
        ("contact from 5 - pi/2", middle - half, "from", None, TIGHT),
        ("contact to 5 + pi/2", middle + half, "to", None, TIGHT),
        ("w under the force", beta / 8 * mp.coth(half), "deflection", 5.0, TIGHT),
        ("M under the force", mp.coth(half) / 4, "moment", 5.0, TIGHT),
        ("slope outside the contact zone", 1 / (4 * mp.sinh(half)), "slope", 0.0, TIGHT),
    ]
    note = "long weightless beam on tensionless Winkler ground under a force F, with the wave number b = (k/(4 EI))^(1/4); "
    note += "under the force F, w = F b coth(pi/2)/(2 k) and M = F coth(pi/2)/(4 b) with the wave number b; "
    note += "outside the contact zone, the slope of the beam is F b^2/(k sinh(pi/2)) with the wave number b"
    return "weightless-winkler", model, note, checks


def weightless_pasternak(mu):
    """The beam of `weightless_winkler` on Pasternak ground, with g = mu / (2 sqrt(k EI))."""
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
        ("M under the force", mpf(w0) / 2, "moment", 5.0, 1e-14),
        ("contact from 5 - X", 5 - X, "from", None, TIGHT),
        ("contact to 5 + X", 5 + X, "to", None, TIGHT),
    ]
    note = f"long weightless beam on tensionless Pasternak ground, with the ground parameter g = mu/(2 sqrt(k EI)) = {mu / 4}; "
    note += "with the wave number b = (k/(4 EI))^(1/4), the contact zone extends a distance X to each side of the force; "
    note += "for a ground parameter g < 1, the wave number b times the distance X is arccos(sqrt g)/sqrt(1-g); "
    note += "for a ground parameter g > 1, the wave number b times the distance X is arccosh(sqrt g)/sqrt(g-1); "
    note += "M = w sqrt(k EI) under the force"
    return f"weightless-pasternak-{mu / 4}", model, note, checks


def rigid_winkler(e):
    """A rigid beam under a force with the eccentricity e. The contact length is 3 (l/2 - e)."""
    at = 0.5 + e
    model = Model(1.0, RIGID, 1.0, loads=[Load("point", 1.0, at)])
    c = 3 * (1 - mpf(at))
    checks = [
        ("contact from l - 3 (l/2 - e)", 1 - c, "from", None, 1e-11),
        ("w at the loaded end, 2 F/(k c) with the contact length c", 2 / c, "deflection", 1.0, 1e-11),
    ]
    return f"rigid-winkler-{e}", model, "limiting case of a rigid beam, with the force outside the middle third", checks


def rigid_pasternak(m):
    """A rigid beam on Pasternak ground. The contact zone has the length m and begins at the loaded end."""
    k, mu = mpf(1), mpf("0.25")
    lam, m = mp.sqrt(mu / k), mpf(m)
    d = m**2 * (m + 3 * lam) / (3 * (m + 2 * lam) ** 2)
    at = float(1 - d)  # rounded to a double: no more than 1e-16 from the formula
    model = Model(1.0, RIGID, 1.0, 0.25, loads=[Load("point", 1.0, at)])
    phi = 2 / (k * (m + 2 * lam) ** 2)
    checks = [
        ("contact from l - m", 1 - m, "from", None, 1e-10),
        ("w at the loaded end", phi * (m + lam), "deflection", 1.0, 1e-10),
        ("end force at the loaded end", k * phi * lam * (m + 2 * lam), "right", None, 1e-10),
    ]
    note = "limiting case of a rigid beam on Pasternak ground, with the contact length m and decay length lam = sqrt(mu/k); "
    note += "for contact length m and decay length lam, the force F acts m^2 (m + 3 lam)/(3 (m + 2 lam)^2) from the loaded end; "
    note += "for contact length m and decay length lam, the slope of the beam is phi = 2 F/(k (m + 2 lam)^2); "
    note += "the deflection of the loaded end is the slope phi times the sum of contact length m and decay length lam; "
    note += "for slope phi, contact length m and decay length lam, the ground force at the loaded end is k phi lam (m + 2 lam)"
    return f"rigid-pasternak-{mp.nstr(m, 3)}", model, note, checks


def rigid_kikuchi(offset):
    """A rigid beam of length 1 on ground with k = mu = 1, under a unit force and a moment M0, both at its
    centre. The left end lifts off if M0 > 1/2 - 4/27."""
    moment = float(mpf(1) / 2 - mpf(4) / 27) + offset
    loads = [Load("point", 1.0, 0.5), Load("moment", moment, 0.5)]
    model = Model(1.0, RIGID, 1.0, 1.0, loads=loads)
    note = "limiting case of a rigid beam of length 1 with k = mu = 1, under a unit force and a moment M0, both at its centre; "
    note += "the left end of the beam lifts off at M0 = 1/2 - 4/27 = 0.351851..."
    checks = [("end force 0 at first lift-off", mpf(0), "left", None, 1e-11)] if offset == 0 else []
    return f"rigid-kikuchi{offset:+g}" if offset else "rigid-kikuchi", model, note, checks


def free_winkler(beta_l):
    """A free-free beam under a force at the centre (Hetenyi). The whole beam is in contact if b l < pi, with
    b = (k/(4 EI))^(1/4)."""
    model = Model(beta_l, 1.0, 4.0, loads=[Load("point", 1.0, beta_l / 2)])
    b = mpf(beta_l)
    s, c = mp.sin, mp.cos
    below = mp.sinh(b) + s(b)
    checks = [
        ("w under the force", (mp.cosh(b) + c(b) + 2) / (8 * below), "deflection", beta_l / 2, TIGHT),
        ("w at the end", mp.cosh(b / 2) * c(b / 2) / (2 * below), "deflection", 0.0, TIGHT),
        ("M under the force", (mp.cosh(b) - c(b)) / (4 * below), "moment", beta_l / 2, TIGHT),
    ]
    note = "free-free beam on Winkler ground under a force at the centre, with F = 1, EI = 1, k = 4: "
    note += "w = (cosh l + cos l + 2)/(8 (sinh l + sin l)) and M = (cosh l - cos l)/(4 (sinh l + sin l)) under the force, "
    note += "for F = 1, EI = 1, k = 4 and the length l, the force F deflects the ends by cosh(l/2) cos(l/2)/(2 (sinh l + sin l))"
    return f"free-winkler-{beta_l:.4g}", model, note, checks


def ends_loaded(beta_l):
    """A weightless beam under equal forces at both ends. Its middle lifts off if b l > pi, with
    b = (k/(4 EI))^(1/4)."""
    loads = [Load("point", 1.0, 0.0), Load("point", 1.0, beta_l)]
    model = Model(beta_l, 1.0, 4.0, loads=loads)
    note = "equal forces at both ends; the middle lifts off if b l > pi, with b = (k/(4 EI))^(1/4) = 1"
    checks = []
    if beta_l == 3.0:
        b = mpf(beta_l)
        w = mp.cosh(b / 2) * mp.cos(b / 2) / (mp.sinh(b) + mp.sin(b))
        checks = [("w at the middle", w, "deflection", beta_l / 2, TIGHT)]
        model.loads.append(Load("point", 0.0, beta_l / 2))  # so that the middle is a station
    return f"ends-loaded-{beta_l:g}", model, note, checks


def pinned_winkler():
    """A beam on tensionless springs, pinned at both ends, under a force at the centre. Its length is 3 pi/b, with
    b = (k/(4 EI))^(1/4)."""
    l = float(3 * mp.pi)
    model = Model(l, 1.0, 4.0, loads=[Load("point", 1.0, l / 2)])
    model.supports = [Support(0.0, "pinned"), Support(l, "pinned")]
    checks = [("w at midspan", mpf("0.12607757"), "deflection", l / 2, 1e-7)]
    note = "Pavlovic and Tsikkos 1982: w EI b^3/F = 0.1254 at midspan, read off figure 2, with b = (k/(4 EI))^(1/4)"
    return "pinned-winkler", model, note, checks


def held_by_tension():
    """The tension P resists rotation, so an equilibrium exists although the static reaction at the left end is negative."""
    loads = [Load("point", 1.0, 0.5), Load("moment", 0.7, 0.5)]
    model = Model(1.0, 1.0, 1.0, 1.0, P=2.0, loads=loads)
    note = "tension P = 2: an equilibrium exists, although the static reaction at the left end is negative"
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
    """Compares a record with its closed forms. Returns the name, the value and the relative difference of each closed
    form. Raises an error if a difference exceeds the tolerance."""
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
                raise AssertionError(f"{record['name']}: {what} is {got}, expected {value}")
            out.append((what, value, off))
    return out
