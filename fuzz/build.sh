#!/usr/bin/env bash
# Builds the targets as cargo-fuzz does without a sanitizer (the crates have no unsafe code of their own), with any toolchain and a C++ compiler.
set -e
cd "$(dirname "$0")"
export RUSTFLAGS="--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
  -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
  -Cllvm-args=-sanitizer-coverage-trace-compares"
cargo build --release --target x86_64-unknown-linux-gnu "$@"
echo "built in fuzz/target/x86_64-unknown-linux-gnu/release"
