"""Parameters along the beam: what the values of a row mean."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ._solution import Array


class Along:
    """Values of ``k``, ``mu`` or ``EI`` along the beam, for ``solve_many``.

    A list is one row for all models; an array of models by values has a row for each.
    """

    values: Array
    """The rows, models by values."""

    def __init__(self, values: npt.ArrayLike) -> None:
        array = np.asarray(values, dtype=np.float64)
        if array.ndim not in (1, 2):
            raise ValueError(
                f"{type(self).__name__} takes a list of values, or an array of models by values, "
                f"not an array of {array.ndim} dimensions"
            )
        self.values = np.atleast_2d(array)

    def __repr__(self) -> str:
        models, count = self.values.shape
        return f"<groundbeam.{type(self).__name__}: {models} by {count}>"


class Points(Along):
    """Values at equally spaced points from end to end, linear between them."""


class Steps(Along):
    """Values of equal stretches from end to end, constant on each."""


class ControlValues(Along):
    """The control values of one curve from end to end, as ``Foundation(k=[...])`` and ``Beam(EI=[...])`` take them.

    ``k`` and ``mu`` have at most three, ``EI`` at most six.
    """
