#!/usr/bin/env bash
# Files of a release on an empty Debian without Rust: a machine moves by the command `plm`, by C source and its compiler, by the wheel and
# Python, and in a browser. Each part begins with an empty Debian and what a user would install; what cannot be had is said, and not checked.
# It needs root, debootstrap and some 2 GB.
#
#     cargo xtask release try                         # the files of target/release-files
#     bash tests/empty.sh FOLDER                      # those of a folder
#     bash tests/empty.sh FOLDER plm python           # some parts: plm, c, python, page
set -euo pipefail
folder=$(realpath "${1:?the folder of the files}")
shift
cd "$(dirname "$0")/.."
parts=("$@")
[ ${#parts[@]} != 0 ] || parts=(plm c python page)

target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
base=$target/empty-debian
if [ "$(id -u)" != 0 ]; then
    printf 'NOT CHECKED: chroot needs root\n'
    exit 0
fi
if ! [ -e "$base.tar" ]; then
    if ! command -v debootstrap >/dev/null && ! { apt-get install -y -qq debootstrap || { apt-get update -qq && apt-get install -y -qq debootstrap; }; } >/dev/null; then
        printf 'NOT CHECKED: debootstrap cannot be had\n'
        exit 0
    fi
    rm -rf "$base"
    debootstrap --variant=minbase bookworm "$base" >"$base.txt" 2>&1 || { tail -n 3 "$base.txt"; exit 1; }
    # As this machine reaches its packages.
    cp /etc/resolv.conf "$base/etc/resolv.conf" 2>/dev/null || true
    tar -cf "$base.tar" -C "$base" .
    rm -rf "$base"
fi

# empty NAME PACKAGE...: a new Debian in $root, with packages.
empty() {
    root=$target/empty-$1
    shift
    rm -rf "$root"
    mkdir -p "$root"
    tar -xf "$base.tar" -C "$root"
    mkdir -p "$root/try"
    if [ $# != 0 ]; then
        inside apt-get update -qq >/dev/null
        inside env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >"$target/empty.txt" 2>&1 ||
            { tail -n 5 "$target/empty.txt"; exit 1; }
    fi
    ! inside sh -c 'command -v rustc || command -v cargo'
    started=$(date +%s.%N)
}

# inside COMMAND...: in the empty Debian, in a process space of its own, without this shell's environment.
inside() {
    unshare --mount --pid --fork -- sh -c 'root=$1; shift
        mount -t proc proc "$root/proc" && mount --bind /dev "$root/dev" &&
        exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 chroot "$root" "$@"' sh "$root" "$@"
}

told() {
    printf '%-7s %5.1f s  %s\n' "$1" "$(awk -v a="$started" -v b="$(date +%s.%N)" 'BEGIN { print b - a }')" "$2"
    rm -rf "$root"
}

# The program, with nothing at all beside it.
try_plm() {
    local archive=$folder/plm-x86_64-unknown-linux-musl.tar.gz
    [ -e "$archive" ] || { printf 'NOT CHECKED: there is no %s\n' "$archive"; return; }
    empty plm
    cp "$archive" examples/playground/four_bar.plm "$root/try"
    inside sh -c 'cd /try && tar -xzf plm-*.tar.gz && ./plm check four_bar.plm && ./plm run four_bar.plm --until 1 --every 0.25 --csv run.csv &&
        ./plm picture four_bar.plm --svg four_bar.svg --png four_bar.png && ./plm export four_bar.plm --c-source c --force >/dev/null'
    rows=$(wc -l <"$root/try/run.csv")
    [ "$rows" -ge 6 ] && grep -q '<svg' "$root/try/four_bar.svg" && head -c 4 "$root/try/four_bar.png" | grep -q PNG
    told plm "a run of $((rows - 1)) rows: $(tail -n 1 "$root/try/run.csv" | cut -d , -f 1-3)"
}

# C source and a C compiler.
try_c() {
    empty c gcc libc6-dev
    tar -xzf "$folder/four_bar_c.tar.gz" -C "$root/try"
    cat >"$root/try/main.c" <<'END'
#include <stdio.h>
#include "four_bar.h"
int main(void)
{
    four_bar self;
    double x[2];
    int k;
    if (four_bar_check() != 0) return 1;
    four_bar_init(&self);
    for (k = 0; k < 1000; k++) {
        if (four_bar_step(&self, 0.001) != PLM_OK) return 2;
    }
    four_bar_get(&self, PLM_OUTPUT, FOUR_BAR_OUTPUT_COUPLER_TIP_POSITION_X, &x[0]);
    four_bar_get(&self, PLM_OUTPUT, FOUR_BAR_OUTPUT_COUPLER_TIP_POSITION_Y, &x[1]);
    printf("tip after 1 s: %.6f %.6f m\n", x[0], x[1]);
    return 0;
}
END
    said=$(inside sh -c 'cd /try && gcc -std=c99 -O2 -I four_bar_c main.c four_bar_c/four_bar.c -o main && ./main')
    [[ $said == tip* ]]
    told c "$said"
}

# The wheel in a virtual environment.
try_python() {
    local wheel
    wheel=$(find "$folder" -name 'plm_planar-*manylinux*x86_64*.whl' | head -n 1)
    [ -n "$wheel" ] || { printf 'NOT CHECKED: there is no wheel for Linux in %s\n' "$folder"; return; }
    empty python python3-venv
    cp "$wheel" "$root/try"
    # Packages of Python as this machine reaches them.
    python3 -m pip download --quiet --disable-pip-version-check --only-binary :all: --python-version 3.11 --no-deps --dest "$root/try" numpy
    mkdir -p "$root/plm"
    cp -r tests examples docs "$root/plm"
    said=$(inside sh -c 'cd /try && python3 -m venv own && own/bin/pip install --quiet --no-index --find-links . plm_planar-*.whl &&
        own/bin/python /plm/tests/python/text/check.py /plm')
    told python "$(tail -n 1 <<<"$said")"
}

# The page in a browser, without network: it has compiled its text. That it moves is seen by examples/playground/check.sh; headless
# Chromium alone does not wait for the worker of a page.
try_page() {
    empty page chromium fonts-dejavu-core
    cp "$folder/playground.html" "$root/try"
    inside sh -c 'cd /try && unshare --net chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=6000 --dump-dom \
        file:///try/playground.html 2>/dev/null >dom.html'
    grep -q 'Nothing is wrong' "$root/try/dom.html"
    told page "the page has compiled its text, and nothing is wrong with it"
}

for part in "${parts[@]}"; do
    "try_$part"
done
