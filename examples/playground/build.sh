#!/usr/bin/env bash
# Makes the playground: target/plm/playground.html, one file that asks nothing of any network.
#
#     bash examples/playground/build.sh
#
# It needs node (20 or later), npm, and `rustup target add wasm32-unknown-unknown`.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD

bash plm-view/page/check.sh --install
made=$root/target/plm/playground
mkdir -p "$made"
(
    cd plm-view/page
    node_modules/.bin/esbuild editor/editor.js --bundle --minify --format=iife --global-name=plmEditor \
        --footer:js="globalThis.plmEditor = plmEditor;" --legal-comments=none --log-level=warning --outfile="$made/bundle.js"
    # The licence of CodeMirror asks to stand beside it.
    { printf '/*\n'; cat node_modules/@codemirror/state/LICENSE; printf '*/\n'; cat "$made/bundle.js"; } > "$made/editor.js"
)

# In a folder of its own: its features are not those of the workspace.
(cd examples/playground && cargo build -q --release --lib --target wasm32-unknown-unknown --target-dir "$root/target/playground")
machines=examples/gallery/machines
cargo run -q -p plm-cli --example playground -- target/plm/playground.html \
    target/playground/wasm32-unknown-unknown/release/plm_playground.wasm "$made/editor.js" examples/four_bar.rs \
    $machines/{watt,peaucellier,lambda,klann,whitworth,pumpjack,scissor,andrews,walschaerts,wiper}.rs examples/double_pendulum.rs
