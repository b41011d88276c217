#!/usr/bin/env bash
# Makes the playground: target/plm/playground.html, one file that asks nothing of any network.
#
#     bash examples/playground/build.sh
#     bash examples/playground/build.sh --book target/book  # also into a built book, whose declarations then have *Open*
#
# It needs node (20 or later), npm, xz, and `rustup target add wasm32-unknown-unknown`.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
book=
if [ "${1:-}" = --book ]; then
    book=$2
    [ -f "$book/index.html" ] || { printf '%s is no built book\n' "$book" >&2; exit 1; }
fi

bash examples/playground/module.sh
made=$root/target/plm/playground
mkdir -p "$made"
cargo run -q -p plm-cli --example playground -- --script "$made/page.js"
(
    cd crates/plm-view/page
    node_modules/.bin/esbuild editor/editor.js --bundle --minify --format=iife --global-name=plmEditor \
        --footer:js="globalThis.plmEditor = plmEditor;" --legal-comments=none --log-level=warning --outfile="$made/bundle.js"
    # Names stay: the text of workers is made of functions.
    node_modules/.bin/esbuild "$made/page.js" --minify-whitespace --minify-syntax --format=esm --log-level=warning \
        --outfile="$made/page.min.js"
    # The licence of CodeMirror asks to stand beside it.
    { printf '/*\n'; cat node_modules/@codemirror/state/LICENSE; printf '*/\n'; cat "$made/bundle.js" "$made/page.min.js"; } \
        > "$made/script.js"
)

machines=examples/gallery/machines
# What browsers inflate by themselves would be larger, the module by a third.
packed() { xz --keep --force --format=lzma --lzma1=preset=9e,lc=4,pb=0 --stdout "$1"; }
packed target/playground/wasm32-unknown-unknown/release/plm_playground.wasm > "$made/module.lzma"
packed "$made/script.js" > "$made/script.lzma"
page() {
    cargo run -q -p plm-cli --example playground -- "$@" \
        "$made/module.lzma" "$made/script.lzma" examples/playground/four_bar.plm \
        $machines/{watt,peaucellier,lambda,klann,whitworth,pumpjack,scissor,andrews,walschaerts,wiper}.rs examples/double_pendulum.rs
}
page target/plm/playground.html
if [ -n "$book" ]; then
    page --book ./ "$book/playground.html"
    printf 'plmPlayground = "playground.html";\n' > "$book/playground-page.js"
fi
