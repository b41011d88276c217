#!/usr/bin/env bash
# All curves, pictures and pages of both galleries, anew: `bash docs/gallery.sh`, or one of them: `bash docs/gallery.sh manual`,
# `bash docs/gallery.sh machines`. Pictures need node and Chromium.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! [ crates/plm-view/page/node_modules/.package-lock.json -nt crates/plm-view/page/package-lock.json ]; then
    npm --prefix crates/plm-view/page ci --silent
fi

# The demos of the manual: curves, pictures, page of the book.
manual() {
    local made=target/plm/gallery images=docs/src/images/manual
    rm -rf "$made"
    cargo run --features analysis,batch,lanes --example manual -- --gallery "$made"
    mkdir -p "$images"
    cp "$made"/*.svg "$images"/
    cp "$made"/gallery.md docs/src/gallery.md
    node crates/plm-view/page/browser/pictures.js "$made" "$images"
}

# Machines that people know: moving pictures, page of the book. The arm is one of the demos.
machines() {
    local made=target/plm/machines images=docs/src/images/machines
    rm -rf "$made" "$images"
    mkdir -p "$made" "$images"
    cargo run --features analysis,batch,lanes --example manual -- DoubleArm --view "$made/arm.html"
    cargo run --features analysis,batch,lanes --example gallery -- --gallery "$made"
    cp "$made"/machines.md docs/src/machines.md
    node crates/plm-view/page/browser/pictures.js "$made" "$images"
}

for gallery in "${@:-manual machines}"; do
    for one in $gallery; do
        "$one"
    done
done
