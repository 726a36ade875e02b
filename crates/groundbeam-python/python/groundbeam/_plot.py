"""Draws a solution with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ._solution import Array, Solution

# Colours of Okabe and Ito, which can be distinguished with any kind of colour vision.
BEAM, GROUND, PRESSURE, MOMENT, SHEAR = "#000000", "#b07000", "#0072b2", "#d55e00", "#009e73"


def figure(solution: Solution) -> Figure:
    """Draws four panels: deflection and pressure downward, the moment on the tension side, and the shear force."""
    from matplotlib.figure import Figure

    drawn = Figure(figsize=(8.0, 9.0), layout="constrained")
    axes = drawn.subplots(4, 1, sharex=True)
    x, sides = both_sides(solution.stations())
    length = solution.length
    fields = [solution.at(each, side) for each, side in ((x, "left"), (x, "right"))]
    both = {
        name: np.where(sides == "left", getattr(fields[0], name), getattr(fields[1], name))
        for name in ("deflection", "pressure", "moment", "shear_force")
    }
    def label(words: str, unit: str) -> str:
        return f"{words} [{unit}]" if si else words

    si = solution.units == "SI"
    small = 1e3 if si else 1.0
    beside = np.linspace(-0.1 * length, 1.1 * length, 241)

    bed, pressure, moment, shear = axes
    bed.plot(x, small * both["deflection"], color=BEAM, linewidth=2.0, label="beam")
    ground = np.unique(np.concatenate([beside, x]))
    bed.plot(ground, small * solution.settlement(ground), color=GROUND, label="ground")
    for start, end, _, _ in solution.lift_off:
        bed.axvspan(start, end, color=GROUND, alpha=0.12, linewidth=0.0)
    bed.invert_yaxis()
    bed.set_ylabel(label("deflection, down", "mm"))
    bed.legend(loc="best")

    pressure.fill_between(x, both["pressure"], color=PRESSURE, alpha=0.3)
    pressure.plot(x, both["pressure"], color=PRESSURE)
    pressure.invert_yaxis()
    pressure.set_ylabel(label("pressure", "N/m"))
    left, right = solution.end_forces
    pressure.set_title(label(f"end forces {left:.4g} and {right:.4g}", "N"), fontsize="medium")
    moment.fill_between(x, both["moment"], color=MOMENT, alpha=0.3)
    moment.plot(x, both["moment"], color=MOMENT)
    moment.invert_yaxis()
    moment.set_ylabel(label("moment, sagging", "N m"))
    shear.fill_between(x, both["shear_force"], color=SHEAR, alpha=0.3)
    shear.plot(x, both["shear_force"], color=SHEAR)
    shear.set_ylabel(label("shear force", "N"))
    shear.set_xlabel(label("x", "m"))
    for panel in axes:
        panel.axhline(0.0, color="0.5", linewidth=0.8)
        panel.margins(x=0.0)
    return drawn


def both_sides(x: Array) -> tuple[Array, np.ndarray[tuple[int], np.dtype[np.str_]]]:
    """Repeats each position for its left and its right side, so that jumps are drawn vertically."""
    return np.repeat(x, 2), np.tile(np.array(["left", "right"]), len(x))
