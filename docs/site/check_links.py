#!/usr/bin/env python3
"""The links of a built site that lead nowhere: check_links.py FOLDER, exit code 1 when there are any.

Looks at each page below FOLDER but for results/, whose report is made elsewhere, and asks for the files and the places in them. An
address of the network is one that a reader may follow (<a>), and a mistake where the page itself would load it.
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.places = [], {"", "top"}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.places.add(value)
            elif name in ("href", "src") and value is not None:
                self.links.append((tag, value))


def broken_links(folder):
    folder = folder.resolve()
    pages = {path: Page(path.read_text(errors="replace")) for path in folder.rglob("*.html")}
    found = []
    for path, page in sorted(pages.items()):
        where = path.relative_to(folder)
        if where.parts[0] == "results":
            continue
        for tag, link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                if tag != "a" and parts.scheme != "data":
                    found.append(f"{where}: loads {link} from a network")
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.exists():
                found.append(f"{where}: {link}")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].places:
                found.append(f"{where}: {link}, no such place")
    return found


if __name__ == "__main__":
    broken = broken_links(Path(sys.argv[1]))
    print("\n".join(broken))
    sys.exit(1 if broken else 0)
