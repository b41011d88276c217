#!/usr/bin/env bash
# Counts instructions of friction (benches/contact.rs). The table that stands beside this file:
#
#     bash benches/contact.sh >benches/contact.txt
set -euo pipefail
cd "$(dirname "$0")/.."

command -v valgrind >/dev/null || { echo "valgrind is needed (apt-get install valgrind)" >&2; exit 1; }
cargo bench --quiet --bench contact "$@"
