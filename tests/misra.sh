#!/usr/bin/env bash
# MISRA C:2012 by the addon of cppcheck, on C sources of two snapshots: every finding is of a rule whose reason stands in
# tests/misra-reasons.txt.
#
#     bash tests/misra.sh
#
# cppcheck is Debian's package, unpacked into the target folder. PLM is the command `plm`; without it cargo builds it.
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
tools=$target/misra
mkdir -p "$tools"
if [ ! -x "$tools/own/cppcheck" ]; then
    # The program looks for its files beside itself.
    (cd "$tools" && apt-get download cppcheck libpcre3 libtinyxml2-9 libz3-4 && find . -name '*.deb' -exec dpkg-deb -x {} . \; -delete &&
        cp -r usr/lib/*/cppcheck own && cp usr/bin/cppcheck own/) >"$tools/unpacked.txt" 2>&1 || true
fi
libraries=$(find "$tools" -name '*.so*' -printf '%h\n' 2>/dev/null | sort -u | paste -sd :)
check() {
    LD_LIBRARY_PATH=$libraries "$tools/own/cppcheck" "$@"
}
check --version 2>/dev/null || { printf 'NOT CHECKED: cppcheck cannot be had on this machine\n'; exit 0; }

plm=${PLM:-}
if [ -z "$plm" ]; then
    cargo build --quiet -p plm-cli
    plm=$target/debug/plm
fi
known=$(sed -n 's/^\([0-9.]*\)  .*/\1/p' tests/misra-reasons.txt)
wrong=0
for name in double_pendulum four_bar; do
    "$plm" export "tests/snapshots/$name.plm" --c-source "$tools/$name" --force >/dev/null
    check --quiet --std=c99 --addon="$tools/own/addons/misra.py" --suppress=missingIncludeSystem --enable=style \
        "$tools/$name/$name.c" >"$tools/$name.txt" 2>&1
    count=$(grep -c 'misra-c2012' "$tools/$name.txt" || true)
    printf '%s: %s findings\n' "$name" "$count"
    [ "$count" -gt 0 ] || { printf 'the addon has not run\n'; wrong=1; }
    for rule in $(grep -o 'misra-c2012-[0-9.]*' "$tools/$name.txt" | sed 's/.*-//' | sort -u); do
        if ! grep -qx "$rule" <<<"$known"; then
            printf 'rule %s is not among the reasons:\n' "$rule"
            grep "misra-c2012-$rule\]" "$tools/$name.txt" | head -n 3
            wrong=1
        fi
    done
done
exit $wrong
