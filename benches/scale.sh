#!/usr/bin/env bash
# What mechanisms of many bodies cost: expansion, compilation, stack of a start, a step. The table in the book:
#
#     bash benches/scale.sh >docs/src/internals/scale-table.txt
#
# Times are those of the processor, of one run; of a step of RK4 they are the least of many, beside its instructions. With
# arguments one scene alone, with CODE as ordered: `CODE=rolled bash benches/scale.sh chain 64`.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
target=${CARGO_TARGET_DIR:-$root/target}/scale
work=$target/crate
command -v valgrind >/dev/null || { echo "valgrind is needed (apt-get install valgrind)" >&2; exit 1; }

# Declarations of N bars, windows or stages. All bars of a chain move from the start: let go at rest and flat, the far ones move by
# numbers so small that processors take many times as long for them.
chain() {
    printf 'pub Scene { gravity: 9.81 m/s^2; ground { port o: (0, 0) m; }
    repeat i in 0..%d { body bar[i] { mass: 1 kg / %d; inertia: 1 kg*m^2 / (12 * %d^3);
        port a: (-0.5 / %d, 0) m; port b: (0.5 / %d, 0) m; start x: (i + 0.5) / %d * 1 m;
        start angle: 0.5 rad*sin(i*1 rad), locked; start omega: 1 rad/s*cos(i*1 rad), locked; } }
    revolute pin[0](ground.o, bar[0].a);
    repeat i in 1..%d { revolute pin[i](bar[i-1].b, bar[i].a); } }' "$1" "$1" "$1" "$1" "$1" "$1" "$1"
}

ladder() {
    printf 'pub Scene { gravity: 9.81 m/s^2; ground {'
    for ((i = 0; i <= $1; i++)); do printf ' port f%d: (%d, 0) m;' "$i" "$i"; done
    printf ' }
    repeat i in 0..=%d { body up[i] { mass: 1 kg; inertia: 1 kg*m^2/12; port low: (-0.5, 0) m; port high: (0.5, 0) m;
        start x: i*1 m; start y: 0.5 m; start angle: 80 deg; } }
    repeat i in 1..=%d { body top[i] { mass: 1 kg; inertia: 1 kg*m^2/12; port a: (-0.5, 0) m; port b: (0.5, 0) m;
        start x: (i - 0.5)*1 m; start y: 1 m; }
        revolute left[i](up[i-1].high, top[i].a); revolute right[i](top[i].b, up[i].high); }' "$1" "$1"
    for ((i = 0; i <= $1; i++)); do printf ' revolute foot%d(ground.f%d, up[%d].low);' "$i" "$i" "$i"; done
    printf ' }'
}

scissor_lift() {
    printf 'pub Scene { gravity: 9.81 m/s^2; ground { port o: (0, 0) m; }
    repeat i in 0..%d {
        body l[i] { mass: 1 kg; inertia: 0.02 kg*m^2; port lo: (-0.25, 0) m; port mid: (0, 0) m; port hi: (0.25, 0) m;
            start angle: 40 deg; start x: 0.19 m; start y: (i + 0.5)*0.32 m; }
        body r[i] { mass: 1 kg; inertia: 0.02 kg*m^2; port lo: (-0.25, 0) m; port mid: (0, 0) m; port hi: (0.25, 0) m;
            start angle: 140 deg; start x: 0.19 m; start y: (i + 0.5)*0.32 m; }
        revolute cross[i](l[i].mid, r[i].mid); }
    repeat i in 1..%d { revolute left[i](r[i - 1].hi, l[i].lo); revolute right[i](l[i - 1].hi, r[i].lo); }
    revolute foot(ground.o, l[0].lo); pin_slot slide(ground.o, r[0].lo) { damping: 20 N*s/m; } }' "$1" "$1"
}

# A program that starts the scene on a stack of the first argument (bytes) and makes as many steps as the second says.
program() {
    cat <<'RUST'
fn main() {
    let arguments: Vec<usize> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let steps = arguments[1];
    let run = move || -> Result<(), plm::Fault> {
        let mut sim = Scene::new().start_with(plm::Rk4::new(1e-4))?;
        let mut least = f64::INFINITY;
        for _ in 0..steps {
            let begin = std::time::Instant::now();
            sim.step(1e-4)?;
            least = least.min(begin.elapsed().as_secs_f64());
        }
        println!("{:.1}", 1e6*least);
        Ok(())
    };
    let thread = std::thread::Builder::new().stack_size(arguments[0]).spawn(run).unwrap();
    thread.join().unwrap().unwrap();
}
RUST
}

# The least power of two of stack (bytes) with which it starts and steps.
stack() {
    local bytes
    for ((bytes = 16384; bytes <= 1 << 30; bytes *= 2)); do
        if "$1" "$bytes" 1 >/dev/null 2>&1; then
            echo $((bytes / 1024))
            return
        fi
    done
    echo "over 1048576"
}

# Above 2 kB glibc clears and copies memory by `rep stosb` and `rep movsb`, each byte of which valgrind counts as an instruction.
instructions() {
    local by_vectors=glibc.cpu.x86_rep_stosb_threshold=1073741824:glibc.cpu.x86_rep_movsb_threshold=1073741824
    GLIBC_TUNABLES=$by_vectors valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" 268435456 "$2" 2>&1 | sed -n 's/.*Collected : //p'
}

# Seconds of the processor that a command takes, the memory that it needs (MB) after them.
cost() {
    /usr/bin/env python3 - "$@" <<'PYTHON'
import resource, subprocess, sys
status = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
if status:
    sys.exit(status)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(f"{used.ru_utime + used.ru_stime:.2f} {used.ru_maxrss // 1024}")
PYTHON
}

# One line of the table; where the compiler gives up after ten minutes it says so.
measure() {
    local scene=$1 count=$2 expansion compilation kilobytes step
    "$scene" "$count" | sed "s/pub Scene {/&${CODE:+ code: $CODE;}/" >"$work/scene.plm"
    expansion=$(cost "$target/debug/plm" expand "$work/scene.plm")
    { printf 'plm::mechanism! { '; cat "$work/scene.plm"; printf ' }\n'; program; } >"$work/src/main.rs"
    touch "$work/src/main.rs"
    local status=0
    compilation=$(cost timeout 600 cargo build --release --manifest-path "$work/Cargo.toml" --target-dir "$target") || status=$?
    if [ "$status" -eq 124 ]; then
        printf '| %s | %d | %s | not in ten minutes | | | | |\n' "${scene//_/ }" "$count" "${expansion% *}"
        return
    fi
    [ "$status" -eq 0 ] || { echo "$scene $count does not compile" >&2; exit 1; }
    local binary=$target/release/scale
    kilobytes=$(stack "$binary")
    step=$((($(instructions "$binary" 30) - $(instructions "$binary" 10)) / 20))
    printf '| %s | %d | %s | %s | %s | %s | %d | %s |\n' "${scene//_/ }" "$count" "${expansion% *}" \
        "${compilation% *}" "${compilation#* }" "$kilobytes" "$step" "$("$binary" 268435456 200)"
}

mkdir -p "$work/src"
cat >"$work/Cargo.toml" <<TOML
[package]
name = "scale"
version = "0.0.0"
edition = "2024"
[dependencies]
plm = { package = "plm-planar", path = "$root" }
[workspace]
TOML
# Users' builds take macros at opt-level 0.
cargo build --quiet --manifest-path "$root/Cargo.toml" --target-dir "$target" -p plm-cli \
    --config 'profile.dev.package.plm-compiler.opt-level=0' --config 'profile.dev.package.plm-cas.opt-level=0' \
    --config 'profile.dev.package.plm-math.opt-level=0'
echo 'fn main() {}' >"$work/src/main.rs"
cargo build --quiet --release --manifest-path "$work/Cargo.toml" --target-dir "$target"

echo '| scene | number | expansion, s | rustc at opt-level 3, expansion included, s | its memory, MB | stack, kB | RK4 step, instructions | µs |'
echo '|---|---:|---:|---:|---:|---:|---:|---:|'
if [ $# -gt 0 ]; then
    measure "$@"
    exit
fi
for count in 16 64 128 256 512 1000; do measure chain "$count"; done
for count in 5 10 20 40; do measure ladder "$count"; done
for count in 5 10 20 40; do measure scissor_lift "$count"; done
