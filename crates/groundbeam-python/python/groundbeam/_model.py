"""Models: built in code, or read from model files."""

from __future__ import annotations

import os
from typing import NamedTuple, Optional, Sequence, Tuple, Union

from . import _native, _parts, _tables
from ._combinations import Combinations
from ._comparison import Comparison
from ._threads import number_of
from ._solution import Solution
from ._trains import Passages


_Files = Optional[Sequence[Tuple[str, str]]]
"""Names and texts of files in memory."""


class Existence(NamedTuple):
    """The existence check of a model."""

    verdict: str
    """``unique``, ``not-unique``, ``none``, or ``local`` for an equilibrium under compression that needs the
    ground."""
    sentence: str
    """The reason, as a sentence."""
    static_reactions: Tuple[float, ...]
    """Static reactions [N]: forces of supports under both ends and under each free hinge between them, for a rigid
    beam on these supports only."""
    motion: Optional[Tuple[float, float, float]]
    """r(0), r(l) and the work of the loads, for a motion that is free (``not-unique``) or gains work
    (``none``)."""


class Model:
    """A beam, the ground under it, supports and loads. It is immutable; each addition returns a new model.

    Numbers are in SI units (m, N), texts have a unit::

        Model(Beam("12 m", EI=1.28e9), Foundation(k="40 MN/m^2", mu=9e6), loads=[Load.point("900 kN", at=1.5)])
    """

    _text: str
    _name: str
    _bare_is_si: bool
    _folder: Optional[str]
    _files: list[Tuple[str, str]]
    _inner: _native.Model

    def __init__(
        self,
        beam: _parts.Beam,
        foundation: _parts.Foundation,
        *,
        loads: Sequence[_parts.Load] = (),
        supports: Sequence[_parts.Support] = (),
        hinges: Sequence[_parts.Hinge] = (),
        gap: _parts.Gap = (),
        ground_loads: Sequence[_parts.GroundLoad] = (),
        troughs: Sequence[_parts.Trough] = (),
        trains: Sequence[_parts.Train] = (),
        combinations: Sequence[_parts.Combination] = (),
        checks: Optional[_parts.Checks] = None,
        title: Optional[str] = None,
    ) -> None:
        """Raises ``ModelError`` with all faults if the model is invalid."""
        several = {
            "load": loads,
            "ground_load": ground_loads,
            "support": supports,
            "hinge": hinges,
            "gap_trough": troughs,
            "train": trains,
            "combination": combinations,
        }
        made = _parts.tables(beam, foundation, several, gap, checks, title)
        self._read(_tables.write(made), "model", True, None)

    def _read(
        self, text: str, name: str, bare_is_si: bool, folder: Optional[str], files: _Files = None
    ) -> None:
        self._text, self._name, self._bare_is_si, self._folder = text, name, bare_is_si, folder
        self._inner = _native.Model(text, name, bare_is_si, folder, files)
        self._files = self._inner.files

    @classmethod
    def _of(
        cls,
        text: str,
        name: str,
        bare_is_si: bool,
        folder: Optional[str] = None,
        files: _Files = None,
    ) -> Model:
        model = cls.__new__(cls)
        model._read(text, name, bare_is_si, folder, files)
        return model

    @classmethod
    def from_toml(cls, text: str, *, name: str = "model") -> Model:
        """A model from the text of a model file. Messages use ``name`` as the name of the file."""
        return cls._of(text, name, False)

    @classmethod
    def from_dict(cls, tables: _tables.Tables) -> Model:
        """A model from nested dictionaries and lists with the keys of the model file; numbers are in SI
        units."""
        return cls._of(_tables.write(tables), "model", True)

    def _with(self, heading: str, part: _parts.Part) -> Model:
        return self._joined({heading: [part.table]})

    def _joined(self, tables: _tables.Tables) -> Model:
        text = self._text.rstrip("\n") + "\n\n" + _tables.write(tables)
        return Model._of(text, self._name, self.units == "SI", self._folder, self._files)

    def with_load(self, load: _parts.Load) -> Model:
        """The model with an additional load."""
        return self._with("load", load)

    def with_support(self, support: _parts.Support) -> Model:
        """The model with an additional support."""
        return self._with("support", support)

    def with_hinge(self, hinge: _parts.Hinge) -> Model:
        """The model with an additional hinge."""
        return self._with("hinge", hinge)

    def with_gap(self, at: _parts.Quantity, value: _parts.Quantity) -> Model:
        """The model with an additional point of the initial gap, to the right of the existing ones."""
        return self._with("gap", _parts.Part(at=at, value=value))

    def with_ground_load(self, load: _parts.GroundLoad) -> Model:
        """The model with an additional load on the ground."""
        return self._with("ground_load", load)

    def with_trough(self, trough: _parts.Trough) -> Model:
        """The model with an additional settlement trough."""
        return self._with("gap_trough", trough)

    def with_train(self, train: _parts.Train) -> Model:
        """The model with an additional train."""
        return self._with("train", train)

    def with_checks(self, checks: _parts.Checks) -> Model:
        """The model with the given limits to check. A model that already has limits is refused."""
        return self._joined({"checks": checks.table})

    def to_toml(self) -> str:
        """The model as a model file. If the model was built in code, numbers without a unit are in SI units."""
        return self._text

    @property
    def title(self) -> Optional[str]:
        """The title of the model."""
        return self._inner.title

    @property
    def units(self) -> str:
        """Unit system of the model: ``SI``, or ``none`` for a file in its own consistent system."""
        return self._inner.units

    @property
    def length(self) -> float:
        """The beam's length [m]."""
        return self._inner.length

    def solve(
        self, method: str = "exact", *, elements: int = 100, combination: Optional[str] = None
    ) -> Solution:
        """Solves the model, or one of its combinations. Other Python threads continue meanwhile.

        ``elements`` is the number of elements for the methods with a mesh: ``active-set``, ``psor`` and ``uzawa``.

        Raises ``NoEquilibrium`` with the motion that proves it, ``NotConverged`` if no result could be certified,
        and ``ModelError`` if the method does not apply to the model. A model with combinations or trains raises
        ``ValueError`` unless a ``combination`` is chosen. Its loads then act without trains: ``solve_trains`` adds them.
        """
        if combination is None:
            self._refuse_more_than_one_answer("solve_combinations(), or solve")
        return Solution(self._inner.solve(method, elements, combination))

    def _refuse_more_than_one_answer(self, calls: Optional[str]) -> None:
        """Raises an error if one result would ignore combinations or trains of the file. ``calls`` are those that
        take a combination."""
        names = [name for name, _ in self._inner.combinations()]
        if names:
            instead = f"use {calls}(combination={names[0]!r})" if calls else "give a model without combinations"
            raise ValueError(f"the model has {len(names)} combinations: {instead}")
        if self._inner.trains:
            raise ValueError(
                f"the train {self._inner.trains[0]!r} moves along the beam, so there is one result for each of its "
                "positions: use solve_trains()"
            )

    def check(self, *, combination: Optional[str] = None) -> Existence:
        """Decides whether an equilibrium exists, without solving: for a combination, or by default for all loads as
        written. Trains are left out."""
        verdict, reactions, motion, sentence = self._inner.check(combination)
        return Existence(verdict, sentence, tuple(reactions), motion)

    def combinations(self) -> list[_parts.Combination]:
        """All combinations of load cases, once for each ground of ``[foundation.band]``, with their load factors."""
        return [
            _parts.Combination(name, dict(factors))
            for name, factors in self._inner.combinations()
        ]

    def solve_combinations(
        self, method: str = "exact", *, elements: int = 100, threads: Optional[int] = None
    ) -> Combinations:
        """Solves each combination. A combination without a solution has the exception that ``solve`` would
        raise. Trains are left out: ``solve_trains`` moves them over the combinations.

        ``threads`` defaults to the number of processors; the results have the same bits with any number.
        """
        if not self._inner.combinations():
            raise ValueError("the model has no combinations: use solve()")
        return Combinations(self._inner.solve_combinations(method, elements, number_of(threads)))

    def solve_trains(
        self,
        method: str = "exact",
        *,
        elements: int = 100,
        combination: Optional[str] = None,
        threads: Optional[int] = None,
    ) -> Passages:
        """Moves every train of the model over every combination, or over one, and solves all positions.

        A model without combinations has its loads as written. The results have the same bits with any number of
        ``threads``.
        """
        if not self._inner.trains:
            raise ValueError("the model has no trains: use solve()")
        native = self._inner.solve_trains(method, elements, combination, number_of(threads))
        return Passages(native)

    def compare(
        self,
        *,
        elements: int = 100,
        most_sweeps: int = 1_000_000,
        combination: Optional[str] = None,
    ) -> Comparison:
        """Solves the model, or one of its combinations, by every method.

        ``elements`` is the number of elements for the methods with a mesh. ``most_sweeps`` limits their
        iterations.
        """
        if combination is None:
            self._refuse_more_than_one_answer("compare")
        found = Comparison(self._inner.compare(elements, most_sweeps, combination))
        exact = found["exact"].answer
        if not isinstance(exact, Solution):
            raise exact
        return found

    def __repr__(self) -> str:
        title = f" {self.title!r}" if self.title else ""
        unit = " m" if self.units == "SI" else ""
        return f"<groundbeam.Model{title}: {self.length:g}{unit}, {self._inner.load_count} loads>"

    def _made_of(self) -> Tuple[str, bool, Tuple[str, ...]]:
        return self._text, self._bare_is_si, tuple(text for _, text in self._files)

    def __eq__(self, other: object) -> bool:
        return self._made_of() == other._made_of() if isinstance(other, Model) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._made_of())

    def __reduce__(self) -> Tuple[object, Tuple[str, str, bool, Optional[str], _Files]]:
        # The pickled model includes the files that it names, which may be missing on another machine.
        return Model._of, (self._text, self._name, self._bare_is_si, self._folder, self._files)


def load(path: Union[str, "os.PathLike[str]"]) -> Model:
    """Reads a model file. Raises ``ModelError`` with the locations of all faults."""
    with open(path, "rb") as file:
        data = file.read()
    name = os.fspath(path)
    return Model._of(_native.text_of(data, name), name, False, os.path.dirname(name))
