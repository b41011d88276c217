#!/usr/bin/env bash
# Makes the playground, and tries it in a browser.
set -euo pipefail
cd "$(dirname "$0")/../.."
bash examples/playground/build.sh
PLM_PLAYGROUND=$PWD/target/plm/playground.html \
    node --test --test-reporter=spec plm-view/page/browser/playground.test.js
