#!/usr/bin/env python3
"""Checks that each page of the site of documents is in a table of contents (toctree), and that each entry is a page.

Sphinx reports the same when it builds the site, which takes minutes and more packages: ./run docs.
"""

import posixpath
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))
import build


def complaints(pages):
    """The complaints about pages, a map from their paths in the site to their texts."""
    names = {posixpath.splitext(page)[0] for page in pages}
    listed, found = {"index"}, []
    for page, text in pages.items():
        for block in re.findall(r"^```\{toctree\}$(.*?)^```$", text, flags=re.M | re.S):
            for line in block.split("\n"):
                if not line.strip() or line.startswith(":"):
                    continue
                entry = re.sub(r"^.*<(.*)>$", r"\1", line.strip())
                name = posixpath.normpath(posixpath.join(posixpath.dirname(page), entry))
                listed.add(name)
                if name not in names:
                    found.append(f"the toctree of {page} lists '{entry}', which does not exist")
    return found + [f"{name} is in no toctree" for name in sorted(names - listed)]


def main():
    stage = build.Stage(Path())
    pages = {name: "" for name in stage.pages.values()}
    for path, name in stage.pages.items():
        if path.endswith(".md") and (ROOT / path).is_file():
            pages[name] = (ROOT / path).read_text()
    found = complaints(pages)
    broken = {
        "index.md": pages["index.md"].replace("\ncommands\n", "\ncommand\n", 1),
        "theorems/index.md": pages["theorems/index.md"].replace("\npendulum\n", "\n", 1),
    }
    noticed = complaints(pages | broken)
    if set(noticed) - set(found) != {
        "the toctree of index.md lists 'command', which does not exist",
        "commands is in no toctree",
        "theorems/pendulum is in no toctree",
    }:
        found.append(f"two removed entries are not noticed: {noticed}")
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
