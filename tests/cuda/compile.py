"""CUDA C of `plm export --cuda`, compiled by NVRTC and ptxas for two kinds of GPU, without one: registers and what is spilled, by kernel.

    python compile.py NVRTC PTXAS FOLDER ...
"""

import ctypes
import re
import subprocess
import sys
from pathlib import Path

nvrtc, ptxas = ctypes.CDLL(sys.argv[1]), sys.argv[2]


def ptx(folder: Path, architecture: int) -> str:
    """The text of one unit for virtual processors of an architecture."""
    (unit,) = folder.glob("*.cu")
    program = ctypes.c_void_p()
    assert nvrtc.nvrtcCreateProgram(ctypes.byref(program), unit.read_bytes(), unit.name.encode(), 0, None, None) == 0
    options = [f"--gpu-architecture=compute_{architecture}", "-fmad=false", f"-I{folder}"]
    words = (ctypes.c_char_p * len(options))(*[option.encode() for option in options])
    failed = nvrtc.nvrtcCompileProgram(program, len(options), words)
    length = ctypes.c_size_t()
    nvrtc.nvrtcGetProgramLogSize(program, ctypes.byref(length))
    log = ctypes.create_string_buffer(length.value)
    nvrtc.nvrtcGetProgramLog(program, log)
    if failed or log.value.strip():
        sys.exit(f"{unit}: NVRTC {failed}\n{log.value.decode()}")
    assert nvrtc.nvrtcGetPTXSize(program, ctypes.byref(length)) == 0
    text = ctypes.create_string_buffer(length.value)
    assert nvrtc.nvrtcGetPTX(program, text) == 0
    return text.value.decode()


for folder in map(Path, sys.argv[3:]):
    for architecture in (80, 90):
        text = ptx(folder, architecture)
        # Roots and quotients are instructions of their own, which round as IEEE 754 says; nothing else may be fused or approximate.
        wrong = set(re.findall(r"\b(?:fma|mad)\.\S*f(?:32|64)\b|\S*\.approx\S*|\S*\.ftz\S*", text))
        assert not wrong, f"{folder}: {wrong}"
        made = folder / f"sm_{architecture}.ptx"
        made.write_text(text)
        said = subprocess.run(
            [ptxas, "-v", f"-arch=sm_{architecture}", made, "-o", made.with_suffix(".cubin")], capture_output=True, text=True, check=True
        ).stderr
        for kernel, stack, spilled, registers in re.findall(
            r"Compiling entry function '(\w+)'.*?(\d+) bytes stack frame, (\d+) bytes spill stores.*?Used (\d+) registers", said, re.DOTALL
        ):
            if kernel.endswith("_steps"):
                print(f"| {folder.name} | sm_{architecture} | {registers} | {spilled} | {stack} |")
