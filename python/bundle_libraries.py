#!/usr/bin/env python3
"""Puts the shared libraries that a wheel needs into it, so that it installs on machines without them.

    bundle_libraries.py WHEEL

Replaces the wheel. Every ELF file in it then finds its libraries in libration/libraries, by an RPATH relative to itself
(patchelf). Only what every Debian system has remains outside: glibc, and the run-time libraries of GCC, of which a process
may load only one version. The wheel runs with the glibc of the machine that built it and later ones, which its platform
tag names (PEP 600).
"""

from __future__ import annotations

import base64
import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

# The parts of glibc and of GCC; everything else is bundled.
OF_THE_SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|pthread|rt|util|resolv|mvec|stdc\+\+|gcc_s))\.so\.\d+$")


def require_programs(*names: str) -> None:
    missing = [name for name in names if shutil.which(name) is None]
    if missing:
        raise SystemExit(f"{' and '.join(missing)} not found: install the Debian packages libc-bin (ldd) and patchelf")


def output_of(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def is_elf(file: Path) -> bool:
    with file.open("rb") as content:
        return content.read(4) == b"\x7fELF"


def libraries_of(file: Path) -> dict[str, Path]:
    """All libraries that a program or a library loads, by name, with those of its libraries."""
    found = {}
    for line in output_of("ldd", str(file)).splitlines():
        match = re.match(r"\s*(\S+) => (\S+)", line)
        if match and match[2] == "not":
            raise SystemExit(f"{file.name} needs {match[1]}, which is not installed")
        if match and not OF_THE_SYSTEM.match(match[1]):
            found[match[1]] = Path(match[2])
    return found


def bundle(package: Path) -> None:
    """Copies the libraries into package/libraries, and sets the RPATH of all files."""
    own = [file for file in package.rglob("*") if file.is_file() and is_elf(file)]
    inside = {file.name for file in own}
    folder = package / "libraries"
    folder.mkdir()
    for file in own:
        for name, path in libraries_of(file).items():
            if name not in inside:
                inside.add(name)
                shutil.copy(path, folder / name)
    for file in [*own, *folder.iterdir()]:
        to_libraries = os.path.relpath(folder, file.parent)
        to_package = os.path.relpath(package, file.parent)
        places = ":".join(f"$ORIGIN/{place}" for place in (to_libraries, to_package))
        subprocess.run(["patchelf", "--force-rpath", "--set-rpath", places, str(file)], check=True)


def write_record(tree: Path) -> None:
    """RECORD lists every file with its hash."""
    (record,) = tree.glob("*.dist-info/RECORD")
    lines = []
    for file in sorted(tree.rglob("*")):
        if file.is_file() and file != record:
            digest = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).rstrip(b"=").decode()
            lines.append(f"{file.relative_to(tree)},sha256={digest},{file.stat().st_size}")
    lines.append(f"{record.relative_to(tree)},,")
    record.write_text("\n".join(lines) + "\n", encoding="utf-8")


def rename_platform(tree: Path, wheel: Path) -> Path:
    """Sets the platform tag to manylinux_X_Y, the glibc of this machine; returns the wheel's new path."""
    glibc = platform.libc_ver()[1].replace(".", "_")
    tag = f"manylinux_{glibc}_{platform.machine()}"
    (description,) = tree.glob("*.dist-info/WHEEL")
    text = description.read_text(encoding="utf-8")
    description.write_text(re.sub(r"(?m)^(Tag: .*-)[^-\n]+$", rf"\1{tag}", text), encoding="utf-8")
    return wheel.with_name(wheel.stem.rsplit("-", 1)[0] + f"-{tag}.whl")


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    wheel = Path(sys.argv[1])
    require_programs("ldd", "patchelf")
    with tempfile.TemporaryDirectory(prefix="libration-wheel-") as name:
        tree = Path(name)
        unpack(wheel, tree)
        bundle(tree / "libration")
        renamed = rename_platform(tree, wheel)
        write_record(tree)
        replace_wheel(wheel, tree, renamed)
    return 0


def unpack(wheel: Path, tree: Path) -> None:
    """Unpacks with the modes of the files, which ZipFile.extractall ignores."""
    with zipfile.ZipFile(wheel) as archive:
        for entry in archive.infolist():
            path = Path(archive.extract(entry, tree))
            if entry.external_attr >> 16:
                path.chmod(entry.external_attr >> 16)


def pack(tree: Path, wheel: Path) -> None:
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in sorted(tree.rglob("*")):
            if file.is_file():
                archive.write(file, file.relative_to(tree))


def replace_wheel(wheel: Path, tree: Path, renamed: Path) -> None:
    """The old wheel is removed only after the new one is complete."""
    beside = renamed.with_name(renamed.name + ".part")
    try:
        pack(tree, beside)
        os.replace(beside, renamed)
    finally:
        beside.unlink(missing_ok=True)
    if wheel != renamed:
        wheel.unlink()


if __name__ == "__main__":
    sys.exit(main())
