"""Compares the claims of a result document with those of the log: pieces, contact, forces, reactions, and
bounds."""

from flint import arb

from balls import NotReplayed, exact, high, upper

# Maximum distance between the positions of a node in the document and in the log, relative to the beam length.
NEAR = arb("16") * arb(2) ** -52

# Each row contains the name of a quantity in `proof.bounds`, its key in the log, and the exponents of force and
# length in its unit.
BOUNDS = (
    ("deflection", "w", 0, 1),
    ("slope", "slope", 0, 0),
    ("rotation", "rotation", 0, 0),
    ("moment", "M", 1, 1),
    ("shear_force", "V", 1, 0),
    ("settlement", "u", 0, 1),
    ("pressure", "p", 1, -1),
)


def part(document, combination):
    """Returns the result of one load combination from a result document."""
    if "combinations" not in document:
        return document
    for found in document["combinations"]:
        if combination in (found.get("name"), found.get("combination")):
            return found
    raise NotReplayed(f"the document has no combination {combination}")


def check(r, document):
    """Checks that log and document claim the same answer, and that no bound in the document is smaller than the same
    bound in the log."""
    force, length = r.units
    in_log = lambda x, f, l: exact(x) / arb(2) ** (f * force + l * length)
    pieces = document.get("pieces") or []
    r.shows("the number of pieces differs between log and document", len(pieces) == len(r.pieces))
    for i, (piece, claimed) in enumerate(zip(r.pieces, pieces)):
        r.shows(f"the ends of piece {i} differ between log and document", all(
            upper(end - in_log(x, 0, 1)) <= NEAR * high(r.x[-1]) for end, x in zip(piece.x, claimed["x"])
        ))
        r.shows(
            f"the half length of piece {i} differs between log and document",
            piece.half == in_log(claimed["half"], 0, 1),
        )
        middle = (in_log(claimed["x"][0], 0, 1) + in_log(claimed["x"][1], 0, 1)) / 2
        r.meets(f"the middle of piece {i}", piece.middle - middle)
        r.shows(f"the contact of piece {i} differs between log and document", piece.touches == claimed["touches"])
        fields = [("deflection", piece.w, 1), ("rotation", piece.phi, 0), ("settlement", piece.settlement, 1)]
        for name, field, exponent in fields:
            coefficients = [in_log(c, 0, exponent) for c in claimed.get(name) or []]
            same = field is None and not coefficients or field is not None and is_same(field, coefficients)
            r.shows(f"the {name} of piece {i} differs between log and document", same)
    for force_claimed in document.get("forces") or []:
        x = in_log(force_claimed["x"], 0, 1)
        nearest = min(range(len(r.x)), key=lambda i: float(upper(r.x[i] - x)))
        touches = r.touches[nearest] or not any(r.layered(nearest)) or not force_claimed["force"] > 0
        r.shows(f"the document has a force at node {nearest}, but the log has none", touches)
    reactions(r, document.get("reactions") or [], in_log)
    bounds(r, (document.get("proof") or {}).get("bounds") or {}, in_log)


def is_same(field, coefficients):
    """Returns whether a polynomial has exactly the given coefficients."""
    return field.degree() < len(coefficients) and all(field[j] == c for j, c in enumerate(coefficients))


def reactions(r, claimed, in_log):
    """Checks that the reactions in the log agree with those in the document. A reaction that the document does not
    list counts as zero."""
    listed = {reaction.get("support", i): reaction for i, reaction in enumerate(claimed)}
    for i, support in enumerate(r.supports):
        reaction = listed.get(i) or {}
        force, moment = in_log(reaction.get("force", 0), 1, 0), in_log(reaction.get("moment") or 0, 1, 1)
        same = support.claimed[0] == force and support.claimed[1] == moment
        r.shows(f"the reaction of support {i} differs between log and document", same)


def bounds(r, claimed, in_log):
    """Checks that the bound of each field in the document is at least the largest bound of this field in the log."""
    for name, key, force, length in BOUNDS:
        if claimed.get(name) is None:
            continue
        pieces = zip(r.pieces, r.errors)
        within = [e[key] for piece, e in pieces if key != "p" or piece.touches or not piece.layered]
        for bound in within:
            if bound.is_finite():
                r.holds(f"the bound of the {name} in the document", bound, in_log(claimed[name], force, length))
            else:
                r.shows(f"the document has a bound of the {name}, but the log has none", False)
