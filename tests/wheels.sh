#!/usr/bin/env bash
# The wheel of a release: built here, and tried without Rust in empty environments of three Pythons, the oldest and the newest that this
# machine has among them. What is missing is said, and not checked. It wants Ctrl+C, which a shell takes from what it runs in the background.
#
#     cargo xtask release wheel                       # into target/release-files
#     bash tests/wheels.sh FOLDER                     # for manylinux2014 on Linux, whose symbols zig links
#     bash tests/wheels.sh FOLDER --target TARGET …   # options of maturin in their place; a wheel for another system is not tried
#     bash tests/wheels.sh FOLDER --only-try          # the wheel of the folder
set -euo pipefail
folder=$(mkdir -p "${1:?the folder of the files}" && cd "$1" && pwd)
shift
cd "$(dirname "$0")/.."
export CARGO_TERM_COLOR=never
plm=$PWD
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
export CARGO_TARGET_DIR=$target
tools=$target/wheel-tools made=$target/wheels

if [ "${1:-}" != --only-try ]; then
    options=("$@")
    if [ ${#options[@]} = 0 ] && [ "$(uname -s)" = Linux ]; then
        options=(--zig --compatibility manylinux2014)
    fi
    packages=(maturin)
    [[ " ${options[*]} " != *" --zig "* ]] || packages=("maturin[zig]")
    scripts=bin
    [ -e "$tools/bin" ] || [ -e "$tools/Scripts" ] || "${PYTHON:-python3}" -m venv "$tools"
    [ -e "$tools/bin" ] || scripts=Scripts
    "$tools/$scripts/pip" install --quiet --disable-pip-version-check "${packages[@]}"
    rm -rf "$made"
    (cd crates/plm-python && PATH="$tools/$scripts:$PATH" maturin build --release --quiet --locked "${options[@]}" --out "$made")
    cp "$made"/*.whl "$folder"
    for wheel in "$made"/*.whl; do
        printf '%s: %s bytes\n' "$(basename "$wheel")" "$(wc -c <"$wheel")"
    done
    if [[ " ${options[*]} " == *" --target "* ]]; then
        printf 'NOT CHECKED: a wheel for another system\n'
        exit 0
    fi
fi

# Pythons of this machine, one for each version, the oldest first.
pythons() {
    local minor own
    for minor in $(seq 9 20); do
        for own in "$(command -v "python3.$minor" || true)" "$(pyenv root 2>/dev/null || true)/versions/3.$minor."*/bin/python3; do
            if [ -x "$own" ] && "$own" -c 'import ensurepip, venv' 2>/dev/null; then
                printf '%s\n' "$own"
                break
            fi
        done
    done
}
mapfile -t all < <(pythons)
[ ${#all[@]} -gt 0 ] || all=("$(command -v python3 || command -v python)")
[ ${#all[@]} -ge 3 ] || printf 'NOT CHECKED: three Pythons; this machine has %d\n' ${#all[@]}
middle=$((${#all[@]} / 2)) last=$((${#all[@]} - 1))
for own in $(printf '%s\n' "${all[0]}" "${all[$middle]}" "${all[$last]}" | uniq); do
    empty=$target/wheel-empty
    rm -rf "$empty"
    "$own" -m venv "$empty"
    scripts=bin
    [ -e "$empty/bin" ] || scripts=Scripts
    # No Rust on the path, no environment of this shell.
    without_rust() { env -i PATH=/usr/bin:/bin HOME="$empty" SYSTEMROOT="${SYSTEMROOT:-}" "$@"; }
    without_rust "$empty/$scripts/pip" install --quiet --disable-pip-version-check numpy
    without_rust "$empty/$scripts/pip" install --quiet --disable-pip-version-check --no-index --no-deps --find-links "$folder" plm-planar
    said=$(without_rust "$empty/$scripts/python" tests/python/text/check.py "$plm" | tr -d '\0') || { printf '%s\n' "$said" | tail -n 3; exit 1; }
    printf '%s: %d things hold\n' "$("$own" -V)" "$(grep -c '^holds: ' <<<"$said")"
done
