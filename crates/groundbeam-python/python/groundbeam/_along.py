"""Parameters along the beam: how a row of values becomes a function of the position."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ._solution import Array


class Along:
    """Values of ``k``, ``mu`` or ``EI`` along the beam, for ``solve_many``.

    A list is a single row that all models share. An array of models by values has one row for each model.
    """

    values: Array
    """The values: one row for each model, or a single row that all models share."""

    def __init__(self, values: npt.ArrayLike) -> None:
        array = np.asarray(values, dtype=np.float64)
        if array.ndim not in (1, 2):
            raise ValueError(
                f"{type(self).__name__} takes a list of values, or an array with one row of values for each model, "
                f"but the given array has {array.ndim} dimensions"
            )
        self.values = np.atleast_2d(array)

    def __repr__(self) -> str:
        models, count = self.values.shape
        return f"<groundbeam.{type(self).__name__}: {models} by {count}>"


class Points(Along):
    """Values at equidistant points along the whole beam, with linear variation between the points."""


class Steps(Along):
    """Values on stretches of equal length along the whole beam, constant on each stretch."""


class ControlValues(Along):
    """Control values of one curve along the whole beam, as in ``Foundation(k=[...])`` and ``Beam(EI=[...])``.

    ``k`` and ``mu`` have at most three, ``EI`` at most six.
    """
