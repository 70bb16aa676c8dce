"""Parts of a sweep on a Ray cluster."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator

import pyarrow as pa
import ray
import ray.data
import ray.exceptions

from ._cluster import LOOK, Watch, lost
from .batch import Plan, compute

if TYPE_CHECKING:
    from ._parts import Done, Parts


def parts(address: str, plan: Plan, missing: Parts, workers: int, worker_timeout: float | None) -> Iterator[Done]:
    """The missing parts as they are done. A part that is lost with its worker is computed again: by Ray, which knows how."""
    on = f"ray://{address}"
    if address == "local":
        ray.init(num_cpus=workers, include_dashboard=False, log_to_driver=False, _node_ip_address="127.0.0.1")
    else:
        ray.init(on, log_to_driver=False)
    try:
        listed = [{"part": part, "start": start, "stop": stop} for part, (start, stop) in missing.items()]
        remote: Any = ray.remote(num_cpus=0)(_Reader)
        reader = remote.remote(plan, listed)
        watch = Watch(on, worker_timeout, lambda: int(ray.cluster_resources().get("CPU", 0)))
        while (rows := _waited(reader.next.remote(), watch)) is not None:
            for row in rows.to_pylist():
                motions = row["trajectories"]
                yield row["part"], _unpacked(row["rows"]), None if motions is None else _unpacked(motions)
    except (ConnectionError, ray.exceptions.ActorDiedError, ray.exceptions.RaySystemError) as error:
        raise lost(on, f"it does not answer ({type(error).__name__})") from error
    finally:
        ray.shutdown()


def _waited(answer: ray.ObjectRef, watch: Watch) -> pa.Table | None:
    """An answer of the cluster, with a look at its workers now and then."""
    while True:
        try:
            return ray.get(answer, timeout=LOOK)
        except ray.exceptions.GetTimeoutError:
            watch.look()


class _Reader:
    """Lives in the cluster, as Ray Data has no results for a client outside it; hands them out as they are done."""

    def __init__(self, plan: Plan, listed: list[dict[str, int]]) -> None:
        work = ray.data.from_items(listed, override_num_blocks=len(listed))
        done = work.map_batches(lambda rows: _parts(plan, rows), batch_size=1, batch_format="pyarrow")
        self._done = iter(done.iter_batches(batch_size=1, batch_format="pyarrow"))

    def next(self) -> pa.Table | None:
        return next(self._done, None)


def _parts(plan: Plan, rows: pa.Table) -> pa.Table:
    """Parts by their members; each is packed whole, so that Ray neither cuts it nor forgets what its columns are."""
    packed = []
    for row in rows.to_pylist():
        members, motions = compute(plan, row["start"], row["stop"])
        packed.append(
            {"part": row["part"], "rows": _packed(members), "trajectories": None if motions is None else _packed(motions)}
        )
    schema = pa.schema([("part", pa.int64()), ("rows", pa.large_binary()), ("trajectories", pa.large_binary())])
    return pa.Table.from_pylist(packed, schema=schema)


def _packed(rows: pa.RecordBatch) -> bytes:
    sink = pa.BufferOutputStream()
    with pa.ipc.new_stream(sink, rows.schema) as stream:
        stream.write_batch(rows)
    return bytes(sink.getvalue())


def _unpacked(packed: bytes) -> pa.RecordBatch:
    with pa.ipc.open_stream(packed) as stream:
        return stream.read_next_batch()
