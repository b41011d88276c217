#!/usr/bin/env bash
# A second compiler for the tests of C and C++: puts clang and clang++ into FOLDER, where the machine has none.
#
#     bash tests/clang.sh FOLDER && PATH=FOLDER:$PATH cargo test --test foreign
#
# It is unpacked, not installed, so that nothing of the machine changes; without apt the tests use gcc alone.
set -euo pipefail

mkdir -p "$1"
cd "$1"
version=14
packages=("clang-$version" "libclang-cpp$version" "libclang-common-$version-dev" "libllvm$version"
    libz3-4 libedit2 libxml2 libbsd0 libicu72 libtinfo6)

unpack() {
    # A fresh image has no lists of packages.
    apt-get download "${packages[@]}" || { apt-get update && apt-get download "${packages[@]}"; } || return
    find . -name '*.deb' -exec dpkg-deb -x {} . \; -delete
}

# A compiler that finds its own libraries, and leaves those of other programs alone.
wrapper() {
    printf '#!/bin/sh\nLD_LIBRARY_PATH=%s exec %s "$@"\n' \
        "$PWD/usr/lib/x86_64-linux-gnu:$PWD/usr/lib/llvm-$version/lib" "$PWD/usr/lib/llvm-$version/bin/$1" >"$1"
    chmod +x "$1"
}

if ! command -v clang++ >/dev/null && ! [ -x clang++ ]; then
    if unpack; then
        wrapper clang
        wrapper clang++
    fi >log 2>&1
fi
PATH=$PWD:$PATH clang++ --version 2>/dev/null | head -n 1 | grep . || printf 'NOT CHECKED: clang cannot be had on this machine\n'
