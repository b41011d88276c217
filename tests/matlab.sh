#!/usr/bin/env bash
# What the page *In MATLAB and Simulink* makes, without MATLAB: its FMU by FMPy and by the schemas of the standard, beside `plm run`; its MEX
# function in GNU Octave, where that is installed.
#
#     bash tests/matlab.sh      # PLM is the command `plm`; without it cargo builds it
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
made=$target/matlab tools=$target/tools/fmpy page=docs/src/running/matlab.md version=0.3.32
if ! "$tools/bin/python" -c "import fmpy; assert fmpy.__version__ == '$version'" 2>/dev/null; then
    if ! python3 -m venv "$tools" || ! "$tools/bin/pip" install --quiet --disable-pip-version-check "fmpy==$version" cmake; then
        printf 'NOT CHECKED: FMPy cannot be had on this machine (python3 with venv and pip)\n'
        exit 0
    fi
fi
plm=${PLM:-}
if [ -z "$plm" ]; then
    cargo build --quiet -p plm-cli
    plm=$target/debug/plm
fi
plm=$(realpath "$plm")

rm -rf "$made"
mkdir -p "$made"
sed -n '/^pub Pendulum {/,/^}/p' $page >"$made/pendulum.plm"
sed -n '/^```c$/,/^```$/p' $page | sed '/^```/d' >"$made/swing.c"
cd "$made"
"$plm" run pendulum.plm --until 2 --every 0.01 --sampled --csv - --input drive=1.5 --method Dop853:1e-12 >run.csv
for fmi in 2 3; do
    "$plm" export pendulum.plm --fmu-source "pendulum$fmi.fmu" --fmi $fmi
    PATH=$tools/bin:$PATH fmpy compile "pendulum$fmi.fmu" >"compile$fmi.txt" 2>&1 || { cat "compile$fmi.txt"; exit 1; }
done
"$tools/bin/python" - <<'END'
import csv, zipfile, io
import fmpy
from fmpy.validation import validate_fmu
from lxml import etree
from pathlib import Path

schemas = Path(fmpy.__file__).parent / "schema"
rows = [[float(cell) for cell in row] for row in list(csv.reader(open("run.csv")))[1:]]
for number in (2, 3):
    name = f"pendulum{number}.fmu"
    problems = validate_fmu(name)
    assert not problems, problems
    archive = zipfile.ZipFile(name)
    schema = etree.XMLSchema(etree.parse(str(schemas / f"fmi{number}" / f"fmi{number}ModelDescription.xsd")))
    schema.assertValid(etree.parse(io.BytesIO(archive.read("modelDescription.xml"))))
    binaries = [entry for entry in archive.namelist() if entry.startswith("binaries/")]
    assert binaries, archive.namelist()
    result = fmpy.simulate_fmu(name, fmi_type="CoSimulation", stop_time=2, output_interval=0.01, start_values={"drive": 1.5},
                               output=["bar.angle"])
    far = max(abs(own["bar.angle"] - row[1]) for own, row in zip(result, rows))
    assert len(result) == len(rows) == 201 and far < 1e-9, (len(result), len(rows), far)
    print(f"{name}: valid, {binaries[-1]}, at most {far:.1e} rad from plm run")
END
if ! command -v mkoctfile >/dev/null || ! command -v octave-cli >/dev/null; then
    printf 'NOT CHECKED: the MEX function, without GNU Octave (apt-get install octave octave-dev)\n'
    exit 0
fi
"$plm" export pendulum.plm --c-source pendulum >/dev/null
mkoctfile --mex -Ipendulum swing.c pendulum/pendulum.c
octave-cli --no-gui --eval 'angle = swing(0.001, 2000, 1.5); printf("%.15g\n", angle(end))' >octave.txt
tail -n 1 run.csv | cut -d , -f 2 | paste - octave.txt |
    awk '{ d = $1 - $2; if (d < 0) d = -d; printf "MEX function in Octave: %s rad, plm run %s\n", $2, $1; exit !(d < 1e-9) }'
