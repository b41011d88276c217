#!/usr/bin/env bash
# All curves, pictures and the page of the gallery, anew: `bash docs/gallery.sh`. Pictures need node and Chromium.
set -euo pipefail
cd "$(dirname "$0")/.."

made=target/plm/gallery
images=docs/src/images/manual
rm -rf "$made"
cargo run --features analysis,batch,lanes --example manual -- --gallery "$made"
mkdir -p "$images"
cp "$made"/*.svg "$images"/
cp "$made"/gallery.md docs/src/gallery.md

if ! [ plm-view/page/node_modules/.package-lock.json -nt plm-view/page/package-lock.json ]; then
    npm --prefix plm-view/page ci --silent
fi
node plm-view/page/browser/pictures.js "$made" "$images"
