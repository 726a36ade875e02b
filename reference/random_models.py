"""Random models in families, each from its own fixed seed.

`FAMILIES` maps a family's name to (count, maker); `make(family, index)` gives the model. A draw without an
equilibrium, or close to the limit, is rejected, and the next one is taken from the same stream of numbers, so that
(family, index) determines everything. Numbers are short decimals.
"""

import math
import random

from groundref.model import Load, Model, Support


def short(v, digits=4):
    return float(f"{v:.{digits}g}")


def log_uniform(r, a, b):
    return math.exp(r.uniform(math.log(a), math.log(b)))


# ---- existence of an equilibrium -----------------------------------------------------------------


def work(model, at_left, at_right):
    """Work done by the loads in the rigid motion r with r(0) = at_left and r(l) = at_right."""
    l = model.length
    slope = (at_right - at_left) / l
    total = 0.0
    for load in model.loads:
        if load.kind == "point":
            total += load.value * (at_left + slope * load.start)
        elif load.kind == "moment":
            total += load.value * slope
        else:
            a, b, v, e = load.start, load.end, load.value, load.end_value
            area, first = (v + e) / 2 * (b - a), (b - a) ** 2 * (v / 6 + e / 3)
            if load.kind == "distributed":
                total += area * (at_left + slope * a) + slope * first
            else:
                total += area * slope
    return total


def load_size(model):
    l = model.length
    size = 0.0
    for load in model.loads:
        unit = l if load.kind in ("moment", "distributed_moment") else 1.0
        if load.is_point:
            size += abs(load.value) / unit
        else:
            size += (abs(load.value) + abs(load.end_value)) / 2 * (load.end - load.start) / unit
    return size


def free_rays(model):
    """Upward rigid motions that supports and tension leave free, as (r(0), r(l)).
    The motions of a cone are the sums of these."""
    l = model.length
    held = [s.at for s in model.supports if s.kind != "spring" or s.spring > 0]
    no_turn = model.P > 0 or any(s.kind == "fixed" or s.rotational > 0 for s in model.supports)
    if not held:
        return [(-1.0, -1.0)] if no_turn else [(-1.0, 0.0), (0.0, -1.0)]
    if no_turn or len(held) > 1:
        return []
    return {0.0: [(0.0, -1.0)], l: [(-1.0, 0.0)]}.get(held[0], [])


def stands(model, margin=0.02):
    """Whether an equilibrium exists: in each free upward rigid motion of `free_rays`, the work of the loads is negative
    and its magnitude exceeds `margin` times the size of the loads."""
    size = load_size(model)
    return size > 0 and all(work(model, *ray) < -margin * size for ray in free_rays(model))


# ---- parts of random models -----------------------------------------------------------------------


def uniform_base(r, stiffness=(0.5, 8.0), layer=(0.3, 20.0), shear=True):
    """A random uniform beam and ground, with l (k/(4 EI))^(1/4) in the range `stiffness` and l sqrt(k/mu) in the range
    `layer`."""
    l = short(log_uniform(r, 0.5, 20.0), 3)
    k = short(log_uniform(r, 0.1, 100.0), 3)
    ratio = log_uniform(r, *stiffness)
    EI = short(k * (l / ratio) ** 4 / 4)
    mu = short(k * (l / log_uniform(r, *layer)) ** 2) if shear else 0.0
    return Model(l, EI, k, mu)


def place(r, l, digits=3):
    return short(l * r.uniform(0.0, 1.0), digits)


def stretch(r, l):
    while True:
        a, b = sorted((place(r, l), place(r, l)))
        if r.random() < 0.25:
            a = 0.0
        if r.random() < 0.25:
            b = l
        if b - a > 0.05 * l:
            return a, b


def random_loads(r, l, count, unit=1.0, upward=0.2, moments=True):
    """Random point loads, point moments, distributed loads and distributed moments. Each has a size of about `unit`."""
    loads = []
    for _ in range(count):
        size = unit * log_uniform(r, 0.3, 3.0)
        sign = -1.0 if r.random() < upward else 1.0
        kind = r.random()
        if kind < 0.45:
            at = r.choice([0.0, l]) if r.random() < 0.1 else place(r, l)
            loads.append(Load("point", short(sign * size), at))
        elif kind < 0.6 and moments:
            at = r.choice([0.0, l]) if r.random() < 0.1 else place(r, l)
            loads.append(Load("moment", short(r.choice([-1, 1]) * size * l * 0.3), at))
        elif kind < 0.75 and moments:
            a, b = stretch(r, l)
            v = short(r.choice([-1, 1]) * size * l * 0.3 / (b - a))
            w = v if r.random() < 0.5 else short(v * r.uniform(-1, 1))
            loads.append(Load("distributed_moment", v, a, b, w))
        else:
            a, b = stretch(r, l)
            v = short(sign * size / (b - a))
            w = v if r.random() < 0.5 else short(v * r.uniform(-0.5, 2))
            loads.append(Load("distributed", v, a, b, w))
    return loads


def loaded(r, model, most=6, upward=0.2, weight=0.4):
    """Adds at least one and at most `most` random loads to the model and, with the probability `weight`, a
    self-weight."""
    unit = log_uniform(r, 0.1, 10.0)
    model.loads = random_loads(r, model.length, r.randint(1, most), unit, upward)
    if r.random() < weight:
        v = short(unit * log_uniform(r, 0.05, 2.0) / model.length)
        model.loads.append(Load("distributed", v, 0.0, model.length, v))
    return model


# ---- families of random models --------------------------------------------------------------------


def plain(r, index):
    return loaded(r, uniform_base(r))


def tension(r, index):
    model = loaded(r, uniform_base(r))
    model.P = short(model.EI * (log_uniform(r, 0.1, 20.0) / model.length) ** 2)
    return model


def cuts(r, l, count):
    while True:
        points = sorted([0.0, l] + [place(r, l) for _ in range(count)])
        if min(b - a for a, b in zip(points, points[1:])) > 0.03 * l:
            return points


def vary_ground(r, model, count, winkler=0.0):
    """Adds ground segments to the model. The first and the last may extend beyond the ends of the beam."""
    l, k, mu = model.length, model.k, model.mu
    points = cuts(r, l, count)
    for a, b in zip(points, points[1:]):
        if r.random() < 0.25:
            continue  # the foundation's own constants here
        ki = short(k * log_uniform(r, 0.1, 10.0))
        mi = 0.0 if r.random() < winkler else short(mu * log_uniform(r, 0.1, 10.0))
        if a == 0.0 and r.random() < 0.3:
            a = -l
        if b == l and r.random() < 0.3:
            b = 2 * l
        model.ground_segments.append((a, b, ki, mi))


def vary_beam(r, model, count):
    for a, b in zip(*[iter(cuts(r, model.length, count))] * 2):
        model.beam_segments.append((a, b, short(model.EI * log_uniform(r, 0.05, 20.0))))


def segments(r, index):
    model = loaded(r, uniform_base(r))
    if index % 3 != 1:
        vary_ground(r, model, r.randint(1, 3), winkler=0.4 if index % 4 == 0 else 0.0)
    if index % 3 != 0:
        vary_beam(r, model, r.randint(1, 4))
    if r.random() < 0.3:
        model.P = short(model.EI * (log_uniform(r, 0.3, 10.0) / model.length) ** 2)
    return model


def winkler(r, index):
    model = loaded(r, uniform_base(r, shear=False))
    if index % 4 == 0:
        vary_ground(r, model, 2)
    if index % 5 == 0:
        model.P = short(model.EI * (log_uniform(r, 0.3, 10.0) / model.length) ** 2)
    return model


def supports(r, index):
    model = uniform_base(r, shear=index % 5 != 4)
    l, EI = model.length, model.EI
    loaded(r, model, upward=0.1 if index % 4 == 0 else 0.3)
    if index % 4 == 0:  # compressed, hence well held: below the beam's own buckling load
        held = r.choice(["pins", "clamp", "clamp and pin"])
        ends = [0.0, l]
        if held == "pins":
            model.supports = [Support(x, "pinned") for x in ends]
        else:
            first, second = r.sample(ends, 2)
            model.supports = [Support(first, "fixed")]
            if held == "clamp and pin":
                model.supports.append(Support(second, "pinned"))
        euler = math.pi**2 * EI / l**2 / (4 if held == "clamp" else 1)
        model.P = short(-euler * r.uniform(0.1, 0.9))
        return model
    places = sorted({r.choice([0.0, l, place(r, l), place(r, l)]) for _ in range(r.randint(1, 3))})
    for at in places:
        kind = r.choice(["pinned", "fixed", "spring", "spring", "rotational"])
        if kind == "spring":
            c = short(model.k * l * log_uniform(r, 0.05, 20.0))
            t = short(EI / l * log_uniform(r, 0.05, 20.0)) if r.random() < 0.5 else 0.0
            model.supports.append(Support(at, "spring", c, t))
        elif kind == "rotational":
            t = short(EI / l * log_uniform(r, 0.05, 20.0))
            model.supports.append(Support(at, "spring", 0.0, t))
        else:
            model.supports.append(Support(at, kind))
    if r.random() < 0.3:
        model.P = short(EI * (log_uniform(r, 0.3, 10.0) / l) ** 2)
    return model


def gap(r, index):
    model = loaded(r, uniform_base(r, shear=index % 5 != 4), weight=0.8)
    l = model.length
    depth = load_size(model) / (model.k * l)
    corners = sorted({place(r, l) for _ in range(r.randint(1, 4))} | set(r.sample([0.0, l], 1)))
    low = -0.5 if index % 4 == 3 else 0.0
    for at in corners:
        value = 0.0 if r.random() < 0.2 else short(depth * r.uniform(low, 1.5))
        model.gap.append((at, value))
    if index % 6 == 5:
        vary_ground(r, model, 1)
    return model


# ---- hard models -------------------------------------------------------------------------------------

# Models with a load at a contact edge. A row contains l, EI, k, mu, the position of a unit force and a moment, the
# moment, and further loads. The secant method gave moments with a contact edge within 1e-16 m (second row: 3e-9 m) of
# the first further load.
EDGE_LOADS = [
    (1.0, 1.0, 1.0, 1.0, 0.5, 0.4851271361921004, [Load("point", 0.1, 0.6)]),
    (1.0, 1.0, 1.0, 1.0, 0.5, 0.4851271351921004, [Load("point", 0.1, 0.6)]),
    (1.0, 0.01, 1.0, 0.0, 0.5, 0.2964834055707226, [Load("point", 0.05, 0.4)]),
    (2.0, 0.5, 3.0, 0.2, 1.2, 0.4357105859550535,
     [Load("moment", 0.02, 0.8), Load("distributed", 0.05, 0.0, 2.0, 0.05)]),
]  # fmt: skip


def hard(r, index):
    if index < 8:  # rigid and long beams: lambda l far from one
        ratio = (0.01, 0.03, 0.1, 0.3, 20.0, 40.0, 70.0, 100.0)[index]
        return loaded(r, uniform_base(r, (ratio, ratio), (0.05, 50.0)), upward=0.1)
    if index < 13:  # EI over eight decades, all else of order one
        model = Model(1.0, (1e-5, 1e-3, 1e-1, 1e1, 1e3)[index - 8], 1.0, short(r.uniform(0.01, 2.0)))
        return loaded(r, model, upward=0.1)
    if index < 18:  # the resultant next to an end
        return nearly_tipping(r, (1e-3, 1e-4, 1e-5, 1e-6, 1e-6)[index - 13])
    if index < 23:  # weightless, with forces up between forces down: many regions
        return alternating(r, index - 16)
    if index < 26:
        return heels(r, index - 23)
    l, EI, k, mu, at, moment, more = EDGE_LOADS[index - 26]
    loads = [Load("point", 1.0, at), Load("moment", moment, at)] + more
    return Model(l, EI, k, mu, loads=list(loads))


def nearly_tipping(r, distance):
    """A model with random loads and a moment that moves their resultant to the distance `distance` * l from an end."""
    model = loaded(r, uniform_base(r, (0.1, 6.0)), most=3, upward=0.0, weight=0.5)
    l, total = model.length, work(model, 1.0, 1.0)
    first = work(model, 0.0, l)
    target = l * (distance if r.random() < 0.5 else 1 - distance)
    model.loads.append(Load("moment", short(total * target - first, 15), place(r, l)))
    return model


def alternating(r, count):
    """A model with `count` downward forces, upward forces between them, a small weight, and sometimes a moment."""
    ratio = 6.0 * count
    model = uniform_base(r, (ratio, 2 * ratio), (ratio / 4, 3 * ratio))
    l = model.length
    for i in range(count):
        at = short(l * (i + 0.3 + 0.4 * r.random()) / count, 3)
        model.loads.append(Load("point", short(r.uniform(0.5, 2.0)), at))
        if i:
            model.loads.append(Load("point", short(-r.uniform(0.05, 0.3)), short(l * i / count, 3)))
    if r.random() < 0.5:
        model.loads.append(Load("moment", short(0.05 * l / ratio), place(r, l)))
    v = short(r.uniform(0.01, 0.05) / l)
    model.loads.append(Load("distributed", v, 0.0, l, v))
    a, b = stretch(r, l)
    model.loads.append(Load("distributed_moment", short(0.1 / ratio), a, b, 0.0))
    return model


def heels(r, kind):
    """A model with contact at single points, such as the ends of the beam or a kink of the initial gap."""
    model = uniform_base(r, (0.3, 1.0), (1.0, 4.0))
    l = model.length
    f = short(0.2 * model.k * l)
    rise, small = l * 0.5, short(0.1 * f)
    if kind == 0:  # a hollow under the beam
        model.gap = [(0.0, 0.0), (short(0.45 * l), short(rise)), (l, 0.0)]
        model.loads = [Load("point", f, place(r, l)), Load("distributed_moment", small, 0.0, l, small)]
    elif kind == 1:  # a ridge with steep sides, and the right end
        at = short(0.3 * l)
        model.gap = [(0.0, short(rise)), (at, 0.0), (short(0.7 * l), short(rise)), (l, 0.0)]
        a = short(0.4 * l)
        model.loads = [Load("point", f, short(0.5 * l)), Load("distributed_moment", small, a, l, -small)]
    else:  # arched by its loads: forces at the ends, one up between them
        model.EI = short(model.k * l**4 / 4 / r.uniform(2.0, 3.0) ** 4)
        model.mu = short(model.k * l**2 / r.uniform(1.0, 2.0) ** 2)
        model.loads = [Load("point", f, 0.0), Load("point", f, l)]
        model.loads.append(Load("point", short(-1.8 * f), short(0.48 * l)))
        model.loads.append(Load("distributed_moment", short(0.01 * f), 0.0, short(0.3 * l), 0.0))
    return model


FAMILIES = {
    "plain": (60, plain),
    "tension": (40, tension),
    "segments": (30, segments),
    "winkler": (20, winkler),
    "supports": (20, supports),
    "gap": (20, gap),
    "hard": (30, hard),
}

NOTES = {
    ("hard", 26): "a force acts at most 1e-16 m from the contact edge",
    ("hard", 27): "a force acts about 3e-9 m from the contact edge",
    ("hard", 28): "Winkler ground; a force acts at most 1e-16 m from the contact edge",
    ("hard", 29): "a moment acts at most 1e-16 m from the contact edge",
}


def make(family, index):
    """Returns the model `index` of the family, its seed, and the number of rejected draws."""
    seed = 100000 * (1 + list(FAMILIES).index(family)) + index
    r = random.Random(seed)
    for thrown in range(1000):
        model = FAMILIES[family][1](r, index)
        if stands(model, 1e-7 if family == "hard" else 0.02):
            model.title = f"{family} {index:03d}"
            return model, seed, thrown
    raise RuntimeError(f"no draw for model {index} of the family {family} has an equilibrium")
