#!/usr/bin/env bash
# Makes the playground, compares the numbers of its module with those of an ordinary program, and tries it in a browser.
set -euo pipefail
cd "$(dirname "$0")/../.."
bash examples/playground/build.sh

# The module's functions are WebAssembly that it wrote, those of the program are evaluated by steps: the same bits.
target=$PWD/target/playground
(cd examples/playground && cargo build -q --release --bin twin --target-dir "$target" &&
    cargo clippy -q --release --lib --target wasm32-unknown-unknown --target-dir "$target" -p plm-playground -p plm-jit -- -D warnings)
texts=$PWD/target/plm/playground/texts
mkdir -p "$texts"
for file in examples/gallery/machines/*.rs crates/plm-program/examples/four_bar.rs examples/double_pendulum.rs; do
    "$target/release/twin" --declaration "$file" > "$texts/$(basename "$file" .rs).plm"
done
find "$texts" -empty -delete
files=("$texts"/*.plm examples/figures/parts/*.plm)
node examples/playground/run.mjs "$target/wasm32-unknown-unknown/release/plm_playground.wasm" "${files[@]}" > "$target/by-module"
"$target/release/twin" "${files[@]}" > "$target/by-steps"
cmp "$target/by-module" "$target/by-steps"
printf '%d texts have the bits of the ordinary program\n' "${#files[@]}"

PLM_PLAYGROUND=$PWD/target/plm/playground.html \
    node --test --test-reporter=spec crates/plm-view/page/browser/{playground,sketch,drawn,deeds,equations}.test.js
