"""Torques and event measures that are Python functions: for one body, or for many at once."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple

import numpy as np

from . import _arrays
from ._arrays import Floats
from ._attitude import Turned
from ._error import PolhodeError
from ._traced_function import asked, positional

#: Function of one body as Rust calls it: the function, the parts of the state in the order of its
#: arguments, and the conversion of its result, which also takes the time.
Called = tuple[Callable[..., Any], list[str], Callable[[Any, float], Any]]

#: Largest difference between the torque of a member alone and among others, relative to the
#: greatest torque. Sums of different lengths round differently.
ALONE = 1e-9


def computed(function: Any) -> Called:
    """Returns the function of a torque as Rust calls it."""
    return *_given(function, asked(function)), _checked


def measured(function: Any) -> Called:
    """Returns the function of an event as Rust calls it."""

    def checked(value: Any, t: float) -> float:
        return _arrays.number(f"what an event measures at t = {t} s", value)

    return *_given(function, asked(function)), checked


def _checked(found: Any, _time: float) -> list[float]:
    torque = _arrays.real("the torque of a function", found)
    if torque.shape != (3,):
        raise PolhodeError(f"the function must return three components, of shape (3,), not {torque.shape}")
    components: list[float] = torque.tolist()
    return components


def _given(function: Any, names: list[str]) -> tuple[Callable[..., Any], list[str]]:
    """Returns a function of parts of the state, and their names in the order of its arguments.

    The attitude is made from its quaternion.
    """
    called = positional(function, names)
    if "attitude" not in names:
        return called, names
    place = names.index("attitude")

    def of(*given: Any) -> Any:
        return called(*given[:place], Turned(given[place]), *given[place + 1 :])

    return of, ["quaternion" if name == "attitude" else name for name in names]


def needs_momentum(function: Any) -> bool:
    """Returns true if a function takes L, which depends on the body."""
    return any(name.startswith("momentum") for name in asked(function))


def computed_of_many(function: Any) -> Callable[..., Floats]:
    """Returns a vectorised function as one of times (n,), ω (n, 3), quaternions (n, 4), L (n, 3)
    and members (n,), body axes."""
    called, names = _given(function, asked(function, vectorized=True))

    def rows(state: State) -> Floats:
        torque = _arrays.real("the torque of a function", called(*(getattr(state, name) for name in names)))
        if torque.shape != (len(state.t), 3):
            rule = f"a vectorised function must return a row for each member, of shape ({len(state.t)}, 3)"
            raise PolhodeError(f"{rule}, not {torque.shape}")
        return torque

    is_known = False

    def of(*given: Any) -> Floats:
        nonlocal is_known
        state = State(*given)
        # A function may modify the arrays that it receives.
        last = None if is_known or len(state.t) < 2 else State(*(array[-1:].copy() for array in given))
        found = rows(state)
        if last is not None:
            # A function written for one body may take a row for a component, and still return the right
            # shape.
            alone = rows(last)
            if np.isfinite(found).all() and not np.abs(alone - found[-1:]).max() <= ALONE * np.abs(found).max():
                rule = "the torque of a member must not depend on other members"
                raise PolhodeError(f"the torque of member {state.member[-1]} is {alone[0]} alone and {found[-1]} among others: {rule}")
            is_known = True
        return found

    return of


def computed_of_one(function: Any) -> Called:
    """Returns a vectorised function as Rust calls it for one body."""
    many = computed_of_many(function)

    def of(t: float, omega: Floats, quaternion: Floats, momentum: Floats) -> list[float]:
        alone = (np.array([t]), omega[None], quaternion[None], momentum[None], np.array([0]))
        components: list[float] = many(*alone)[0].tolist()
        return components

    return of, ["t", "omega", "quaternion", "momentum"], _checked


class State(NamedTuple):
    """Rows of states of many bodies, by the names of the parameters of functions."""

    t: Any
    omega: Floats
    quaternion: Floats
    momentum: Floats
    member: Any

    @property
    def omega_space(self) -> Any:
        return Turned(self.quaternion).apply(self.omega)

    @property
    def momentum_space(self) -> Any:
        return Turned(self.quaternion).apply(self.momentum)
