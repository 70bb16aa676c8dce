#!/usr/bin/env bash
# Runs all targets, or those named, for SECONDS altogether:  SEEDS=… OUT=… run.sh SECONDS [TARGET …]
# OUT gets summary.txt, and log/, corpus/ and found/ with a folder for each target.
set -eu
HERE=$(cd "$(dirname "$0")" && pwd)
BIN=${BIN:-$HERE/target/x86_64-unknown-linux-gnu/release} SEEDS=${SEEDS:-$HERE/corpus} OUT=${OUT:-$HERE/out} CORES=${CORES:-$(nproc)}
TOTAL=${1:?seconds}; shift
read -ra TARGETS <<< "${*:-$(basename -a -s .rs "$HERE"/fuzz_targets/*.rs | xargs)}"
# Every core has as many turns as the others; where turns are left over, the first targets have another.
COUNT=${#TARGETS[@]} TURNS=$(((${#TARGETS[@]} + CORES - 1) / CORES))
EACH=$((TOTAL >= TURNS ? TOTAL / TURNS : 1))
mkdir -p "$OUT/log"

most() { # the longest input: what is slow beyond it finds nothing new
  case $1 in unit) echo 64 ;; expression | formula) echo 160 ;; times | xyz | particles | mol | pdb) echo 400 ;;
    obj | off | ply) echo 600 ;; stl) echo 1200 ;; gltf | threemf) echo 2500 ;; *) echo 1500 ;; esac
}

slice() { # TARGET CORE: starts again after each finding, until its time is over
  local target=$1 end=$((SECONDS + EACH)) starts=0 dict=()
  mkdir -p "$OUT/corpus/$target" "$OUT/found/$target" "$HERE/corpus/$target" "$SEEDS/$target"
  [ -s "$SEEDS/$target.dict" ] && dict=(-dict="$SEEDS/$target.dict")
  while [ $((end - SECONDS)) -gt 0 ] && [ $starts -lt 50 ]; do
    starts=$((starts + 1))
    # On one core no mesh is shared among threads: starting them would take longer than the mesh.
    taskset -c "$2" nice "$BIN/$target" -max_total_time=$((end - SECONDS)) -max_len="$(most "$target")" "${dict[@]}" -timeout=10 \
      -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix="$OUT/found/$target/" \
      "$OUT/corpus/$target" "$SEEDS/$target" "$HERE/corpus/$target" 2>&1 \
      | grep -avE '^#[0-9]+.(NEW|REDUCE|RELOAD)|NEW_FUNC' >> "$OUT/log/$target" || true
  done
}

for core in $(seq 0 $((CORES - 1))); do
  for ((k = core; k < TURNS * CORES; k += CORES)); do slice "${TARGETS[k % COUNT]}" "$core"; done &
done
wait

for target in "${TARGETS[@]}"; do
  awk -v target="$target" -v found="$(find "$OUT/found/$target" -type f | wc -l)" '
    /stat::number_of_executed_units/ { runs += $2 } /Done [0-9]+ runs in/ { seconds += $5 }
    match($0, /ft: [0-9]+/) { at = substr($0, RSTART + 4, RLENGTH - 4) + 0; if (at > features) features = at }
    END { print target, runs + 0, int(runs / (seconds ? seconds : 1)), features + 0, found }' "$OUT/log/$target"
done | awk 'BEGIN { print "target executions per_second features found" } { print; all += $2 } END { print "all", all + 0 }' \
  | column -t | tee "$OUT/summary.txt"
