#!/usr/bin/env bash
# A wheel of a mechanism in an environment of Python that is made here: what is missing is said, and not checked.
#
#   bash tests/python.sh            # tests/python.rs; half a minute where plm is built, four from nothing
#   bash tests/python.sh --book     # the page of the book as its reader follows it, from an empty folder; makes its picture
#   PYTHON=python3.9 bash tests/python.sh
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TERM_COLOR=never

plm=$PWD
target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
environment=$target/python
packages=(maturin numpy mypy matplotlib)
if ! "${PYTHON:-python3}" -m venv --clear "$environment" ||
    ! "$environment/bin/pip" install --quiet --disable-pip-version-check "${packages[@]}"; then
    printf 'NOT CHECKED: Python with %s cannot be had on this machine\n' "${packages[*]}"
    exit
fi
export PATH="$environment/bin:$PATH" PLM_PYTHON="$environment/bin/python"

# The block of the page that begins with this fence.
block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" docs/src/running/python.md | sed '1d;$d'; }

book() {
    local folder
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' RETURN
    ln -s "$plm" "$folder/plm"
    # Commands and the session of Python, as they stand there.
    CARGO_TARGET_DIR=$folder/target python "$plm/tests/python/page.py" "$plm/docs/src/running/python.md" "$folder"
    cp docs/src/running/python/notebook.py "$folder/pendulum"
    cd "$folder/pendulum"
    # Letters stay letters, and no day stands in the picture.
    printf 'svg.fonttype: none\nsvg.hashsalt: plm\nfont.family: sans-serif\n' >matplotlibrc
    SOURCE_DATE_EPOCH=0 MPLBACKEND=svg .venv/bin/python notebook.py | tee said.txt
    # Colours for readers who prefer a dark scheme: those of charts (crates/plm-view/src/chart/draw/look.rs).
    dark='[style*="fill: #ffffff"]{fill:#161a21!important}[style*="stroke: #000000"]{stroke:#9aa5b6!important}'
    dark+='[style*="stroke: #cccccc"]{stroke:#2c333f!important}text{fill:#e6eaf1}'
    sed "0,/^ <defs>\$/s|^ <defs>\$| <style>@media(prefers-color-scheme:dark){$dark}</style>\n <defs>|" pendulum.svg >"$plm/docs/src/images/python.svg"
    cd "$plm"
    if ! block text | cmp - "$folder/pendulum/said.txt"; then
        printf 'the page says otherwise\n'
        return 1
    fi
}

if [ "${1:-}" = --book ]; then
    book
else
    cargo test --features analysis,batch,lanes --test python -- --nocapture
fi
