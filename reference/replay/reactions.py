"""Checks the error bounds of the reactions of supports, and whether each one-way support is proven active or inactive
(section 6)."""

from flint import arb

from balls import INFINITE, NotReplayed, ball, exact, high, optional, positive_part, upper
from deflection import at_support
from test_functions import lifted_side, straight, turned_side


class Support:
    """A support of the model with its claimed reaction, an upward force and a clockwise moment."""

    def __init__(self, line):
        self.node, self.x, self.acts = line["node"], ball(line["x"]), line["acts"]
        self.springs = optional(line["springs"], lambda both: [ball(x) for x in both])
        self.settlement = ball(line["settlement"])
        self.claimed = [ball(x) for x in line["claimed"]]
        self.errors = [exact(x) for x in line["errors"]]

    def towards(self, x):
        return -x if self.acts < 0 else x


def check(r):
    """Checks the logged error bounds of forces and moments, the sums of the supports at each node, and the state of
    one-way supports."""
    r.supports = [Support(line) for line in r.all("support")]
    sums(r)
    decided = True
    for i, support in enumerate(r.supports):
        found = errors(r, support)
        for name, left, right in zip(("force", "moment"), found, support.errors):
            r.holds(f"the error of the {name} of support {i}", left, right)
        if support.acts:
            clear = is_clear(r, support)
            if support.node is None:
                r.shows(f"the beam may reach the inactive one-way support {i}", clear)
            decided = decided and (clear or support.towards(support.claimed[0]) > support.errors[0])
    if r.one("supports")["decided"]:
        r.shows("the state of a one-way support is not decided", decided)


def sums(r):
    """Checks that the stiffnesses and claimed reactions of the supports at each node add up to the values of the
    node."""
    for i, node in enumerate(r.nodes):
        here = [support for support in r.supports if support.node == i]
        springs = [support for support in here if support.springs is not None]
        total = lambda of: sum((of(support) for support in springs), arb(0))
        spring = total(lambda s: s.springs[0]), total(lambda s: s.springs[0] * s.settlement)
        for name, found, of_node in zip(("spring", "settled spring"), spring, node.spring or (arb(0), arb(0))):
            r.meets(f"the {name} at node {i}", found - of_node)
        r.meets(f"the rotational spring at node {i}", total(lambda s: s.springs[1]) - (node.turning or arb(0)))
        rigid = [support for support in here if support.springs is None]
        r.shows(
            f"the model and the log disagree: only one of them has a rigid support at node {i}",
            (node.rigid is not None) == bool(rigid),
        )
        for support in rigid:
            r.meets(f"the settlement of the support at node {i}", support.settlement - node.rigid)
        for j, sign in ((0, 1), (1, -1)):
            claimed = sum((support.claimed[j] for support in rigid), arb(0))
            r.meets(f"the reaction at node {i}", claimed * sign - node.reaction[j])
        if node.acts:
            r.shows(
                f"the model does not have exactly the one-way support that the log has at node {i}",
                [support.acts for support in here] == [node.acts],
            )
        elif any(support.acts for support in here):
            raise NotReplayed("a one-way support shares its node with a two-way support")


def errors(r, support):
    if support.node is None:
        # The exact reaction of an inactive support is zero.
        return [upper(claimed) for claimed in support.claimed]
    if support.springs is not None:
        return of_springs(r, support)
    if sum(other.node == support.node and other.springs is None for other in r.supports) > 1:
        return [INFINITE, INFINITE]
    return [of_rigid_support(r, support.node), of_clamp(r, support.node)]


def of_springs(r, support):
    """Returns the error bounds of force and moment of a spring support. The bound of the force is min(κε_w, s₂√κ +
    κ|c|) plus the difference of the claimed reaction from κ(w − δ). The bound of the moment is the same with the
    rotation."""
    w, slope = at_support(r, support.node)
    piece = max(support.node - 1, 0)
    bounds = (r.errors[piece]["w"], r.errors[piece]["rotation"])
    force = support.springs[0] * (w - support.settlement)
    if support.acts:
        force = support.towards(positive_part(support.towards(force)))
    found = []
    for j, computed in enumerate((force, -support.springs[1] * slope)):
        stiffness = high(support.springs[j])
        if stiffness == 0:
            found.append(upper(support.claimed[j]))
            continue
        energy = (2 * r.beam_energy * stiffness).sqrt() + stiffness * r.c[piece][j]
        found.append((stiffness * bounds[j]).min(energy) + upper(support.claimed[j] - computed))
    return found


def of_rigid_support(r, node):
    """Returns s₂K + W|λ|, the error bound of the force of a rigid support. K belongs to a test function z that is 1
    at this support and 0 at all other rigid supports. z is a cubic on each side, or a linear function."""
    here = r.nodes[node]
    k = (lifted_side(r, node, 0) + lifted_side(r, node, 1) + here.stiff()[0]).min(tilted(r, node))
    given_back = upper(here.reaction[0]) if here.acts else here.weights["rigid"]
    return r.test_factor * k.sqrt() + upper(r.factor[node]) * given_back


def tilted(r, node):
    """Returns K² of the linear test function that is 1 at a rigid support and 0 at the only other rigid support, if
    neither support is a clamp. Otherwise returns infinity."""
    rigid = [i for i, other in enumerate(r.nodes) if other.rigid is not None]
    if len(rigid) != 2 or any(r.nodes[i].clamped for i in rigid):
        return INFINITE
    base = r.x[rigid[0] if rigid[1] == node else rigid[1]]
    return straight(r, base, 1 / (r.x[node] - base))


def of_clamp(r, node):
    """Returns s₂K + W_θ|λ′|, the error bound of the moment of a clamp at xᵢ. K belongs to a test function z with z′ =
    1 at the clamp. z is a cubic on both sides, or x − xᵢ on the whole beam if there is no other rigid support."""
    here = r.nodes[node]
    if not here.clamped:
        # A pinned support exerts no moment. The proof refuses an answer that claims a moment at a pinned support.
        return arb(0)
    k = turned_side(r, node, 0) + turned_side(r, node, 1) + here.stiff()[1]
    if sum(other.rigid is not None for other in r.nodes) == 1:
        k = k.min(straight(r, r.x[node], arb(1)))
    steep = r.steep[max(node - 1, 0)].max(r.steep[min(node, len(r.pieces) - 1)])
    return r.test_factor * k.sqrt() + steep * here.weights["clamp"]


def is_clear(r, support):
    """Returns whether the beam is proven to be clear of the one-way support, on every piece that may contain this
    support."""
    found = False
    for piece, error in zip(r.pieces, r.errors):
        if support.x < piece.x[0] or support.x > piece.x[1]:
            continue
        found = True
        t = (support.x - piece.middle) / piece.half
        if not support.towards(support.settlement - piece.w(t)) > error["w"]:
            return False
    return found
