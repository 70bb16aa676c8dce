"""Parts of a sweep, as exchanged between the writing process and the engines that compute."""

import pyarrow as pa

#: Indices of parts, with their first member and the one after their last.
Parts = dict[int, tuple[int, int]]

#: A finished part: its index, its rows, and its trajectories if the plan requests them.
Done = tuple[int, pa.RecordBatch, "pa.RecordBatch | None"]
