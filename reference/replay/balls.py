"""Ball arithmetic of the replay: numbers of a log, their bounds, and proofs on intervals by bisection
(python-flint)."""

from flint import arb, arb_poly, ctx

ctx.prec = 320
SUBDIVISIONS = 20_000
HALVINGS = 24
INFINITE = arb("+inf")


class NotReplayed(Exception):
    """Error for a log that cannot be replayed; the message states the reason."""


def exact(x):
    """Returns a double as a ball of radius zero. A `null` in the log becomes infinity."""
    return INFINITE if x is None else arb(float(x))


def ball(parts):
    """Returns a ball from its three numbers in the log: midpoint, correction of the midpoint, radius."""
    middle, correction, radius = map(float, parts)
    return arb(middle) + arb(correction) + arb(0, radius)


def optional(parts, read=ball):
    return None if parts is None else read(parts)


def poly(coefficients):
    return arb_poly([ball(c) for c in coefficients])


def upper(x):
    """Returns the upper bound of |x| as a ball of radius zero."""
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
    """Returns an upper bound of max(−x, 0)."""
    return upper(low(x)) if not x >= 0 else arb(0)


def least_of_halves(h, bound):
    """Returns the smallest value of bound(h) over the lengths h, h/2, h/4 and so on."""
    found = INFINITE
    for _ in range(HALVINGS):
        found = found.min(bound(h))
        h /= 2
    return found


def ball_of(ends):
    """Returns one ball that contains the interval between two numbers."""
    return ((ends[0] + ends[1]) / 2).union(ends[0]).union(ends[1])


def sorted_pair(a, b):
    return (a, b) if a < b else (b, a)


def on(ends, is_true):
    """Proves a statement on an interval of t by bisection; `is_true` receives each subinterval as a ball."""
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
    """Returns a lower bound of a polynomial on an interval of t, a ball, from the Taylor coefficients at the
    midpoint."""
    about, reach = p(arb_poly([t.mid(), 1])), arb(t.rad())
    return low(about[0] - sum((upper(about[j]) * reach**j for j in range(1, about.degree() + 1)), arb(0)))


def above(p, ends, limit):
    """Returns whether a polynomial is proven to be larger than a limit on an interval of t."""
    return on(ends, lambda t: least_on(p, t) > limit)


def below(p, ends):
    """Returns two bounds for a polynomial on an interval: the size of its most negative value, and the length on
    which it is negative."""
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
    raise NotReplayed("the sign of a polynomial could not be determined")


class Checks:
    """Counts the inequalities and stores those that do not hold."""

    # The radii of balls have 30 bits and depend on the order of operations. The left side of an inequality may
    # therefore exceed the right side by this relative amount.
    ROUNDING = arb("1e-5")

    def __init__(self):
        self.count, self.failed = 0, []

    def holds(self, name, left, right):
        """Checks left ≤ right up to the rounding of radii. An infinite right side is not checked."""
        if not right.is_finite():
            return
        self.count += 1
        if not left <= right * (1 + self.ROUNDING):
            self.failed.append(f"{name}: {left.str(20)} <= {right.str(20)} does not hold")

    def meets(self, name, difference):
        """Checks that the ball of a difference contains zero; in exact arithmetic the difference is zero."""
        self.count += 1
        if not difference.contains(0):
            self.failed.append(f"{name}: the difference {difference.str(10)} is not zero")

    def shows(self, name, is_true):
        """Checks a statement; `name` is the message if the statement is false."""
        self.count += 1
        if not is_true:
            self.failed.append(name)
