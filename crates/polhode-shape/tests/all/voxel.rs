//! Voxel files: the same grid in every encoding, truncated files, and wrong headers.

use std::io::Write;

use flate2::Compression;
use flate2::write::GzEncoder;
use polhode::body::shape::{BoxShape, Shape, Substance};
use polhode::body::{MassProperties, PlacedPart, assemble};
use polhode::math::{Part, Position, Rotation};
use polhode_shape::voxel::{VoxelOptions, Voxels, read};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

const COUNTS: [usize; 3] = [2, 3, 4];
const SIZE: [f64; 3] = [0.02, 0.035, 0.05];

/// Returns the value of voxel (i, j, k), a small integer.
fn number(i: usize, j: usize, k: usize) -> u8 {
    (1 + 7 * i + 3 * j * j + 11 * k * (i + 1)) as u8
}

/// Returns all values, with the first index fastest or the last.
fn numbers(fortran: bool) -> Vec<u8> {
    let [a, b, c] = COUNTS;
    let at = |n: usize| {
        if fortran { number(n % a, n / a % b, n / a / b) } else { number(n / c / b, n / c % b, n % c) }
    };
    (0..a * b * c).map(at).collect()
}

fn npy(version: u8, descr: &str, fortran: bool, shape: &str, data: &[u8]) -> Vec<u8> {
    let order = if fortran { "True" } else { "False" };
    let header = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}   \n");
    npy_of(version, &header, data)
}

fn npy_of(version: u8, header: &str, data: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY".to_vec();
    bytes.extend([version, 0]);
    match version {
        1 => bytes.extend((header.len() as u16).to_le_bytes()),
        _ => bytes.extend((header.len() as u32).to_le_bytes()),
    }
    bytes.extend(header.as_bytes());
    bytes.extend(data);
    bytes
}

fn nrrd(fields: &str, data: &[u8]) -> Vec<u8> {
    [b"NRRD0005\n# by hand\n", fields.as_bytes(), b"\n", data].concat()
}

const FIELDS: &str = "type: uchar\ndimension: 3\nsizes: 2 3 4\nencoding: raw\nspace dimension: 3\n\
    space directions: (2,0,0) (0,3.5,0) (0,0,5)\nspace origin: (1,-2,0.5)\nspace units: \"cm\" \"cm\" \"cm\"\n\
    key with spaces:=value\n";

/// Returns the mass properties of the numbers as kg/m³, as an assembly of boxes; the centre of the
/// first voxel is at `origin`.
fn exact(origin: [f64; 3]) -> MassProperties<polhode::math::Body> {
    let brick = BoxShape::new(SIZE).unwrap();
    let mut parts = Vec::new();
    for i in 0..2 {
        for j in 0..3 {
            for k in 0..4 {
                let place = [0, 1, 2].map(|axis| origin[axis] + [i, j, k][axis] as f64 * SIZE[axis]);
                let part = brick.mass_properties(Substance::Density(f64::from(number(i, j, k)))).unwrap();
                parts.push(PlacedPart::new(part, Position::from_array(place), Rotation::identity()).unwrap());
            }
        }
    }
    assemble(&parts).unwrap()
}

#[track_caller]
fn require_exact(mut voxels: Voxels<'_>, options: &VoxelOptions, origin: [f64; 3]) {
    assert_eq!(voxels.counts(), COUNTS);
    let grid = voxels.grid(options).unwrap();
    let body: MassProperties<Part> = voxels.mass_properties(&grid, 1.0).unwrap().unwrap().properties;
    let exact = exact(origin);
    assert!((body.mass() / exact.mass() - 1.0).abs() < 1e-15);
    let (a, b) = (body.center_of_mass().to_array(), exact.center_of_mass().to_array());
    assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-16), "{a:?} {b:?}");
    let (a, b) = (body.inertia().matrix(), exact.inertia().matrix());
    assert!((0..9).all(|k| (a[k / 3][k % 3] - b[k / 3][k % 3]).abs() < 2e-15 * b[0][0]));
}

const PLACED: VoxelOptions =
    VoxelOptions { spacing: Some(SIZE), unit: None, origin: Some([0.01, -0.02, 0.005]) };

#[test]
fn npy_of_every_type_order_and_version_is_the_same_body() {
    type Encode = fn(u8) -> Vec<u8>;
    let kinds: [(&str, Encode); 16] = [
        ("|u1", |v| vec![v]),
        ("<u2", |v| u16::from(v).to_le_bytes().into()),
        (">u2", |v| u16::from(v).to_be_bytes().into()),
        ("<i2", |v| i16::from(v).to_le_bytes().into()),
        (">i2", |v| i16::from(v).to_be_bytes().into()),
        ("<u4", |v| u32::from(v).to_le_bytes().into()),
        ("<i4", |v| i32::from(v).to_le_bytes().into()),
        (">i4", |v| i32::from(v).to_be_bytes().into()),
        ("<u8", |v| u64::from(v).to_le_bytes().into()),
        ("<i8", |v| i64::from(v).to_le_bytes().into()),
        (">i8", |v| i64::from(v).to_be_bytes().into()),
        ("<f4", |v| f32::from(v).to_le_bytes().into()),
        (">f4", |v| f32::from(v).to_be_bytes().into()),
        ("<f8", |v| f64::from(v).to_le_bytes().into()),
        (">f8", |v| f64::from(v).to_be_bytes().into()),
        ("<u1", |v| vec![v]),
    ];
    for (descr, encode) in kinds {
        for fortran in [false, true] {
            for version in 1..=3 {
                let data: Vec<u8> = numbers(fortran).into_iter().flat_map(encode).collect();
                let file = npy(version, descr, fortran, "(2, 3, 4)", &data);
                require_exact(read(&file).unwrap(), &PLACED, [0.01, -0.02, 0.005]);
            }
        }
    }
    // Negative numbers and booleans.
    let bytes = [(-3_i16).to_be_bytes(), 500_i16.to_be_bytes()].concat();
    let file = npy(1, ">i2", false, "(1, 2, 1)", &bytes);
    let mut voxels = read(&file).unwrap();
    assert_eq!(voxels.type_name(), "int16");
    // Access in any order.
    let mut values = voxels.values();
    assert_eq!([0, 1, 1, 0].map(|v| values.at(v).unwrap()), [-3.0, 500.0, 500.0, -3.0]);
    assert!(values.at(2).unwrap().is_nan() && values.at(usize::MAX).unwrap().is_nan());
    let file = npy(1, "|b1", true, "(1,2,2,)", &[1, 0, 1, 7]);
    let mut voxels = read(&file).unwrap();
    let mut values = voxels.values();
    assert_eq!([0, 2, 3, 1].map(|v| values.at(v).unwrap()), [1.0, 1.0, 1.0, 0.0]);
}

#[test]
fn nrrd_is_the_same_body() {
    let data = numbers(true);
    require_exact(read(&nrrd(FIELDS, &data)).unwrap(), &VoxelOptions::default(), [0.01, -0.02, 0.005]);
    // Big-endian floats, \r\n, other spellings, and bytes to skip.
    let floats: Vec<u8> = data.iter().flat_map(|&v| f32::from(v).to_be_bytes()).collect();
    let fields = "Type: float\ndimension: 3\nsizes:  2 3  4\nendian: BIG\nencoding: RAW\nspacings: 2 3.5 5\n\
        units: \"cm\" \"cm\" \"cm\"\nline skip: 1\nbyte skip: 3\nlabels: \"a\" \"b\" \"c\"\n"
        .replace('\n', "\r\n");
    let file = nrrd(&fields, &[]);
    let file = [&file[..file.len() - 1], b"\r\n", b"a line\nxyz", &floats].concat();
    let options = VoxelOptions { origin: Some([0.3, 0.2, -0.1]), ..VoxelOptions::default() };
    require_exact(read(&file).unwrap(), &options, [0.3, 0.2, -0.1]);
    let fields = FIELDS.to_owned() + "byte skip: -1\n";
    let file = nrrd(&fields, &[b"anything".as_slice(), &data].concat());
    require_exact(read(&file).unwrap(), &VoxelOptions::default(), [0.01, -0.02, 0.005]);
}

/// Compresses data with gzip.
fn gzip(data: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(data).unwrap();
    encoder.finish().unwrap()
}

#[test]
fn compressed_nrrd_is_the_same_body() {
    let fields = FIELDS.replace("raw", "gzip");
    let placed = [0.01, -0.02, 0.005];
    let file = nrrd(&fields, &gzip(&numbers(true)));
    require_exact(read(&file).unwrap(), &VoxelOptions::default(), placed);
    // Two compressed members, after a line and three bytes that were compressed with them.
    let (first, second) = (gzip(&[b"xyz", &numbers(true)[..7]].concat()), gzip(&numbers(true)[7..]));
    let skipping = fields.clone() + "line skip: 1\nbyte skip: 3\n";
    let file = nrrd(&skipping, &[b"a line\n", first.as_slice(), &second].concat());
    require_exact(read(&file).unwrap(), &VoxelOptions::default(), placed);

    // Truncated anywhere: in the data, or in the checksum after them.
    let compressed = gzip(&numbers(true));
    for length in 0..compressed.len() {
        let error = refused(&nrrd(&fields, &compressed[..length]));
        let ContentErrorKind::Count { declared: 24, present, .. } = error.kind else { panic!("{error}") };
        assert!(present <= 24 && error.hint.unwrap().contains("truncated"));
    }
    // A wrong checksum, and too few or too many numbers.
    let mut damaged = compressed.clone();
    let at = damaged.len() - 6;
    damaged[at] ^= 1;
    assert!(refused(&nrrd(&fields, &damaged)).to_string().contains("data compressed by gzip"));
    let few = refused(&nrrd(&fields, &gzip(&numbers(true)[1..]))).kind;
    assert!(matches!(few, ContentErrorKind::Count { declared: 24, present: 23, .. }), "{few:?}");
    let many = refused(&nrrd(&fields, &gzip(&[0; 10_000_000]))).kind; // stops at the first excess
    assert!(matches!(many, ContentErrorKind::Count { declared: 24, present: 25, .. }), "{many:?}");
    // A size that cannot be filled must not be reserved.
    let huge = refused(&nrrd(&fields.replace("2 3 4", "2 3 400000000000"), &compressed)).kind;
    assert!(
        matches!(huge, ContentErrorKind::Count { declared: 2_400_000_000_000, present: 24, .. }),
        "{huge:?}"
    );
}

#[test]
fn slanted_axes_are_as_the_file_has_them() {
    // Two voxels with a step of length 3 along (1, 2, 2).
    let fields =
        FIELDS.replace("2 3 4", "2 1 1").replace("(2,0,0) (0,3.5,0) (0,0,5)", "(1,2,2)(2,1,-2) (-2,2,-1)");
    let file = nrrd(&fields, &[5, 5]);
    let mut voxels = read(&file).unwrap();
    let grid = voxels.grid(&VoxelOptions::default()).unwrap();
    let body = voxels.mass_properties(&grid, 1.0).unwrap().unwrap();
    let bar = BoxShape::new([0.06, 0.03, 0.03]).unwrap().mass_properties(Substance::Density(5.0)).unwrap();
    let (a, b) = (body.properties.principal().moments(), bar.principal().moments());
    assert!((0..3).all(|k| (a[k] / b[k] - 1.0).abs() < 4e-15), "{a:?} {b:?}");
    let along = body.properties.principal().axis(0).to_array();
    assert!((0..3).all(|k| (along[k] - [1.0, 2.0, 2.0][k] / 3.0).abs() < 1e-15), "{along:?}");
}

fn refused(bytes: &[u8]) -> ContentError {
    to_the_end(bytes).unwrap_err()
}

/// Reads all values of a file.
fn to_the_end(bytes: &[u8]) -> Result<usize, ContentError> {
    let mut voxels = read(bytes)?;
    let mut values = voxels.values();
    for voxel in 0.. {
        if values.at(voxel)?.is_nan() {
            return Ok(voxel);
        }
    }
    Ok(usize::MAX)
}

#[test]
fn what_a_file_does_not_say_is_asked_and_never_guessed() {
    let file = npy(1, "|u1", false, "(2, 3, 4)", &numbers(false));
    let error = read(&file).unwrap().grid(&VoxelOptions::default()).unwrap_err();
    assert_eq!(error.kind, ContentErrorKind::Missing { what: "spacing of its voxels".to_owned() });
    assert!(error.hint.unwrap().starts_with("give the "));

    let without_unit = FIELDS.replace("space units: \"cm\" \"cm\" \"cm\"\n", "");
    let file = nrrd(&without_unit, &numbers(true));
    let voxels = read(&file).unwrap();
    let error = voxels.grid(&VoxelOptions::default()).unwrap_err();
    assert_eq!(error.kind, ContentErrorKind::Missing { what: "unit of length".to_owned() });
    assert!(error.hint.unwrap().starts_with("give the "));
    let centimetres = VoxelOptions { unit: Some(0.01), ..VoxelOptions::default() };
    require_exact(voxels, &centimetres, [0.01, -0.02, 0.005]);

    // Values that the file and the options both give.
    let file = nrrd(FIELDS, &numbers(true));
    let voxels = read(&file).unwrap();
    let nothing = VoxelOptions::default();
    for options in [
        VoxelOptions { unit: Some(0.001), ..nothing },
        VoxelOptions { spacing: Some([1.0; 3]), ..nothing },
        VoxelOptions { origin: Some([1.0; 3]), ..nothing },
    ] {
        let error = voxels.grid(&options).unwrap_err();
        assert!(error.to_string().contains("must be absent"), "{error}");
    }
    let file = npy(1, "|u1", false, "(2, 3, 4)", &numbers(false));
    for spacing in [[0.0, 1.0, 1.0], [1.0, f64::NAN, 1.0], [1e200; 3]] {
        let options = VoxelOptions { spacing: Some(spacing), ..nothing };
        let error = read(&file).unwrap().grid(&options).unwrap_err();
        assert!(matches!(error.kind, ContentErrorKind::Value { .. }), "{error}");
    }
}

#[test]
fn every_wrong_npy_header_is_named() {
    let data = numbers(false);
    let with = |header: &str| refused(&npy_of(1, header, &data)).to_string();
    for (header, expected) in [
        ("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 12)}", "number of dimensions = 2 must be 3"),
        ("{'descr': '|u1', 'fortran_order': False, 'shape': ()}", "number of dimensions = 0"),
        (
            "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, -4)}",
            "expected a whole number, found \"-\"",
        ),
        (
            "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 5)}",
            "30 bytes of voxels are declared, but the file has 24",
        ),
        (
            "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 3)}",
            "18 bytes of voxels are declared, but the file has 24",
        ),
        ("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 0, 3)}", "has no voxels"),
        (
            "{'descr': '|u1', 'fortran_order': False, 'shape': (4294967296, 4294967296, 2)}",
            "must be addressable",
        ),
        ("{'descr': '|u1', 'fortran_order': False, 'shape': (99999999999999999999, 1, 1)}", "a whole number"),
        ("{'descr': '<f2', 'fortran_order': False, 'shape': (2, 3, 4)}", "numbers of the type '<f2'"),
        ("{'descr': '|u2', 'fortran_order': False, 'shape': (2, 3, 4)}", "numbers of the type '|u2'"),
        ("{'descr': '', 'fortran_order': False, 'shape': (2, 3, 4)}", "numbers of the type ''"),
        ("{'descr': [('a', '<f8')], 'fortran_order': False, 'shape': (2, 3, 4)}", "arrays of records"),
        ("{'descr': '|u1', 'fortran_order': 0, 'shape': (2, 3, 4)}", "expected True or False, found \"0\""),
        ("{'descr': '|u1', 'shape': (2, 3, 4)}", "has no 'fortran_order'"),
        ("{'descr': '|u1', 'descr': '|u1', 'shape': (2, 3, 4)}", "once, found \"descr\""),
        ("{'color': 'red'}", "once, found \"color\""),
        (
            "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 4)} x",
            "the end of the header, found \"x\"",
        ),
        ("'descr'", "expected {, found \"'\""),
        ("{", "expected a string, found the end"),
    ] {
        let message = with(header);
        assert!(message.contains(expected), "{header}: {message}");
    }
    let mut file = npy(1, "|u1", false, "(2, 3, 4)", &data);
    file[6] = 4;
    assert!(refused(&file).to_string().contains("version 4.0 of NPY"));
    let huge = [b"\x93NUMPY\x02\x00".as_slice(), &u32::MAX.to_le_bytes(), b"{}"].concat();
    assert!(matches!(
        refused(&huge).kind,
        ContentErrorKind::Count { declared: 4_294_967_295, present: 2, .. }
    ));
}

#[test]
fn every_wrong_nrrd_header_is_named_in_its_line() {
    let data = numbers(true);
    for (from, to, expected) in [
        ("NRRD0005", "NRRD0009", "NRRD0001 to NRRD0005"),
        ("type: uchar", "type: block", "numbers of the type block"),
        ("type: uchar\n", "", "has no field type"),
        ("type: uchar", "type: short", "has no field endian"),
        ("type: uchar", "type: short\nendian: middle", "little or big"),
        (
            "type: uchar",
            "type: short\nendian: little",
            "48 bytes of voxels are declared, but the file has 24",
        ),
        ("dimension: 3\nsizes", "dimension: 4\nsizes", "the dimension = 4 must be 3"),
        ("2 3 4", "2 3", "three whole numbers"),
        ("2 3 4", "2 3 4 1", "three whole numbers"),
        ("2 3 4", "2 -3 4", "three whole numbers"),
        ("2 3 4", "2 0 4", "has no voxels"),
        ("2 3 4", "4294967296 4294967296 4294967296", "must be addressable"),
        ("2 3 4", "2 3 400000000000", "2400000000000 bytes of voxels are declared"),
        ("encoding: raw", "encoding: bzip2", "the encoding bzip2"),
        ("encoding: raw", "encoding: gzip", "data compressed by gzip"),
        ("encoding: raw", "encoding: gz\nbyte skip: -1", "a byte skip of -1 in compressed data"),
        ("2 3 4\nencoding: raw", "2 3 400000000000\nencoding: gzip", "data compressed by gzip"),
        ("encoding: raw\n", "", "has no field encoding"),
        ("encoding: raw", "encoding: raw\ndata file: ../../secret.raw", "data in another file"),
        ("encoding: raw", "encoding: raw\ndatafile: LIST", "data in another file"),
        ("encoding: raw", "encoding: raw\nbyte skip: 25", "at most the number of bytes"),
        ("encoding: raw", "encoding: raw\nline skip: 1000000", "at most the number of lines"),
        ("encoding: raw", "encoding: raw\nbyte skip: -2", "a whole number, or -1"),
        ("encoding: raw", "encoding: raw\nencoding: raw", "must be given once"),
        ("encoding: raw", "encoding: raw\naxis mins: 1 2 3", "the field axis mins"),
        ("encoding: raw", "encoding: raw\nkinds: domain domain 3-color", "an axis of the kind 3-color"),
        ("encoding: raw", "encoding: raw\nsample units: \"g/cm^3\"", "values in g/cm^3"),
        ("encoding: raw", "encoding: raw\nspacings: 1 2 3", "spacings together with space directions"),
        ("encoding: raw", "encoding: raw\nnonsense", "field: value, or an empty line"),
        ("(2,0,0) (0", "none (0", "an axis that is not a spatial axis"),
        ("(2,0,0) (0", "(2,0) (0", "three vectors"),
        ("(2,0,0) (0", "(2,0,nan) (0", "three vectors"),
        ("(1,-2,0.5)", "(1,-2)", "a vector"),
        ("\"cm\" \"cm\" \"cm\"", "\"cm\" \"mm\" \"cm\"", "axes with different units"),
        ("\"cm\" \"cm\" \"cm\"", "\"cm\"", "three units in quotes"),
        ("\"cm\" \"cm\" \"cm\"", "\"kg\" \"kg\" \"kg\"", "a unit of length"),
        ("\"cm\" \"cm\" \"cm\"", "\"\" \"\" \"\"", "a unit of length"),
    ] {
        let text = "NRRD0005\n".to_owned() + FIELDS + "\n";
        assert!(text.contains(from), "{from}");
        let file = [text.replacen(from, to, 1).as_bytes(), &data].concat();
        let error = refused(&file);
        assert!(error.to_string().contains(expected), "{to}: {error}");
        if let ContentPlace::Text(span) = error.place {
            assert!(span.start <= span.end && span.end <= file.len());
        }
    }
    assert!(refused(b"PK\x03\x04").to_string().contains("NPY or NRRD"));
}

#[test]
fn no_truncation_and_no_flipped_byte_panics() {
    let mut state = 5_u64;
    let mut below = |n: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((u128::from(state) * n as u128) >> 64) as usize
    };
    let files = [
        npy(1, "|u1", false, "(2, 3, 4)", &numbers(false)),
        npy(2, "|u1", true, "(2, 3, 4)", &numbers(true)),
        nrrd(FIELDS, &numbers(true)),
        nrrd(&FIELDS.replace("raw", "gzip"), &gzip(&numbers(true))),
    ];
    for whole in files {
        for length in 0..whole.len() {
            assert!(to_the_end(&whole[..length]).is_err(), "{length}");
        }
        assert!(to_the_end(&[whole.as_slice(), b"\0"].concat()).is_err());
        let mut read_on = 0;
        for _ in 0..30_000 {
            let mut bytes = whole.clone();
            for _ in 0..=below(3) {
                let at = below(bytes.len());
                bytes[at] = if below(2) == 0 { below(256) as u8 } else { b"0123456789(),' \n"[below(16)] };
            }
            bytes.truncate(whole.len() - below(2) * below(whole.len()));
            match read(&bytes) {
                Ok(mut voxels) => {
                    read_on += 1;
                    let options = VoxelOptions { spacing: Some(SIZE), ..VoxelOptions::default() };
                    for options in [options, VoxelOptions::default()] {
                        if let Ok(grid) = voxels.grid(&options) {
                            let _ = voxels.mass_properties(&grid, 1.0);
                        }
                    }
                }
                Err(error) => assert!(!error.to_string().is_empty() && error.hint.as_deref() != Some("")),
            }
        }
        assert!(read_on > 500, "{read_on}");
    }
}

#[test]
fn what_a_voxel_is_called_does_no_harm() {
    for field in ["kinds: domain space ???", "sample units: HU", "sample units: kg/m^3", "sample units: \"\""]
    {
        let bytes = nrrd(&format!("{FIELDS}{field}\n"), &numbers(true));
        let voxels = read(&bytes).unwrap_or_else(|e| panic!("{field}: {e}"));
        assert_eq!(voxels.counts(), COUNTS);
    }
}
