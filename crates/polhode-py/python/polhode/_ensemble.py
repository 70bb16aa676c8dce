"""Many bodies at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._arrays import Floats
from ._error import PolhodeError, warn
from ._mass_properties import findings_of, warn_of
from ._record import same
from ._scenario import functions_of, text_of_torques
from ._states import ATTITUDE, OMEGA, States, ends, rotations
from ._table import Column, Table, Variable, vector
from .scenario import FunctionTorque, Torque

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation


#: The time of a state.
REACHED = "time, or the last good one of a member that could go no further"


class Failure(NamedTuple):
    """A member that could go no further."""

    #: The member, from 0.
    member: int
    #: Its last good time among those asked for, s; 0 if there is none.
    time: float
    #: Why.
    cause: str


class EnsembleStates(Table):
    """Where the members of an ensemble were: it unpacks as ``omega, attitude``.

    Its length is the number of members, and ``states[417]`` are the :class:`States` of one, at the times that it reached. All arrays are views of one, in
    which each state lies together, and read-only.
    """

    #: Nothing with arrays in it is hashed.
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, times: Floats, rows: Floats, failures: list[Failure]) -> None:
        #: The times that were asked for (t,), s.
        self.times = times
        #: The members that could go no further.
        self.failures = failures
        self._rows = rows
        self._lock()

    def _lock(self) -> None:
        self.times.flags.writeable = self._rows.flags.writeable = False

    @property
    def omega(self) -> Floats:
        """ω along body axes (n, t, 3), rad/s."""
        return self._rows[:, :, 5:]

    @property
    def attitude(self) -> Floats:
        """R_space_body as unit quaternions (n, t, 4): w, x, y, z; each of the sign nearest to the one before it."""
        return self._rows[:, :, 1:5]

    @property
    def reached(self) -> Floats:
        """The time of each state (n, t), s: that asked for, or the last good one of a member that could go no further."""
        return self._rows[:, :, 0]

    def rotations(self, member: int) -> Rotation:
        """The attitudes of a member as a ``scipy.spatial.transform.Rotation``.

        Parameters
        ----------
        member
            Which one, from 0.

        Returns
        -------
        scipy.spatial.transform.Rotation
            One for each time; it takes body components to space components.

        Raises
        ------
        ImportError
            Without SciPy.
        """
        return rotations(self.attitude[member])

    def _table(self) -> list[Column]:
        members, times, _ = self._rows.shape
        return [
            Column("member", "1", "the member, from 0", np.repeat(np.arange(members), times)),
            Column("time_s", "s", REACHED, self.reached.ravel()),
            *vector("attitude_{}", "1", ATTITUDE, self.attitude, "wxyz"),
            *vector("omega_body_{}_rad_s", "rad/s", OMEGA, self.omega),
        ]

    def _variables(self) -> list[Variable]:
        along = ("member", "time")
        return [
            Variable("member", ("member",), "1", "the member, from 0", np.arange(len(self))),
            Variable("time", ("time",), "s", "the time that was asked for", self.times.copy()),
            Variable("reached", along, "s", REACHED, self.reached.copy()),
            Variable("omega", (*along, "axis"), "rad/s", OMEGA, self.omega.copy()),
            Variable("attitude", (*along, "component"), "1", ATTITUDE, self.attitude.copy()),
        ]

    def __iter__(self) -> Iterator[Floats]:
        return iter((self.omega, self.attitude))

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, member: int) -> States:
        return States(self.reached[member].copy(), self.omega[member].copy(), self.attitude[member].copy())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, EnsembleStates):
            return NotImplemented
        return same(self._rows, other._rows) and same(self.times, other.times) and self.failures == other.failures

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self._lock()

    def __repr__(self) -> str:
        members, times, _ = self._rows.shape
        failures = f", {len(self.failures)} failures" if self.failures else ""
        return f"EnsembleStates({members} members, {times} times{ends(self.times)}{failures})"


class Ensemble:
    """Many bodies that move independently of each other: free, or each under the same ``torques``.

    The bits do not depend on the number of threads, nor on which members there are beside one.

    Parameters
    ----------
    omega
        Angular velocities at t = 0 (n, 3), along body axes, rad/s. What all members share, here and below, may be given once.
    moments
        Moments (n, 3) about the axes x, y and z, kg·m².
    inertia
        Instead of ``moments``: tensors (n, 3, 3) about the centres of mass, kg·m².
    attitude
        What takes body components to space components at t = 0: quaternions (n, 4), matrices (n, 3, 3), or a
        ``scipy.spatial.transform.Rotation`` of n.
    torques
        Torques of :mod:`polhode.scenario`, or a text of ``[[torque]]`` tables, as scenarios have them; all members are under them. A
        :class:`polhode.scenario.FunctionTorque` is called for one member at a time, or, if it is ``vectorized``, once for all of them at each stage of their
        steps. What it raises is raised here, as it is called once at the start, or by :meth:`at`.

    Raises
    ------
    PolhodeError
        Where there is no such body; the message names the member.

    Examples
    --------
    >>> import numpy as np, polhode
    >>> omega = np.random.default_rng(1).normal(size=(1000, 3))
    >>> ensemble = polhode.Ensemble(moments=[1.0, 2.0, 2.5], omega=omega)
    >>> states = ensemble.at([0.0, 10.0, 1e6])
    >>> states.omega.shape, states.attitude.shape
    ((1000, 3, 3), (1000, 3, 4))
    >>> one = polhode.FreeMotion(moments=[1.0, 2.0, 2.5], omega=omega[417])
    >>> bool((states.omega[417] == one.at([0.0, 10.0, 1e6]).omega).all())
    True
    """

    def __init__(
        self,
        *,
        omega: npt.ArrayLike,
        moments: npt.ArrayLike | None = None,
        inertia: npt.ArrayLike | None = None,
        attitude: object = (1.0, 0.0, 0.0, 0.0),
        torques: str | Sequence[Torque] = "",
    ) -> None:
        if (moments is None) == (inertia is None):
            raise PolhodeError("bodies are given by moments or by inertia, exactly one of them")
        given = {
            "omega": _each("omega", omega, (3,)),
            "attitude": _each("attitude", attitude, (4,)),
        }
        if moments is not None:
            given["moments"] = _each("moments", moments, (3,))
        else:
            given["inertia"] = _each("inertia", inertia, (3, 3))
        counts = {name: len(rows) for name, rows in given.items() if len(rows) != 1}
        if len(set(counts.values())) > 1:
            said = ", ".join(f"{name} has {count}" for name, count in counts.items())
            raise PolhodeError(f"{said}: there must be as many of each as members, or one for all")
        # For copies; of its own, as what was given may change.
        self._arguments = {name: rows.copy() for name, rows in given.items()}
        self._torques, self._functions = (torques, []) if isinstance(torques, str) else text_of_torques(torques)
        self._native = _of(self._arguments, self._torques, self._functions)
        warn_of(findings_of(self._native.findings))

    def at(
        self, times: npt.ArrayLike, *, threads: int | None = None, tolerance: float = 1e-13
    ) -> EnsembleStates:
        """All members at times (t,), ascending, s, none before the start.

        Each member is computed by the best method there is: a closed form, else Taylor's method, else DOP853, within ``tolerance`` a step. Under functions of Python it is one thread. There is no estimate of the error: :func:`simulate`
        has one for each of its motions.

        A member that cannot go on stays where it was last good; it is among ``failures``, and there is a :class:`PolhodeWarning`.

        Parameters
        ----------
        times
            Times (t,), ascending, s, none before the start.
        threads
            How many; all processors that this process may use unless given.
        tolerance
            Relative error of a step, where a member is integrated.

        Returns
        -------
        EnsembleStates
            ω (n, t, 3) and attitudes (n, t, 4).

        Raises
        ------
        PolhodeError
            Where an argument is refused: its name, the element and the rule are in the message.
        """
        asked = _arrays.numbers("times", times, ("t",))
        rows, failures = self._native.at(
            asked,
            _native.available_threads() if threads is None else _arrays.count("threads", threads),
            _arrays.positive("tolerance", tolerance),
        )
        states = EnsembleStates(asked.copy(), rows, [Failure(*failure) for failure in failures])
        if states.failures:
            first = states.failures[0]
            message = f"{len(failures)} of {len(self)} members cannot go on, the first is {first.member}: {first.cause}"
            warn(message)
        return states

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "_native"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        # The same arguments are the same bodies, bit for bit.
        self._native = _of(self._arguments, self._torques, self._functions)

    def __len__(self) -> int:
        return len(self._native)

    def __eq__(self, other: object) -> bool:
        """Equal are ensembles of the same bodies, given alike, with the same starts and torques."""
        if not isinstance(other, Ensemble):
            return NotImplemented
        one, two = self._arguments, other._arguments
        same_torques = self._torques == other._torques and self._functions == other._functions
        return same_torques and one.keys() == two.keys() and all(same(one[name], two[name]) for name in one)

    def __hash__(self) -> int:
        return hash((len(self), self._torques))

    def __repr__(self) -> str:
        return f"Ensemble({len(self)} members)"


def _each(name: str, value: Any, shape: tuple[int, ...]) -> Floats:
    """A row for each member, or one for all."""
    check, ndim = _arrays.numbers, len(shape)
    given = np.asarray(value.as_quat()) if hasattr(value, "as_quat") else _arrays.real(name, value)
    if name == "attitude":
        # Of matrices (3, 3) there is an axis more.
        check, ndim = _arrays.quaternions, 2 if given.ndim > 1 and given.shape[-2:] == (3, 3) else 1
    if given.ndim == ndim:
        return check(name, value, shape)[None]
    return check(name, value, ("n", *shape))


def _of(given: dict[str, Floats], torques: str, functions: list[FunctionTorque | None]) -> _native.Ensemble:
    """Of rows for each member, or of one for all."""
    count = next((len(rows) for rows in given.values() if len(rows) != 1), 1)
    tensors = given["moments"][:, :, None] * np.eye(3) if "moments" in given else given["inertia"]

    def each(rows: Floats) -> Floats:
        return rows if len(rows) == count else np.repeat(rows, count, axis=0)

    return _native.Ensemble.of(each(tensors.reshape(-1, 9)), each(given["omega"]), each(given["attitude"]), torques, functions_of(functions))
