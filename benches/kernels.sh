#!/usr/bin/env bash
# Generated code beside kernels written by hand (benches/kernels.rs), for processors with AVX2: without and with fused
# multiply-add. Times are the best of many in one process; the counts need valgrind. The table that stands beside this file:
#
#     bash benches/kernels.sh >benches/kernels.txt
set -euo pipefail
cd "$(dirname "$0")/.."

command -v valgrind >/dev/null || { echo "valgrind is needed (apt-get install valgrind)" >&2; exit 1; }
export RUSTFLAGS="-C target-cpu=x86-64-v3"
target="${CARGO_TARGET_DIR:-target}/x86-64-v3"
for features in std fma; do
    bench() { cargo bench --quiet --bench kernels --features "$features" --target-dir "$target" -- "$@"; }
    bench check
    bench
    bench instructions
done
