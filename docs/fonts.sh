#!/usr/bin/env bash
# The font of the book's formulas: those signs of Latin Modern Math that formulas have, under a name of its own.
#
#     bash docs/fonts.sh /usr/share/texmf/fonts/opentype/public/lm-math/latinmodern-math.otf   # of Debian's fonts-lmodern
#
# Needs Python with fonttools and brotli.
set -euo pipefail
font=$(realpath "$1")
cd "$(dirname "$0")/src/fonts"

signs=U+20-7E,U+A0,U+A8,U+AC,U+AF,U+B1,U+B4,U+B7,U+D7,U+F7,U+2C6-2DC,U+302-308,U+391-3A9,U+3B1-3C9,U+3D1,U+3D5,U+3D6,U+3F1,U+3F5,U+2016,U+2026
signs+=,U+2032-2037,U+2061-2064,U+210E,U+2190-2194,U+21D0-21D4,U+2200-2209,U+220F-2213,U+2215-221E,U+2223-222E,U+223C,U+2243
signs+=,U+2245,U+2248,U+2260,U+2261,U+2264,U+2265,U+226A,U+226B,U+22A4,U+22A5,U+22C5,U+22EE-22F1,U+2308-230B,U+27E8,U+27E9
signs+=,U+2A7D,U+2A7E,U+1D400-1D467,U+1D5B3,U+1D6FC-1D71B

python3 - "$font" "$signs" <<'PYTHON'
import sys
from fontTools import subset

font, signs = sys.argv[1:]
options = subset.Options(flavor="woff2", layout_features=["ssty"], hinting=False, desubroutinize=True)
options.drop_tables += ["FFTM"]
made = subset.load_font(font, options)
wanted = subset.Subsetter(options)
wanted.populate(unicodes=subset.parse_unicodes(signs))
wanted.subset(made)
# The licence asks for another name of what was changed.
for record in made["name"].names:
    if record.nameID in (1, 3, 4, 6, 16):
        record.string = "PlmMath" if record.nameID == 6 else "Plm Math"
cff = made["CFF "].cff
cff.fontNames[0] = "PlmMath"
cff[0].FullName, cff[0].FamilyName = "Plm Math", "Plm Math"
subset.save_font(made, "math.woff2", options)
PYTHON
