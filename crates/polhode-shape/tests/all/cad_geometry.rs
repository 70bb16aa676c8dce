//! Reports in metres and inches, and geometric properties of shapes without mass.

use polhode::body::shape::{BoxShape, Shape, Substance};
use polhode::body::{MassProperties, PlacedPart};
use polhode::math::{Body, Direction, Part, Position, Rotation};
use polhode_shape::cad::{
    CadOptions, CadProduct, GeometryProgram, GeometryReport, ProductConvention, SignSource, read,
};
use polhode_source::{ContentError, ContentErrorKind};

use crate::cad::programs::{Print, solidworks, two_decimals};

const CREO_IN_METRES: &str = "\
MASS PROPERTIES OF THE PART DRUM

VOLUME =  4.0212386e+00  M^3
SURFACE AREA =  1.4074335e+01  M^2
DENSITY =  3.7800000e+01 KILOGRAM / M^3
MASS =  1.5200282e+02 KILOGRAM 
CENTER OF GRAVITY with respect to _DRUM coordinate frame:
X   Y   Z     0.0000000e+00 -1.5000000e+00  0.0000000e+00  M

INERTIA with respect to _DRUM coordinate frame:  (KILOGRAM * M^2)

INERTIA TENSOR:
Ixx Ixy Ixz  4.1699440e+02  0.0000000e+00  0.0000000e+00
Iyx Iyy Iyz  0.0000000e+00  4.8640902e+01  0.0000000e+00
Izx Izy Izz  0.0000000e+00  0.0000000e+00  4.1699440e+02

INERTIA at CENTER OF GRAVITY with respect to _DRUM coordinate frame:  (KILOGRAM * M^2)

INERTIA TENSOR:
Ixx Ixy Ixz  7.4988057e+01  0.0000000e+00  0.0000000e+00
Iyx Iyy Iyz  0.0000000e+00  4.8640902e+01  0.0000000e+00
Izx Izy Izz  0.0000000e+00  0.0000000e+00  7.4988057e+01

PRINCIPAL MOMENTS OF INERTIA:  (KILOGRAM * M^2)
I1  I2  I3  4.8640902e+01  7.4988057e+01  7.4988057e+01

ROTATION MATRIX from _DRUM orientation to PRINCIPAL AXES:
      0.00000        1.00000        0.00000
      1.00000        0.00000        0.00000
      0.00000        0.00000       -1.00000
ROTATION ANGLES from _DRUM orientation to PRINCIPAL AXES (degrees):
angles about x  y  z   0.000          0.000         90.000

RADII OF GYRATION with respect to PRINCIPAL AXES:
R1  R2  R3  5.6568542e-01  7.0237692e-01  7.0237692e-01  M
";

/// Unit names in capital letters: M and KILOGRAM * M^2.
#[test]
fn creo_in_metres_is_read_in_metres() {
    let report = read(CREO_IN_METRES, &CadOptions::default()).unwrap();
    assert_eq!((report.product, report.proof.by), (CadProduct::Creo, SignSource::NoProducts));
    let close =
        |got: f64, want: f64| assert!((got - want).abs() < 1e-7 * want.abs().max(1.0), "{got} {want}");
    close(report.properties.mass(), 152.002_818_951_288_56);
    assert_eq!(report.properties.center_of_mass(), Position::new(0.0, -1.5, 0.0));
    let tensor = report.properties.inertia().matrix();
    for (k, want) in
        [74.988_057_349_302_35, 48.640_902_064_412_344, 74.988_057_349_302_35].into_iter().enumerate()
    {
        close(tensor[k][k], want);
    }
    close(report.volume.unwrap(), 4.021_238_6);
    close(report.density.unwrap(), 37.8);
    close(report.surface_area.unwrap(), 14.074_335);
    // Other units in capital letters.
    for (words, mass, length) in
        [(["GRAM", "CM"], 1e-3, 1e-2), (["TONNE", "MM"], 1e3, 1e-3), (["KG", "M"], 1.0, 1.0)]
    {
        let text = CREO_IN_METRES.replace("KILOGRAM", words[0]).replace("M^", &format!("{}^", words[1]));
        let text = text.replace("0.0000000e+00  M\n", &format!("0.0000000e+00  {}\n", words[1]));
        let report =
            read(&text, &CadOptions::default()).unwrap_or_else(|error| panic!("{words:?}: {error}\n{text}"));
        close(report.properties.mass() / mass, 152.002_82);
        close(report.properties.center_of_mass().y / length, -1.5);
        close(report.properties.inertia().matrix()[1][1] / (mass * length * length), 48.640_902);
    }
}

/// Pseudo-random numbers (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Returns a block with a rotation and a small displacement. Under the wrong sign, the
/// parallel-axis theorem has an error of 2 M `c_i c_j`.
fn block(random: &mut Random) -> MassProperties<Body> {
    let size = [0; 3].map(|_| random.between(0.02, 0.08));
    let block =
        BoxShape::new(size).unwrap().mass_properties(Substance::Mass(random.between(0.1, 0.4))).unwrap();
    let axis = Direction::from_array([0; 3].map(|_| random.between(-1.0, 1.0)));
    let turn: Rotation<Body, Part> = Rotation::from_axis_angle(axis, random.between(0.3, 2.8)).unwrap();
    let place = Position::from_array([0; 3].map(|_| random.between(-0.002, 0.002)));
    PlacedPart::new(block, place, turn).unwrap().in_body()
}

/// SolidWorks in grams and inches with two decimals: rounding nearly hides the sign. If only one
/// sign is within the rounding, it is the report's. A sign is never wrong.
#[test]
fn the_one_sign_within_the_rounding_is_the_sign() {
    let mut random = Random(7);
    let (mut clear, mut narrow, mut open) = (0, 0, 0);
    for case in 0..400 {
        let body = block(&mut random);
        let sign = [ProductConvention::Negative, ProductConvention::Positive][case % 2];
        let print = Print { sign, words: ["grams", "inches"], units: [1e-3, 0.0254], number: two_decimals };
        let text = solidworks(&body, print);
        match read(&text, &CadOptions::default()) {
            Ok(report) => {
                let proof = report.proof;
                assert_eq!(proof.convention, sign, "{proof:?}\n{text}");
                assert_eq!(proof.by, SignSource::ParallelAxis);
                let is_narrow = proof.residual_negative.max(proof.residual_positive) < 10.0;
                assert_eq!(
                    report.findings.iter().any(|finding| finding.code == "cad.narrow-sign"),
                    is_narrow
                );
                if !is_narrow {
                    clear += 1;
                    continue;
                }
                narrow += 1;
                // Words that agree are accepted; words that contradict the numbers are refused.
                let worded = |word: &str| {
                    text.replace("system.\n", &format!("system. (Using {word} tensor notation.)\n"))
                };
                let [same, other] = match sign {
                    ProductConvention::Negative => ["negative", "positive"],
                    ProductConvention::Positive => ["positive", "negative"],
                };
                let stated = read(&worded(same), &CadOptions::default()).unwrap();
                assert_eq!((stated.proof.by, stated.proof.convention), (SignSource::Stated, sign));
                let error = read(&worded(other), &CadOptions::default()).unwrap_err();
                assert!(matches!(error.kind, ContentErrorKind::ProductSign { .. }), "{error}");
            }
            Err(error) => {
                let ContentErrorKind::ProductSign { negative, positive, .. } = error.kind else {
                    panic!("{error}\n{text}")
                };
                assert!(negative <= 1.0 && positive <= 1.0, "{negative} {positive}\n{text}");
                open += 1;
            }
        }
    }
    assert!(clear > 20 && narrow > 100 && open < 40, "{clear} {narrow} {open}");
}

const MESHLAB: &str = "\
Opened mesh base.stl
Mesh Bounding Box Size 5.000000 4.982923 2.230000
Mesh Bounding Box Diag 7.404000
Mesh Surface Area is 98.211000
Mesh Volume is 36.789902
Center of Mass is 0.012000 -0.000300 0.941000
Inertia Tensor is :
| 68.811394  0.000714  0.918281 |
| 0.000714  66.050369  0.000911 |
| 0.918281  0.000911  103.803253 |
";

#[track_caller]
fn meshlab(text: &str, unit: Option<f64>) -> Result<GeometryReport, ContentError> {
    assert_eq!(GeometryProgram::of_text(text), Some(GeometryProgram::MeshLab));
    GeometryReport::read(GeometryProgram::MeshLab, text, unit)
}

#[test]
fn meshlabs_measures_are_those_of_density_one() {
    let shape = meshlab(MESHLAB, Some(1e-3)).unwrap();
    assert!((shape.volume / 36.789_902e-9 - 1.0).abs() < 1e-15 && !shape.unit_assumed);
    assert!((shape.surface_area.unwrap() / 98.211e-6 - 1.0).abs() < 1e-15);
    let body = shape.mass_properties(Substance::Density(1240.0)).unwrap();
    let mass = 1240.0 * 36.789_902e-9;
    assert!((body.mass() / mass - 1.0).abs() < 1e-15);
    let center = Position::new(0.012e-3, -0.0003e-3, 0.941e-3);
    assert!((body.center_of_mass() - center).norm() < 1e-18);
    let want =
        [[68.811394, 0.000714, 0.918281], [0.000714, 66.050369, 0.000911], [0.918281, 0.000911, 103.803253]];
    for (i, row) in body.inertia().matrix().into_iter().enumerate() {
        for (j, got) in row.into_iter().enumerate() {
            assert!((got / (1240.0e-15 * want[i][j]) - 1.0).abs() < 1e-12, "{i} {j}");
        }
    }
    // A mass gives the density: I = (M/V) I₁.
    let weighed = shape.mass_properties(Substance::Mass(mass)).unwrap();
    for (a, b) in weighed.inertia().matrix().as_flattened().iter().zip(body.inertia().matrix().as_flattened())
    {
        assert!((a - b).abs() < 1e-14 * b.abs());
    }
    let metres = meshlab(MESHLAB, None).unwrap();
    assert!(metres.unit_assumed && metres.volume == 36.789_902);
    // With the prefix of MeshLab's server, with principal axes, and a mesh that is wound inward.
    let axes = "Principal axes are :\n| 1.0 0.0 0.0 |\n| 0.0 1.0 0.0 |\n| 0.0 0.0 1.0 |\naxis momenta are :\n| 66.050369 68.787331 103.827316 |\n";
    let logged: String = format!("{MESHLAB}{axes}").lines().map(|line| format!("LOG: 2 {line}\n")).collect();
    assert_eq!(meshlab(&logged, None).unwrap(), metres);
    let inward = MESHLAB
        .replace("is 36.", "is -36.")
        .replace("| 0.", "| -0.")
        .replace("| 6", "| -6")
        .replace("  0.", "  -0.");
    let inward = inward.replace("  66.", "  -66.").replace("  103.", "  -103.");
    let turned = meshlab(&inward, None).unwrap();
    assert_eq!(turned.findings[0].code, "cad.inward");
    assert_eq!(turned.mass_properties(Substance::Mass(2.0)), metres.mass_properties(Substance::Mass(2.0)));
}

#[test]
fn what_meshlab_leaves_open_is_refused_or_reported() {
    let refused = |text: &str| meshlab(text, None).unwrap_err();
    for line in [
        "Mesh Volume is 36.789902\n",
        "Center of Mass is 0.012000 -0.000300 0.941000\n",
        "| 0.918281  0.000911  103.803253 |\n",
    ] {
        assert!(MESHLAB.contains(line));
        let kind = refused(&MESHLAB.replace(line, "")).kind;
        assert!(matches!(kind, ContentErrorKind::Missing { .. }), "{line} {kind}");
    }
    let twice = refused(&MESHLAB.repeat(2));
    assert!(twice.to_string().contains("given once"), "{twice}");
    for (from, to) in [
        ("36.789902", "nan"),
        ("36.789902", "0.000000"),
        ("36.789902", "36,789902"),
        ("103.803253 |", "|"),
        ("0.000911  103", "0.9  103"),
    ] {
        let error = refused(&MESHLAB.replacen(from, to, 1));
        assert!(
            matches!(error.kind, ContentErrorKind::Value { .. } | ContentErrorKind::Expected { .. }),
            "{error}"
        );
    }
    let other = format!("{MESHLAB}axis momenta are :\n| 66.050369 68.787331 103.900000 |\n");
    assert!(refused(&other).to_string().contains("sum"), "{}", refused(&other));
    let open = "Mesh Surface Area is 98.2\nMesh is not 'watertight', no information on volume, barycenter and inertia tensor.\n";
    assert!(refused(open).to_string().contains("closed"));
    // Six decimals of a small shape in metres: ± 0.0000005 of 0.000012 and of 0.000001.
    let small = "Mesh Volume is 0.001576\nCenter of Mass is -0.021993 0.001259 0.001489\nInertia Tensor is :\n\
                 | 0.000012 -0.000000 -0.000000 |\n| -0.000000 0.000008 -0.000000 |\n| -0.000000 -0.000000 0.000007 |\n";
    let rough = meshlab(small, None).unwrap();
    assert_eq!(rough.findings[0].code, "cad.rounding");
    assert!(rough.findings[0].message.contains("7.17 %"), "{}", rough.findings[0].message);
    let lost = refused(&small.replace("0.000007", "0.000001"));
    assert!(lost.to_string().contains("more digits") && lost.hint.unwrap().contains("mm"));
    // The reader of CAD reports states the missing quantity.
    let error = read(MESHLAB, &CadOptions::default()).unwrap_err();
    assert!(error.hint.unwrap().contains("MeshLab prints"), "{:?}", error.kind);
}

/// Returns the geometric properties of a rotated and displaced block of 20, 30 and 50 mm, in
/// FreeCAD's format.
fn freecad(
    matrix: impl Fn([[f64; 3]; 3]) -> String,
    shown: impl Fn([String; 3]) -> String,
) -> (String, MassProperties<Body>) {
    let turn: Rotation<Body, Part> = Rotation::from_axis_angle(Direction::new(1.0, 2.0, 3.0), 0.7).unwrap();
    let block =
        BoxShape::new([0.02, 0.03, 0.05]).unwrap().mass_properties(Substance::Density(2700.0)).unwrap();
    let body = PlacedPart::new(block, Position::new(0.011, -0.007, 0.023), turn).unwrap().in_body();
    // Tensor at density 1, in mm: I / (ρ 1e-15 m⁵/mm⁵).
    let rows = body.inertia().matrix().map(|row| row.map(|x| x / 2700.0e-15));
    let [x, y, z] = body.center_of_mass().to_array().map(|x| 1e3 * x);
    (shown(["30000.000000000004".to_owned(), format!("Vector ({x}, {y}, {z})"), matrix(rows)]), body)
}

#[test]
fn freecads_console_is_read_in_millimetres() {
    let long = |rows: [[f64; 3]; 3]| {
        let row = |r: [f64; 3]| format!("({},{},{},0.0)", r[0], r[1], r[2]);
        format!("Matrix ({},{},{},(0.0,0.0,0.0,1.0))", row(rows[0]), row(rows[1]), row(rows[2]))
    };
    let short = |rows: [[f64; 3]; 3]| {
        let number = |x: f64| format!("{x:.5e}").replace('e', "e+0");
        let row = |r: [f64; 3]| format!("({},{},{},0)", number(r[0]), number(r[1]), number(r[2]));
        format!("Matrix ({},{},{},(0,0,0,1))", row(rows[0]), row(rows[1]), row(rows[2]))
    };
    let console = |[volume, center, matrix]: [String; 3]| {
        format!(
            ">>> s = App.ActiveDocument.Box.Shape\n>>> s.Volume\n{volume}\n>>> s.CenterOfMass\n{center}\n>>> s.MatrixOfInertia\n{matrix}\n"
        )
    };
    let macro_output = |[volume, center, matrix]: [String; 3]| {
        format!(
            "Volume: {volume} mm^3\nMass = {volume}\nCenter of mass: {center}\nMatrix of inertia = {}\n",
            matrix.replace("),(", "),\n(")
        )
    };
    let litres = |[_, center, matrix]: [String; 3]| {
        format!("Volume = 30 cm^3\nCenterOfGravity = {center}\nMatrixOfInertia\n{matrix}\n")
    };
    for (digits, (text, want)) in [
        (1e-14, freecad(long, console)),
        (1e-14, freecad(long, macro_output)),
        (2e-5, freecad(short, console)),
        (1e-14, freecad(long, litres)),
    ] {
        assert_eq!(GeometryProgram::of_text(&text), Some(GeometryProgram::FreeCad));
        let shape = GeometryReport::read(GeometryProgram::FreeCad, &text, None)
            .unwrap_or_else(|e| panic!("{e}\n{text}"));
        assert_eq!((shape.unit, shape.unit_assumed), (1e-3, false));
        let body = shape.mass_properties(Substance::Density(2700.0)).unwrap();
        assert!((body.mass() / want.mass() - 1.0).abs() < 1e-14);
        assert!((body.center_of_mass() - want.center_of_mass()).norm() < 1e-16);
        let scale = want.inertia().matrix()[0][0];
        for (got, want) in
            body.inertia().matrix().as_flattened().iter().zip(want.inertia().matrix().as_flattened())
        {
            assert!((got - want).abs() < digits * scale, "{got} {want}");
        }
    }
    let (text, _) = freecad(long, console);
    let refused = |text: &str| GeometryReport::read(GeometryProgram::FreeCad, text, None).unwrap_err();
    for (from, to) in [
        (",0.0,1.0))", ",0.0,2.0))"),
        ("Vector (", "Vertex ("),
        ("30000.000000000004", "nan"),
        ("Matrix (", "Matrix ((7),"),
    ] {
        let error = refused(&text.replacen(from, to, 1));
        assert!(
            matches!(error.kind, ContentErrorKind::Value { .. } | ContentErrorKind::Expected { .. }),
            "{error}"
        );
    }
    let missing = refused(&text.replace(">>> s.Volume\n30000.000000000004\n", ""));
    assert!(missing.hint.unwrap().contains("Shape.Volume"));
    let heavy = refused(&format!("{text}Mass = 81\n"));
    assert!(heavy.to_string().contains("density 1") && heavy.hint.unwrap().contains("--mass"));
}

/// A sheet is not a solid. A tensor that is unphysical by rounding or by a typing error is refused.
#[test]
fn an_impossible_shape_is_refused() {
    let text = MESHLAB.replace("103.803253", "203.803253");
    let shape = meshlab(&text, None).unwrap();
    assert!(shape.mass_properties(Substance::Density(1.0)).is_err());
    let shape = meshlab(MESHLAB, None).unwrap();
    for wrong in [
        Substance::AreaDensity(1.0),
        Substance::Mass(-1.0),
        Substance::Density(f64::NAN),
        Substance::Mass(0.0),
    ] {
        assert!(shape.mass_properties(wrong).is_err(), "{wrong:?}");
    }
}

/// The tensor must be at least that of the ball with the same volume.
#[test]
fn a_volume_that_is_too_large_for_the_tensor_is_refused() {
    let freecad = |volume: f64, tensor: f64| {
        let row = |k: usize| -> String {
            let cell = |j: usize| if j == k { format!("{tensor:?}") } else { "0.0".to_owned() };
            format!("({},{},{},0.0)", cell(0), cell(1), cell(2))
        };
        let matrix = format!("Matrix ({},{},{},(0.0,0.0,0.0,1.0))", row(0), row(1), row(2));
        let text = format!(
            "Volume = {volume:?}\nCenterOfMass = Vector (5.0, 10.0, 15.0)\nMatrixOfInertia = {matrix}\n"
        );
        GeometryReport::read(GeometryProgram::FreeCad, &text, None)
    };
    for radius in [0.3, 7.0, 1e4_f64] {
        let volume = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
        let moment = 0.4 * volume * radius * radius;
        assert!(freecad(volume, moment).is_ok() && freecad(volume, 3.0 * moment).is_ok());
        let error = freecad(volume, 0.999 * moment).unwrap_err();
        assert!(
            error.to_string().contains("for a given volume the ball has the smallest moments"),
            "{error}"
        );
        assert!(freecad(10.0 * volume, moment).is_err());
    }
    let error = meshlab(&MESHLAB.replace("36.789902", "3678.9902"), Some(1e-3)).unwrap_err();
    assert!(error.to_string().contains("at most "), "{error}");
    let inward = MESHLAB.replace("Mesh Volume is 36", "Mesh Volume is -3600");
    assert!(meshlab(&inward, Some(1e-3)).is_err());
}

/// Doubles printed by Python are exact, however few digits they have.
#[test]
fn shortest_doubles_of_freecad_have_no_rounding() {
    let text = |volume: &str, moment: &str, rest: [&str; 2]| {
        let [zero, one] = rest;
        format!(
            ">>> s.Volume\n{volume}\n>>> s.CenterOfMass\nVector (0.5, 0.5, 0.5)\n>>> s.MatrixOfInertia\n\
             Matrix (({moment},{zero},{zero},{zero}),({zero},{moment},{zero},{zero}),({zero},{zero},{moment},{zero}),({zero},{zero},{zero},{one}))\n"
        )
    };
    let exact = ["0.0", "1.0"];
    for (volume, moment) in [("1.0", "0.16666666666666666"), ("0.6", "0.1"), ("1e-3", "0.16666666666666666")]
    {
        let shape =
            GeometryReport::read(GeometryProgram::FreeCad, &text(volume, moment, exact), None).unwrap();
        assert!(shape.findings.is_empty(), "{:?}", shape.findings);
        let body = shape.mass_properties(Substance::Mass(3.0)).unwrap();
        let want = 3.0 * moment.parse::<f64>().unwrap() / volume.parse::<f64>().unwrap() * 1e-6;
        assert!((body.inertia().matrix()[1][1] / want - 1.0).abs() < 1e-14);
    }
    // C++ streams write 0 and 1, and six digits.
    let rounded = text("0.6", "0.12", ["0", "1"]);
    let shape = GeometryReport::read(GeometryProgram::FreeCad, &rounded, None).unwrap();
    assert_eq!(shape.findings[0].code, "cad.rounding");
}

/// Checks m = ρ V within the rounding of all three.
#[test]
fn a_mass_that_contradicts_density_and_volume_is_refused() {
    let report = |mass: &str| {
        format!(
            "Density = 2700.00 kilograms per cubic meter\n\nMass = {mass}\n\nVolume = 0.50 cubic meters\n\n\
             Center of mass: ( meters )\n\tX = 0.0\n\tY = 0.1\n\tZ = 0.0\n\n\
             Moments of inertia: ( kilograms * square meters )\n\
             Taken at the center of mass and aligned with the output coordinate system.\n\
             \tLxx = 100.1\tLxy = 0.0\tLxz = 0.0\n\tLyx = 0.0\tLyy = 110.2\tLyz = 0.0\n\tLzx = 0.0\tLzy = 0.0\tLzz = 90.3\n"
        )
    };
    // 0.50 m³ means 0.495 to 0.505 m³.
    for mass in ["1350.00 kilograms", "1340.00 kilograms", "1373.00 kilograms"] {
        assert!(read(&report(mass), &CadOptions::default()).is_ok(), "{mass}");
    }
    for mass in ["5.00 kilograms", "1300.00 kilograms", "1350.00 grams"] {
        let error = read(&report(mass), &CadOptions::default()).unwrap_err();
        let text = error.to_string();
        assert!(text.contains("2700 kg/m³ × 0.5 m³ = 1350 kg"), "{text}");
    }
    let overridden = read(&report("5.00 kilograms (user-overridden)"), &CadOptions::default()).unwrap();
    assert!(overridden.findings.iter().any(|finding| finding.code == "cad.overridden"));
}

#[test]
fn a_unit_that_is_not_known_is_named() {
    let text = CREO_IN_METRES.replace("1.5200282e+02 KILOGRAM", "1.5200282e-01 MG");
    let error = read(&text, &CadOptions::default()).unwrap_err();
    assert!(error.to_string().contains("expected a unit of mass, found \"MG\""), "{error}");
    assert!(error.hint.unwrap().contains("milligram or the megagram"));
}
