#!/usr/bin/env bash
# What `plm export` writes is built and run: the table of the program has the bytes of that of the interpreter, the wheel the bits of
# the library for C, the FMU its numbers. What is missing is said, and not checked.
#
#   bash tests/exports.sh           # some minutes, most of which build plm once with optimisation
#   PYTHON=python3.9 bash tests/exports.sh
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TERM_COLOR=never

plm=$PWD
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
tools=$target/exports-tools made=$target/exports-made declaration=$plm/tests/snapshots/bouncer.plm
if ! "${PYTHON:-python3}" -m venv --clear "$tools" ||
    ! "$tools/bin/pip" install --quiet --disable-pip-version-check maturin numpy fmpy; then
    printf 'NOT CHECKED: Python with maturin, NumPy and FMPy cannot be had on this machine\n'
    exit
fi
CARGO_TARGET_DIR=$target cargo build --quiet --package plm-cli
rm -rf "$made"
mkdir -p "$made"

# One package: the folder of its builds is that of all.
export CARGO_TARGET_DIR=$target/exports PATH="$tools/bin:$PATH"
for product in rust c fmu python; do
    "$target/debug/plm" export "$declaration" "--$product" "$made" --plm "$plm" --build >/dev/null
done

"$target/debug/plm" run "$declaration" --until 5 --csv "$made/interpreted.csv" >/dev/null
cmp "$made/interpreted.csv" "$made/outputs.csv"
gcc -O2 -Wall -Werror -I "$made/c" tests/exports/rows.c "$made/c/libbouncer.a" -lm -lpthread -ldl -o "$made/rows"
"$made/rows" >"$made/c.txt"
"$tools/bin/pip" install --quiet --disable-pip-version-check "$made"/wheels/bouncer-*.whl
"$tools/bin/python" tests/exports/compare.py "$made"
printf 'program, C, FMU and wheel have the same numbers\n'
