"""The contact set of layers with the bounds of V. With shear deformation it needs several rounds, because slope
and contact set depend on each other."""

from balls import INFINITE, NotReplayed, exact
from contact import Contact, Edge, roughly
from points import pressure
from shear_force import bounds, first_slopes


def check(r):
    """The logged ε_V, ε_a and edges; with shear deformation also ε_θ and ε_p, round by round."""
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
        r.shows("the edges are not those of the last round", same == used)
        for i, line in enumerate(r.all("tolerance of a force")):
            r.holds(f"eps_a at node {i}", r.contact.tolerance[i], exact(line["error"]))


def nothing(r):
    """Without the contact set the logged bounds of V are infinite."""
    for i, error in enumerate(r.errors):
        r.shows(f"eps_V on piece {i} is finite without a contact set", not error["V"].is_finite())


def final(r, errors):
    """ε_V, and the other bounds that it lowers, from the last round."""
    r.contact.errors = errors
    for i, (force, slope) in enumerate(bounds(r, r.contact)):
        r.holds(f"(15) eps_V on piece {i}", force, r.errors[i]["V"])
        if r.pieces[i].stiffness is not None:
            r.holds(f"eps_theta on piece {i}", slope, r.errors[i]["slope"])
            r.holds(f"eps_p on piece {i}", errors[i]["p"], r.errors[i]["p"])


def in_rounds(r):
    """The first round uses rough bounds of the contact; the bounds of each further round follow from the previous
    one."""
    rounds, errors, before = r.all("round"), first_slopes(r), None
    if len(rounds) < 2:
        raise NotReplayed("the rounds of a beam with shear deformation are not in the log")
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
            r.shows(f"round {number} follows from one that is not proven", False)
        before, errors = contact, [dict(error) for error in errors]
    r.contact = before
    if before.shown != r.shown[0]:
        r.shows("the last round differs from the contact set", False)
    if before.shown:
        final(r, before.errors)
        return
    r.contact = None
    for i, error in enumerate(r.errors):
        for key in ("V", "slope", "p"):
            r.holds(f"eps_{key} on piece {i}", before.errors[i][key], error[key])


def compared(r, number, i, error, claimed):
    """The bounds of a round. A logged bound replaces the recomputed bound if the recomputed bound is not larger."""
    found = dict(error)
    for key, logged in zip(("slope", "V", "p"), map(exact, claimed)):
        r.holds(f"eps_{key} on piece {i} in round {number}", error[key], logged)
        found[key] = logged
    return found
