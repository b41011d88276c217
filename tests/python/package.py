"""Looks for paths of this machine in a wheel and a source distribution: package.py WHEEL SOURCE PATHS..."""

import io
import os
import re
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

from common import expect

wheel, source, *paths = sys.argv[1:]
known = {path for path in (*paths, os.getcwd(), os.path.expanduser("~"), sys.prefix) if len(path) > 1}
# A source of Rust by its whole path; those of the standard library stand under what every machine calls so.
RUST = re.compile(rb"(?<![\w./<>-])/(?!rustc/|rust/deps/)[\w.@+-]+/[\w./@+-]*\.rs\b")


def members():
    with zipfile.ZipFile(wheel) as archive:
        yield from ((f"wheel: {name}", archive.read(name)) for name in archive.namelist())
    with tarfile.open(fileobj=io.BytesIO(Path(source).read_bytes())) as archive:
        for member in archive.getmembers():
            if member.isfile():
                yield f"source: {member.name}", archive.extractfile(member).read()


count, found = 0, []
for name, data in members():
    count += 1
    found += [f"{name}: {path}" for path in known if os.fsencode(path) in data]
    if name.endswith((".so", ".pyd", ".dylib")):
        found += [f"{name}: {path!r}" for path in RUST.findall(data)]
expect(not found, f"no path of this machine is in {count} files, {sorted(known)}: {found[:9]}")
names = [name for name, _ in members()]
expect(any(name.endswith("/plm/src/lib.rs") for name in names) and any("_native" in name for name in names), "all is there")

# cargo finds all that it needs in the source distribution, of the versions of the wheel.
with tempfile.TemporaryDirectory() as folder:
    with tarfile.open(source) as archive:
        archive.extractall(folder)
    (root,) = Path(folder).iterdir()
    (manifest,) = (path for path in root.rglob("Cargo.toml") if "plm" not in path.relative_to(root).parts)
    command = ["cargo", "metadata", "--format-version", "1", "--locked", "--offline", "--manifest-path", manifest]
    done = subprocess.run(command, capture_output=True, text=True)
    expect(done.returncode == 0, f"cargo resolves the source distribution: {done.stderr}")
    expect(done.stdout.count(f'"manifest_path":"{root}') > 5, "in itself")
