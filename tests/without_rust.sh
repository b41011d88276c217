#!/usr/bin/env bash
# The recipes without Rust: the files and the commands of each page, from an empty folder, with `plm` on the path and Rust off it. What the
# commands print is what the page shows, and the angle at the end is that of `plm run` by another method.
#
#     bash tests/without_rust.sh          # PLM is the command `plm`; without it cargo builds it
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
made=$target/without-rust tools=$target/without-rust-tools
plm=${PLM:-}
if [ -z "$plm" ]; then
    cargo build --quiet -p plm-cli
    plm=$target/debug/plm
fi
rm -rf "$made"
mkdir -p "$made/bin" "$tools"
ln -s "$(realpath "$plm")" "$made/bin/plm"

# The compiler and the emulator as packages of Debian, unpacked by apt-get download.
unpack() {
    local packages=(gcc-arm-none-eabi binutils-arm-none-eabi libnewlib-arm-none-eabi libnewlib-dev qemu-system-arm qemu-system-common
        qemu-system-data libcapstone4 libdaxctl1 libfdt1 libibverbs1 libkmod2 libmpc3 libmpfr6 libgmp10 libisl23 libndctl6 libnl-3-200
        libnl-route-3-200 libpmem1 librdmacm1 libslirp0 libvdeplug2)
    apt-get download "${packages[@]}" || { apt-get update && apt-get download "${packages[@]}"; } || return
    find . -name '*.deb' -exec dpkg-deb -x {} . \; -delete && touch complete
}
[ -e "$tools/complete" ] || (cd "$tools" && unpack) >"$made/unpacked.txt" 2>&1 || true
libraries=$(find "$tools" -name '*.so*' -printf '%h\n' 2>/dev/null | sort -u | paste -sd :)
# tool NAME OPTION...: a program of these packages, as if it were installed.
tool() {
    printf '#!/bin/sh\nexport PATH="%s:$PATH" LD_LIBRARY_PATH="%s"\nexec timeout 60 %s "$@"\n' \
        "$tools/usr/bin" "$libraries" "$tools/usr/bin/$*" >"$made/bin/$1"
    chmod +x "$made/bin/$1"
}
tool arm-none-eabi-gcc -B "$tools/usr/lib/arm-none-eabi/newlib/" -isystem "$tools/usr/include/newlib"
tool qemu-system-arm -L "$tools/usr/share/qemu"

path=$made/bin:/usr/bin:/bin
for program in rustc cargo; do
    if PATH=$path command -v $program >/dev/null; then
        printf 'NOT CHECKED: %s stands beside the programs of the system\n' $program
        exit 0
    fi
done

# page NAME: runs a page; its output is compared with that of the page.
page() {
    mkdir -p "$made/$1"
    python3 tests/without_rust/page.py "docs/src/recipes/$1.md" "$made/$1"
    (cd "$made/$1" && PATH=$path bash -e commands.sh </dev/null >said.txt 2>errors.txt) ||
        { printf '%s:\n' "$1"; tail -n 5 "$made/$1/errors.txt"; exit 1; }
    diff "$made/$1/shown.txt" "$made/$1/said.txt" || { printf '%s: the page shows other output\n' "$1"; exit 1; }
}

# near NAME BOUND: the last angle that a page shows, beside a run by another method.
near() {
    local run shown
    run=$("$plm" run "$made/$1/pendulum.plm" --until 1 --every 1 --csv - --method Dop853:1e-12 | tail -n 1 | cut -d , -f 2)
    shown=$(tail -n 1 "$made/$1/said.txt" | grep -oE -e '-?[0-9]+\.[0-9]{4,}' | tail -n 1)
    awk -v a="$run" -v b="$shown" -v bound="$2" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(d < bound) }' ||
        { printf '%s: %s rad, by plm run %s\n' "$1" "$shown" "$run"; exit 1; }
    printf '%-20s angle after 1 s: %s rad, by plm run %s\n' "$1" "$shown" "$run"
}

if "$made/bin/arm-none-eabi-gcc" --version >/dev/null 2>&1 && "$made/bin/qemu-system-arm" --version >/dev/null 2>&1; then
    page board-without-rust
    near board-without-rust 1e-5
else
    printf 'NOT CHECKED: gcc-arm-none-eabi and qemu-system-arm cannot be had on this machine\n'
fi
if python3 -m venv "$made/there" 2>/dev/null && "$made/there/bin/pip" download --quiet --no-deps --dest "$made" fmpy >/dev/null 2>&1; then
    page fmpy-without-rust
    near fmpy-without-rust 1e-9
else
    printf 'NOT CHECKED: FMPy cannot be had on this machine\n'
fi
