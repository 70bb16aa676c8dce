"""Writes sounding-rocket.xlsx: the parts of a small sounding rocket, as a spreadsheet program would keep them.

The sheet of parts has a title in merged cells above its headings, percents, sums with their results, numbers that are shown with
two decimals, and a column for people; other sheets have what is asked, how parts grow, what burns and what is dropped. The numbers are invented. The same
bytes are written each time.

    python3 make_sounding_rocket.py
"""

import zipfile
from pathlib import Path
from xml.sax.saxutils import escape

# Number formats of cells.
GENERAL, TWO, PERCENT = 0, 1, 2

# Stations are millimetres behind the tip of the nose, along z; x and y lie across.
HEADINGS = [
    "Name", "Parent", "Configuration", "Quantity", "Copies", "Mass [kg]", "Mass sd [%]", "x [mm]", "y [mm]", "z [mm]",
    "at x [mm]", "at y [mm]", "at z [mm]", "Yaw [deg]", "Shape", "Size [mm]", "Radius [mm]", "Top radius [mm]", "Height [mm]",
    "Length [mm]", "Ixx [kg m^2]", "Iyy [kg m^2]", "Izz [kg m^2]", "Ixy [kg m^2]", "Ixz [kg m^2]", "Iyz [kg m^2]", "Maturity",
    "Group", "Subtotal [kg]", "Allowable [kg]", "Drawing",
]

# name, parent, and what else a row has.
PARTS = [
    ("rocket", None, {"Allowable [kg]": 68}),
    ("forebody", "rocket", {"Subtotal [kg]": "sum"}),
    ("nose cone", "forebody", {"Mass [kg]": 1.82, "Mass sd [%]": 0.04, "z [mm]": 402.5, "Ixx [kg m^2]": 0.0492, "Iyy [kg m^2]": 0.0493,
                               "Izz [kg m^2]": 0.0051, "Ixy [kg m^2]": 0.0002, "Ixz [kg m^2]": -0.0004, "Iyz [kg m^2]": 0.0001,
                               "Maturity": "L", "Drawing": "SR-101"}),
    ("nose tip", "forebody", {"Mass [kg]": 0.31, "Mass sd [%]": 0.01, "z [mm]": 38, "Maturity": "B", "Drawing": "SR-102"}),
    ("camera", "forebody", {"Mass [kg]": 0.46, "Mass sd [%]": 0.05, "x [mm]": 31.5, "y [mm]": -12, "z [mm]": 512, "Shape": "box",
                            "Size [mm]": "62 x 44 x 90", "Maturity": "B", "Drawing": "bought"}),
    ("spectrometer", "forebody", {"Mass [kg]": 3.95, "Mass sd [%]": 0.08, "x [mm]": -4.2, "y [mm]": 6.8, "z [mm]": 702, "Shape": "cylinder",
                                  "Radius [mm]": 58, "Length [mm]": 210, "Maturity": "E", "Drawing": "SR-110"}),
    ("electronics", "forebody", {"Mass [kg]": 2.64, "Mass sd [%]": 0.06, "x [mm]": 5.5, "y [mm]": 3.1, "z [mm]": 884, "Shape": "cylinder",
                                 "Radius [mm]": 62, "Length [mm]": 118, "Maturity": "L", "Drawing": "SR-120"}),
    ("batteries", "forebody", {"Quantity": 2, "Copies": "independent", "Mass [kg]": 0.88, "Mass sd [%]": 0.01, "z [mm]": 973,
                               "x [mm]": 1.5, "y [mm]": -2.5, "Maturity": "B", "Drawing": "bought"}),
    ("payload tube", "forebody", {"Mass [kg]": 2.05, "Mass sd [%]": 0.03, "z [mm]": 825, "Shape": "cylinder_shell", "Radius [mm]": 75,
                                  "Length [mm]": 350, "Maturity": "R", "Group": "tubes", "Drawing": "SR-130"}),
    ("recovery", "rocket", {"at z [mm]": 1010, "Subtotal [kg]": "sum"}),
    ("main parachute", "recovery", {"Mass [kg]": 1.94, "Mass sd [%]": 0.05, "z [mm]": 165, "Shape": "cylinder", "Radius [mm]": 66,
                                    "Length [mm]": 240, "Maturity": "R", "Drawing": "SR-201"}),
    ("drogue", "recovery", {"Mass [kg]": 0.42, "Mass sd [%]": 0.05, "x [mm]": 3, "z [mm]": 312, "Maturity": "R", "Drawing": "SR-202"}),
    ("release", "recovery", {"Mass [kg]": 0.76, "Mass sd [%]": 0.1, "x [mm]": -8.5, "y [mm]": 14, "z [mm]": 352, "Maturity": "E",
                             "Drawing": "SR-203"}),
    ("recovery tube", "recovery", {"Mass [kg]": 2.21, "Mass sd [%]": 0.03, "z [mm]": 190, "Shape": "cylinder_shell", "Radius [mm]": 75,
                                   "Length [mm]": 380, "Maturity": "R", "Group": "tubes", "Drawing": "SR-210"}),
    ("motor", "rocket", {"at z [mm]": 1390}),
    ("case", "motor", {"Mass [kg]": 9.35, "Mass sd [%]": 0.01, "z [mm]": 640, "Shape": "cylinder_shell", "Radius [mm]": 74,
                       "Length [mm]": 1280, "Maturity": "W", "Group": "tubes", "Drawing": "SR-301"}),
    ("bulkhead", "motor", {"Mass [kg]": 1.28, "Mass sd [%]": 0.01, "z [mm]": 12, "Shape": "cylinder", "Radius [mm]": 72, "Length [mm]": 24,
                           "Maturity": "W", "Drawing": "SR-302"}),
    ("nozzle", "motor", {"Mass [kg]": 2.36, "Mass sd [%]": 0.02, "x [mm]": 0.3, "y [mm]": -0.2, "z [mm]": 1322, "Shape": "cone",
                         "Radius [mm]": 34, "Top radius [mm]": 61, "Height [mm]": 130, "Maturity": "W", "Drawing": "SR-303"}),
    ("slag", "motor", {"Configuration": "burnout", "Mass [kg]": 0.24, "Mass sd [%]": 0.5, "z [mm]": 1180, "Maturity": "E",
                       "Drawing": "what stays of the propellant"}),
    ("fins", "rocket", {"at z [mm]": 2480}),
] + [
    # Fins in their own frames, turned about the axis.
    (f"fin {k + 1}", "fins", {"Yaw [deg]": 90 * k if k else None, "Mass [kg]": 0.615, "Mass sd [%]": 0.02, "x [mm]": 152, "y [mm]": 0,
                              "z [mm]": 96, "Shape": "box", "Size [mm]": "146 x 4 x 172", "Maturity": "R", "Group": "fins",
                              "Drawing": "SR-401"})
    for k in range(4)
] + [
    ("fin can", "fins", {"Mass [kg]": 1.44, "Mass sd [%]": 0.03, "z [mm]": 92, "Shape": "cylinder_shell", "Radius [mm]": 77,
                         "Length [mm]": 190, "Maturity": "R", "Drawing": "SR-402"}),
]

PLAN = [
    ("key", "value"),
    ("title", "A sounding rocket"),
    ("products", "tensor elements"),
    ("about", "center"),
    ("ignore", '["Drawing"]'),
    ("configurations", '["lift-off", "burnout"]'),
]
GROWTH = [("code", "growth"), ("E", 0.25), ("L", 0.15), ("R", 0.08), ("B", 0.03), ("W", 0.0)]
GROUP = [("name", "mass"), ("tubes", 0.8), ("fins", 0.95)]
LIMIT = [
    ("name", "of", "along", "most", "least"),
    ("centre off the axis", "center distance", "z", "0.8 mm", None),
    ("couple about the axis", "couple unbalance", "z", "0.05 kg m^2", None),
    ("tilt", "tilt", "z", "0.08 deg", None),
    ("spin lasts", "spin stability", "z", None, 0),
]
# Holes in the ring between payload and recovery.
SITE = [
    ("name", "at", "radius", "normal", "holes", "first"),
    ("ring", "[0, 0, '1010 mm']", "68 mm", "z", 12, "x"),
]
BALLAST = [("key", "value"), ("most", "500 g")]
RESULT = [("key", "value"), ("about", "[0, 0, '1.5 m']"), ("seed", 11)]
# The grain, in the motor's frame, by what is left of it: it burns from its axis outwards.
GRAIN_MASS, GRAIN_RADIUS, GRAIN_LENGTH, GRAIN_PLACE = 28.6, 0.068, 1.21, 648


def grain(left):
    mass, inner = GRAIN_MASS * left, GRAIN_RADIUS**2 * (1 - left)
    along = mass * (GRAIN_RADIUS**2 + inner) / 2
    across = along / 2 + mass * GRAIN_LENGTH**2 / 12
    return (float(f"{mass:.8g}"), GRAIN_PLACE, *(float(f"{moment:.8g}") for moment in (across, across, along)))


GRAIN = [("mass [kg]", "z [mm]", "Ixx [kg m^2]", "Iyy [kg m^2]", "Izz [kg m^2]"), *(grain(k / 8) for k in range(1, 9))]
# The motor is full of it, and its density is known to half a percent.
TANK = [
    ("name", "frame", "configuration", "table", "fill", "density_sd"),
    ("propellant", "motor", "lift-off", "grain", 1, "0.5 %"),
]
SEQUENCE = [("key", "value"), ("configuration", "lift-off"), ("until", "20 s"), ("spin", '["0.05 rad/s", 0, "3 rev/s"]')]
# What does not burn is the slag.
BURN = [("tank", "until", "mass"), ("propellant", "6.2 s", "28.36 kg")]
DROP = [("time", "rows"), ("12 s", '["motor", "fins"]')]
EXIT = [("position", "radius", "axis"), ("[0, 0, '2777 mm']", "61 mm", "[0, 0, 1]")]

OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
PACKAGE = "http://schemas.openxmlformats.org/package/2006"
MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
HEAD = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'


def letters(column):
    name = ""
    column += 1
    while column:
        column, rest = divmod(column - 1, 26)
        name = chr(ord("A") + rest) + name
    return name


class Strings:
    """The texts that cells share."""

    def __init__(self):
        self.all = []

    def number(self, text):
        if text not in self.all:
            self.all.append(text)
        return self.all.index(text)

    def xml(self):
        items = "".join(f'<si><t xml:space="preserve">{escape(text)}</t></si>' for text in self.all)
        return f'{HEAD}<sst xmlns="{MAIN}" count="{len(self.all)}" uniqueCount="{len(self.all)}">{items}</sst>'


def cell(strings, row, column, value, style=GENERAL, formula=None):
    place = f"{letters(column)}{row}"
    if value is None:
        return ""
    if isinstance(value, str):
        return f'<c r="{place}" t="s"><v>{strings.number(value)}</v></c>'
    formula = f"<f>{formula}</f>" if formula else ""
    return f'<c r="{place}" s="{style}">{formula}<v>{value!r}</v></c>'


def parts(strings):
    rows = [f'<row r="1">{cell(strings, 1, 0, "Sounding rocket, mass properties")}</row>']
    first = 3
    rows.append(f'<row r="{first}">{"".join(cell(strings, first, k, name) for k, name in enumerate(HEADINGS))}</row>')
    mass, quantity = HEADINGS.index("Mass [kg]"), HEADINGS.index("Quantity")
    for number, (name, parent, values) in enumerate(PARTS, first + 1):
        # What is on the axis has zeros across: an empty cell would not say so.
        for across in ("x [mm]", "y [mm]", "at x [mm]", "at y [mm]"):
            if across.replace("x", "z").replace("y", "z") in values:
                values.setdefault(across, 0)
        cells = [name, parent] + [values.get(heading) for heading in HEADINGS[2:]]
        xml = ""
        for column, value in enumerate(cells):
            heading = HEADINGS[column]
            style = {"Mass [kg]": TWO, "Subtotal [kg]": TWO, "Mass sd [%]": PERCENT}.get(heading, GENERAL)
            formula = None
            if value == "sum":
                inside = [(k, row) for k, row in enumerate(PARTS, first + 1) if row[1] == name]
                value = sum(row[2]["Mass [kg]"] * row[2].get("Quantity", 1) for _, row in inside)
                m, q = letters(mass), letters(quantity)
                a, b = inside[0][0], inside[-1][0]
                formula = f"SUMPRODUCT({m}{a}:{m}{b},IF({q}{a}:{q}{b}=&quot;&quot;,1,{q}{a}:{q}{b}))"
            xml += cell(strings, number, column, value, style, formula)
        rows.append(f'<row r="{number}">{xml}</row>')
    return rows, '<mergeCells count="1"><mergeCell ref="A1:F1"/></mergeCells>'


def table(strings, rows, style=GENERAL):
    return [
        f'<row r="{number}">{"".join(cell(strings, number, k, value, style) for k, value in enumerate(row))}</row>'
        for number, row in enumerate(rows, 1)
    ]


def sheet(rows, behind=""):
    return f'{HEAD}<worksheet xmlns="{MAIN}"><sheetData>{"".join(rows)}</sheetData>{behind}</worksheet>'


def relations(all_of_them):
    items = "".join(
        f'<Relationship Id="rId{k}" Type="{OFFICE}/{kind}" Target="{target}"/>' for k, (kind, target) in enumerate(all_of_them, 1)
    )
    return f'{HEAD}<Relationships xmlns="{PACKAGE}/relationships">{items}</Relationships>'


STYLES = (
    f'{HEAD}<styleSheet xmlns="{MAIN}"><fonts count="1"><font/></fonts><fills count="2"><fill><patternFill patternType="none"/></fill>'
    '<fill><patternFill patternType="gray125"/></fill></fills><borders count="1"><border/></borders>'
    '<cellStyleXfs count="1"><xf numFmtId="0"/></cellStyleXfs>'
    '<cellXfs count="3"><xf numFmtId="0" xfId="0"/><xf numFmtId="2" xfId="0" applyNumberFormat="1"/>'
    '<xf numFmtId="10" xfId="0" applyNumberFormat="1"/></cellXfs>'
    '<cellStyles count="1"><cellStyle name="Normal" xfId="0" builtinId="0"/></cellStyles></styleSheet>'
)


def main():
    strings = Strings()
    rows, merged = parts(strings)
    sheets = {
        "parts": sheet(rows, merged),
        "plan": sheet(table(strings, PLAN)),
        "growth": sheet(table(strings, GROWTH, PERCENT)),
        "group": sheet(table(strings, GROUP)),
        "result": sheet(table(strings, RESULT)),
        "limit": sheet(table(strings, LIMIT)),
        "site": sheet(table(strings, SITE)),
        "ballast": sheet(table(strings, BALLAST)),
        "tank": sheet(table(strings, TANK)),
        "grain": sheet(table(strings, GRAIN)),
        "sequence": sheet(table(strings, SEQUENCE)),
        "burn": sheet(table(strings, BURN)),
        "drop": sheet(table(strings, DROP)),
        "exit": sheet(table(strings, EXIT)),
    }
    kind = "application/vnd.openxmlformats-officedocument.spreadsheetml"
    types = "".join(
        f'<Override PartName="/xl/{name}" ContentType="{kind}.{of}+xml"/>'
        for name, of in [("workbook.xml", "sheet.main"), ("styles.xml", "styles"), ("sharedStrings.xml", "sharedStrings")]
        + [(f"worksheets/sheet{k}.xml", "worksheet") for k in range(1, len(sheets) + 1)]
    )
    names = "".join(f'<sheet name="{name}" sheetId="{k}" r:id="rId{k}"/>' for k, name in enumerate(sheets, 1))
    entries = {
        "[Content_Types].xml": f'{HEAD}<Types xmlns="{PACKAGE}/content-types"><Default Extension="rels" '
        f'ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="xml" '
        f'ContentType="application/xml"/>{types}</Types>',
        "_rels/.rels": relations([("officeDocument", "xl/workbook.xml")]),
        "xl/workbook.xml": f'{HEAD}<workbook xmlns="{MAIN}" xmlns:r="{OFFICE}"><sheets>{names}</sheets></workbook>',
        "xl/_rels/workbook.xml.rels": relations(
            [("worksheet", f"worksheets/sheet{k}.xml") for k in range(1, len(sheets) + 1)]
            + [("styles", "styles.xml"), ("sharedStrings", "sharedStrings.xml")]
        ),
        "xl/styles.xml": STYLES,
        "xl/sharedStrings.xml": strings.xml(),
    }
    entries |= {f"xl/worksheets/sheet{k}.xml": xml for k, xml in enumerate(sheets.values(), 1)}
    with zipfile.ZipFile(Path(__file__).with_name("sounding-rocket.xlsx"), "w", zipfile.ZIP_STORED) as archive:
        for name, text in entries.items():
            archive.writestr(zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0)), text)


if __name__ == "__main__":
    main()
