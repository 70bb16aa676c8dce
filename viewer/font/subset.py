"""Makes crates/polhode-document/assets/stix-two-math.woff2: of STIX Two Math what formulas of polhode need, with its MATH table; and writes
the characters that are in it into math.css, as unicode-range.

    pip install fonttools==4.68.0 brotli==1.2.1
    npm ci && python3 font/subset.py

A character that is not among them is shown in another font: tests of polhode-document's `mathml` say that no formula has one.
"""

import re
from io import BytesIO
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

VIEWER = Path(__file__).resolve().parent.parent
SOURCE = VIEWER / "node_modules/@fontsource/stix-two-math/files/stix-two-math-latin-400-normal.woff2"
ASSETS = VIEWER.parent / "crates/polhode-document/assets"

RANGES = [
    (0x20, 0x7E),  # ASCII
    (0xA0, 0xBE),  # no-break space, ° ± ² ³ · ½ …
    (0xD7, 0xD7),  # ×
    (0x2C6, 0x2DD),  # accents
    (0x302, 0x308),  # combining accents
    (0x391, 0x3F5),  # Greek
    (0x2013, 0x2014),
    (0x2026, 0x2033),  # … ′ ″
    (0x2061, 0x2062),  # function application, invisible times
    (0x2070, 0x208E),  # superscripts, subscripts
    (0x210E, 0x210F),  # italic h, ℏ
    (0x239B, 0x23AE),  # pieces of tall brackets
    (0x1D400, 0x1D467),  # bold and italic Latin
    (0x1D6A4, 0x1D71B),  # dotless i and j, bold and italic Greek
]
OPERATORS = "−√∞∠∫≃≈≠≤≥∂∑∏∇∈∝∥⊥⋅⋯←→↔⇒⇔≡≪≫"


def main() -> None:
    options = subset.Options()
    options.flavor = "woff2"
    options.hinting = False
    options.layout_features = ["ssty", "dtls", "flac", "mkmk", "mark", "ccmp"]
    options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 13, 14]
    options.glyph_names = False
    options.notdef_outline = True
    font = TTFont(SOURCE)
    wanted = {c for first, last in RANGES for c in range(first, last + 1)} | set(map(ord, OPERATORS))
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=wanted)
    subsetter.subset(font)
    assert "MATH" in font
    # The same bytes each time.
    font["head"].modified = font["head"].created
    font.recalcTimestamp = False
    out = BytesIO()
    font.flavor = "woff2"
    font.save(out)
    (ASSETS / "stix-two-math.woff2").write_bytes(out.getvalue())
    css = ASSETS / "math.css"
    held = runs(sorted(font.getBestCmap()))
    css.write_text(re.sub(r"unicode-range:[^;]*;", f"unicode-range: {held};", css.read_text(), count=1))
    print(f"{len(out.getvalue())} bytes, {len(font.getBestCmap())} characters, {len(font.getGlyphOrder())} glyphs")


def runs(characters: list[int]) -> str:
    """U+20-7E, U+A0, …"""
    found: list[list[int]] = []
    for c in characters:
        if found and c == found[-1][1] + 1:
            found[-1][1] = c
        else:
            found.append([c, c])
    return ", ".join(f"U+{a:X}" if a == b else f"U+{a:X}-{b:X}" for a, b in found)


if __name__ == "__main__":
    main()
