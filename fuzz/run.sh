#!/usr/bin/env bash
# Runs all targets, or those named, with the built fuzzer:  BIN=… SEEDS=… OUT=… run.sh SECONDS [TARGET …]
# OUT gets summary.txt (executions and findings by target), logs.tar.gz, artifacts.tar.gz, corpus.tar.gz.
set -u
HERE=$(cd "$(dirname "$0")" && pwd)
BIN=${BIN:-$HERE/polhode-fuzz} SEEDS=${SEEDS:-$HERE/seeds} OUT=${OUT:-$HERE/out} CORES=${CORES:-$(nproc)}
TOTAL=${1:-60}; shift
TARGETS=${*:-$(cd "$SEEDS" && ls -d */ | tr -d /)}
WORK=$(mktemp -d "${TMPDIR:-/tmp}/polhode-fuzz.XXXX")
mkdir -p "$OUT" "$WORK/logs" "$WORK/artifacts" "$WORK/corpus"

most() { # the longest input: what is slow beyond it finds nothing new
  case $1 in unit) echo 64;; expression | formula) echo 160;; times | xyz | particles) echo 400;;
    scenario | plan | cad) echo 2500;; *) echo 4096;; esac
}

slice() { # TARGET NUMBER SECONDS: starts again after each finding, until the time is over
  local target=$1 number=$2 end=$((SECONDS + $3)) log=$WORK/logs/$1.$2.log
  mkdir -p "$WORK/corpus/$target" "$WORK/artifacts/$target" "$SEEDS/$target"
  local dict=(); [ -f "$SEEDS/$target.dict" ] && dict=(-dict="$SEEDS/$target.dict")
  local starts=0
  while [ $((end - SECONDS)) -gt 0 ] && [ $starts -lt 200 ]; do
    starts=$((starts + 1))
    POLHODE_FUZZ_TARGET=$target "$BIN" -max_total_time=$((end - SECONDS)) -seed=$((1000 * number + starts)) -max_len="$(most "$target")" \
      "${dict[@]}" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 -verbosity=1 -use_value_profile=$((number % 2)) \
      -artifact_prefix="$WORK/artifacts/$target/" "$WORK/corpus/$target" "$SEEDS/$target" 2>&1 \
      | grep -avE '^#[0-9]+.(NEW|REDUCE|RELOAD|pulse)' >> "$log"
  done
}

# Each target has as many slices as fill the machine evenly; those whose inputs are richest are first in line for the rest.
COUNT=$(wc -w <<< "$TARGETS")
ROUNDS=$(((2 * COUNT + CORES - 1) / CORES))
SLICES=$((ROUNDS * CORES)) EACH=$((TOTAL / ROUNDS)) JOBS=()
for number in $(seq 1 $((SLICES / COUNT + 1))); do
  for target in $([ "$number" -gt $((SLICES / COUNT)) ] && echo scenario plan urdf mjcf sdf gltf 3mf voxel ply cad "$TARGETS" || echo "$TARGETS"); do
    grep -qw -- "$target" <<< "$TARGETS" && [ ${#JOBS[@]} -lt $SLICES ] && JOBS+=("$target $number")
  done
done
for job in "${JOBS[@]}"; do
  while [ "$(jobs -rp | wc -l)" -ge "$CORES" ]; do wait -n; done
  read -r target number <<< "$job"
  slice "$target" "$number" "$EACH" &
done
wait

{
  echo "target executions inputs_kept crashes timeouts oom slow"
  for target in $TARGETS; do
    runs=$(cat "$WORK/logs/$target".*.log | awk '/stat::number_of_executed_units/ {n += $2} END {print n + 0}')
    count() { find "$WORK/artifacts/$target" -name "$1-*" | wc -l; }
    echo "$target $runs $(find "$WORK/corpus/$target" -type f | wc -l) $(count crash) $(count timeout) $(count oom) $(count slow-unit)"
  done
} | tee "$OUT/summary.txt"
awk 'NR > 1 {n += $2} END {print "executions in all:", n}' "$OUT/summary.txt" | tee -a "$OUT/summary.txt"
for what in logs artifacts corpus; do tar -C "$WORK" -czf "$OUT/$what.tar.gz" "$what"; done
rm -rf "$WORK"
