#!/usr/bin/env bash
# The sketch of the page *On an Arduino*: built with the core of Arduino for AVR, run in simavr, and its serial line compared with the same
# source on this machine.
#
#     bash tests/arduino.sh      # PLM is the command `plm`; without it cargo builds it
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
made=$target/arduino own=/usr/share/arduino/hardware/arduino/avr
packages=(gcc-avr binutils-avr avr-libc arduino-core-avr simavr)
if ! [ -d $own ] || ! command -v avr-gcc simavr >/dev/null; then
    if [ "$(id -u)" != 0 ] || ! { apt-get install -y -qq --no-install-recommends "${packages[@]}" ||
        { apt-get update -qq && apt-get install -y -qq --no-install-recommends "${packages[@]}"; }; } >/dev/null; then
        printf 'NOT CHECKED: %s cannot be had on this machine\n' "${packages[*]}"
        exit 0
    fi
fi
plm=${PLM:-}
if [ -z "$plm" ]; then
    cargo build --quiet -p plm-cli
    plm=$target/debug/plm
fi

rm -rf "$made"
mkdir -p "$made/swing"
page=docs/src/running/arduino.md
sed -n '/^pub Pendulum {/,/^}/p' $page >"$made/pendulum.plm"
sed -n '/^```cpp/,/^```/p' $page | sed '/^```/d' >"$made/swing/swing.ino"
"$plm" export "$made/pendulum.plm" --c-source "$made/swing" --single >/dev/null

# The same steps on this machine.
cat >"$made/here.c" <<'END'
#include <stdio.h>

#include "pendulum.h"

int main(void)
{
    pendulum plant;
    float angle;
    int k;
    pendulum_init(&plant);
    for (k = 0; k < 40; k++) {
        if (pendulum_step(&plant, 0.02f) != PLM_OK) return 1;
        pendulum_get(&plant, PLM_OUTPUT, PENDULUM_OUTPUT_BAR_ANGLE, &angle);
        printf("%.6f\n", (double)angle);
    }
    return 0;
}
END
cc -std=c99 -O2 -I "$made/swing" "$made/here.c" "$made/swing/pendulum.c" -o "$made/here"
"$made/here" >"$made/here.txt"

# build NAME PROCESSOR VARIANT SKETCH: $made/NAME.elf, by the options of platform.txt of the core.
build() {
    local out=$made/$1 file
    local common=(-Os -w -ffunction-sections -fdata-sections -flto -mmcu="$2" -DF_CPU=16000000L -DARDUINO=10819 -DARDUINO_ARCH_AVR
        -I $own/cores/arduino -I "$own/variants/$3" -I "$made/swing")
    # GCC 5 of Debian names DECIMAL_DIG in C alone.
    local cpp=(-DDECIMAL_DIG=__DECIMAL_DIG__ -std=gnu++11 -fpermissive -fno-exceptions -fno-threadsafe-statics -Wno-error=narrowing)
    mkdir -p "$out"
    for file in $own/cores/arduino/*.c "$made/swing/pendulum.c"; do
        avr-gcc -c -std=gnu11 -fno-fat-lto-objects "${common[@]}" "$file" -o "$out/$(basename "$file").o"
    done
    for file in $own/cores/arduino/*.cpp; do
        avr-g++ -c "${cpp[@]}" "${common[@]}" "$file" -o "$out/$(basename "$file").o"
    done
    avr-g++ -c "${cpp[@]}" "${common[@]}" -x c++ -include Arduino.h "$4" -o "$out/sketch.o"
    avr-gcc -Os -flto -fuse-linker-plugin -Wl,--gc-sections -mmcu="$2" "$out"/*.o -lm -o "$out.elf"
}

# said NAME PROCESSOR LINES: lines of the serial line, from simavr.
said() {
    local text
    # simavr goes on until it is ended.
    text=$(timeout 60 simavr -m "$2" -f 16000000 "$made/$1.elf" 2>&1 | sed -u 's/\x1b\[[0-9;]*m//g; s/\.*\r*$//' | grep -m "$3" -E '^-?[0-9]' || true)
    printf '%s\n' "$text"
}

# The same sketch, with the time of each step in the place of the angle.
sed -e 's/  if (pendulum_step/  unsigned long began = micros();\n  if (pendulum_step/' \
    -e 's/^  pendulum_get.*/  began = micros() - began;/' -e 's/println(angle, 6)/println(began)/' "$made/swing/swing.ino" >"$made/timed.ino"

printf '| board | processor | flash of %s | memory, without stack | a step |\n|---|---|---|---|---|\n' "the sketch"
for board in "Uno atmega328p standard" "Mega atmega2560 mega"; do
    read -r name processor variant <<<"$board"
    build "$name" "$processor" "$variant" "$made/swing/swing.ino"
    said "$name" "$processor" 40 >"$made/$name.txt"
    [ "$(wc -l <"$made/$name.txt")" = 40 ] || { printf '%s says\n' "$name"; cat "$made/$name.txt"; exit 1; }
    # Arduino prints digits by sums of its own.
    paste "$made/here.txt" "$made/$name.txt" | awk '{ d = $1 - $2; if (d < 0) d = -d; if (d > 2e-6) { print "other angle: " $0; exit 1 } }'
    build "$name-timed" "$processor" "$variant" "$made/timed.ino"
    times=$(said "$name-timed" "$processor" 40 | sort -n)
    read -r flash memory < <(avr-size "$made/$name.elf" | awk 'NR == 2 { print $1 + $2, $2 + $3 }')
    printf '| %s | %s | %s B | %s B | %s ms to %s ms |\n' "$name" "$processor" "$flash" "$memory" \
        "$(head -n 1 <<<"$times" | awk '{ printf "%.1f", $1 / 1000 }')" "$(tail -n 1 <<<"$times" | awk '{ printf "%.1f", $1 / 1000 }')"
done
printf 'the serial lines of both boards are the angles of this machine\n'
