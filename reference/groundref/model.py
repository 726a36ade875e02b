"""The model: beam, ground, loads, supports, initial gap; and its TOML text.

All numbers are binary64. A model file has the shortest decimal that reads back as the same double, and every
computation starts from exactly that double.
"""

import tomllib
from dataclasses import dataclass, field


@dataclass
class Load:
    """One load. kind: "point", "moment" (value, at); "distributed", "distributed_moment"
    (value at `start`, value at `end`, linear in between)."""

    kind: str
    value: float
    start: float
    end: float = None
    end_value: float = None

    @property
    def is_point(self):
        return self.kind in ("point", "moment")


@dataclass
class Support:
    """One support. kind: "pinned", "fixed" or "spring". A spring resists w with the stiffness `spring` and w' with
    the stiffness `rotational`."""

    at: float
    kind: str
    spring: float = 0.0
    rotational: float = 0.0


@dataclass
class Model:
    length: float
    EI: float
    k: float
    mu: float = 0.0
    P: float = 0.0
    title: str = ""
    beam_segments: list = field(default_factory=list)  # (from, to, EI)
    ground_segments: list = field(default_factory=list)  # (from, to, k, mu)
    loads: list = field(default_factory=list)
    supports: list = field(default_factory=list)
    gap: list = field(default_factory=list)  # (at, value)
    hinges: list = field(default_factory=list)  # (at, rotational spring); solved, but not guessed

    # ---- properties along the beam; x is the middle of a stretch, never one of its ends ---------
    def EI_at(self, x):
        for a, b, EI in self.beam_segments:
            if a <= x < b:
                return EI
        return self.EI

    def ground_at(self, x):
        for a, b, k, mu in self.ground_segments:
            if a <= x < b:
                return k, mu
        return self.k, self.mu

    def breakpoints(self):
        """All positions at which the data change, including both ends of the beam."""
        l = self.length
        points = {0.0, l}
        points.update(x for s in self.beam_segments for x in s[:2])
        points.update(x for s in self.ground_segments for x in s[:2])
        points.update(x for load in self.loads for x in (load.start, load.end) if x is not None)
        points.update(s.at for s in self.supports)
        points.update(at for at, _ in self.gap)
        points.update(at for at, _ in self.hinges)
        return sorted(x for x in points if 0.0 <= x <= l)

    # ---- TOML ------------------------------------------------------------------------------
    def to_toml(self):
        n = lambda v: repr(float(v))
        out = []
        if self.title:
            out += [f'title = "{self.title}"', ""]
        out += ["[beam]", f"length = {n(self.length)}", f"EI = {n(self.EI)}"]
        if self.P:
            out.append(f"axial_force = {n(self.P)}")
        for a, b, EI in self.beam_segments:
            out += ["", "[[beam.segment]]", f"from = {n(a)}", f"to = {n(b)}", f"EI = {n(EI)}"]
        out += ["", "[foundation]", f"k = {n(self.k)}", f"mu = {n(self.mu)}"]
        for a, b, k, mu in self.ground_segments:
            out += ["", "[[foundation.segment]]", f"from = {n(a)}", f"to = {n(b)}"]
            out += [f"k = {n(k)}", f"mu = {n(mu)}"]
        for load in self.loads:
            out += ["", "[[load]]"]
            if load.is_point:
                out += [f"{load.kind} = {n(load.value)}", f"at = {n(load.start)}"]
            else:
                same = load.value == load.end_value
                both = f"[{n(load.value)}, {n(load.end_value)}]"
                out.append(f"{load.kind} = {n(load.value) if same else both}")
                out += [f"from = {n(load.start)}", f"to = {n(load.end)}"]
        for s in self.supports:
            out += ["", "[[support]]", f"at = {n(s.at)}"]
            if s.kind == "spring":
                if s.spring:
                    out.append(f"spring = {n(s.spring)}")
                if s.rotational:
                    out.append(f"rotational_spring = {n(s.rotational)}")
            else:
                out.append(f'type = "{s.kind}"')
        for at, spring in self.hinges:
            out += ["", "[[hinge]]", f"at = {n(at)}"]
            if spring:
                out.append(f"rotational_spring = {n(spring)}")
        for at, value in self.gap:
            out += ["", "[[gap]]", f"at = {n(at)}", f"value = {n(value)}"]
        return "\n".join(out) + "\n"

    @staticmethod
    def from_toml(text):
        """Reads the text of a model file. The file must not contain units or load cases."""
        doc = tomllib.loads(text)
        beam, ground = doc["beam"], doc["foundation"]
        model = Model(
            length=float(beam["length"]),
            EI=float(beam["EI"]),
            k=float(ground["k"]),
            mu=float(ground.get("mu", 0.0)),
            P=float(beam.get("axial_force", 0.0)),
            title=doc.get("title", ""),
        )
        for s in beam.get("segment", []):
            model.beam_segments.append((float(s["from"]), float(s["to"]), float(s["EI"])))
        for s in ground.get("segment", []):
            k, mu = float(s["k"]), float(s.get("mu", 0.0))
            model.ground_segments.append((float(s["from"]), float(s["to"]), k, mu))
        for entry in doc.get("load", []):
            for kind in ("point", "moment"):
                if kind in entry:
                    model.loads.append(Load(kind, float(entry[kind]), float(entry["at"])))
            for kind in ("distributed", "distributed_moment"):
                if kind in entry:
                    v = entry[kind] if isinstance(entry[kind], list) else [entry[kind]] * 2
                    a, b = float(entry.get("from", 0.0)), float(entry.get("to", model.length))
                    model.loads.append(Load(kind, float(v[0]), a, b, float(v[1])))
        for s in doc.get("support", []):
            spring, rot = float(s.get("spring", 0.0)), float(s.get("rotational_spring", 0.0))
            model.supports.append(Support(float(s["at"]), s.get("type", "spring"), spring, rot))
        hinges = doc.get("hinge", [])
        model.hinges = [(float(h["at"]), float(h.get("rotational_spring", 0.0))) for h in hinges]
        model.gap = [(float(c["at"]), float(c["value"])) for c in doc.get("gap", [])]
        return model


# ---- values on a stretch [a, b] that lies between two neighbouring breakpoints ---------------
# `num` converts a double exactly to the number type of the caller (mpmath or gmpy2).


def linear_load(model, kind, a, b, num):
    """Returns the sum of all distributed loads of `kind` at the left end `a` of the stretch [a, b], and the slope of
    this sum."""
    value, slope = num(0), num(0)
    middle = (a + b) / 2
    for load in model.loads:
        if load.kind == kind and load.start <= middle < load.end:
            m = (num(load.end_value) - num(load.value)) / (num(load.end) - num(load.start))
            value += num(load.value) + m * (a - num(load.start))
            slope += m
    return value, slope


def initial_gap(model, a, b, num):
    """Returns the initial gap at the left end `a` of the stretch [a, b], and the slope of the initial gap on this
    stretch."""
    corners = model.gap
    if not corners:
        return num(0), num(0)
    middle = (a + b) / 2
    if middle <= corners[0][0]:
        return num(corners[0][1]), num(0)
    for (x0, v0), (x1, v1) in zip(corners, corners[1:]):
        if x0 <= middle <= x1:
            m = (num(v1) - num(v0)) / (num(x1) - num(x0))
            return num(v0) + m * (a - num(x0)), m
    return num(corners[-1][1]), num(0)


def point_actions(model, x):
    """Returns the point forces F and the point moments M0 at the breakpoint x, as two lists."""
    force = [load.value for load in model.loads if load.kind == "point" and load.start == x]
    moment = [load.value for load in model.loads if load.kind == "moment" and load.start == x]
    return force, moment


def support_at(model, x):
    return next((s for s in model.supports if s.at == x), None)
