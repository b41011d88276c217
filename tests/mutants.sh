#!/usr/bin/env bash
# Puts small mistakes into the code of a room, one at a time, and counts those that a test notices (https://mutants.rs).
#
#     bash tests/mutants.sh ROOM [K/N [again]]
#
# ROOM is cas, formulate (with derive), math or runtime. K/N is a sample: of all mistakes in the order of the files
# every N-th, from the K-th on (0 <= K < N). What the cheapest tests miss is tried with the tests of the next stage; with
# `again`, only what the last run missed is tried, by all stages, and counted with the rest.
# Results stand in target/mutants/ROOM-K-N: caught.txt, missed.txt, timeout.txt, unviable.txt, and a folder for each stage.
set -euo pipefail
cd "$(dirname "$0")/.."

command -v cargo-mutants >/dev/null || { echo "cargo-mutants is needed (cargo install cargo-mutants --locked)" >&2; exit 1; }

room=${1:?cas, formulate, math or runtime}
shard=${2:-0/1}
# Tests of the compiler but for those that take the time.
compiler='--lib --test book --test diagnostics --test emitted --test freedom --test front -- --skip=in_time'
rooms='--test assembly --test declaration --test evaluation --test events --test formulations --test physics'
scenes="--features lanes $rooms --test augmented --test jumps --test lanes --test times"
runtime='--test algebra --test assembly --test events --test methods'
# Stages: the packages whose tests run, a colon, and which of them.
case $room in
cas)
    files=('plm-macros/cas/src/**')
    stages=("plm-cas:--lib --tests" "plm-compiler:$compiler")
    ;;
formulate)
    files=('plm-macros/compiler/src/formulate/**' 'plm-macros/compiler/src/derive/**')
    stages=("plm-compiler:$compiler" "plm-planar:$scenes")
    export PLM_SWEEP=40
    ;;
math)
    files=('plm-runtime/math/src/**')
    stages=("plm-math:--lib --tests" "plm-runtime:--lib $runtime")
    ;;
runtime)
    files=('plm-runtime/src/**')
    # First without the tests that take seconds.
    slow=(random_conditions change_points drift_that_is_left rounding_grows what_touches)
    stages=("plm-runtime:--lib $runtime -- ${slow[*]/#/--skip=}" "plm-runtime:$runtime" "plm-planar:$scenes")
    ;;
*)
    echo "no such room: $room" >&2
    exit 1
    ;;
esac

# Within a stage only what a mistake changes is built again; nobody debugs here.
export CARGO_INCREMENTAL=1 CARGO_PROFILE_DEV_DEBUG=0
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")/mutants
# The tool works on a copy and builds in it: what a run left behind that was broken off may hold a mistake.
unset CARGO_TARGET_DIR
results=$target/$room-${shard/\//-}

mutants() {
    cargo mutants --workspace "${files[@]/#/--file=}" --colors never "$@"
}

# Tries what chosen.txt lists with the tests $2; results in the folder $1.
stage() {
    local folder=$1 packages=${2%%:*} tests=${2#*:} status=0
    # The tool takes all others for caught before: unlike --re, this holds for every kind of mistake.
    rm -rf "$folder"
    mkdir -p "$folder/mutants.out"
    mutants --list | grep -Fvxf "$results/chosen.txt" >"$folder/mutants.out/caught.txt" || true
    # shellcheck disable=SC2086 # the tests are several words
    # Tests take longer than what is measured once where others work on the same machine.
    mutants --iterate --minimum-test-timeout 300 --output "$folder" --test-package "$packages" -- $tests || status=$?
    # 2: some were missed, 3: some ran for too long. All else is an error of the run.
    case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac
    for outcome in caught timeout unviable; do
        cat "$folder/mutants.out/$outcome.txt" >>"$results/$outcome.txt"
    done
    cp "$folder/mutants.out/missed.txt" "$results/missed.txt"
}

if [ "${3:-}" = again ]; then
    cp "$results/missed.txt" "$results/chosen.txt"
else
    rm -rf "$results"
    mkdir -p "$results"
    mutants --list --shard "$shard" --sharding round-robin >"$results/chosen.txt"
fi
for number in "${!stages[@]}"; do
    if [ -s "$results/chosen.txt" ]; then
        stage "$results/$((number + 1))" "${stages[number]}"
        cp "$results/missed.txt" "$results/chosen.txt"
    fi
done

count() {
    wc -l <"$results/$1.txt"
}
noticed=$(($(count caught) + $(count timeout)))
printf '\n%s %s: %d caught, %d ran for too long, %d missed, %d do not compile; noticed: %d of %d\n' "$room" "$shard" \
    "$(count caught)" "$(count timeout)" "$(count missed)" "$(count unviable)" "$noticed" $((noticed + $(count missed)))
cat "$results/missed.txt"
