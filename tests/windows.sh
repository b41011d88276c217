#!/usr/bin/env bash
# `plm` for Windows, by Wine: commands and their exit codes, paths with blanks and backslashes, lines that end by CR LF, a console, the server
# for agents; a run has the bytes of one on this machine. What is missing is said, and not checked.
#
#     cargo xtask release try windows
#     bash tests/windows.sh FOLDER       # of plm-x86_64-pc-windows-gnu.tar.gz, and of plm-x86_64-unknown-linux-musl.tar.gz
set -euo pipefail
folder=$(realpath "${1:?the folder of the files}")
cd "$(dirname "$0")/.."
plm=$PWD
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
archive=$folder/plm-x86_64-pc-windows-gnu.tar.gz
if ! [ -e "$archive" ]; then
    printf 'NOT CHECKED: there is no %s\n' "$archive"
    exit 0
fi
if ! command -v wine >/dev/null; then
    printf 'NOT CHECKED: Wine is not on this machine\n'
    exit 0
fi
export WINEPREFIX=$target/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree=;mshtml="
drive=$WINEPREFIX/drive_c
timeout 120 wine cmd /c exit >/dev/null 2>&1 || { printf 'NOT CHECKED: Wine does not start\n'; exit 0; }

home="$drive/a folder"
rm -rf "$home"
mkdir -p "$home/machines" "$home/bin"
tar -xzf "$archive" -C "$home/bin"
# Rust's library asks a system library of Windows for random numbers, which older Wine lacks: one stands in there.
if ! [ -e "$drive/windows/system32/bcryptprimitives.dll" ]; then
    printf '#include <windows.h>\n#include <ntsecapi.h>\n__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE to, SIZE_T count)\n{ return RtlGenRandom(to, count); }\n' >"$target/prng.c"
    if ! x86_64-w64-mingw32-gcc -shared -o "$home/bin/bcryptprimitives.dll" "$target/prng.c" -ladvapi32; then
        printf 'NOT CHECKED: this Wine lacks bcryptprimitives.dll, and there is no compiler for one in its place\n'
        exit 0
    fi
    printf 'a library for random numbers, bcryptprimitives.dll, stands in for the one that this Wine lacks\n'
fi
cp examples/playground/four_bar.plm "$home/machines/four bar.plm"
sed 's/$/\r/' examples/playground/four_bar.plm >"$home/machines/crlf.plm"
sed 's/mass: 1 kg/mass: 1 s/' examples/playground/four_bar.plm >"$home/machines/wrong.plm"
cd "$home"

# plm WORDS: its output in $out, its errors in $err, its exit code in $code.
run() {
    code=0
    timeout 120 wine bin/plm.exe "$@" >"$target/wine.out" 2>"$target/wine.err" || code=$?
    out=$(tr -d '\0' <"$target/wine.out") err=$(<"$target/wine.err")
}
expect() { # CODE PATTERN WHAT: a pattern of grep in output and errors
    if [ "$code" != "$1" ] || ! grep -q -- "$2" <<<"$out$err"; then
        printf 'DOES NOT HOLD: %s (code %s)\n%s\n%s\n' "$3" "$code" "$out" "$err"
        exit 1
    fi
    printf 'holds: %s\n' "$3"
}

run check 'C:\a folder\machines\four bar.plm'
expect 0 '' 'a declaration in a folder with a blank is checked'
run check 'machines\wrong.plm'
expect 1 'machines\\wrong.plm' 'a mistake has the code 1, and is told with its file as it was named'
run check 'machines\missing.plm'
expect 2 'missing.plm' 'a file that is missing has the code 2'
run nonsense
expect 2 'nonsense' 'a word that is no command has the code 2'
run check --json - <"$home/machines/crlf.plm"
expect 0 '' 'standard input with lines that end by CR LF is read'

run run 'machines\four bar.plm' --until 1 --every 0.05 --csv 'C:\a folder\made here\run.csv'
expect 0 '' 'a run writes into a folder that was not there'
head -n 1 "$home/made here/run.csv" | grep -q '^time' || { printf 'DOES NOT HOLD: the run has its columns\n'; exit 1; }
linux=$folder/plm-x86_64-unknown-linux-musl.tar.gz
if [ -e "$linux" ]; then
    mkdir -p "$target/windows-beside"
    tar -xzf "$linux" -C "$target/windows-beside"
    "$target/windows-beside/plm" run "$plm/examples/playground/four_bar.plm" --until 1 --every 0.05 --csv "$target/windows-beside/run.csv"
    cmp "$home/made here/run.csv" "$target/windows-beside/run.csv"
    printf 'holds: the run has the bytes of one on Linux, %s rows\n' "$(wc -l <"$home/made here/run.csv")"
else
    printf 'NOT CHECKED: the bytes of a run on Linux, for want of %s\n' "$linux"
fi
run run 'machines\crlf.plm' --until 1 --every 0.05 --csv -
expect 0 '^1.0,' 'a run writes to standard output'
printf '%s\n' "$out" | cmp - "$home/made here/run.csv"

run report 'machines\four bar.plm'
expect 0 'coupler' 'a report is written'
run picture 'machines\four bar.plm' --svg 'drawn\here\a.svg' --png 'drawn\here\a.png'
expect 0 '' 'pictures are written'
grep -q '<svg' "$home/drawn/here/a.svg" && head -c 4 "$home/drawn/here/a.png" | grep -q PNG
run run 'machines\four bar.plm' --until 1 --view 'made here\page.html' --out 'made here\run.plmz'
expect 0 '' 'a page and a results file are written'
[ -s "$home/made here/page.html" ]
run export 'machines\four bar.plm' --c-source 'C:\a folder\c source'
expect 0 '' 'C source is written'
[ -s "$home/c source/four_bar.c" ]
run export 'machines\four bar.plm' --fmu-source 'made here\four bar.fmu'
expect 0 '' 'an FMU is written'
run modes 'machines\four bar.plm' --as-started
expect 0 'mode' 'modes are written'
run fmt --check 'machines\crlf.plm'
[ "$code" = 0 ] || [ "$code" = 1 ]

# A terminal, in which Wine has a console.
if command -v script >/dev/null; then
    said=$(script -qec "stty columns 200; wine bin/plm.exe check 'machines\\wrong.plm'" /dev/null | tr -d '\0' || true)
    grep -q 'error' <<<"$said"
    printf 'holds: a console shows a mistake\n'
else
    printf 'NOT CHECKED: a console, for want of script\n'
fi

# The server for agents, in its folder; a call is a process of its own.
call() { printf '{"jsonrpc":"2.0","id":%d,"method":"tools/call","params":{"name":"%s","arguments":%s}}\n' "$@"; }
{
    printf '{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"2025-11-25","capabilities":{},"clientInfo":{"name":"t","version":"0"}}}\n'
    call 2 check '{"file":"four bar.plm"}'
    call 3 run '{"file":"four bar.plm","until":1}'
    call 4 check '{"file":"..\\run.csv"}'
    call 5 check '{"file":"C:\\a folder\\machines\\four bar.plm"}'
    call 6 check '{"file":"four bar.plm:other"}'
    call 7 picture '{"file":"four bar.plm","format":"png"}'
} >"$target/wine.in"
run mcp --folder machines <"$target/wine.in"
expect 0 '"id":7' 'a server for agents answers each call'
answer() { grep "\"id\":$1," <<<"$out"; }
for id in 2 3 7; do grep -q '"isError":false' <<<"$(answer $id)" || { answer $id; exit 1; }; done
for id in 4 5 6; do grep -q '"isError":true' <<<"$(answer $id)" || { answer $id; exit 1; }; done
printf 'holds: a call outside of the folder is refused, one within is answered\n'
