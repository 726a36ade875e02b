"""Stiffness K and load T of the ground outside the beam, flux = Ku − T at the beam's end, from its stretches."""

from flint import arb

from balls import ball, optional


def check(r):
    """K and T computed from the stretches agree with the logged K and T, and replace them."""
    for line in r.all("ground beside the beam"):
        side = line["side"]
        stiffness, pushed = seen(line["stretches"], line["held"])
        r.meets(f"K of the ground outside the beam, side {side}", stiffness - r.outside[side])
        r.meets(f"T of the ground outside the beam, side {side}", pushed - r.pushed[side])
        r.outside[side], r.pushed[side] = stiffness, pushed


def seen(stretches, held):
    """From the far end to the beam: S⁺ = K(S + Kt)/(K + St), T⁺ likewise; see `outside.rs` for the formulas."""
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
