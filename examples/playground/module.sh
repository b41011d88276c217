#!/usr/bin/env bash
# Makes the module of WebAssembly that the playground and the npm package have, and installs what bundles them:
# target/playground/wasm32-unknown-unknown/release/plm_playground.wasm.
#
# It needs node (20 or later), npm, and `rustup target add wasm32-unknown-unknown`.
set -euo pipefail
cd "$(dirname "$0")"
bash ../../crates/plm-view/page/check.sh --install
# In a folder of its own: its features are not those of the workspace.
cargo build -q --release --lib --target wasm32-unknown-unknown --target-dir ../../target/playground
