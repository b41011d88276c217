#!/usr/bin/env bash
# Makes the npm package of `<plm-mechanism>`: target/plm/npm/plm-mechanism-VERSION.tgz, of at most 2 MB.
#
#     bash examples/playground/npm.sh          # no more than that
#     bash examples/playground/npm.sh --check  # and tries the packed file: its types, and pages that Chromium opens
set -euo pipefail
cd "$(dirname "$0")/../.."
bash examples/playground/module.sh
page=$PWD/crates/plm-view/page
made=$PWD/target/plm/npm
rm -rf "$made"
mkdir -p "$made/package"
version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' Cargo.toml)
repository=$(sed -n '/^\[workspace.package\]/,/^\[/s/^repository = "\(.*\)"/\1/p' Cargo.toml)

# Names stay: the text of the worker is made of functions.
"$page/node_modules/.bin/esbuild" "$page/element/element.js" --bundle --minify-whitespace --minify-syntax --format=esm \
    --loader:.css=text --legal-comments=none --log-level=warning --outfile="$made/package/plm-mechanism.js"
cp "$page/element/plm-mechanism.d.ts" "$page/element/README.md" LICENSE-APACHE LICENSE-MIT "$made/package/"
cp target/playground/wasm32-unknown-unknown/release/plm_playground.wasm "$made/package/plm.wasm"
node "$page/element/package.mjs" "$version" "$repository" > "$made/package/package.json"
(cd "$made/package" && npm pack --silent --pack-destination .. > /dev/null)
file=$made/plm-mechanism-$version.tgz
size=$(wc -c < "$file")
printf '%s: %d bytes\n' "$file" "$size"
[ "$size" -le 2000000 ] || { printf 'it has more than 2 MB\n' >&2; exit 1; }

if [ "${1:-}" = --check ]; then
    PLM_ELEMENT=$file node --test --test-reporter=spec "$page"/browser/element.test.js
fi
