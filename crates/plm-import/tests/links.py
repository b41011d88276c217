"""Drawings of `plm export --dxf`, read by ezdxf.

    python3 -m pip install ezdxf==1.4.5
    python3 crates/plm-import/tests/links.py FOLDER

audits each DXF of the folder, asks for closed outlines in millimetres, and compares round holes with pins.csv, and their distances with
lengths.csv. It ends with 1 where something is wrong.
"""

import csv
import math
import sys
from pathlib import Path

import ezdxf
from ezdxf import bbox


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def main(folder):
    pins, lengths = rows(folder / "pins.csv"), rows(folder / "lengths.csv")
    wrong = 0
    for path in sorted(folder.glob("**/*.dxf")):
        drawing = ezdxf.readfile(path)
        audit = drawing.audit()
        space = drawing.modelspace()
        kinds = {kind: len(space.query(kind)) for kind in ("POLYLINE", "CIRCLE", "TEXT")}
        closed = all(line.is_closed for line in space.query("POLYLINE"))
        box = bbox.extents(space.query("POLYLINE CIRCLE"))
        size = " x ".join(f"{part:.3f}" for part in (box.size.x, box.size.y))
        print(f"{path.name}: {len(audit.errors)} errors, {len(audit.fixes)} fixes, units {drawing.units}, {kinds}, {size} mm")
        wrong += len(audit.errors) + len(audit.fixes) + (drawing.units != 4) + (not closed)
        if path.parent.name != "links":
            continue
        own = {pin["port"]: pin for pin in pins if pin["link"] == path.stem and pin["joint"]}
        holes = [circle.dxf for circle in space.query("CIRCLE")]
        for pin in own.values():
            at = (float(pin["x (mm)"]), float(pin["y (mm)"]))
            near = [hole for hole in holes if math.dist(at, (hole.center.x, hole.center.y)) < 1e-6]
            wrong += len(near) != 1
        for row in lengths:
            if row["link"] == path.stem and row["from"] in own and row["to"] in own:
                ends = [[float(own[row[end]][axis]) for axis in ("x (mm)", "y (mm)")] for end in ("from", "to")]
                wrong += abs(math.dist(*ends) - float(row["length (mm)"])) > 2e-6
    print("nothing is wrong" if wrong == 0 else f"{wrong} things are wrong")
    return wrong != 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
