#!/usr/bin/env bash
# The same bits on every machine, and what a step costs on microcontrollers.
#
#     bash tests/machines.sh              # seven machines, both packages
#     bash tests/machines.sh --quick      # the book's table: Cortex-M4F in f32, Cortex-M7 in f64; and WebAssembly
#     bash tests/machines.sh --one        # what CI runs: Cortex-M4F in f32, beside the machine itself, which has 64 bits
#     PLM_BLESS=1 bash tests/machines.sh  # writes the book's table anew
#
# Programs: tests/no_std (all methods) and examples/firmware (10 000 steps of eight mechanisms and a filter). Targets come by rustup, QEMU
# by apt into the target folder, the disassembler by rustup; what cannot be had is named and left out.
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
# That of tests/no_std.rs: the compiler of plm is built once for both.
built=$(realpath -m "$target/tmp")/no_std
qemu=$target/qemu
results=$target/machines
table=docs/src/targets-table.txt
mkdir -p "$results"

boards=(m4:f32 m7:f64)
if [ "${1:-}" = --one ]; then
    boards=(m4:f32)
    [ -z "${PLM_BLESS:-}" ] || { printf 'the table has two boards: PLM_BLESS=1 bash tests/machines.sh --quick\n' >&2; exit 1; }
fi

missing() {
    printf 'NOT CHECKED: %s cannot be had on this machine\n' "$1"
}

has_target() {
    rustup target add "$1" >/dev/null 2>&1 || { missing "the target $1" && false; }
}

# Unpacked beside the build, since an installation may remove other packages of QEMU. Without apt, one that is installed.
fetch_qemu() {
    if [ ! -e "$qemu/complete" ]; then
        mkdir -p "$qemu"
        (cd "$qemu" && unpack) >"$results/qemu.txt" 2>&1 || true
    fi
    { emulate qemu-system-arm --version && emulate qemu-riscv64 --version; } >/dev/null 2>&1 || { missing QEMU && false; }
}

unpack() {
    local packages=(qemu-system-arm qemu-system-data qemu-user libcapstone4 libdaxctl1 libfdt1 libibverbs1 libkmod2
        libndctl6 libnl-3-200 libnl-route-3-200 libpmem1 librdmacm1 libslirp0 libvdeplug2)
    # A fresh image has no lists of packages.
    apt-get download "${packages[@]}" || { apt-get update && apt-get download "${packages[@]}"; } || return
    find . -name '*.deb' -exec dpkg-deb -x {} . \; -delete && touch complete
}

emulate() {
    local libraries
    libraries=$(find "$qemu" -name '*.so*' -printf '%h\n' 2>/dev/null | sort -u | paste -sd :)
    PATH="$qemu/usr/bin:$PATH" LD_LIBRARY_PATH="$libraries" timeout 600 "$@"
}

# build PACKAGE BIN MACHINE [OPTION...]: leaves the program as $results/<PACKAGE>-<MACHINE>.
build() {
    local package=$1 bin=$2 machine=$3 program
    shift 3
    # What is built in steps is optimised in smaller parts, and has other counts.
    program=$(env -u RUSTFLAGS CARGO_INCREMENTAL=0 cargo build --release --manifest-path "$package/Cargo.toml" --target-dir "$built" --bin "$bin" \
        --message-format json-render-diagnostics "$@" | sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' | tail -n 1)
    cp "$program" "$results/$(basename "$package")-$machine"
}

# musl's targets bring all that the linker needs.
musl() {
    printf 'target.%s.linker="rust-lld"' "$1"
}

processor() {
    printf 'target.thumbv7em-none-eabihf.rustflags=["-C", "target-cpu=%s"]' "$1"
}

run_on() {
    local machine=$1 program=$2 board
    case $machine in
    x86_64*) "$program" ;;
    i686) emulate qemu-i386 "$program" ;;
    aarch64) emulate qemu-aarch64 "$program" ;;
    riscv64*) emulate qemu-riscv64 "$program" ;;
    wasm32) node tests/wasm.mjs "$program" ;;
    cortex-m*)
        board=mps2-an386
        [[ $machine == cortex-m4* ]] || board=mps2-an500
        emulate qemu-system-arm -L "$qemu/usr/share/qemu" -machine "$board" -display none -monitor none -serial none \
            -chardev stdio,id=sh -semihosting-config enable=on,target=native,chardev=sh \
            -icount shift=10,sleep=off -kernel "$program" </dev/null
        ;;
    esac
}

# same PACKAGE MACHINE [PRECISION]: its numbers are those of the ordinary program.
same() {
    local name
    name=$(basename "$1")
    run_on "$2" "$results/$name-$2" >"$results/$name-$2.txt"
    grep -v '^#' "$results/$name-$2.txt" >"$results/$name-$2.bits"
    # A program of one precision prints a half: the first is f32.
    case ${3:-} in
    f32) head -n "$(($(wc -l <"$results/$name.bits") / 2))" "$results/$name.bits" ;;
    f64) tail -n "$(($(wc -l <"$results/$name.bits") / 2))" "$results/$name.bits" ;;
    *) cat "$results/$name.bits" ;;
    esac | cmp - "$results/$name-$2.bits"
    printf '%-18s %-14s the same %d numbers\n' "$name" "$2" "$(wc -l <"$results/$name-$2.bits")"
}

# The ordinary program gives the numbers that the others are held to.
reference() {
    local name
    name=$(basename "$1")
    # The bits are the same at any level of optimisation, and this one is the soonest built.
    build "$1" twin x86_64-std --features std --config 'profile.release.opt-level=1' --config 'profile.release.lto="off"' \
        --config 'profile.release.codegen-units=16'
    "$results/$name-x86_64-std" >"$results/$name.bits"
    [ "$(wc -l <"$results/$name.bits")" -ge 100 ]
}

# on PACKAGE MACHINE TARGET BIN [OPTION...]
on() {
    local package=$1 machine=$2 triple=$3 bin=$4
    shift 4
    if has_target "$triple"; then
        build "$package" "$bin" "$machine" --target "$triple" "$@"
        same "$package" "$machine"
    fi
}

boards() {
    local chosen machine
    has_target thumbv7em-none-eabihf || return 0
    for chosen in "${boards[@]}"; do
        machine=cortex-${chosen%:*}-${chosen#*:}
        build examples/firmware bare "$machine" --target thumbv7em-none-eabihf --no-default-features \
            --features "${chosen#*:},processor-sqrt-${chosen#*:}" --config "$(processor "cortex-${chosen%:*}")"
        same examples/firmware "$machine" "${chosen#*:}"
    done
    worst_cases
    make_table >"$results/table.md"
    if [ -n "${PLM_BLESS:-}" ]; then
        ! grep -qF '?' "$results/table.md" || return
        cp "$results/table.md" "$table"
    fi
    not_grown
}

# The longest paths of the steps that were measured: files beside the reports.
worst_cases() {
    local programs=() chosen objdump
    for chosen in "${boards[@]/:/-}"; do
        programs+=("$results/firmware-cortex-$chosen" "$results/firmware-cortex-$chosen.txt")
    done
    rm -f "$results"/firmware-cortex-*.worst
    rustup component add llvm-tools >/dev/null 2>&1 || true
    objdump=$(find "$(rustc --print sysroot)/lib/rustlib" -name llvm-objdump -print -quit || true)
    if [ -n "$objdump" ] && command -v python3 >/dev/null; then
        python3 -B tests/worst_case/check.py
        python3 -B tests/worst_case/worst_case.py "$objdump" "${programs[@]}"
    else
        missing "the worst case, by python3 and rustup's llvm-tools,"
    fi
}

# Columns of `# mechanism,scalar,by,fewest,most,stack,size`, and of `worst,mechanism,all,few turns`.
make_table() {
    printf '| | step alone: fewest | most | worst case | of few turns | `Sim::step`: fewest | most | stack, bytes | state, bytes | `Sim`, bytes |\n'
    printf '|---|---|---|---|---|---|---|---|---|---|\n'
    local machine
    for machine in "${boards[@]/:/-}"; do
        awk -F, -v machine="Cortex-${machine^^}" '
            $1 == "worst" { all[$2] = $3; few[$2] = $4 }
            function found(table) { return $1 in table ? table[$1] : "?" }
            { sub(/^# /, "") }
            machine ~ /M4/ { place = "Cortex-M4F, `f32`" }
            machine ~ /M7/ { place = "Cortex-M7, `f64`" }
            $3 == "Sim" { fewest = $4; most = $5; stack = $6; size = $7 }
            $3 == "step" { printf "| %s, %s | %d | %d | %s | %s | %d | %d | %d | %d | %d |\n",
                $1, place, $4, $5, found(all), found(few), fewest, most, stack, $7, size }
            $3 == "filter" { printf "| %s, %s | %d | %d | | | | | %d | %d | |\n", $1, place, $4, $5, $6, $7 }
            $1 == "program" { printf "| all, %s: code %d bytes, variables %d bytes | | | | | | | | | |\n", place, $2, $3 }
        ' <(sed 's/^/worst,/' "$results/firmware-cortex-$machine.worst" 2>/dev/null) <(grep '^#' "$results/firmware-cortex-$machine.txt")
    done
}

# Rows of the book's table for the boards that were run.
of_boards() {
    grep "$(printf '%s\n' "${boards[@]%:*}" | sed 's/m\(.\)/Cortex-M\1/')" "$table"
}

# Two in a hundred are left to other versions of rustc. What was not found is a question mark.
not_grown() {
    paste -d ' ' <(grep -o '[0-9]\+\|?' "$results/table.md") <(of_boards | grep -o '[0-9]\+') |
        awk 'NF != 2 || $1 != "?" && $1 > 1.02*$2 { grown = 1; print "grown: " $1 ", the book has " $2 } END { exit grown }' || {
        cat "$results/table.md"
        printf 'A table that is meant to grow is written anew by PLM_BLESS=1 bash tests/machines.sh\n'
        false
    }
    printf 'instructions, stack and sizes are those of %s or less\n' "$table"
}

web() {
    if command -v node >/dev/null; then
        on "$1" wasm32 wasm32-unknown-unknown bare
    else
        missing node
    fi
}

everywhere() {
    build "$1" bare x86_64
    same "$1" x86_64
    web "$1"
    if fetch_qemu; then
        on "$1" i686 i686-unknown-linux-musl twin --features std --config "$(musl i686-unknown-linux-musl)"
        on "$1" aarch64 aarch64-unknown-linux-musl twin --features std --config "$(musl aarch64-unknown-linux-musl)"
        on "$1" riscv64 riscv64gc-unknown-none-elf bare
        [[ $1 != *firmware ]] || on "$1" riscv64-roots riscv64gc-unknown-none-elf bare --features processor-sqrt-f64
        on "$1" cortex-m4 thumbv7em-none-eabihf bare --config "$(processor cortex-m4)"
        on "$1" cortex-m7 thumbv7em-none-eabihf bare --config "$(processor cortex-m7)"
    fi
}

reference examples/firmware
if fetch_qemu; then
    boards
fi
case ${1:-} in
--one) ;;
--quick)
    reference tests/no_std
    web tests/no_std
    ;;
*)
    reference tests/no_std
    everywhere examples/firmware
    everywhere tests/no_std
    ;;
esac
