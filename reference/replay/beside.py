"""Computes for the ground outside the beam the stiffness K, and the force T at the beam's end from loads on this
ground. Both follow from the stretches of this ground. The flux at the beam's end is Ku − T."""

from flint import arb

from balls import ball, optional


def check(r):
    """Checks that K and T computed from the stretches agree with the logged K and T, and stores the computed
    values."""
    for line in r.all("ground beside the beam"):
        side = line["side"]
        stiffness, pushed = seen(line["stretches"], line["held"])
        r.meets(f"the stiffness K of the ground outside the beam, side {side}", stiffness - r.outside[side])
        r.meets(f"the force T at the beam's end from loads on the ground outside, side {side}", pushed - r.pushed[side])
        r.outside[side], r.pushed[side] = stiffness, pushed


def seen(stretches, held):
    """Returns the stiffness S of the ground outside the beam, and the force T at the beam's end from loads on this
    ground. Each stretch, from the far end on, replaces S by K(S + Kt)/(K + St) with K = √(kμ) and t = tanh(h√(k/μ)),
    and T by a similar formula of `outside.rs`."""
    stiffness, pushed, fixed = arb(0), arb(0), held
    for length, ground, spread, force in reversed(stretches):
        (k, mu), h = map(ball, ground), optional(length)
        root = (k * mu).sqrt()
        if h is None:
            stiffness, pushed, fixed = root, arb(0), False
            continue
        z = (k / mu).sqrt() * h
        near, far = (ball(q) / k for q in spread)
        slope = mu * (near - far) / h
        if fixed:
            stiffness = root / z.tanh()
            pushed = stiffness * near - slope - far * root / z.sinh()
        else:
            driven = pushed + ball(force) + slope - stiffness * far
            passed = root / (root * z.cosh() + stiffness * z.sinh())
            stiffness = root * (stiffness + root * z.tanh()) / (root + stiffness * z.tanh())
            pushed = driven * passed + stiffness * near - slope
        fixed = False
    return stiffness, pushed
