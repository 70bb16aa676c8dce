"""Computation of the parts of a sweep on a Ray cluster."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING, Any, Iterator

import ray
import ray.exceptions

from ._cluster import LOOK, LOST_WORKERS, Watch, lost
from .batch import Plan, compute

if TYPE_CHECKING:
    from ._parts import Done, Parts

#: Number of parts on the cluster for each processor: one being computed, and one ready to start.
AHEAD = 2


def parts(address: str, plan: Plan, missing: Parts, workers: int, worker_timeout: float | None) -> Iterator[Done]:
    """Yields the missing parts as they are done.

    Ray computes a part again if its worker is lost.
    """
    on = f"ray://{address}"
    # Errors are reported here instead.
    quiet: dict[str, Any] = {"log_to_driver": False, "logging_level": logging.ERROR}
    if address == "local":
        # On a busy machine Ray's own processes may start more slowly than its default timeout
        # allows.
        patient = {"agent_register_timeout_ms": 120_000}
        ray.init(num_cpus=workers, include_dashboard=False, _node_ip_address="127.0.0.1", _system_config=patient, **quiet)
    else:
        try:
            ray.init(on, **quiet)
        except ConnectionAbortedError as error:
            # The message is a traceback of Ray's proxy, which starts a server for each client.
            why = str(error).strip().splitlines()[-1]
            hint = "start its head with GRPC_ENABLE_FORK_SUPPORT=0 in the environment, and try again"
            raise ConnectionError(f"{on} did not start a server for this client: {why}; {hint}") from error
        except ConnectionError as error:
            # Ray gives the same message if the client has no token and the head refuses its calls.
            hint = "check that its client port is open and, if it requires a token, that RAY_AUTH_MODE=token is set here"
            raise ConnectionError(f"{on} does not answer: {error}; {hint}") from error
    try:
        remote: Any = ray.remote(num_cpus=1, max_retries=LOST_WORKERS)(compute)
        sent = ray.put(plan)
        watch = Watch(on, worker_timeout, _processors)
        left = iter(missing.items())
        waiting: dict[Any, int] = {}
        while True:
            # Limit the parts in progress to what the cluster computes, so that unwritten results
            # fit into its memory.
            for number, (start, stop) in _some(left, AHEAD * max(1, _processors()) - len(waiting)):
                waiting[remote.remote(sent, start, stop)] = number
            if not waiting:
                return
            done, _ = ray.wait(list(waiting), timeout=LOOK)
            if not done:
                watch.look()
            for answer in done:
                yield (waiting.pop(answer), *ray.get(answer))
    except ray.exceptions.RayTaskError as error:
        # Raise the original exception, without Ray's wrapper.
        raise getattr(error, "cause", None) or error from error
    except (ConnectionError, ray.exceptions.RaySystemError) as error:
        raise lost(on, f"it does not answer ({type(error).__name__})") from error
    finally:
        ray.shutdown()


def _processors() -> int:
    return int(ray.cluster_resources().get("CPU", 0))


def _some(items: Iterator[Any], count: int) -> Iterator[Any]:
    """Yields up to ``count`` of the next items."""
    return (item for _, item in zip(range(count), items))
