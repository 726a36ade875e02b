"""Ball arithmetic of the replay: numbers of a log, their bounds, and proofs on intervals by bisection
(python-flint)."""

from flint import arb, arb_poly, ctx

ctx.prec = 320
SUBDIVISIONS = 20_000
HALVINGS = 24
INFINITE = arb("+inf")


class NotReplayed(Exception):
    """A log that cannot be replayed, with the reason."""


def exact(x):
    """A double as a ball of radius zero; null in the log means infinite."""
    return INFINITE if x is None else arb(float(x))


def ball(parts):
    """A ball of the log: middle, correction of the middle, radius."""
    middle, correction, radius = map(float, parts)
    return arb(middle) + arb(correction) + arb(0, radius)


def optional(parts, read=ball):
    return None if parts is None else read(parts)


def poly(coefficients):
    return arb_poly([ball(c) for c in coefficients])


def upper(x):
    """The smallest upper bound of |x|, as a ball."""
    return arb(abs(x).upper())


def low(x):
    return arb(x.lower())


def high(x):
    return arb(x.upper())


def largest(*values):
    most = arb(0)
    for value in values:
        most = most.max(upper(value))
    return most


def positive_part(x):
    return x.max(arb(0))


def negative_part(x):
    """An upper bound of max(−x, 0)."""
    return upper(low(x)) if not x >= 0 else arb(0)


def least_of_halves(h, bound):
    """The smallest value of a bound over a length and its halves."""
    found = INFINITE
    for _ in range(HALVINGS):
        found = found.min(bound(h))
        h /= 2
    return found


def ball_of(ends):
    """The interval between two numbers as one ball."""
    return ((ends[0] + ends[1]) / 2).union(ends[0]).union(ends[1])


def sorted_pair(a, b):
    return (a, b) if a < b else (b, a)


def on(ends, is_true):
    """Proves a statement on an interval of t by bisection; the statement receives the interval as a ball."""
    todo = [tuple(ends)]
    for _ in range(SUBDIVISIONS):
        if not todo:
            return True
        a, b = todo.pop()
        middle, reach = (a + b) / 2, (b - a) / 2
        if is_true(arb(middle.mid(), upper(reach))):
            continue
        if not reach > arb(2) ** -90 or not is_true(arb(middle.mid())):
            return False
        todo += [(a, middle), (middle, b)]
    return False


def least_on(p, t):
    """A lower bound of a polynomial on an interval of t, given as a ball, from its coefficients about the
    middle."""
    about, reach = p(arb_poly([t.mid(), 1])), arb(t.rad())
    return low(about[0] - sum((upper(about[j]) * reach**j for j in range(1, about.degree() + 1)), arb(0)))


def above(p, ends, limit):
    """Whether a polynomial is larger than a limit on an interval of t."""
    return on(ends, lambda t: least_on(p, t) > limit)


def below(p, ends):
    """Bounds of the negative part of a polynomial on an interval: its depth, and the length where it is
    negative."""
    depth = measure = arb(0)
    todo = [(low(ends[0]), high(ends[1]))]
    smallest = arb(2) ** -60
    for _ in range(SUBDIVISIONS):
        if not todo:
            return depth, measure
        a, b = todo.pop()
        middle = (a + b) / 2
        if p(arb(middle.mid(), ((b - a) / 2).upper())) >= 0:
            continue
        shifted = p(arb_poly([middle.mid(), 1]))
        reach = (b - a) / 2
        tail = sum((abs(shifted[j]) * reach**j for j in range(1, shifted.degree() + 1)), arb(0))
        least = shifted[0] - tail
        if least >= 0:
            continue
        if b - a < smallest or p(middle.mid()) < 0 and tail < -shifted[0] / 4:
            depth = depth.max(-low(least))
            measure += b - a
        else:
            todo += [(a, arb(middle.mid())), (arb(middle.mid()), b)]
    raise NotReplayed("the sign of a polynomial is not decided")


class Checks:
    """Counts the inequalities and stores those that do not hold."""

    # Radii have 30 bits and depend on the order of operations, so this relative excess over the right side is
    # allowed.
    ROUNDING = arb("1e-5")

    def __init__(self):
        self.count, self.failed = 0, []

    def holds(self, name, left, right):
        """left ≤ right, except for the rounding of radii. An infinite bound makes no claim."""
        if not right.is_finite():
            return
        self.count += 1
        if not left <= right * (1 + self.ROUNDING):
            self.failed.append(f"{name}: {left.str(20)} <= {right.str(20)} does not hold")

    def meets(self, name, difference):
        """A difference that is zero in exact arithmetic."""
        self.count += 1
        if not difference.contains(0):
            self.failed.append(f"{name}: the difference {difference.str(10)} is not zero")

    def shows(self, name, is_true):
        """A statement."""
        self.count += 1
        if not is_true:
            self.failed.append(name)
