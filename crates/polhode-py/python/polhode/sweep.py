"""Sweeps: computation of all members of a plan into a folder, locally or on a cluster.

Requires PyArrow.

``polhode sweep --on`` calls ``python -m polhode.sweep PLAN.toml -o DIR --on dask://HOST:PORT``.

The division of the folder into parts depends only on the plan. A cluster computes the missing
parts, each a pure function of the plan and the part's members. This process writes them, durably
and with the same code as without a cluster, so the files are byte-identical whatever happens to
workers. The engine, Dask or Ray, assigns parts to workers and repeats those of lost workers. A part
that Dask gives up is submitted again, within ``_cluster.LOST_WORKERS``.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import warnings
from typing import Any, Callable, Iterator, NamedTuple, Sequence

from . import _arrays, _cluster, _html, _native, batch
from ._error import PolhodeError, PolhodeWarning
from ._units import Quantity
from .batch import Plan

import pyarrow as pa  # after batch, whose error explains the installation
from ._parts import Done, Parts

#: Engines, and the packages that pip must install for them.
_ENGINES = {"dask": "distributed", "ray": "ray[data,client]"}


class Summary(NamedTuple):
    """Summary of a sweep."""

    #: Contents of ``summary.json``.
    summary: dict[str, Any]
    #: Summary as text.
    text: str

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return _html.text(self.text)


def run(
    plan: Plan | str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    on: str | None = None,
    threads: int | None = None,
    workers: int | None = None,
    resume: bool = False,
    force: bool = False,
    progress: Callable[[int, int], object] = lambda done, members: None,
    worker_timeout: Quantity | None = 600.0,
) -> Summary:
    """Computes the members of a plan into the folder ``output``.

    Parameters
    ----------
    plan
        Plan, or path of its file.
    output
        Folder for the results.
    on
        Where to compute: ``None`` for threads of this process, ``"dask://HOST:PORT"`` or
        ``"ray://HOST:PORT"`` for a cluster, and ``"dask://local"`` or ``"ray://local"`` for a
        cluster that is started on this machine and ends with the sweep.
    threads
        Number of threads of this process. The default is all processors available to it.
    workers
        Number of processes of a local cluster. The default is all processors available to this
        process.
    resume
        If true, continues with existing results.
    force
        If true, deletes existing results.
    progress
        Function that receives the number of finished members and the number of all members.
    worker_timeout
        Time without a worker after which the sweep gives up, s; ``None`` for no limit. A warning
        is issued earlier.

    Returns
    -------
    Summary
        Summary of the results.

    Raises
    ------
    PolhodeError
        If an argument or the plan is invalid.
    ConnectionError
        If the cluster is lost. Finished parts are kept.
    TimeoutError
        If the cluster has had no worker for ``worker_timeout``. Finished parts are kept.
    """
    plan = plan if isinstance(plan, Plan) else Plan(_arrays.path("plan", plan))
    if all([_arrays.truth("resume", resume), _arrays.truth("force", force)]):
        raise PolhodeError("resume and force are both given: resume continues the earlier results, force deletes them")
    timeout = None if worker_timeout is None else _arrays.positive("worker_timeout", worker_timeout)
    engine = None if on is None else _engine(on, timeout)
    if threads is not None and on is not None:
        raise PolhodeError("threads have no effect on a cluster: each worker has one thread", "set the number of processes by workers")
    if workers is not None and on is None:
        raise PolhodeError("workers have no effect without a cluster", "set the number of threads by threads, or a cluster by on")
    name, given = ("threads", threads) if on is None else ("workers", workers)
    count = _native.available_threads() if given is None else _arrays.count(name, given)
    if not callable(progress):
        raise TypeError(f"progress must be a function of two numbers, not {type(progress).__name__}")
    folder = _arrays.path("output", output)
    dataset = _native.Dataset.open(folder, plan._native, "resume" if resume else "replace" if force else "create")
    try:
        if engine is None:
            dataset.compute(plan._native, count, progress)
        else:
            parts = {part: dataset.rows(part) for part in dataset.missing()}
            done = plan.members - sum(stop - start for start, stop in parts.values())
            for part, rows, motions in engine(plan, parts, count) if parts else ():
                if motions is not None:
                    dataset.write_trajectories(part, batch._columns(motions))
                dataset.write(part, batch._columns(rows))
                done += rows.num_rows
                progress(done, plan.members)
        summary, text = dataset.finish(plan._native, _native.available_threads())
    finally:
        # Otherwise the traceback of an error would keep the folder locked.
        del dataset
    return Summary(json.loads(summary), text)


def _engine(on: str, timeout: float | None) -> Callable[[Plan, Parts, int], Iterator[Done]]:
    """Returns the engine of an address: a function that computes parts, in any order."""
    kind, _, address = _arrays.text("on", on).partition("://")
    if kind not in _ENGINES or not address:
        raise PolhodeError(f"on = {on!r} is not a cluster", "write dask://HOST:PORT, ray://HOST:PORT, dask://local or ray://local")
    try:
        if kind == "dask":
            from ._dask import parts
        else:
            from ._ray import parts
    except ImportError as error:
        raise ImportError(f"{on} needs {error.name or kind}: pip install '{_ENGINES[kind]}'") from error
    return lambda plan, missing, workers: _cluster.in_words(on, parts(address, plan, missing, workers, timeout))


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command and returns its exit status."""
    parser = argparse.ArgumentParser(prog="python -m polhode.sweep", description="Compute a plan on a cluster or on this machine.")
    parser.add_argument("plan", metavar="PLAN", help="a TOML file with a [sweep] and a [run] section")
    parser.add_argument("-o", "--output", metavar="DIR", help="output folder [default: the plan's name, in the current folder]")
    parser.add_argument("--on", metavar="URL", help="dask://HOST:PORT, ray://HOST:PORT, dask://local or ray://local")
    parser.add_argument("--workers", "--threads", type=int, metavar="N", help="processes of a local cluster, or threads [default: all]")
    parser.add_argument(
        "--worker-timeout", type=float, default=600.0, metavar="S", help="stop if the cluster has no worker for S seconds [default: 600]"
    )
    parser.add_argument("--resume", action="store_true", help="continue an interrupted sweep, or start it")
    parser.add_argument("--force", action="store_true", help="delete the results of an earlier sweep")
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    given = parser.parse_args(arguments)
    output = given.output or os.path.splitext(os.path.basename(given.plan))[0]

    def show(done: int, members: int) -> None:
        if sys.stderr.isatty():
            print(f"\r\x1b[K{100 * done // members:3} %   {done} of {members} members", end="", file=sys.stderr, flush=True)

    clear = "\r\x1b[K" if sys.stderr.isatty() else ""

    def say(message: Warning | str, *_: object, **__: object) -> None:
        print(f"{clear}warning: {message}", file=sys.stderr, flush=True)

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", PolhodeWarning)
            warnings.showwarning = say
            found = run(
                given.plan,
                output,
                on=given.on,
                **{"workers" if given.on else "threads": given.workers},
                resume=given.resume,
                force=given.force,
                progress=show,
                worker_timeout=given.worker_timeout,
            )
    except PolhodeError as error:
        print(f"{clear}error: {error._as_command()}", file=sys.stderr)
        return 2
    except (OSError, ImportError) as error:
        print(f"{clear}error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print(f"\nstopped: finished parts are in {output}; continue with --resume", file=sys.stderr)
        return 130
    print(clear, end="", file=sys.stderr)
    print(json.dumps(found.summary, indent=2, ensure_ascii=False) if given.json else found.text)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
