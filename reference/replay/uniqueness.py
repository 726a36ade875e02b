"""Checks uniqueness: every part between free hinges must be supported at two positions, or at one position and
against rotation (section 7)."""

from anchors import REACHES, least_pressure


def check(r):
    """Checks the claim of uniqueness. A contact force counts as a support if the contact set proves it. A one-way
    support counts if its reaction exceeds the error bound."""
    if not r.one("unique")["shown"] or r.sigma is not None:
        return
    pressed = set(r.contact.pressed) if r.contact is not None else set()
    for support in r.supports:
        if support.node is not None and support.acts and support.towards(support.claimed[0]) > support.errors[0]:
            pressed.add(support.node)
    parts = r.joined_parts()
    counts = [holds(r, part, pressed) for part in parts]
    if r.tension is not None and any(places for places, _ in counts):
        r.count += 1
        return
    held = set()
    for _ in parts:
        for j, (places, turning) in enumerate(counts):
            # A part that is supported also supports its neighbours at the common hinges.
            places += (j - 1 in held) + (j + 1 in held)
            if places + turning > 1 and places > 0:
                held.add(j)
    r.shows("the solution is not proven to be unique", len(held) == len(parts))


def holds(r, part, pressed):
    """Returns the number of positions that support a part of the beam, and whether a clamp or a spring supports this
    part against rotation."""
    nodes = range(part.start, part.stop + 1)
    stands = lambda node: node.acts == 0 and (node.rigid is not None or node.spring is not None)
    places = sum(stands(r.nodes[i]) or i in pressed for i in nodes) + 2 * any(presses(r, i) for i in part)
    return places, any(r.nodes[i].clamped or r.nodes[i].turning is not None for i in nodes)


def presses(r, i):
    """Returns whether a test function z ≥ 0 proves that the exact pressure p* is positive in both halves of an
    interval of a piece. The condition is p_m∫z > s₂‖z‖_b, with the lower bound p_m of the pressure."""
    piece = r.pieces[i]
    for reach in REACHES if piece.touches else ():
        least, h = least_pressure(r, i, reach), reach * piece.half
        norm = (8 * piece.spring.high * h / 15 + 16 * piece.shear.high / (3 * h)).sqrt()
        if least > 0 and 2 * h / 3 * least > r.s2 * norm:
            return True
    return False
