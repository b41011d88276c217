#!/usr/bin/env bash
# FMUs of FMI 3.0 and 2.0 by FMPy: validated, run in both modes, compared with Rust (tests/fmu/check.py, two.py and, of FMUs with
# sources, crates/plm-source/tests/fmu.py say what they look at). Makes a virtual environment of Python in target/tools and installs FMPy there, half a minute once. Where the tests are built as CI
# builds them, all the rest takes three quarters of a minute. What is missing is said, and not checked.
#
#   bash tests/fmu.sh               # a hundred thousand steps for the memory
#   bash tests/fmu.sh 1000000       # a million
#   bash tests/fmu.sh --second      # by another importer, fmi-sim, which takes some minutes to build once
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
tools=$target/tools/fmpy
version=0.3.32
started=$SECONDS
if ! "$tools/bin/python" -c "import fmpy; assert fmpy.__version__ == '$version'" 2>/dev/null; then
    if ! python3 -m venv "$tools" || ! "$tools/bin/pip" install --quiet --disable-pip-version-check "fmpy==$version" cmake; then
        printf 'NOT CHECKED: FMPy cannot be had on this machine (python3 with venv and pip)\n'
        exit 0
    fi
fi

# fmi-sim binds the standard's headers by libclang, which Python's registry has.
second() {
    local sim=0.7.0 own=$target/tools/fmi-sim made=$target/tmp libclang
    if [ "$("$own/bin/fmi-sim" --version 2>/dev/null)" != "fmi-sim $sim" ]; then
        "$tools/bin/pip" install --quiet --disable-pip-version-check libclang
        libclang=$(find "$tools" -name 'libclang*.so*' -print -quit)
        LIBCLANG_PATH=${libclang%/*} BINDGEN_EXTRA_CLANG_ARGS="-I$(gcc -print-file-name=include)" \
            cargo install fmi-sim --version "$sim" --locked --debug --root "$own" --target-dir "$own/build"
    fi
    env -u PLM_PYTHON cargo test --workspace --features analysis,batch,lanes --test foreign -- an_fmu
    for fmu in press press2; do
        "$tools/bin/python" tests/fmu/second.py "$own/bin/fmi-sim" "$made/fmu/$fmu.fmu" "$made/fmu/press.csv"
    done
}
if [ "${1:-}" = --second ]; then
    second
    exit
fi

export PLM_PYTHON=$tools/bin/python PLM_FMU_STEPS=${1:-100000}
for test in an_fmu two_fmus; do
    cargo test --workspace --features analysis,batch,lanes --test foreign -- "$test" --nocapture
done
# Those with sources, which FMPy compiles.
cargo test -p plm-source --test fmu -- --nocapture
printf 'the FMUs are as FMI wants them; %d s\n' $((SECONDS - started))
