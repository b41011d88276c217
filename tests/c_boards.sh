#!/usr/bin/env bash
# C source on boards without Rust: the same bits as on this machine, and what it takes of flash, memory and stack.
#
#     bash tests/c_boards.sh             # Cortex-M4 and M0, RISC-V 32 by QEMU, ATmega2560 by simavr
#
# Compilers and machines are Debian's packages, unpacked into the target folder by apt-get download; what cannot be had is named and left
# out. PLM is the command `plm`; without it cargo builds it.
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
tools=$target/c-boards made=$target/c-boards-made own=tests/c_boards
mkdir -p "$tools" "$made"

missing() {
    printf 'NOT CHECKED: %s cannot be had on this machine\n' "$1"
}

unpack() {
    local packages=(gcc-arm-none-eabi binutils-arm-none-eabi gcc-riscv64-unknown-elf binutils-riscv64-unknown-elf
        gcc-avr binutils-avr avr-libc simavr libsimavr2 libelf1 qemu-system-arm qemu-system-misc qemu-system-data
        libcapstone4 libdaxctl1 libfdt1 libibverbs1 libkmod2 libmpc3 libmpfr6 libgmp10 libisl23 libndctl6 libnl-3-200
        libnl-route-3-200 libpmem1 librdmacm1 libslirp0 libvdeplug2)
    # A fresh image has no lists of packages.
    apt-get download "${packages[@]}" || { apt-get update && apt-get download "${packages[@]}"; } || return
    find . -name '*.deb' -exec dpkg-deb -x {} . \; -delete && touch complete
}

if [ ! -e "$tools/complete" ]; then
    (cd "$tools" && unpack) >"$made/unpacked.txt" 2>&1 || true
fi
libraries=$(find "$tools" -name '*.so*' -printf '%h\n' 2>/dev/null | sort -u | paste -sd :)
tool() {
    PATH="$tools/usr/bin:$PATH" LD_LIBRARY_PATH="$libraries" timeout 300 "$@"
}
for program in "arm-none-eabi-gcc --version" "qemu-system-arm --version" "riscv64-unknown-elf-gcc --version" \
    "qemu-system-riscv32 --version" "avr-gcc --version" "simavr -m atmega2560 none"; do
    # shellcheck disable=SC2086
    said=$(tool $program 2>&1 || true)
    # simavr has no option that only tells of itself.
    [[ $said =~ [Cc]opyright|"Unable to load" ]] || { missing "${program%% *}"; exit 0; }
done

plm=${PLM:-}
if [ -z "$plm" ]; then
    cargo build --quiet -p plm-cli
    plm=$target/debug/plm
fi

# compile COMPILER ROOM... : $out/program of the mechanism $name in $real, with the options that follow; the object is $out/own.o.
compile() {
    local compiler=$1
    shift
    tool "$compiler" "$@" -std=c99 -O2 -ffunction-sections -I "$out" -c "$out/$name.c" -o "$out/own.o"
    tool "$compiler" "$@" -std=c99 -O2 -ffunction-sections -I "$out" -DNAME="$name" -DREAL="$real" -DSTEPS="$steps" \
        -DHEADER="\"$name.h\"" ${main:+-Dmain=$main} -c $own/main.c -o "$out/main.o"
}

# bare COMPILER FLASH RAM ROOM OPTION...: a program that starts by itself.
bare() {
    local compiler=$1 flash=$2 ram=$3 room=$4
    shift 4
    set -- "$@" -ffreestanding -I $own/include
    main='' compile "$compiler" "$@"
    tool "$compiler" "$@" -std=gnu99 -O2 -c $own/bare.c -o "$out/board.o"
    tool "$compiler" "$@" -nostdlib -static -T $own/bare.ld -Wl,--defsym=FLASH="$flash",--defsym=RAM="$ram",--defsym=ROOM="$room" \
        -Wl,--gc-sections,--no-warn-rwx-segments "$out/board.o" "$out/main.o" "$out/own.o" -lgcc -o "$out/program"
}

ran() {
    case $1 in
        host)
            main='' compile cc && cc -c $own/host.c -o "$out/board.o" && cc "$out/board.o" "$out/main.o" "$out/own.o" -o "$out/program"
            "$out/program"
            ;;
        m4)
            bare arm-none-eabi-gcc 0 0x20000000 0x40000 -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard
            tool qemu-system-arm -M mps2-an386 -nographic -semihosting -kernel "$out/program" 2>&1 | grep "^check"
            ;;
        m0)
            bare arm-none-eabi-gcc 0 0x20000000 0x4000 -mcpu=cortex-m0 -mthumb
            tool qemu-system-arm -M microbit -nographic -semihosting -kernel "$out/program" 2>&1 | grep "^check"
            ;;
        rv32)
            bare riscv64-unknown-elf-gcc 0x80000000 0x80100000 0x40000 -march=rv32imac -mabi=ilp32 -mcmodel=medany
            tool qemu-system-riscv32 -M virt -bios none -nographic -semihosting -kernel "$out/program" 2>&1 | grep "^check"
            ;;
        avr)
            main=run compile avr-gcc -mmcu=atmega2560 -isystem "$tools/usr/lib/avr/include"
            tool avr-gcc -mmcu=atmega2560 -isystem "$tools/usr/lib/avr/include" -std=gnu99 -Os -c $own/avr.c -o "$out/board.o"
            tool avr-gcc -mmcu=atmega2560 -B "$tools/usr/lib/avr/lib/avr6" -L "$tools/usr/lib/avr/lib/avr6" -Wl,--gc-sections \
                "$out/board.o" "$out/main.o" "$out/own.o" -o "$out/program"
            tool simavr -m atmega2560 -f 16000000 "$out/program" 2>&1 | sed 's/\x1b\[[0-9;]*m//g; s/\.*$//' | grep check
            ;;
    esac
}

size_of() {
    local prefix=
    case $1 in m4 | m0) prefix=arm-none-eabi- ;; rv32) prefix=riscv64-unknown-elf- ;; avr) prefix=avr- ;; esac
    tool "${prefix}size" "$out/own.o" | awk 'NR == 2 { print $1 + $2 }'
}

word() {
    sed -n "s/.* $1 \([0-9]*\).*/\1/p" <<<" $2"
}

# The example of the page *In an interrupt*.
out=$made/interrupt
mkdir -p "$out"
sed -n '/^pub Pendulum {/,/^}/p' docs/src/running/c-source.md >"$out/pendulum.plm"
"$plm" export "$out/pendulum.plm" --c-source "$out" --single --force >/dev/null
tool arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -std=c99 -Os -ffreestanding -I $own/include -I "$out" \
    -Wall -Wextra -Werror -c $own/interrupt.c -o "$out/interrupt.o"

wrong=0
printf '%-16s %-7s %-5s %6s %7s %6s  %s\n' mechanism numbers board flash object stack bits
for name in double_pendulum four_bar chain bouncer arm_on_jack; do
    for real in float double; do
        for board in m4 m0 rv32 avr; do
            # avr-gcc has no numbers of 64 bits.
            [ "$board:$real" != avr:double ] || continue
            steps=1000
            [ "$board" != avr ] || steps=100
            out=$made/$name-$real-$board
            mkdir -p "$out"
            "$plm" export "tests/snapshots/$name.plm" --c-source "$out" $([ $real = double ] || echo --single) --force >/dev/null
            here=$(ran host)
            if ! there=$(ran "$board" 2>"$out/errors.txt"); then
                printf '%-16s %-7s %-5s DOES NOT RUN: %s\n' "$name" "$real" "$board" "$(tail -n 1 "$out/errors.txt")"
                wrong=1
                continue
            fi
            verdict=same
            [ "$(word bits "$here") $(word steps "$here")" = "$(word bits "$there") $(word steps "$there")" ] || verdict=OTHER
            check=$(word check "$there")
            [ "$check" = 0 ] || verdict="$verdict, check $check"
            [ "$verdict" = same ] || wrong=1
            printf '%-16s %-7s %-5s %6s %7s %6s  %s\n' "$name" "$real" "$board" "$(size_of "$board")" "$(word object "$there")" \
                "$(word stack "$there")" "$verdict"
        done
    done
done
exit $wrong
