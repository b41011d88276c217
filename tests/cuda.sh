#!/usr/bin/env bash
# CUDA C of mechanisms, compiled for `sm_80` and `sm_90` by NVRTC, ptxas and nvcc of NVIDIA's packages for Python. No GPU is needed, and
# nothing is run: that loops and threads have the bits of steps from text is tested by `cargo test -p plm-source`.
#
#     bash tests/cuda.sh      # PLM is the command `plm`; without it cargo builds it
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
made=$target/cuda tools=$target/tools/cuda
packages=(nvidia-cuda-nvrtc nvidia-cuda-nvcc nvidia-cuda-crt nvidia-nvvm nvidia-cuda-runtime nvidia-cuda-cccl)
if ! [ -x "$tools/bin/python" ] || ! "$tools/bin/pip" show --quiet "${packages[@]}" 2>/dev/null; then
    rm -rf "$tools"
    if ! { python3 -m venv "$tools" && "$tools/bin/pip" install --quiet --disable-pip-version-check "${packages[@]/%/==13.*}"; } >/dev/null 2>&1; then
        printf 'NOT CHECKED: %s cannot be had on this machine\n' "${packages[*]}"
        exit 0
    fi
fi
root=$(cd "$tools"/lib/python3*/site-packages/nvidia/cu13 && pwd)
nvrtc=$(find "$root" -name 'libnvrtc.so.*' | head -n 1)
plm=${PLM:-}
if [ -z "$plm" ]; then
    cargo build --quiet -p plm-cli
    plm=$target/debug/plm
fi

rm -rf "$made"
mkdir -p "$made"
folders=()
export_of() { # FILE NAME [OPTION]
    "$plm" export "$1" --cuda "$made/$2" "${@:3}" >/dev/null
    folders+=("$made/$2")
}
for name in double_pendulum four_bar chain slider_crank bouncer arm_on_jack; do
    export_of tests/snapshots/$name.plm $name
done
export_of tests/snapshots/double_pendulum.plm double_pendulum_single --single
export_of tests/cuda/crate.plm crate

printf '| mechanism | processor | registers | bytes spilled | bytes of local memory |\n|---|---|---|---|---|\n'
"$tools/bin/python" tests/cuda/compile.py "$nvrtc" "$root/bin/ptxas" "${folders[@]}"

# The whole program by nvcc, with its host half by the system's compiler.
for name in double_pendulum four_bar crate; do
    (cd "$made/$name" && PATH=$root/bin:$PATH nvcc -fmad=false -arch=sm_80 -I "$root/include" -L "$root/lib" -x cu -c ./*_run.c -o run.o)
done
printf 'compiled by NVRTC and nvcc; not run, since no GPU is asked for\n'
