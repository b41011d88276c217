#!/usr/bin/env bash
# The README's moving pictures, anew: `bash docs/hero.sh`. Needs node and Chromium.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo run --quiet --example four_bar
bash plm-view/page/check.sh --install
# GitHub's own backgrounds, so that the picture has no frame there.
declare -A back=([light]="#ffffff" [dark]="#0d1117")
for scheme in light dark; do
    node plm-view/page/browser/moving.js target/plm/four_bar.html "docs/src/images/four-bar-$scheme.webp" --height 320 \
        --arrows 0.6 --paths coupler.tip --forces all --scheme "$scheme" --back "${back[$scheme]}"
done
