"""Parts of a sweep, between the process that writes and the engines that compute."""

import pyarrow as pa

#: Numbers of parts, with their first members and the ones after their last.
Parts = dict[int, tuple[int, int]]

#: A part that is done: its number, its rows, and its trajectories if the plan wants them.
Done = tuple[int, pa.RecordBatch, "pa.RecordBatch | None"]
