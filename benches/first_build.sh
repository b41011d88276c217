#!/usr/bin/env bash
# What a user's first build costs, a double pendulum with default features: seconds of the processor that rustc takes, by
# crate, the least of some runs (half a minute each). With load on the machine they grow, so compare two checkouts in turn:
#
#     CARGO_INCREMENTAL=0 bash benches/first_build.sh 3
#
# Without incremental compilation, as dependencies from a registry are built. Another checkout is measured by ROOT=folder.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
root=$(cd "${ROOT:-$here}" && pwd)
runs=${1:-1}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir "$work/src"
cp "$root/Cargo.lock" "$work/"
cat >"$work/Cargo.toml" <<TOML
[package]
name = "first"
version = "0.0.0"
edition = "2024"
[dependencies]
plm = { package = "plm-planar", path = "$root" }
[workspace]
TOML
{
    echo 'plm::mechanism! {'
    cat "$here/plm-macros/compiler/examples/double_pendulum.plm"
    echo '}
fn main() -> Result<(), plm::Fault> {
    DoublePendulum::new().start()?.step(1e-3)
}'
} >"$work/src/main.rs"

# In the place of rustc: runs it, and appends what it took and which crate it built.
cat >"$work/timed" <<'PYTHON'
#!/usr/bin/env python3
import os, resource, subprocess, sys
status = subprocess.run(sys.argv[1:], close_fds=False).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
words = sys.argv[1:]
if "--crate-name" in words and "___" not in words:
    name = words[words.index("--crate-name") + 1]
    with open(os.environ["PLM_TIMES"], "a") as times:
        times.write(f"{name} {used.ru_utime + used.ru_stime:.2f}\n")
sys.exit(status)
PYTHON
chmod +x "$work/timed"

for ((run = 1; run <= runs; run++)); do
    PLM_TIMES=$work/times.$run RUSTC_WRAPPER=$work/timed cargo build --quiet --manifest-path "$work/Cargo.toml" \
        --target-dir "$work/target"
    rm -rf "$work/target"
done

# Of each crate the least; build scripts have one name, and are added up.
python3 - "$work"/times.* <<'PYTHON'
import collections, sys
least = {}
for path in sys.argv[1:]:
    used = collections.Counter()
    for line in open(path):
        name, seconds = line.split()
        used[name.replace("build_script_build", "build scripts")] += float(seconds)
    for name, seconds in used.items():
        least[name] = min(seconds, least.get(name, seconds))
for name, seconds in sorted(least.items(), key=lambda row: -row[1]):
    print(f"{name:16} {seconds:6.2f}")
print(f"{'all':16} {sum(least.values()):6.2f}")
PYTHON
