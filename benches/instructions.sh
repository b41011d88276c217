#!/usr/bin/env bash
# Counts instructions per step (benches/instructions.rs), built for the processors that the limits were taken on.
# The table that stands beside this file:
#
#     bash benches/instructions.sh >benches/instructions.txt
set -euo pipefail
cd "$(dirname "$0")/.."

command -v valgrind >/dev/null || { echo "valgrind is needed (apt-get install valgrind)" >&2; exit 1; }
RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench --quiet --bench instructions \
    --target-dir "${CARGO_TARGET_DIR:-target}/x86-64-v3" "$@"
