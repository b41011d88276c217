#!/usr/bin/env bash
# The README's moving pictures, anew: `bash docs/hero.sh`. Needs node and Chromium.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo run --quiet -p plm-program --example four_bar
bash crates/plm-view/page/check.sh --install
node crates/plm-view/page/browser/hero.js target/plm/four_bar.html docs/src/images
