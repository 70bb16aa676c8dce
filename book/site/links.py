"""Checks the links of the built pages: python links.py SITE. Each must lead to an existing file,
and each anchor to an element in it. No page may load anything from another site."""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# Pages written by other programs, which check their own links.
FOREIGN = ("rust/", "polhode.html")
# In its address a fragment is a state, not an anchor.
INTERACTIVE = "polhode.html"


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if value is None:
                continue
            if name in ("href", "src"):
                self.links.append(value)
                if name == "src" or tag == "link":
                    self.loaded.append(value)
            elif name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)


def main(site):
    pages = {}

    def page(file):
        if file not in pages:
            pages[file] = Page(file.read_text(encoding="utf-8"))
        return pages[file]

    dead, count = [], 0
    for file in sorted(site.rglob("*.html")):
        name = file.relative_to(site).as_posix()
        if name.startswith(FOREIGN):
            continue
        dead += [f"{name}: {link}: from another site" for link in page(file).loaded if urlsplit(link).netloc]
        for link in page(file).links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            count += 1
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            anchor = unquote(parts.fragment)
            if not target.is_file():
                dead.append(f"{name}: {link}: no such file")
            elif anchor and target.suffix == ".html" and target != site / INTERACTIVE and anchor not in page(target).anchors:
                dead.append(f"{name}: {link}: no such anchor")
    for line in dead:
        print(line, file=sys.stderr)
    print(f"   {len(pages)} pages, {count} links")
    return 1 if dead or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
