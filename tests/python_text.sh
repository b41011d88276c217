#!/usr/bin/env bash
# The package `plm` for Python: its wheel is built here, and used in an empty environment without Rust. What is missing is said, and not
# checked.
#
#   bash tests/python_text.sh           # some minutes, most of which build the compiler and the runtime for the wheel
#   bash tests/python_text.sh --speed   # also 100 000 steps of Rk4, beside a wheel that rustc compiles where target/python-empty has one
#   PYTHON=python3.9 bash tests/python_text.sh
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TERM_COLOR=never

plm=$PWD
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
export CARGO_TARGET_DIR=$target
tools=$target/python-tools empty=$target/python-empty wheels=$target/python-wheels
if ! "${PYTHON:-python3}" -m venv --clear "$tools" ||
    ! "$tools/bin/pip" install --quiet --disable-pip-version-check maturin numpy mypy ||
    ! "${PYTHON:-python3}" -m venv --clear "$empty"; then
    printf 'NOT CHECKED: Python with maturin, NumPy and mypy cannot be had on this machine\n'
    exit
fi

cargo fmt --check --manifest-path crates/plm-python/dynamic/Cargo.toml
cargo clippy --quiet --manifest-path crates/plm-python/dynamic/Cargo.toml -- -D warnings
rm -rf "$wheels"
(cd crates/plm-python && PATH="$tools/bin:$PATH" maturin build --release --quiet --out "$wheels")
wheel=$(echo "$wheels"/plm_planar-*-abi3-*.whl)
printf 'wheel: %s, %s bytes\n' "$(basename "$wheel")" "$(stat -c %s "$wheel" 2>/dev/null || stat -f %z "$wheel")"

# No Rust on the path, no environment of this shell.
without_rust() { env -i PATH=/usr/bin:/bin HOME="$empty" "$@"; }
without_rust "$empty/bin/pip" install --quiet --disable-pip-version-check "$wheel"
without_rust "$empty/bin/python" tests/python/text/check.py "$plm"

"$tools/bin/pip" install --quiet --disable-pip-version-check --no-deps "$wheel"
cd tests/python/text
"$tools/bin/mypy" --strict --cache-dir "$target/mypy" use.py
"$tools/bin/mypy" --strict --disable-error-code import-not-found --cache-dir "$target/mypy" -p plm
"$tools/bin/python" -m mypy.stubtest plm._native

if [ "${1:-}" = --speed ]; then
    without_rust "$empty/bin/python" speed.py "$plm"
fi
