#!/usr/bin/env bash
# All tests of the page: installs what they need, then the modules, their types, and the page in a browser.
#
#     bash crates/plm-view/page/check.sh --install  # no more than that
#     bash crates/plm-view/page/check.sh --book     # instead, makes the pictures of the page in the book anew
set -euo pipefail
cd "$(dirname "$0")"

if ! command -v node >/dev/null; then
    printf 'NOT CHECKED: node is missing (20 or later; `apt-get install nodejs npm`)\n'
    exit 0
fi
if ! [ node_modules/.package-lock.json -nt package-lock.json ]; then
    npm ci --silent
fi
browser=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
if [ -z "$browser" ] && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    apt-get update -qq && apt-get install -y -qq --no-install-recommends chromium fonts-dejavu-core >/dev/null || true
fi
if [ "${1:-}" = --install ]; then
    exit 0
fi

# What `cargo test -p plm-planar --test live_module --example manual` has made: the module of a live page, and pages and gallery of
# the manual's demos. Tests that find none say so.
target=${CARGO_TARGET_DIR:-../../../target}
export PLM_LIVE=${PLM_LIVE:-$(cd ../../.. && pwd)/target/plm/packages/live}
if [ -d "$target/tmp" ]; then
    export PLM_PAGES=${PLM_PAGES:-$(cd "$target/tmp" && pwd)/pages}
    export PLM_GALLERY=${PLM_GALLERY:-$(cd "$target/tmp" && pwd)/gallery}
fi

# The served page's test takes the example of plm-planar where `cargo test` has built it; without it it says so.
if [ -z "${PLM_SERVED:-}" ] && served=$(cd "$target/debug/examples" 2>/dev/null && pwd) && [ -x "$served/served" ]; then
    export PLM_SERVED=$served/served
fi

# The page of the README's moving pictures: the example `four_bar`.
if [ -z "${PLM_FOUR_BAR:-}" ] && four_bar=$(cd "$target/debug/examples" 2>/dev/null && pwd) && [ -x "$four_bar/four_bar" ]; then
    export PLM_FOUR_BAR=$four_bar/four_bar
fi

if [ "${1:-}" = --book ]; then
    exec node browser/book.js
fi

printf '== types\n'
node_modules/.bin/tsc --project tsconfig.json

printf '== modules\n'
node --test --test-reporter=dot tests/*.test.js

# The browser opens pages as Rust writes them.
if [ -z "${PLM_PAGE:-}" ]; then
    PLM_PAGE=$(cargo build -q -p plm-view --example page --message-format=json |
        sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' | tail -n 1)
fi
export PLM_PAGE

printf '== browser\n'
node --test --test-reporter=spec --test-concurrency=2 browser/*.test.js
