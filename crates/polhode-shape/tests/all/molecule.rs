//! Molecules: published ones in every format, and malformed files.

use std::path::Path;

use polhode::body::Severity;
use polhode::observe::{RotationalConstants, Top};
use polhode_shape::molecule::{
    Atom, Element, Isotope, Isotopes, Molecule, MoleculeFormat, Species, mol, parse, pdb, xyz,
};
use polhode_source::FormatError;

const ANGSTROM: f64 = 1e-10;
const BOHR: f64 = 0.529_177_210_903;

/// Symbol, and position in ångström.
type Place = (&'static str, [f64; 3]);

fn fixture() -> toml::Table {
    let path = format!("{}/../../fixtures/molecules.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}")).parse().unwrap()
}

fn float(value: &toml::Value) -> f64 {
    value.as_float().or_else(|| value.as_integer().map(|n| n as f64)).unwrap()
}

fn floats(value: &toml::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(float).collect()
}

fn places(atoms: &toml::Value, unit: f64) -> Vec<Place> {
    let one = |atom: &toml::Value| {
        let row = floats(atom);
        let element = Element::from_number(row[0] as u8).unwrap();
        (element.symbol(), [row[1] * unit, row[2] * unit, row[3] * unit])
    };
    atoms.as_array().unwrap().iter().map(one).collect()
}

fn xyz_text(atoms: &[Place]) -> String {
    let lines = atoms.iter().map(|(s, [x, y, z])| format!("{s:2} {x:.12} {y:.12} {z:.12}\n"));
    format!("{}\nname\n{}", atoms.len(), lines.collect::<String>())
}

/// Returns a V2000 table. Its columns of ten characters hold seven decimals of these molecules,
/// instead of the usual four.
fn v2000_text(atoms: &[Place]) -> String {
    let lines = atoms.iter().map(|(s, [x, y, z])| {
        format!("{x:10.7}{y:10.7}{z:10.7} {s:<3} 0  0  0  0  0  0  0  0  0  0  0  0\n")
    });
    let bond = "  1  2  1  0\n";
    let (n, lines) = (atoms.len(), lines.collect::<String>());
    format!("name\n  program\n\n{n:3}  1  0  0  0  0  0  0  0  0999 V2000\n{lines}{bond}M  END\n")
}

fn v3000_text(atoms: &[Place]) -> String {
    let lines = atoms.iter().enumerate().map(|(k, (s, [x, y, z]))| {
        format!("M  V30 {} {s} {x:.12} {y:.12} -\nM  V30 {z:.12} 0 CHG=0\n", k + 1)
    });
    let (n, lines) = (atoms.len(), lines.collect::<String>());
    format!(
        "name\n  program\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS {n} 0 0 0 0\n\
         M  V30 BEGIN ATOM\n{lines}M  V30 END ATOM\nM  V30 END CTAB\nM  END\n"
    )
}

fn pdb_text(atoms: &[Place], decimals: usize) -> String {
    let line = |(k, (s, [x, y, z])): (usize, &Place)| {
        format!(
            "HETATM{:5} {:>2}{:<2} MOL A   1    {x:8.decimals$}{y:8.decimals$}{z:8.decimals$}  1.00  0.00          {:>2}\n",
            k + 1,
            s.to_uppercase(),
            k + 1,
            s.to_uppercase()
        )
    };
    atoms.iter().enumerate().map(line).collect::<String>() + "END\n"
}

/// Returns the molecule in every format, with the relative error due to the number of decimals.
fn in_every_format(atoms: &[Place]) -> Vec<(&'static str, f64, Molecule)> {
    let one = |text: String| mol::read(text.as_bytes()).unwrap().remove(0);
    vec![
        ("xyz", 0.0, xyz::read(xyz_text(atoms).as_bytes()).unwrap()),
        ("v2000", 5e-7, one(v2000_text(atoms))),
        ("v3000", 0.0, one(v3000_text(atoms))),
        ("pdb", 3e-3, pdb::read(pdb_text(atoms, 3).as_bytes()).unwrap()),
        ("pdb, five decimals", 3e-5, pdb::read(pdb_text(atoms, 5).as_bytes()).unwrap()),
    ]
}

fn constants(molecule: &Molecule, isotopes: Isotopes) -> RotationalConstants {
    molecule.rotational_constants(isotopes).unwrap().unwrap()
}

#[test]
fn gaussians_molecules_come_out_of_every_format() {
    for case in fixture()["gaussian"].as_array().unwrap() {
        for (format, rounding, molecule) in in_every_format(&places(&case["atoms"], 1.0)) {
            let what = format!("{:?} as {format}", case["name"]);
            let found = constants(&molecule, Isotopes::Abundant);
            assert_eq!(found.top().name(), case["top"].as_str().unwrap(), "{what}");
            let found: Vec<f64> = found.gigahertz().into_iter().flatten().collect();
            let printed = floats(&case["rotational_constants_ghz"]);
            for (got, want) in found[found.len() - printed.len()..].iter().zip(printed) {
                assert!((got / want - 1.0).abs() < 1.5e-6 + rounding, "{what}: {got} {want}");
            }
            assert_eq!(molecule.findings, [], "{what}");
        }
    }
}

#[test]
fn crawfords_molecule_comes_out_of_every_format_with_both_masses() {
    for case in fixture()["crawford"].as_array().unwrap() {
        for (format, rounding, molecule) in in_every_format(&places(&case["atoms_bohr"], BOHR)) {
            assert_eq!(molecule.formula(), "C2H4O");
            let found = constants(&molecule, Isotopes::Abundant);
            for (got, want) in found.hertz().iter().zip(floats(&case["rotational_constants_mhz"])) {
                assert!((got.unwrap() * 1e-6 / want - 1.0).abs() < 2e-7 + rounding, "{format}");
            }
            let found = constants(&molecule, Isotopes::Average).moments_in_unified_units();
            for (got, want) in found.iter().zip(floats(&case["average_moments_u_bohr2"])) {
                assert!((got / (want * BOHR * BOHR) - 1.0).abs() < 2e-8 + rounding, "{format}");
            }
        }
    }
}

#[test]
fn an_xyz_file_may_be_extended_numbered_labelled_or_in_bohr() {
    let read = |text: &str| xyz::read(text.as_bytes()).unwrap();
    let plain = read("2\nname\n13C 0.1 -0.2 0.3\n8 0.4 1.5D0 -6e-1 9 9\n");
    let carbon = Isotope::new(Element::from_symbol("C").unwrap(), 13).unwrap();
    let oxygen = Element::from_number(8).unwrap();
    let at = |x: f64, y: f64, z: f64| [x * ANGSTROM, y * ANGSTROM, z * ANGSTROM];
    let want = [
        Atom { species: Species::Isotope(carbon), position_m: at(0.1, -0.2, 0.3) },
        Atom { species: Species::Element(oxygen), position_m: at(0.4, 1.5, -0.6) },
    ];
    assert_eq!((plain.name.as_str(), plain.atoms.as_slice()), ("name", &want[..]));
    let extended = read(
        "2\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=forces:R:3:pos:R:3:Z:I:1:species:S:1 energy=-1\n\
         9 9 9 0.1 -0.2 0.3 6 C-13\n9 9 9 0.4 1.5 -0.6 8 O\n",
    );
    assert_eq!(extended.atoms, want);
    assert_eq!(extended.findings[0].code, "molecule.lattice");
    let bohr = read("1 bohr\n\nAr 1 2 4\n");
    assert!((bohr.atoms[0].position_m[2] / (4.0 * BOHR * ANGSTROM) - 1.0).abs() < 1e-15);
    assert_eq!(bohr.findings[0].code, "molecule.bohr");
    let labels = read("\u{feff}3\r\n\r\nC1 0 0 0\r\nO12 0 0 1.1\r\nBq 0 0 0.5\r\n");
    assert_eq!(labels.formula(), "CO");
    let codes: Vec<_> = labels.findings.iter().map(|f| (f.code, f.severity)).collect();
    assert_eq!(
        codes,
        [("molecule.numbered_atoms", Severity::Warning), ("molecule.massless_points", Severity::Warning)]
    );
    let frames = read("1\na\nHe 0 0 0\n2\nb\nHe 0 0 0\nHe 0 0 1\n\n1\nc\nHe 0 0 9\n\n");
    assert_eq!((frames.atoms.len(), frames.name.as_str()), (1, "a"));
    assert_eq!(frames.findings[0].message, "the file has 3 frames; only the first one is read");
    assert_eq!(frames.rotational_constants(Isotopes::Abundant).unwrap(), None);
}

#[test]
fn isotopes_are_read_from_every_connection_table() {
    let v2000 = |atoms: &str, rest: &str| {
        let text = format!(
            "\n\n\n  3  2  0  0  0  0              1 V2000\n{atoms}  1  2  1\n  1  3  1\n{rest}M  END\n"
        );
        mol::read(text.as_bytes()).map(|mut list| list.remove(0))
    };
    let atoms = "    0.0000    0.0000    0.1208 O   2  0
    0.0000    0.7617   -0.4833 H   1  0
    0.0000   -0.7617   -0.4833 H   0  0\n";
    assert_eq!(v2000(atoms, "").unwrap().formula(), "DH[18O]".replace("DH", "HD"));
    // With one `M  ISO` line, the mass differences are ignored.
    assert_eq!(v2000(atoms, "M  CHG  1   1   0\nM  ISO  1   3   3\n").unwrap().formula(), "HTO");
    assert_eq!(v2000(atoms, "M  ISO  2   1  17   2   2\nA    1\nM  END\n").unwrap().formula(), "HD[17O]");
    let d = atoms.replacen("H   1", "D   0", 1).replace("O   2", "O   0");
    assert_eq!(v2000(&d, "").unwrap().formula(), "HDO");
    let index = v2000(atoms, "M  ISO  1   4  13\n").unwrap_err();
    assert_eq!(index.kind.to_string(), "atom 4 does not exist: there are 3");
    let unknown = v2000(atoms, "M  ISO  1   1  99\n").unwrap_err();
    assert_eq!(unknown.kind.to_string(), "the isotope = 99 must be one with a known mass");
    assert_eq!(unknown.hint.unwrap(), "known isotopes: 14O, 15O, 16O, 17O, 18O");
    // The rounded atomic weight of bromine is 80, its most abundant isotope 79.
    let hbr = mol::read(
        b"\n\n\n  1  0  0     0  0            999 V2000\n    0.0000    0.0000    0.0000 Br  1  0\nM  END\n",
    );
    assert_eq!(
        (hbr.as_ref().unwrap()[0].formula(), hbr.unwrap()[0].findings[0].code),
        ("[81Br]".to_owned(), "molecule.mass_difference")
    );
    let v3000 = v3000_text(&[("C", [0.0; 3]), ("O", [0.0, 0.0, 1.1])]).replace("CHG=0", "CHG=0 MASS=18");
    let v3000 = v3000.replacen("MASS=18", "MASS=13.00335", 1);
    assert_eq!(mol::read(v3000.as_bytes()).unwrap()[0].formula(), "[13C][18O]");
}

#[test]
fn an_sdf_has_all_its_molecules() {
    let water = v2000_text(&[("O", [0.0; 3]), ("H", [0.0, 0.76, -0.59]), ("H", [0.0, -0.76, -0.59])]);
    let oxide = v3000_text(&[("C", [0.0; 3]), ("O", [0.0, 0.0, 1.1])]).replacen("name", "", 1);
    // Initials, program, date and time take twenty columns.
    let drawn = water.replacen("  program\n", "ABprogramm11212612002D\n", 1);
    let text = format!("{water}> <id>\n7\n\n$$$$\n{oxide}$$$$\n{drawn}$$$$\n\n");
    let molecules = parse(text.as_bytes(), MoleculeFormat::Sdf, Path::new("all.sdf")).unwrap();
    let all: Vec<_> = molecules.iter().map(|m| (m.name.as_str(), m.formula())).collect();
    assert_eq!(all, [("name", "H2O".to_owned()), ("", "CO".to_owned()), ("name", "H2O".to_owned())]);
    assert_eq!(molecules[0].findings, []);
    assert_eq!(molecules[2].findings[0].code, "molecule.drawing");
}

#[test]
fn a_pdb_file_has_columns_locations_and_models() {
    let line =
        |record: &str, serial: &str, name: &str, location: char, residue: &str, site: &str, rest: &str| {
            format!("{record:<6}{serial:>5} {name:<4}{location}{residue:>3} {site:<6}   {rest}\n")
        };
    let at = |x: f64, occupancy: f64, element: &str| {
        format!("{x:8.3}{:8.3}{:8.3}{occupancy:6.2}{:6.2}          {element}", 0.5, -0.25, 9.0)
    };
    let text = line("TITLE", "", "", ' ', "", "", "")
        + "TITLE     A CHAIN\nMODEL        1\n"
        + &line("ATOM", "1", " N", ' ', "ALA", "A   1 ", &at(1.0, 1.0, " N"))
        + &line("ATOM", "A0000", " CA", 'A', "ALA", "A   1 ", &at(2.0, 0.4, " C"))
        + &line("ATOM", "*****", " CA", 'B', "ALA", "A   1 ", &at(2.1, 0.6, " C1+"))
        + &line("ATOM", "4", " CB", 'A', "ALA", "A   1 ", &at(3.0, 0.4, ""))
        + &line("ATOM", "5", "HB11", ' ', "ALA", "A   1 ", &at(3.5, 1.0, ""))
        + &line("ATOM", "6", "CA", ' ', "ALA", "AA000 ", &at(4.0, 1.0, ""))
        + &line("HETATM", "7", "CA", ' ', "CA", "A   9 ", &at(5.0, 1.0, ""))
        + &line("HETATM", "8", "FE", ' ', "HEM", "A  10 ", &at(6.0, 1.0, "FE2+"))
        + &line("HETATM", "9", " O", ' ', "HOH", "A  11 ", &at(7.0, 1.0, "O1- "))
        + "ENDMDL\nMODEL        2\n"
        + &line("ATOM", "1", " N", ' ', "ALA", "A   1 ", &at(1.5, 1.0, " N"))
        + "ENDMDL\nEND\n";
    let molecule = pdb::read(text.as_bytes()).unwrap();
    let all: Vec<_> = molecule
        .atoms
        .iter()
        .map(|atom| (atom.species.element().symbol(), (atom.position_m[0] / ANGSTROM * 10.0).round()))
        .collect();
    // The first location of CA is skipped; that of CB is the only one.
    assert_eq!(
        all,
        [
            ("N", 10.0),
            ("C", 21.0),
            ("C", 30.0),
            ("H", 35.0),
            ("C", 40.0),
            ("Ca", 50.0),
            ("Fe", 60.0),
            ("O", 70.0)
        ]
    );
    let codes: Vec<_> = molecule.findings.iter().map(|f| f.code).collect();
    assert_eq!(codes, ["molecule.models", "molecule.alternate_locations", "molecule.elements_deduced"]);
    assert_eq!(molecule.findings[2].message, "the element of 4 atoms was inferred from the atom name");
    assert_eq!(molecule.step_m, 1e-3 * ANGSTROM);
    let bare = line("ATOM", "1", " CA", ' ', "ALA", "A   1 ", &at(1.0, 1.0, " C"));
    assert_eq!(pdb::read(bare.as_bytes()).unwrap().findings[0].code, "molecule.no_hydrogen");
}

#[test]
fn formulas_are_in_hills_order_and_masses_are_a_choice() {
    let read = |symbols: &str| {
        let atoms = symbols.split(' ').enumerate().map(|(k, s)| format!("{s} {k} 0.5 {}\n", k * k));
        let text = format!("{}\n\n{}", symbols.split(' ').count(), atoms.collect::<String>());
        xyz::read(text.as_bytes()).unwrap()
    };
    assert_eq!(read("Cl H O C Br D 13C H C").formula(), "C2[13C]H2DBrClO");
    assert_eq!(read("O H H Na S").formula(), "H2NaOS");
    let chlorine = read("Cl");
    let mass = |isotopes| chlorine.mass_properties(isotopes).unwrap().mass() / 1.660_539_066_60e-27;
    assert!((mass(Isotopes::Abundant) - 34.968_852_694).abs() < 1e-13);
    assert!((mass(Isotopes::Average) - 35.45).abs() < 1e-13);
    let technetium = read("Tc O 99Tc");
    let findings = technetium.findings_with(Isotopes::Average);
    assert_eq!(findings.len(), 1);
    assert!(findings[0].message.starts_with("Tc has no standard atomic weight: the mass of 97Tc is used"));
}

#[test]
fn a_turned_and_rounded_geometry_keeps_its_top() {
    // CO2 and methane along generic directions, with the usual decimals of four formats.
    let (x, y, z) = ([0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]);
    let turned =
        |[a, b, c]: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| a * x[k] + b * y[k] + c * z[k]) };
    let oxide: [Place; 3] =
        [("O", [-1.162, 0.0, 0.0]), ("C", [0.0; 3]), ("O", [1.162, 0.0, 0.0])].map(|(s, r)| (s, turned(r)));
    let h = 0.631_339;
    let methane: [Place; 5] =
        [("C", [0.0; 3]), ("H", [h, h, h]), ("H", [-h, -h, h]), ("H", [-h, h, -h]), ("H", [h, -h, -h])]
            .map(|(s, r)| (s, turned(r)));
    for (format, _, molecule) in in_every_format(&oxide) {
        let found = constants(&molecule, Isotopes::Abundant);
        assert_eq!((found.top(), found.gigahertz()[0]), (Top::Linear, None), "{format}");
    }
    for (format, _, molecule) in in_every_format(&methane) {
        assert_eq!(constants(&molecule, Isotopes::Abundant).top(), Top::Spherical, "{format}");
    }
    // A molecule bent by a degree is not linear.
    let bent = [("H", [0.0, 0.0, -1.066]), ("C", [0.0; 3]), ("N", [0.0, 0.02, 1.153])];
    for (format, _, molecule) in in_every_format(&bent) {
        assert_ne!(constants(&molecule, Isotopes::Abundant).top(), Top::Linear, "{format}");
    }
}

fn refused(format: MoleculeFormat, text: &str) -> (String, String) {
    let error: FormatError = parse(text.as_bytes(), format, Path::new("f")).unwrap_err();
    (error.to_string(), error.hint().unwrap_or_default())
}

#[test]
fn malformed_xyz_files_say_where() {
    let xyz = |text: &str| refused(MoleculeFormat::Xyz, text);
    let cases = [
        ("", "f: the file has no atoms", ""),
        ("0\n\n", "f: the file has no atoms with a mass", ""),
        ("C 0 0 0\n", "f:1:1: expected the number of atoms, found \"C\"", "line 1 is the number of atoms"),
        ("2\n\nC 0 0 0\n", "f:1:1: 2 atoms are declared, but the file has 1", "truncated"),
        (
            "99999999999\n\nC 0 0 0\n",
            "f:1:1: 99999999999 atoms are declared, but the file has 1",
            "truncated",
        ),
        (
            "1\n\nC 0 0 0\nO 0 0 1\nO 0 0 2\n",
            "f:1:1: 1 atoms are declared, but the file has 3",
            "correct the number",
        ),
        ("1\n\n8 0 0 0\n8 0 0 1\n", "f:1:1: 1 atoms are declared, but the file has 2", "correct the number"),
        ("1\n\nC 0 0 0\nbonds\n", "f:4:1: expected the number of atoms of another frame", ""),
        ("1\n\nC 0 0,5 0\n", "f:3:5: expected the coordinate y, found \"0,5\"", "use a decimal point"),
        ("1\n\nC 0 nan 0\n", "f:3:5: the coordinate y nan is not finite", ""),
        ("1\n\nC 0 1e999 0\n", "f:3:5: the coordinate y 1e999 is not finite", ""),
        ("1\n\nC 0 ******* 0\n", "f:3:5: expected the coordinate y, found \"*******\"", "did not fit"),
        ("1\n\nQq 0 0 0\n", "f:3:1: the element = Qq must be a chemical symbol", "13C"),
        ("1\n\n25C 0 0 0\n", "f:3:1: the isotope = 25C must be one with a known mass", "11C, 12C, 13C, 14C"),
        ("1\n\n119 0 0 0\n", "f:3:1: the atomic number = 119 must be from 1 to 118", ""),
        ("1\n\n1 O 0 0 0 5\n", "f:3:3: expected the coordinate x, found \"O\"", "Tinker"),
        ("1\n\nX 0 0 0\n", "f: the file has no atoms with a mass", ""),
        ("1\nProperties=species:S:1\nC 0 0 0\n", "f:2:1: Properties = ", ""),
        ("1\nProperties=pos:R:99999999999999999999\nC 0 0 0\n", "f:2:1: Properties = ", ""),
        ("1\nProperties=a:R:18446744073709551615:species:S:1:pos:R:3\nC 0 0 0\n", "f:3:8: ", ""),
        ("2\n\nC 1e200 0 0\nC -1e300 0 1\n", "f: ", ""),
    ];
    for (text, message, hint) in cases {
        let (got, advice) = xyz(text);
        assert!(got.starts_with(message), "{text:?}: {got}");
        assert!(advice.contains(hint), "{text:?}: {advice}");
    }
}

#[test]
fn malformed_tables_and_columns_say_where() {
    let head = "\n\n\n";
    let atom = "    0.0000    0.0000    0.1208 O   0  0\n";
    let counts = |n: &str| format!("{head}{n} V2000\n");
    let one = counts("  1  0  0     0  0            999");
    let shifted = format!(" {}", atom.replace("0.1208", "-0.1208"));
    let cases = [
        (
            "water".to_owned(),
            "f:1:6: expected the line of the program, found the end of the file",
            "truncated",
        ),
        (format!("{head}O 0 0 0\n"), "f:4:1: expected the number of atoms, found \"O 0\"", "line 4"),
        (one.replace("V2000", "V4000"), "f:4:35: expected V2000 or V3000 in columns 35 to 39", "line 4"),
        (
            counts("100  0  0     0  0            999") + atom,
            "f:4:1: 100 atoms are declared, but the file has 1",
            "truncated",
        ),
        (one.clone() + &shifted, "f:5:", "columns 1 to 10"),
        (one.clone() + atom, "f:6:1: expected M  END, found the end of the file", "truncated"),
        (one.clone() + atom + "$$$$\n", "f:6:1: expected M  END, found \"$$$$\"", ""),
        (one.clone() + &atom.replace('O', "R#") + "M  END\n", "f:5:32: the element = R# must be", "13C"),
        (
            one.clone() + &atom.replace("0.1208", "0,1208"),
            "f:5:25: expected a coordinate, found \"0,1208\"",
            "point",
        ),
        (
            counts("  1  1  0     0  0            999") + atom + atom + "  1  2  1\nM  END\n",
            "f:6:5: expected a bond",
            "one atom more",
        ),
        (one.clone() + atom + "M  ISO999   1  13\nM  END\n", "f:6:", ""),
        ("<?xml version=\"1.0\"?>\n<sdf/>\n".to_owned(), "f:1:1: polhode does not read XML", ""),
        ("$RXN\n\n\n\n".to_owned(), "f:1:1: polhode does not read reactions", ""),
        (String::new(), "f: the file has no molecule", ""),
        (
            v3000_text(&[("C", [0.0; 3])]).replace("COUNTS 1", "COUNTS 4000000000"),
            "f:6:15: 4000000000 atoms are declared, but the file has 1",
            "truncated",
        ),
        (v3000_text(&[("C", [0.0; 3])]).replace("CHG=0", "MASS=12.5"), "f:9:30: the isotope = 12.5", "11C"),
        (v3000_text(&[("[C,N]", [0.0; 3])]), "f:8:10: the element = [C,N]", ""),
    ];
    for (text, message, hint) in cases {
        let (got, advice) = refused(MoleculeFormat::Mol, &text);
        assert!(got.starts_with(message), "{text:?}: {got}");
        assert!(advice.contains(hint), "{text:?}: {advice}");
    }
    let good = pdb_text(&[("C", [-100.5, 0.25, 0.5])], 3);
    let cases = [
        ("REMARK nothing\nEND\n".to_owned(), "f: the file has no atoms (ATOM or HETATM)", ""),
        (good.replacen("MOL A ", "MOL A", 1), "f:1:30: expected blanks in columns 28 to 30", "31 to 38"),
        (good.replacen("MOL A ", "MOL A   ", 1), "f:1:", "31 to 38"),
        (good.replace("0.250", "0,250"), "f:1:42: expected a coordinate, found \"0,250\"", "point"),
        (good[..44].to_owned(), "f:1:45: expected a coordinate", "31 to 38"),
        (good[..53].to_owned(), "f:1:50: expected z up to column 54, found \"0.50\"", "31 to 38"),
        (good.replace(" C1 ", " ?? ").replace(" C\n", "  \n"), "f:1:14: the atom's name", "77 and 78"),
    ];
    for (text, message, hint) in cases {
        let (got, advice) = refused(MoleculeFormat::Pdb, &text);
        assert!(got.starts_with(message), "{text:?}: {got}");
        assert!(advice.contains(hint), "{text:?}: {advice}");
    }
}

#[test]
fn no_bytes_make_a_reader_panic() {
    // Valid files with bytes changed, removed and repeated by a Lehmer generator.
    let atoms = [("O", [0.0, 0.1, 0.12]), ("H", [0.0, 0.76, -0.48]), ("Cl", [0.3, -0.76, -0.48])];
    let files = [
        (MoleculeFormat::Xyz, xyz_text(&atoms).repeat(2)),
        (MoleculeFormat::Sdf, v2000_text(&atoms) + "$$$$\n" + &v3000_text(&atoms)),
        (MoleculeFormat::Pdb, pdb_text(&atoms, 3)),
    ];
    let mut state = 20_261_121_u64;
    let mut next = |n: usize| {
        state = state * 48_271 % 2_147_483_647;
        state as usize % n
    };
    let mut read = 0;
    for (format, text) in files {
        for _ in 0..3000 {
            let mut bytes = text.clone().into_bytes();
            for _ in 0..=next(3) {
                let at = next(bytes.len());
                match next(4) {
                    0 => bytes[at] = b"0123456789 -.,\n\r\xff\0MCH"[next(21)],
                    1 => drop(bytes.remove(at)),
                    2 => bytes.insert(at, b" 9-\nE\xc3"[next(6)]),
                    _ => bytes.truncate(at.max(1)),
                }
            }
            if let Ok(molecules) = parse(&bytes, format, Path::new("f")) {
                read += 1;
                for molecule in molecules {
                    let body = molecule.mass_properties(Isotopes::Average).unwrap();
                    assert!(body.mass() > 0.0 && body.gyration_radii().iter().all(|r| r.is_finite()));
                }
            }
        }
    }
    assert!(read > 500, "{read}");
}

#[test]
fn what_would_change_the_mass_is_not_passed_over() {
    let masses = "1\nProperties=species:S:1:pos:R:3:masses:R:1\nC 0 0 0 13.0\n";
    let (error, hint) = refused(MoleculeFormat::Xyz, masses);
    assert!(error.contains("masses of individual atoms") && hint.contains("13C"), "{error}");

    // Ethanol as drawn by programs, without and with its hydrogen atoms.
    let atoms: [Place; 3] = [("C", [0.0, 0.1, 0.2]), ("C", [1.5, 0.0, 0.1]), ("O", [2.0, 1.3, -0.1])];
    let bare = v2000_text(&atoms).replace("  3  1  0", "  3  2  0").replace("M  END", "  2  3  1  0\nM  END");
    let read = |text: &str| parse(text.as_bytes(), MoleculeFormat::Mol, Path::new("f")).unwrap().remove(0);
    let codes = |text: &str| read(text).findings.iter().map(|f| f.code).collect::<Vec<_>>();
    assert_eq!(codes(&bare), ["molecule.no_hydrogen"]);
    // O=C=O has no hydrogen atoms.
    let dioxide: [Place; 3] = [("O", [-1.2, 0.1, 0.2]), ("C", [0.0, 0.0, 0.1]), ("O", [1.2, 0.3, -0.1])];
    let whole = v2000_text(&dioxide).replace("  3  1  0", "  3  2  0").replace("  1  2  1", "  1  2  2");
    let whole = whole.replace("M  END", "  2  3  2  0\nM  END");
    assert_eq!(codes(&whole), [""; 0]);
    let named = whole.replace("M  END", "A    1\nPh\nM  END");
    assert_eq!(codes(&named), ["molecule.abbreviations"]);
}
