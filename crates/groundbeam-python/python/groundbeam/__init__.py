"""Beams on tensionless ground: contact, lift-off and end forces, with proof.

>>> import groundbeam as gb
>>> model = gb.Model(
...     gb.Beam("12 m", E="30 GPa", section={"width": "1 m", "height": "0.8 m"}),
...     gb.Foundation(subgrade_modulus="40 MN/m^3", width="1 m", mu="9 MN"),
...     loads=[gb.Load.point("900 kN", at="1.5 m"), gb.Load.distributed("10 kN/m")],
... )
>>> solution = model.solve()
>>> [(start, end)] = solution.contact
>>> f"contact from {start:.3f} m to {end:.3f} m"
'contact from 0.000 m to 6.983 m'

Deflections, forces and settlements are positive down, positions are measured from the left end, moments are sagging.
"""

from ._along import ControlValues, Points, Steps
from ._batch import Batch, solve_many
from ._calibrate import Calibration, calibrate
from ._combinations import Band, Banded, Bound, Combinations, Envelope
from ._comparison import Comparison, MethodAnswer, MethodErrors
from ._errors import Diagnostic, GroundbeamError, ModelError, NoEquilibrium, NotConverged
from ._model import Existence, Model, load
from ._native import __version__
from ._parts import (
    Beam,
    Checks,
    Combination,
    Foundation,
    GroundLoad,
    Hinge,
    Load,
    Support,
    Train,
    Trough,
)
from ._solution import (
    Certificate,
    EndForces,
    Extreme,
    Fields,
    Force,
    Gradient,
    HingeTurn,
    LiftOff,
    Range,
    Reaction,
    Solution,
)
from ._study import Estimate, Spread, Study, Summary, merge
from ._trains import MovingBound, MovingEnvelope, Passage, Passages

__all__ = [
    "Batch",
    "Beam",
    "Bound",
    "Band",
    "Banded",
    "Calibration",
    "Certificate",
    "Checks",
    "Combination",
    "Combinations",
    "Comparison",
    "ControlValues",
    "Diagnostic",
    "EndForces",
    "Envelope",
    "Estimate",
    "Existence",
    "Extreme",
    "Fields",
    "Force",
    "Foundation",
    "Gradient",
    "GroundLoad",
    "GroundbeamError",
    "Hinge",
    "HingeTurn",
    "LiftOff",
    "Load",
    "Model",
    "MethodAnswer",
    "MethodErrors",
    "ModelError",
    "MovingBound",
    "MovingEnvelope",
    "NoEquilibrium",
    "NotConverged",
    "Passage",
    "Passages",
    "Points",
    "Range",
    "Reaction",
    "Solution",
    "Spread",
    "Steps",
    "Study",
    "Summary",
    "Support",
    "Train",
    "Trough",
    "__version__",
    "calibrate",
    "load",
    "merge",
    "solve_many",
]
