//! Workbooks: contents of cells, and refusals with sheet, row and column.

use polhode_budget::Growth;

use super::workbook_file::{Book, zipped};
use super::{Folder, csv, same};

const PARTS: &[&[&str]] = &[
    &["A parts list"],
    &[],
    &[
        "name",
        "parent",
        "mass [g]",
        "x [mm]",
        "y [mm]",
        "z [mm]",
        "mass sd [%]",
        "growth",
        "subtotal [g]",
        "maturity",
        "note",
        "group",
    ],
    &["sat", "", "", "", "", "", "", "", "two:17.36", "", "TRUE"],
    &[
        "rich:battery & case",
        "sat",
        "12.340000000000002",
        "1.5",
        "-2",
        "3e1",
        "percent:0.02",
        "percent:0.075",
        "",
        "",
        "date:45000",
        "wheels",
    ],
    &["inline:bolt", "sat", "result:5.02", "0", "0.25", "5.02 cm", "3", "", "", "E", "", "rods"],
];

#[test]
fn a_workbook_says_what_a_csv_says() {
    let folder = Folder::new("workbook");
    let book = Book::new()
        .sheet("parts", PARTS)
        .sheet(
            "plan",
            &[
                &["key", "value"],
                &["title", "A sat"],
                &["about", "center"],
                &["coverage_factor", "2"],
                &["result.seed", "9"],
                &["configurations", "[\"a\", \"b\"]"],
            ],
        )
        .sheet("growth", &[&["code", "growth"], &["E", "percent:0.25"], &["C 1", "0.1"]])
        .sheet("group", &[&["name", "mass"], &["wheels", "0.5"], &["rods", "percent:0.75"]])
        .sheet("empty", &[]);
    let file = folder.read("sat.xlsx", book.bytes()).unwrap();
    assert_eq!((file.title.as_deref(), file.questions.seed), (Some("A sat"), 9));
    assert_eq!(file.configurations.len(), 2);
    let other = csv(
        "# growth = { E = 0.25 }\nname,parent,mass [g],x [mm],y [mm],z [mm],mass sd [%],growth,subtotal [g],maturity\nsat,,,,,,,,17.36,\n\
         battery & case,sat,12.34,1.5,-2,30,2,7.5 %,,\nbolt,sat,5.02,0,0.25,5.02 cm,3,,,E\n",
    )
    .unwrap();
    let budget = &file.configurations[0].budget;
    same(budget, &other.configurations[0].budget, "a workbook");
    let list = budget.list();
    assert_eq!(list.rows[1].name, "battery & case");
    assert_eq!(list.rows[1].growth, Growth::Fraction(0.075));
    assert_eq!(list.rows[2].growth, Growth::Code("E".to_owned()));
    assert_eq!(list.growth.get("C 1"), Some(0.1));
    assert_eq!((list.groups[0].mass, list.groups[1].mass), (0.5, 0.75));
    // Half a unit of the last digit that is shown, not of the last that is stored.
    assert_eq!(list.rows[0].subtotal.unwrap().tolerance, 0.005e-3);
}

#[test]
fn what_is_hidden_is_read_and_said() {
    let folder = Folder::new("hidden");
    let rows: &[&[&str]] = &[&["name", "mass [g]", "x"], &["a", "1", "0"], &["b", "2", "0"]];
    let columns = "<cols><col min=\"2\" max=\"3\" hidden=\"1\"/></cols>";
    let book = Book::new()
        .sheet_with("_list", rows, columns, "", &[3])
        .sheet("plan", &[&["ignore", "[\"remarks\"]"]])
        .sheet("remarks", &[&["anything"]]);
    let file = folder.read("hidden.xlsx", book.bytes()).unwrap();
    let lines = file.sources().join("\n");
    for said in [
        "hidden sheet that was read: _list",
        "hidden columns that were read: B to C",
        "hidden rows that were read: 3",
        "ignored sheets: remarks",
    ] {
        assert!(lines.contains(said), "{said}: {lines}");
    }
    assert_eq!(file.configurations[0].budget.list().rows.len(), 3);
}

#[test]
fn a_unit_in_a_number_format_is_as_good_as_written() {
    let folder = Folder::new("shown");
    let limit: &[&[&str]] = &[&["of", "most"], &["mass", "two:3"]];
    let mass = |heading: &str, value: &str| {
        let book = Book::new().sheet("parts", &[&["name", heading], &["a", value]]).sheet("limit", limit);
        let file = folder.read("shown.xlsx", book.bytes())?;
        let budget = &file.configurations[0].budget;
        Ok::<_, String>((budget.list().rows[0].part.as_ref().unwrap().mass, file.limits[0].clone()))
    };
    for heading in ["mass [kg]", "mass [g]", "mass"] {
        let (mass, limit) = mass(heading, "two:12").unwrap();
        assert_eq!(mass, 0.012, "{heading}");
        assert_eq!(
            limit,
            csv("# [[limit]]\n# of = \"mass\"\n# most = \"3 g\"\nname,mass\na,1\n").unwrap().limits[0]
        );
    }
    let rows: &[&[&str]] = &[&["name", "mass [kg]", "x [mm]"], &["a", "1", "two:12"]];
    let error = folder.read("shown.xlsx", Book::new().sheet("parts", rows).bytes()).unwrap_err();
    assert!(error.contains("shown.xlsx: parts!C2: \"g\" is a mass where a length belongs"), "{error}");
}

#[test]
fn each_mistake_in_a_workbook_is_named_with_its_cell() {
    let folder = Folder::new("cells");
    let one = |mass: &str| Book::new().sheet("parts", &[&["name", "mass [g]"], &["a", mass]]);
    let two = |name: &str, rows: &[&[&str]]| one("1").sheet(name, rows);
    let merged = "<mergeCells count=\"1\"><mergeCell ref=\"B2:B3\"/></mergeCells>";
    let books: Vec<(Book, &str)> = vec![
        (
            one("=B1*2"),
            "b.xlsx: parts!B2: mass [g] = =B1*2 must be a value: the formula has no stored result",
        ),
        (one("#REF!"), "b.xlsx: parts!B2: mass [g] = #REF! must be a value, but the cell has an error"),
        (one("date:45000"), "b.xlsx: parts!B2: mass [g] = 45000 must be a number or a text, not a date"),
        (one("percent:0.5"), "b.xlsx: parts!B2: "),
        (one("1,234.5"), "b.xlsx: parts!B2: \"1,234.5\" is not a number"),
        (one("3 mm"), "b.xlsx: parts!B2: \"mm\" is a length where a mass belongs"),
        (one("-1"), "b.xlsx: parts!B2: \"a\" cannot exist: the mass = -0.001 must be positive"),
        (
            Book::new().sheet("the parts", &[&["name", "mass"], &["a", "heavy"]]),
            "b.xlsx: 'the parts'!B2: \"heavy\" is not a number",
        ),
        (
            Book::new().sheet("parts", &[&["name", "date:45000"], &["a", "1"]]),
            "b.xlsx: parts!B1: the heading = 45000 must be a number or a text, not a date",
        ),
        (
            Book::new().sheet("parts", &[&["name", "mass"], &["a", "1", "", "2"]]),
            "b.xlsx: parts!D2: a cell outside the columns = 2 must be under a heading",
        ),
        (
            Book::new().sheet_with("parts", &[&["name", "mass"], &["a", "1"], &["b"]], "", merged, &[]),
            "b.xlsx: parts!B2: mass = 1 must be in a separate cell: it is merged with others",
        ),
        (
            Book::new().sheet("parts", &[&["name", "mass", "shape", "radius"], &["a", "1", "sphere", "-2"]]),
            "b.xlsx: parts!D2: radius = -2.0 must be positive",
        ),
        (Book::new().sheet("parts", &[&["name", "mass", "mesh"], &["a", "1", "bad.stl"]]), "bad.stl"),
        (two("growth", &[&["E", "-0.1"]]), "b.xlsx: growth!B1: growth = -0.1 must be zero or positive"),
        (
            two("growth", &[&["E", "0.1", "0.2"]]),
            "b.xlsx: growth!C1: the row = 0.2 must be a key and its value, in two cells",
        ),
        (
            two("plan", &[&["titel", "x"]]),
            "b.xlsx: plan!A1: unknown key \"titel\" in the file | did you mean title?",
        ),
        (
            two("plan", &[&["products", "integrals"]]),
            "b.xlsx: plan!B1: products = \"integrals\" must be one of",
        ),
        (
            two("plan", &[&["coverage_factor", "=1+1"]]),
            "b.xlsx: plan!B1: coverage_factor = =1+1 must be a value: the formula has no stored result",
        ),
        (two("plan", &[&["title", "a"], &["title", "b"]]), "b.xlsx: plan!A2: duplicate key"),
        (two("group", &[&["name", "mass"], &["g", "2"]]), "b.xlsx: group!B2: mass = 2 must be from 0 to 1"),
        (two("group", &[&["mass"], &["1"]]), "b.xlsx: group!A2: the key name is missing in [[group]]"),
        (
            two("remarks", &[&["x"]]),
            "b.xlsx: which of the sheets parts, remarks has the parts? The file does not say | name it \"parts\", and list the others as ignore = [\"remarks\"]",
        ),
        (Book::new().sheet("plan", &[&["title", "x"]]), "b.xlsx: the file has no sheet \"parts\""),
    ];
    folder.write("bad.stl", "solid x\nfacet nonsense\n");
    let mut wrong = Vec::new();
    for (k, (book, expected)) in books.iter().enumerate() {
        let found = folder.read("b.xlsx", book.bytes()).err().unwrap_or_default();
        if !found.starts_with(expected) {
            wrong.push(format!("{k}: found    {found}\n   expected {expected}"));
        }
        if *expected == "bad.stl" {
            assert!(found.contains("(named in b.xlsx: parts!C2)"), "{found}");
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn archives_that_are_no_workbooks_are_refused() {
    let folder = Folder::new("archives");
    let read = |bytes: &[u8]| folder.read("a.xlsx", bytes).unwrap_err();
    let other = zipped(&[("word/document.xml".to_owned(), "<document/>".to_owned())]);
    assert!(
        read(&other).starts_with("a.xlsx: the file has no workbook | it is a ZIP archive without sheets")
    );
    let book = Book::new().sheet("parts", &[&["name", "mass"], &["a", "1"]]).bytes();
    assert!(
        read(&book[..book.len() / 2]).starts_with("a.xlsx: the archive"),
        "{}",
        read(&book[..book.len() / 2])
    );
    // A sheet with 80 MiB of spaces, which compress by a factor of about a thousand.
    let large = "<worksheet><sheetData><row r=\"1\">".to_owned()
        + &" ".repeat(80 << 20)
        + "</row></sheetData></worksheet>";
    let mut entries = vec![
        (
            "_rels/.rels".to_owned(),
            "<R><Relationship Type=\"x/officeDocument\" Target=\"w.xml\"/></R>".to_owned(),
        ),
        (
            "w.xml".to_owned(),
            "<workbook xmlns:r=\"x\"><sheets><sheet name=\"parts\" r:id=\"a\"/></sheets></workbook>"
                .to_owned(),
        ),
        (
            "_rels/w.xml.rels".to_owned(),
            "<R><Relationship Id=\"a\" Type=\"x/worksheet\" Target=\"s.xml\"/></R>".to_owned(),
        ),
    ];
    entries.push(("s.xml".to_owned(), large));
    assert!(read(&zipped(&entries)).contains("expands to more than 64 MiB"), "{}", read(&zipped(&entries)));
    for (sheet, expected) in [
        (
            "<worksheet><sheetData><row r=\"2\"><c r=\"A1\"><v>1</v></c></row></sheetData></worksheet>",
            "s.xml, line 1: cell = A1 must be in its row",
        ),
        (
            "<worksheet><sheetData><row r=\"2\"/><row r=\"1\"/></sheetData></worksheet>",
            "s.xml, line 1: row = 1 must be below the row before",
        ),
        (
            "<worksheet><sheetData><row r=\"9999999\"/></sheetData></worksheet>",
            "s.xml, line 1: row = 9999999 must be below",
        ),
        (
            "<worksheet><sheetData><row><c r=\"XFE1\"><v>1</v></c></row></sheetData></worksheet>",
            "s.xml, line 1: column = 16384 must be one of 16384",
        ),
        (
            "<worksheet><sheetData><row><c t=\"s\"><v>7</v></c></row></sheetData></worksheet>",
            "s.xml, line 1: the string = 7 must be one of the workbook's",
        ),
        ("<worksheet><sheetData><row><c>", "s.xml, line 1: expected the end of an element"),
        ("<!DOCTYPE x><worksheet/>", "s.xml, line 1: polhode does not read XML with a document type"),
    ] {
        entries.pop();
        entries.push(("s.xml".to_owned(), sheet.to_owned()));
        let error = read(&zipped(&entries));
        assert!(error.starts_with(&format!("a.xlsx: {expected}")), "{error}");
    }
    // Cells without names follow each other.
    entries.pop();
    let nameless = "<worksheet><sheetData><row><c t=\"inlineStr\"><is><t>name</t></is></c><c t=\"str\"><v>mass</v></c></row>\
                    <row><c t=\"str\"><f>A1</f><v>a&#10;&amp;</v></c><c><v>2</v></c></row></sheetData></worksheet>";
    entries.push(("s.xml".to_owned(), nameless.to_owned()));
    let file = folder.read("a.xlsx", zipped(&entries)).unwrap();
    assert_eq!(file.configurations[0].budget.list().rows[0].name, "a &");
}

#[test]
fn a_cell_is_read_alike_however_it_is_written() {
    let folder = Folder::new("alike");
    let read = |cell: &str, front: &str| {
        let rows: &[&[&str]] = &[&["name", "mass", "note"], &["a"], &["two words", "1"]];
        let mut book = Book::new().sheet("parts", rows);
        let end = "</row><row r=\"3\">";
        book.change(|xml| xml.replace(end, &format!("{cell}{end}")).replace("<c ", front));
        folder.read("alike.xlsx", book.bytes())
    };
    let mut refused = 0;
    for cell in [
        "<c r=\"D2\"><v>1.5</v></c>",
        "<c r=\"B2\"><v>1.5</v></c>",
        "<c r=\"B2\" s=\"0\"><v> 2e-3\n</v></c>\n<c r=\"C2\" t=\"b\"><v>1</v></c>",
        "<c r=\"B2\" s=\"2\"><v>0.5</v></c>",
        "<c r=\"B2\" s=\"1\"><v>45000</v></c>",
        "<c r=\"B2\" s=\"9\" t=\"n\"><v>3</v></c>",
        "<c r=\"B2\" t=\"e\"><v>#REF!</v></c>",
        "<c r=\"C2\" t=\"s\"><v>2</v></c>",
        "<c r=\"B2\" t=\"s\"><v>99</v></c>",
        "<c r=\"B2\"><f>SUM(B3)</f><v>4</v></c>",
        "<c r=\"B2\"><f>SUM(B3)</f><v></v></c>",
        "<c r=\"B2\" t=\"str\"><f>A1</f><v></v></c>",
        "<c r=\"B2\" t=\"inlineStr\"><is><t>5 ± 4 %</t></is></c>",
        "<c r=\"B2\"><v>1</v></c><c r=\"B2\"><v>2</v></c>",
        "<c r=\"A2\"><v>1</v></c>",
        "<c r=\"B3\"><v>1</v></c>",
        "<c r=\"XFE2\"><v>1</v></c>",
        "<c r=\"B2\"><v>&#49;</v></c>",
        "<c r=\"B2\"><v>1</v></b>",
        "<c r=\"B2\"><v>1",
    ] {
        // The second form is not plain.
        let (plain, other) = (read(cell, "<c "), read(cell, "<c  "));
        assert_eq!(plain, other, "{cell}");
        refused += usize::from(plain.is_err());
    }
    assert_eq!(refused, 14);
}
