"""Many bodies at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _threads
from ._arrays import Floats
from ._error import PolhodeError, warn
from ._free_motion import rotations
from ._mass_properties import findings_of, warn_of
from ._scenario import text_of_torques
from .scenario import Torque

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation


class Failure(NamedTuple):
    """A member that could go no further."""

    #: The member, from 0.
    member: int
    #: Its last good time among those asked for, s; 0 if there is none.
    time: float
    #: Why.
    cause: str


class EnsembleStates:
    """Where the members of an ensemble were: it unpacks as ``omega, attitude``.

    Both are views of one array, in which each state lies together.
    """

    def __init__(self, rows: Floats, failures: list[Failure]) -> None:
        self._rows = rows
        self.failures = failures

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
        """The attitudes of a member as a ``scipy.spatial.transform.Rotation``."""
        return rotations(self.attitude[member])

    def __iter__(self) -> Iterator[Floats]:
        return iter((self.omega, self.attitude))

    def __repr__(self) -> str:
        members, times, _ = self._rows.shape
        return f"EnsembleStates({members} members, {times} times, {len(self.failures)} failures)"


class Ensemble:
    """Many bodies that move independently of each other: free, or each under the same ``torques``.

    Bodies by ``moments`` (n, 3) about their axes x, y and z, or by ``inertia`` (n, 3, 3) about their centres of mass; ``omega`` (n, 3) at t = 0
    along body axes, rad/s; ``attitude`` (n, 4), quaternions w, x, y, z, or a ``scipy.spatial.transform.Rotation`` of n. What all share may be
    given once: (3,), (3, 3), (4,). ``torques`` are torques of :mod:`polhode.scenario`, or a text of ``[[torque]]`` tables, as scenarios have them.

    The bits do not depend on the number of threads, nor on which members there are beside one.

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
        self._torques = torques if isinstance(torques, str) else text_of_torques(torques)
        self._native = _of(self._arguments, self._torques)
        warn_of(findings_of(self._native.findings))

    def at(
        self, times: npt.ArrayLike, *, threads: int | None = None, tolerance: float = 1e-13
    ) -> EnsembleStates:
        """All members at times (t,), ascending, s, none before the start.

        Each member is computed by the best method there is: a closed form, else Taylor's method, else DOP853, within ``tolerance`` a step.
        ``threads``: all processors that this process may use unless you say otherwise. There is no estimate of the error: :func:`simulate`
        has one for each of its motions.

        A member that cannot go on stays where it was last good; it is among ``failures``, and there is a :class:`PolhodeWarning`.
        """
        rows, failures = self._native.at(
            _arrays.numbers("times", times, ("t",)),
            _threads.available() if threads is None else _arrays.count("threads", threads),
            _arrays.positive("tolerance", tolerance),
        )
        states = EnsembleStates(rows, [Failure(*failure) for failure in failures])
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
        self._native = _of(self._arguments, self._torques)

    def __len__(self) -> int:
        return len(self._native)

    def __repr__(self) -> str:
        return f"Ensemble({len(self)} members)"


def _each(name: str, value: object, shape: tuple[int, ...]) -> Floats:
    """A row for each member, or one for all."""
    check = _arrays.quaternions if name == "attitude" else _arrays.numbers
    given = np.asarray(value.as_quat()) if hasattr(value, "as_quat") else _arrays.real(name, value)
    if given.ndim == len(shape):
        return check(name, value, shape)[None]
    return check(name, value, ("n", *shape))


def _of(given: dict[str, Floats], torques: str) -> _native.Ensemble:
    """Of rows for each member, or of one for all."""
    count = next((len(rows) for rows in given.values() if len(rows) != 1), 1)
    tensors = given["moments"][:, :, None] * np.eye(3) if "moments" in given else given["inertia"]

    def each(rows: Floats) -> Floats:
        return rows if len(rows) == count else np.repeat(rows, count, axis=0)

    return _native.Ensemble.of(each(tensors.reshape(-1, 9)), each(given["omega"]), each(given["attitude"]), torques)
