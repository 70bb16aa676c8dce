//! Files of a scenario, and files that it names: found, missing, malformed.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::math::Position;
use polhode_scenario::read as scenario;
use polhode_shape::mesh::{MeshContents, MeshFormat, MeshSolid};
use polhode_shape::molecule;
use polhode_shape::molecule::MoleculeFormat;
use polhode_shape::{cad, particles};
use polhode_source::FormatErrorKind;
use polhode_source::files::{Disk, Memory};
use polhode_source::times;
use polhode_source::{read_file, read_text_file};

/// Returns a folder for this test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("scenario-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

const CORNER: [[[f64; 3]; 3]; 4] = {
    let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    [[o, y, x], [o, x, z], [o, z, y], [x, y, z]]
};

fn stl(triangles: &[[[f64; 3]; 3]]) -> String {
    let facet = |[a, b, c]: &[[f64; 3]; 3]| {
        let vertex = |[x, y, z]: &[f64; 3]| format!("vertex {x} {y} {z}\n");
        format!("facet normal 0 0 0\nouter loop\n{}{}{}endloop\nendfacet\n", vertex(a), vertex(b), vertex(c))
    };
    format!("solid corner\n{}endsolid\n", triangles.iter().map(facet).collect::<String>())
}

#[test]
fn a_mesh_is_found_beside_its_scenario() {
    let folder = folder("mesh");
    let odd = "naïve part (2), \"final\".stl";
    fs::write(folder.join(odd), stl(&CORNER)).unwrap();
    let text = format!("[[body.part]]\nshape = 'mesh'\nfile = '{odd}'\nunit = 'mm'\ndensity = '4 g/cm^3'\n");
    let path = folder.join("scenario with spaces.toml");
    fs::write(&path, &text).unwrap();
    let read = scenario::read(&path).unwrap();
    assert!((read.body().mass() - 4e-6).abs() < 1e-20);
    assert!((read.body().center_of_mass() - Position::new(5e-4, 7.5e-4, 2.5e-4)).norm() < 1e-18);
    assert!(read.findings().is_empty());

    let inverted: Vec<_> = CORNER.iter().map(|&[a, b, c]| [a, c, b]).chain([[[1.0; 3]; 3]]).collect();
    fs::write(folder.join(odd), stl(&inverted)).unwrap();
    let again = scenario::read(&path).unwrap();
    assert!((again.body().mass() - 4e-6).abs() < 1e-20);
    let found: Vec<_> = again.findings().iter().map(|f| (f.code, f.place.as_deref())).collect();
    let place = format!("part \"mesh 1\", {odd}");
    let triangle = format!("{place}, triangle 5");
    assert_eq!(
        found,
        [("mesh.inverted", Some(place.as_str())), ("mesh.degenerate", Some(triangle.as_str()))]
    );

    for (unit, message) in [
        ("kg", "\"kg\" is a mass where a length belongs"),
        ("1 mm", "unit = '1 mm' must be the name of a unit of length"),
        ("mmm", "unknown unit \"mmm\""),
    ] {
        let error = scenario::parse(&text.replace("'mm'", &format!("'{unit}'")), &path).unwrap_err();
        assert_eq!((error.message().as_str(), error.place().unwrap().line), (message, 4));
        assert!(error.hint().is_some());
    }
}

#[test]
fn a_draft_that_knows_a_mesh_reads_no_file_in_the_unit_that_it_knows() {
    let path = folder("known").join("part.stl");
    let text = |unit: &str| {
        format!("[[body.part]]\nshape = 'mesh'\nfile = 'part.stl'\nunit = '{unit}'\ndensity = '4 g/cm^3'\n")
    };
    let contents = MeshContents::parse(&Disk, stl(&CORNER).as_bytes(), &path, MeshFormat::Stl).unwrap();
    let solid = MeshSolid::of(contents, &path, MeshFormat::Stl, Some(0.001)).unwrap();
    let draft = || scenario::Draft::new(&path, [path.clone()]);
    let mut knowing = draft().knowing(path.clone(), Some(0.001), solid.clone());
    // The file does not exist; the mesh read before is kept.
    for _again in 0..2 {
        assert!((knowing.read(&Disk, text("mm")).unwrap().scenario.body().mass() - 4e-6).abs() < 1e-20);
    }
    let is_missing = |read: Result<_, polhode_source::FormatError>| {
        matches!(read.map(|_: scenario::ScenarioFile| ()).unwrap_err().kind(), FormatErrorKind::Io { .. })
    };
    assert!(is_missing(draft().knowing(path.clone(), Some(0.001), solid.clone()).read(&Disk, text("m"))));
    knowing.forget();
    assert!(is_missing(knowing.read(&Disk, text("mm"))));
    let other = path.with_file_name("other.stl");
    assert!(is_missing(draft().knowing(other, Some(0.001), solid).read(&Disk, text("mm"))));
}

#[test]
fn a_draft_that_is_ended_says_that_a_mesh_is_undecided() {
    let path = folder("ended").join("part.stl");
    fs::write(&path, stl(&CORNER)).unwrap();
    let text =
        "[[body.part]]\nshape = 'mesh'\nfile = 'part.stl'\nunit = 'mm'\ndensity = '4 g/cm^3'\n".to_owned();
    let mut draft = scenario::Draft::new(&path, [path.clone()]);
    let error = draft.read_watched(&Disk, text.clone(), &|| false).unwrap_err();
    assert!(error.message().contains("too many of the mesh's"), "{error}");
    // The result of the interrupted reading is not cached.
    assert!(draft.read(&Disk, text).is_ok());
}

#[test]
fn a_scenario_in_memory_is_the_one_on_the_disk() {
    let folder = folder("memory");
    fs::write(folder.join("part.stl"), stl(&CORNER)).unwrap();
    let text = "[[body.part]]\nshape = 'mesh'\nfile = 'part.stl'\nunit = 'mm'\ndensity = '4 g/cm^3'\n";
    let on_disk = scenario::parse(text, &folder.join("a.toml")).unwrap();
    let memory = Memory::from([("in/a.toml", text), ("in/part.stl", &stl(&CORNER))]);
    let read = |path: &str| scenario::ScenarioFile::read(&memory, path.as_ref());
    assert_eq!(read("in/a.toml").unwrap().scenario.body(), on_disk.body());
    // A file on the disk is not in memory.
    let error = read(folder.join("part.stl").to_str().unwrap()).unwrap_err();
    assert!(error.message().contains("the file does not exist"), "{error}");
    let other = Memory::from([("in/a.toml", text)]);
    let error = scenario::ScenarioFile::read(&other, "in/a.toml".as_ref()).unwrap_err();
    assert!(error.to_string().starts_with("in/a.toml:3:8: file = 'part.stl' must be"), "{error}");
}

#[test]
fn files_that_cannot_be_read_say_so() {
    let folder = folder("files");
    let mesh = |file: &str| {
        let text = format!("[[body.part]]\nshape = 'mesh'\nfile = \"{file}\"\nmass = 1\n");
        let path = folder.join("x.toml");
        let error = scenario::parse(&text, &path).unwrap_err();
        (error.to_string().replace(&format!("{}/", folder.display()), ""), error.hint().unwrap_or_default())
    };
    let (message, hint) = mesh("missing.stl");
    assert_eq!(message, "x.toml:3:8: cannot read \"missing.stl\": the file does not exist");
    assert!(hint.starts_with("paths are relative to the scenario"), "{hint}");
    assert_eq!(mesh("").0, "x.toml:3:8: file = \"\" must be a path");
    assert!(mesh("a\\u0000b.stl").0.starts_with("x.toml:3:8: cannot read \"a\\0b.stl\": "));
    fs::create_dir(folder.join("part.stl")).unwrap();
    assert_eq!(mesh("part.stl").0, "x.toml:3:8: cannot read \"part.stl\": it is a directory");

    fs::write(folder.join("open.stl"), stl(&CORNER[..3])).unwrap();
    let (message, hint) = mesh("open.stl");
    assert!(message.starts_with("open.stl: the mesh is open, so it has no volume: 3 edges"), "{message}");
    assert!(message.ends_with("(named in x.toml:3:8)"), "{message}");
    assert!(hint.starts_with("close the surface"), "{hint}");

    fs::write(folder.join("comma.stl"), "solid é\nfacet normal 0 0 1\nouter loop\nvertex é 0,5 1 2").unwrap();
    let (message, _) = mesh("comma.stl");
    assert_eq!(message, "comma.stl:4:8: expected a number, found \"é\" (named in x.toml:3:8)");
    let mut binary = vec![0; 84 + 50];
    binary[80] = 1;
    binary[84 + 12 + 3] = 0x7f;
    binary[84 + 12 + 2] = 0x80;
    fs::write(folder.join("binary.stl"), &binary).unwrap();
    let (message, _) = mesh("binary.stl");
    let record = "binary.stl: triangle 0 (counted from 0), byte 96: the coordinate inf is not finite";
    assert_eq!(message, format!("{record} (named in x.toml:3:8)"));
    fs::write(folder.join("cut.stl"), &binary[..100]).unwrap();
    assert!(mesh("cut.stl").0.contains("declares 1 triangle, but 0 complete ones and 16 bytes follow"));

    let read = |name: &str| scenario::read(&folder.join(name)).unwrap_err();
    let missing = read("missing\n.toml");
    assert!(missing.to_string().contains("missing\\n.toml: cannot read"), "{missing}");
    assert!(missing.place().is_none() && missing.hint().is_some());
    assert!(read("part.stl").message().ends_with("it is a directory"));
    fs::write(folder.join("latin1.toml"), b"title = 'x'\n# caf\xe9\n").unwrap();
    let latin = read("latin1.toml");
    assert_eq!(latin.message(), "the file is not valid UTF-8 text: invalid byte 0xE9");
    assert_eq!(latin.place().map(|p| (p.line, p.column)), Some((2, 6)));
    assert_eq!(latin.hint().as_deref(), Some("save the file as UTF-8"));
    fs::write(folder.join("empty.toml"), b"").unwrap();
    assert_eq!(read("empty.toml").place().map(|p| (p.line, p.column)), Some((1, 1)));
}

#[test]
fn text_in_utf16_is_named_as_such_in_every_format() {
    let folder = folder("utf16");
    let text = "mass_kg,x_m,y_m,z_m\n1,2,3,4\n";
    let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let files =
        [[vec![0xff, 0xfe], little.clone()].concat(), [vec![0xfe, 0xff], big.clone()].concat(), little, big];
    for bytes in files {
        let path = folder.join("file");
        fs::write(&path, &bytes).unwrap();
        let mut errors = vec![
            scenario::read(&path).unwrap_err(),
            read_text_file(&Disk, &path, |text| cad::read(text, &cad::CadOptions::default())).unwrap_err(),
            read_file(&Disk, &path, |bytes| particles::read(bytes, &particles::ParticleOptions::default()))
                .unwrap_err(),
            times::read(&Disk, &path).unwrap_err(),
        ];
        for &format in MeshFormat::ALL {
            errors.push(MeshContents::read(&Disk, &path, format).unwrap_err());
        }
        for format in [MoleculeFormat::Xyz, MoleculeFormat::Mol, MoleculeFormat::Sdf, MoleculeFormat::Pdb] {
            errors.push(molecule::read(&Disk, &path, format).unwrap_err());
        }
        for error in errors {
            assert_eq!(error.kind(), &FormatErrorKind::Utf16, "{error}");
            assert!(error.hint().unwrap().contains("UTF-8"));
        }
    }
}
