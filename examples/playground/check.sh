#!/usr/bin/env bash
# Makes the playground, and tries it in a browser.
set -euo pipefail
cd "$(dirname "$0")/../.."
bash examples/playground/build.sh
cargo build -q -p plm-view --example page
PLM_PLAYGROUND=$PWD/target/plm/playground.html PLM_PAGE=$PWD/target/debug/examples/page \
    node --test --test-reporter=spec plm-view/page/browser/playground.test.js
