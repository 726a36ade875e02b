"""Checks the contact set of shear layers and the bounds of V. With shear deformation this needs several rounds,
because the bounds of the slope and the contact set depend on each other."""

from balls import INFINITE, NotReplayed, exact
from contact import Contact, Edge, roughly
from points import pressure
from shear_force import bounds, first_slopes


def check(r):
    """Checks the logged edges, and the logged error bounds of shear force and contact forces. With shear deformation it
    also checks the bounds of slope and pressure, round by round."""
    r.shown = r.one("contact set")["shown"]
    edges = [Edge(line["edge"]) for line in r.all("edge")]
    r.contact = None
    if r.shears:
        in_rounds(r)
    elif r.shown[0]:
        r.contact = Contact(r, r.errors, edges)
        r.contact.check()
        final(r, [{**error, "V": INFINITE} for error in r.errors])
    else:
        nothing(r)
    if r.contact is not None:
        same = sorted((e.node, e.side, float(e.outside), float(e.inside)) for e in edges)
        used = sorted((e.node, e.side, float(e.outside), float(e.inside)) for e in r.contact.edges)
        r.shows("the contact edges in the log differ from those of the last round of the proof", same == used)
        for i, line in enumerate(r.all("tolerance of a force")):
            r.holds(f"eps_a at node {i}", r.contact.tolerance[i], exact(line["error"]))


def nothing(r):
    """Checks that the bounds in the log for the error of the shear force V are infinite, because no contact set is
    proven."""
    for i, error in enumerate(r.errors):
        r.shows(f"the error bound of V on piece {i} is finite, but no contact set is proven", not error["V"].is_finite())


def final(r, errors):
    """Checks the error bounds of the shear force V that follow from the proven contact set, and with shear deformation
    also the error bounds of the slope w′ and of the pressure."""
    r.contact.errors = errors
    for i, (force, slope) in enumerate(bounds(r, r.contact)):
        r.holds(f"(15) eps_V on piece {i}", force, r.errors[i]["V"])
        if r.pieces[i].stiffness is not None:
            r.holds(f"eps_theta on piece {i}", slope, r.errors[i]["slope"])
            r.holds(f"eps_p on piece {i}", errors[i]["p"], r.errors[i]["p"])


def in_rounds(r):
    """Checks all rounds of a beam with shear deformation. The first round checks the edges without a bound of the
    slope; the bounds of each further round follow from the previous round."""
    rounds, errors, before = r.all("round"), first_slopes(r), None
    if len(rounds) < 2:
        raise NotReplayed("the beam has shear deformation, but the log has fewer than two rounds")
    for number, line in enumerate(rounds):
        if before is not None and before.shown:
            for error, (force, slope) in zip(errors, bounds(r, before)):
                error["V"], error["slope"] = force, slope
        for i, (error, claimed) in enumerate(zip(errors, line["bounds"])):
            if r.pieces[i].stiffness is not None:
                error["p"] = error["p"].min(pressure(r, i, error))
            errors[i] = compared(r, number, i, error, claimed)
        contact = Contact(r, errors, [Edge(edge) for edge in line["edges"]])
        contact.shown = line["shown"]
        if contact.shown:
            roughly(contact) if number == 0 else contact.check()
        elif number > 0 and number + 1 < len(rounds):
            r.shows(f"the contact set is not proven in round {number} of the proof, but a further round follows", False)
        before, errors = contact, [dict(error) for error in errors]
    r.contact = before
    if before.shown != r.shown[0]:
        r.shows("the log line `contact set` and the last round of the proof disagree on whether the contact set is proven", False)
    if before.shown:
        final(r, before.errors)
        return
    r.contact = None
    for i, error in enumerate(r.errors):
        for key in ("V", "slope", "p"):
            r.holds(f"eps_{key} on piece {i}", before.errors[i][key], error[key])


def compared(r, number, i, error, claimed):
    """Checks that each recomputed bound of a round is at most the logged bound, and returns the bounds with the
    logged values."""
    found = dict(error)
    for key, logged in zip(("slope", "V", "p"), map(exact, claimed)):
        r.holds(f"eps_{key} on piece {i} in round {number}", error[key], logged)
        found[key] = logged
    return found
