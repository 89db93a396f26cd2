#!/usr/bin/env python3
"""Compiles a kernel in C++ from standard input with NVIDIA's NVRTC. Prints the number of registers on the first line, with the
bytes of private memory if there are any, then nvdisasm's text.

NVRTC_HOME names the folder with lib/libnvrtc.so* and bin/nvdisasm, as the packages nvidia-cuda-nvrtc and nvidia-cuda-nvdisasm
install them; NVRTC_ARCHITECTURE the GPU (default sm_90). Used by `shader-stats --ray`."""
import ctypes
import glob
import os
import re
import subprocess
import sys
import tempfile

home = os.environ["NVRTC_HOME"]
architecture = os.environ.get("NVRTC_ARCHITECTURE", "sm_90")
OPTIONS = ["--gpu-architecture=" + architecture, "-std=c++20", "-default-device", "-fmad=true", "-w", "--ptxas-options=-v"]


def compiled(source):
    """Returns the binary and the log."""
    libraries = glob.glob(os.path.join(home, "lib", "libnvrtc.so*"))
    # The compiler's own library of functions, found by name once it is loaded.
    for builtins in glob.glob(os.path.join(home, "lib", "libnvrtc-builtins.so*")):
        ctypes.CDLL(builtins, mode=ctypes.RTLD_GLOBAL)
    nvrtc = ctypes.CDLL(min(libraries, default="libnvrtc.so"))

    def read(what):
        size = ctypes.c_size_t()
        getattr(nvrtc, "nvrtcGet" + what + "Size")(program, ctypes.byref(size))
        buffer = ctypes.create_string_buffer(size.value)
        getattr(nvrtc, "nvrtcGet" + what)(program, buffer)
        return buffer.raw

    program = ctypes.c_void_p()
    if nvrtc.nvrtcCreateProgram(ctypes.byref(program), source, b"kernel.cu", 0, None, None):
        sys.exit("NVRTC makes no program")
    options = (ctypes.c_char_p * len(OPTIONS))(*[option.encode() for option in OPTIONS])
    failed = nvrtc.nvrtcCompileProgram(program, len(OPTIONS), options)
    log = read("ProgramLog").rstrip(b"\0").decode()
    if failed:
        sys.exit(log)
    return read("CUBIN"), log


binary, log = compiled(sys.stdin.buffer.read())
registers = re.search(r"Used (\d+) registers", log)
frame = re.search(r"(\d+) bytes stack frame", log)
if not registers:
    sys.exit("NVRTC's log has no number of registers:\n" + log)
private = int(frame.group(1)) if frame else 0
print(registers.group(1) + (f", {private} B private" if private else ""))
with tempfile.NamedTemporaryFile(suffix=".cubin") as file:
    file.write(binary)
    file.flush()
    sys.stdout.flush()
    sys.exit(subprocess.run([os.path.join(home, "bin", "nvdisasm"), "-c", file.name]).returncode)
