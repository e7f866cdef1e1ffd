"""What a machine is made of, as far as it says so itself."""

import datetime
import json
import os
import pathlib
import platform
import re
import subprocess

from .store import ROOT

ADAPTER_LINE = re.compile(r"^(?P<name>.+) \((?P<type>[^,()]+), (?P<backend>[^,()]+), (?P<driver>.+)\)$")


def output_of(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=60, check=True).stdout.strip()
    except (OSError, subprocess.SubprocessError):
        return ""


def adapters(binary):
    """As `weft adapters` lists them, the one that is taken without --adapter first."""
    lines = output_of(str(binary), "adapters").splitlines()
    return [match.groupdict() for match in map(ADAPTER_LINE.match, lines) if match]


def field(path, pattern):
    try:
        match = re.search(pattern, pathlib.Path(path).read_text(), re.M)
    except OSError:
        return None
    return match[1].strip().strip('"') if match else None


def gpu_memory():
    """[bytes], of the first card that the driver's own tool lists."""
    mib = output_of("nvidia-smi", "--query-gpu=memory.total", "--format=csv,noheader,nounits").splitlines()
    return int(mib[0]) * 1024**2 if mib and mib[0].strip().isdigit() else None


def libraries(binary):
    found = {"weft": output_of(str(binary), "--version").removeprefix("weft ")}
    found["wheel wgpu (wgpu-native)"] = field(ROOT / "scripts/setup.sh", r"wheel wgpu==([\d.]+)")
    found["npm webgpu (Dawn)"] = npm("webgpu")
    found["three.js"] = npm("three")
    found["Python"] = platform.python_version()
    return {name: version for name, version in found.items() if version}


def npm(package):
    try:
        lock = json.loads((ROOT / "package-lock.json").read_text())
    except (OSError, ValueError):
        return None
    return lock["packages"].get(f"node_modules/{package}", {}).get("version")


def describe(binary, adapter=None):
    listed = [one for one in adapters(binary) if not adapter or adapter.lower() in one["name"].lower()]
    gpu = listed[0] if listed else {}
    kib = field("/proc/meminfo", r"^MemTotal:\s+(\d+) kB")
    return {
        "date": datetime.date.today().isoformat(),
        "cpu": field("/proc/cpuinfo", r"^model name\s*:\s*(.+)$"),
        "threads": os.cpu_count(),
        "memory_bytes": int(kib) * 1024 if kib else None,
        "gpu": gpu.get("name"),
        "gpu_type": gpu.get("type"),
        "backend": gpu.get("backend"),
        "driver": gpu.get("driver"),
        "gpu_memory_bytes": gpu_memory() if gpu.get("type") != "CPU" else None,
        "system": field("/etc/os-release", r"^PRETTY_NAME=(.+)$"),
        "kernel": platform.release(),
        "browser": output_of(os.environ.get("CHROMIUM", "chromium"), "--version") or None,
        "libraries": libraries(binary),
    }


def slug(hardware):
    """A name for the file of results: adapter and threads."""
    name = re.sub(r"\(.*?\)", "", hardware["gpu"] or "no adapter").strip().lower()
    return f"{re.sub('[^a-z0-9]+', '-', name).strip('-')}-{hardware['threads']}core"
