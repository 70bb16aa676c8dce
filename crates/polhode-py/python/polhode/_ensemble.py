"""Ensembles of many bodies."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _rotation
from ._actions import Actions, Functions, Torques
from ._arrays import Floats
from ._body import Body, is_body, whole
from ._ensemble_states import EnsembleStates, Failure, Stop
from ._deprecated import Former
from ._error import PolhodeError, warn
from ._mass_properties import MassProperties, findings_of, warn_of
from ._motion import EventOccurrence
from ._public import public
from ._record import same
from ._scenario import Scenario
from .scenario import Event, Orbit, Wheel


@public()
class Ensemble:
    """Many bodies that move independently of each other, free or held at a pivot.

    Torques, wheels and events are shared by all members, or given for each.

    Results are bit-identical for any number of threads, and whichever other members there are.

    Parameters
    ----------
    body
        :class:`MassProperties` or :class:`Body` of the n members. In this and the following
        arguments, a value that all members share may be given once.
    omega
        Angular velocities at t = 0 (n, 3), body axes, rad/s.
    moments
        Instead of ``body``, if mass and centre of mass do not matter: moments (n, 3) about the axes
        x, y and z, kg·m².
    inertia
        Instead of ``body``: tensors (n, 3, 3) about the centres of mass, kg·m². Mass properties are
        also accepted, as in ``body``.
    pivot
        Fixed points of the bodies (n, 3), body axes, m. Without a pivot here or in
        :class:`polhode.scenario.Gravity`, the bodies are free.
    attitude
        Attitudes at t = 0, which take body components to space components: quaternions (n, 4),
        matrices (n, 3, 3), or a ``scipy.spatial.transform.Rotation`` of n.
    torques
        Torques of :mod:`polhode.scenario`, all of which act on each member; or a text of
        ``[[torque]]`` tables, as in scenario files; or a list of n such lists, one for each member.
        A :class:`polhode.scenario.FunctionTorque` is called for one member at a time. If it is
        ``vectorized``, it is called once for all members at each stage of their steps. Its
        exceptions are raised here, because it is called once at the start, or by :meth:`at`.
    wheels
        A list of :class:`polhode.scenario.Wheel`, all of which spin in each member, or a list of n
        such lists.
    events
        A list of :class:`polhode.scenario.Event` to detect in each member, or a list of n such
        lists. An event that stops a member stops no other. A member with events is computed alone,
        as in :func:`simulate`, and a ``vectorized`` function is called for it alone. The measure of
        an event may be a function, whose exceptions :meth:`at` raises.
    orbit
        The :class:`polhode.scenario.Orbit` on which torques depend: one for all members, or a list
        of n.

    Raises
    ------
    PolhodeError
        If a body is not physical; the message names the member.

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

    Tops of three radii, until their inclination reaches 40°:

    >>> from polhode import shapes
    >>> from polhode.scenario import Event, Gravity
    >>> tops = [
    ...     shapes.cylinder(radius=radius, length=0.009, material="brass").placed(position=[0, 0, 0.038])
    ...     for radius in (0.02, 0.026, 0.032)
    ... ]
    >>> spun = polhode.Ensemble(
    ...     tops,
    ...     omega=[0.0, 0.0, 150.0],
    ...     attitude=[np.cos(0.25), np.sin(0.25), 0.0, 0.0],
    ...     pivot=[0.0, 0.0, 0.0],
    ...     torques=[Gravity()],
    ...     events=[Event(name="leans", measure="nutation", value="40 deg", then="stop")],
    ... )
    >>> states = spun.at([0.0, 5.0])
    >>> [ending.kind for ending in states.endings]
    ['stopped', 'stopped', 'complete']
    >>> states.event_times("leans").round(4)
    array([0.0596, 0.0675,    nan])
    """

    def __init__(
        self,
        body: MassProperties | Body | Sequence[MassProperties | Body] | None = None,
        *,
        omega: npt.ArrayLike,
        moments: npt.ArrayLike | None = None,
        inertia: npt.ArrayLike | MassProperties | Body | Sequence[MassProperties | Body] | None = None,
        pivot: npt.ArrayLike | None = None,
        attitude: object = (1.0, 0.0, 0.0, 0.0),
        torques: Torques = "",
        wheels: Sequence[Wheel] | Sequence[Sequence[Wheel]] = (),
        events: Sequence[Event] | Sequence[Sequence[Event]] = (),
        orbit: Orbit | Sequence[Orbit] | None = None,
    ) -> None:
        if sum(given is not None for given in (body, moments, inertia)) != 1:
            raise PolhodeError("give exactly one of body, moments and inertia")
        given = {"omega": _each("omega", omega, (3,)), "attitude": _each("attitude", attitude, (4,))}
        if body is not None or _is_of_bodies(inertia):
            name = "inertia" if body is None else "body"
            given |= _numbers_of(_bodies(name, inertia if body is None else body))
        elif moments is not None:
            given["moments"] = _each("moments", moments, (3,))
        else:
            given["inertia"] = _arrays.symmetric("inertia", _each("inertia", inertia, (3, 3)))
        if pivot is not None:
            given["pivot"] = _each("pivot", pivot, (3,))
        self._actions = Actions.of(torques=torques, wheels=wheels, events=events, orbit=orbit)
        rows = {"body" if name == "mass" else name: len(rows) for name, rows in given.items() if name != "center_of_mass" and not ("mass" in given and name == "inertia")}
        counts = {name: count for name, count in (rows | self._actions.counts()).items() if count != 1}
        if len(set(counts.values())) > 1:
            said = ", ".join(f"{name} has {count}" for name, count in counts.items())
            raise PolhodeError(f"{said}: give one for each member, or one for all")
        # Copies for pickling, because the caller may change the originals.
        self._arguments = {name: rows.copy() for name, rows in given.items()}
        self._count = next(iter(counts.values()), 1)
        self._scenarios: tuple[Scenario, ...] | None = None
        self._native = self._made()
        warn_of(findings_of(self._native.findings))

    @classmethod
    def from_scenarios(cls, scenarios: Iterable[Scenario]) -> Ensemble:
        """Makes an ensemble of scenarios, one for each member.

        A member has the start, the constraint, the torques and the events of its scenario. The
        arguments of :meth:`at` replace the settings of ``run``. The title, the pointings, the axis
        of a pendulum and the velocity of the centre of mass have no effect on the rotation.

        Parameters
        ----------
        scenarios
            Scenarios of the members.

        Returns
        -------
        Ensemble
            Ensemble of bodies that are free or held at a pivot.

        Raises
        ------
        PolhodeError
            If a body is on the ground, in gimbals or on a shaft, if its mass changes, if its motion
            is prescribed, or if a ``run`` has its own method or tolerance. The message names the
            member.

        Examples
        --------
        >>> import numpy as np, polhode
        >>> from polhode.scenario import Drag, Event, Run, Start
        >>> body = polhode.MassProperties(mass=2.0, inertia=[1.0, 2.0, 2.5])
        >>> slow = Event(name="slow", measure="omega", value=1.0, then="stop")
        >>> braked = [
        ...     polhode.Scenario(body, start=Start(omega=[0.1, 0.2, 3.0]), torques=[Drag(law="linear", coefficient=c)], events=[slow], run=Run(duration=9.0))
        ...     for c in (0.2, 0.4, 0.8)
        ... ]
        >>> states = polhode.Ensemble.from_scenarios(braked).at([0.0, 9.0])
        >>> states.event_times("slow").round(3)
        array([  nan, 6.874, 3.437])
        >>> bool(states.event_times("slow")[2] == polhode.simulate(braked[2]).ending.time)
        True
        """
        self = cls.__new__(cls)
        self._scenarios = _scenarios_of(scenarios)
        self._arguments, self._actions, self._count = {}, Actions.of(torques=(), wheels=(), events=(), orbit=None), len(self._scenarios)
        self._native = self._made()
        warn_of(findings_of(self._native.findings))
        return self

    of = Former("Ensemble.of", "from_scenarios")

    def at(
        self, times: npt.ArrayLike, *, threads: int | None = None, tolerance: float = 1e-13, method: str = "auto"
    ) -> EnsembleStates:
        """Computes the states of all members at times (t,), s.

        By default each member is computed by the best applicable method: a closed form, else
        Taylor's method, else DOP853, with ``tolerance`` per step. If torques are Python functions,
        one thread is used. The error is not estimated: :func:`simulate` estimates it for a single
        motion.

        Events are detected up to the last time. A member that an event stops keeps the state of the
        event; see ``stops``. A member whose computation fails keeps its last good state. It is
        listed in ``failures``, and a :class:`PolhodeWarning` is issued.

        Parameters
        ----------
        times
            Times (t,), s, ascending, none before the start.
        threads
            Number of threads; the default is all processors available to this process, where the
            work is worth it.
        tolerance
            Relative error tolerance per step, for members that are integrated.
        method
            ``"auto"``, ``"exact"``, ``"taylor"`` or ``"dop853"``. Preparing a closed form takes
            some 3 µs a member. For free bodies that are computed once, over less than about a turn,
            ``"taylor"`` takes a third of the time, with an error of ``tolerance``. A member for
            which the method is not possible fails.

        Returns
        -------
        EnsembleStates
            Angular velocities (n, t, 3) and attitudes (n, t, 4), and the events.

        Raises
        ------
        PolhodeError
            If an argument is invalid; the message names the argument, the element and the rule.
        """
        asked = _arrays.numbers("times", times, ("t",))
        rows, failures, stops, happened = self._native.at(
            asked,
            None if threads is None else _arrays.count("threads", threads),
            _arrays.positive("tolerance", tolerance),
            _arrays.choice("method", method, ["auto", "exact", "taylor", "dop853"]),
        )
        found = [(member, EventOccurrence(name, time, rising, tuple(omega), tuple(wxyz))) for member, name, time, rising, omega, wxyz in happened]
        states = EnsembleStates(asked.copy(), rows, [Failure(*failure) for failure in failures], [Stop(*stop) for stop in stops], found)
        if states.failures:
            first = states.failures[0]
            message = f"{len(failures)} of {len(self)} members failed; the first is {first.member}: {first.cause}"
            warn(message)
        return states

    def _made(self) -> _native.Ensemble:
        """Makes the native ensemble. The same arguments give the same bodies, bit for bit."""
        functions = Functions()
        if self._scenarios is not None:
            members = [(one._path, one._text(), functions.placed(one.torques, one.events)) for one in self._scenarios]
            return _native.Ensemble.of_scenarios(members, functions.native)
        given = self._arguments
        tensors = given["moments"][:, :, None] * np.eye(3) if "moments" in given else given["inertia"]

        def each(rows: Floats) -> Floats:
            return rows if len(rows) == self._count else np.repeat(rows, self._count, axis=0)

        known = (each(given["mass"]), each(given["center_of_mass"])) if "mass" in given else None
        pivots = each(given["pivot"]) if "pivot" in given else None
        texts = self._actions.texts(functions)
        bodies = (known, each(tensors.reshape(-1, 9)))
        try:
            return _native.Ensemble.of(bodies, pivots, each(given["omega"]), each(given["attitude"]), texts, functions.native)
        except PolhodeError as error:
            raise self._actions.placed(error) from None

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "_native"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self._native = self._made()

    def __len__(self) -> int:
        return len(self._native)

    def __eq__(self, other: object) -> bool:
        """Returns true if the bodies (given in the same way), starts, torques, wheels and events
        are equal, or the scenarios."""
        if not isinstance(other, Ensemble):
            return NotImplemented
        one, two = self._arguments, other._arguments
        same_actions = self._actions == other._actions and self._scenarios == other._scenarios
        return same_actions and one.keys() == two.keys() and all(same(one[name], two[name]) for name in one)

    def __hash__(self) -> int:
        return hash((Ensemble, len(self)))

    def __repr__(self) -> str:
        return f"Ensemble({len(self)} members)"


def _each(name: str, value: Any, shape: tuple[int, ...]) -> Floats:
    """Returns a row for each member, or one row for all."""
    check, ndim = _arrays.numbers, len(shape)
    if name == "attitude":
        # A matrix (3, 3) has one axis more than a quaternion.
        given = _rotation.rotations(name, value)
        check, ndim = _rotation.quaternions, 2 if given.ndim > 1 and given.shape[-2:] == (3, 3) else 1
    else:
        given = _arrays.real(name, value)
    return check(name, given, shape)[None] if given.ndim == ndim else check(name, given, ("n", *shape))


def _is_of_bodies(value: object) -> bool:
    """Returns true if the value is a body, or a list that begins with one."""
    return is_body(value) or isinstance(value, (list, tuple)) and len(value) > 0 and is_body(value[0])


def _bodies(name: str, value: object) -> list[MassProperties]:
    """Returns the bodies of all members, or one for all."""
    if is_body(value):
        return [whole(name, value)]
    if isinstance(value, (str, bytes, Mapping, np.ndarray)) or not isinstance(value, Iterable):
        raise TypeError(f"{name} must be MassProperties or a Body, or a list of these, not {_arrays.kind_of(value)}")
    found = [whole(f"{name}[{k}]", one) for k, one in enumerate(value)]
    if not found:
        raise PolhodeError(f"{name} is an empty list: at least one body is required")
    return found


def _numbers_of(bodies: list[MassProperties]) -> dict[str, Floats]:
    """Returns the mass, centre of mass and tensor of each body, a row each."""
    return {
        "mass": np.array([body.mass for body in bodies]),
        "center_of_mass": np.array([body.center_of_mass for body in bodies]),
        "inertia": np.array([body.inertia for body in bodies]),
    }


def _scenarios_of(scenarios: object) -> tuple[Scenario, ...]:
    if isinstance(scenarios, (str, bytes, Mapping)) or not isinstance(scenarios, Iterable):
        raise TypeError(f"scenarios must be a list of polhode.Scenario, not {_arrays.kind_of(scenarios)}")
    found = tuple(scenarios)
    for k, one in enumerate(found):
        if not isinstance(one, Scenario):
            raise TypeError(f"scenarios[{k}] must be a polhode.Scenario, not {_arrays.kind_of(one)}")
    return found
