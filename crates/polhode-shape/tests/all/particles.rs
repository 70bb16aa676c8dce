//! Particles as CSV: headers, units, separators, and malformed lines.

use std::fmt::Write;

use polhode::body::Particle;
use polhode::math::{Body, Position};
use polhode_shape::particles::{ParticleFile, ParticleOptions, read};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

/// Rows of mass, kg, and position, m.
const GENERIC: [[f64; 4]; 3] =
    [[1.5, 0.25, -3.125, 0.0625], [0.375, -1.75, 2.5, -0.875], [20.25, 4.0625, 0.125, 7.5]];

fn expected(rows: &[[f64; 4]]) -> Vec<Particle<Body>> {
    rows.iter().map(|&[m, x, y, z]| Particle::new(m, Position::new(x, y, z)).unwrap()).collect()
}

fn plain(text: &str) -> Result<ParticleFile, ContentError> {
    read(text.as_bytes(), &ParticleOptions::default())
}

/// Returns the error, the text at its place, and the hint.
#[track_caller]
fn refused<'a>(text: &'a str, options: &ParticleOptions) -> (ContentErrorKind, &'a str, String) {
    let ContentError { kind, place, hint } = read(text.as_bytes(), options).unwrap_err();
    let marked = match place {
        ContentPlace::Text(span) => &text[span],
        _ => "",
    };
    (kind, marked, hint.unwrap_or_default())
}

#[test]
fn every_separator_header_and_unit_reads_the_same() {
    let files = [
        "mass_kg,x_m,y_m,z_m\n1.5,0.25,-3.125,0.0625\n0.375,-1.75,2.5,-0.875\n20.25,4.0625,0.125,7.5\n",
        "\u{feff}mass [g], x [mm], y [mm], z [mm]\r\n1500, 250, -3125, 62.5\r\n\r\n375,-1750,2500,-875\r\n20250,4062.5,125,7500",
        "x [mm];y [cm];z (m);m [t]\n250;-312,5;0,0625;0,0015\n-1750;250;-0,875;0,000375\n4062,5;12,5;7,5;0,02025\n",
        "mass_kg\tx_m\ty_m\tz_m\n1,5\t0,25\t-3,125\t0,0625\n0,375\t-1,75\t2,5\t-0,875\n20,25\t4,0625\t0,125\t7,5\n",
        "# by hand\n mass [kg]  x [m] y [m]   z [m]\n1.5   0.25 -3.125 .0625 # the first\n3.75e-1 -1.75 2.5 -0.875\n20.25 4.0625 +0.125 7.5\n",
        "# made by a program\n# mass_kg x_m y_m z_m\n1.5e+00 2.5e-01 -3.125 0.0625\n0.375 -1.75 2.5 -0.875\n20.25 4.0625 0.125 7.5\n",
        "\"name, or number\",\"Mass_kg\",\"X_m\",Y_m,Z_m\n\"a \"\"b\"\", # c\",1.5,0.25,-3.125,0.0625\n,0.375,-1.75,2.5,-0.875\nx,20.25,4.0625,0.125,7.5\n",
    ];
    for file in files {
        let read = plain(file).unwrap_or_else(|e| panic!("{e}\n{file}"));
        assert_eq!(read.particles, expected(&GENERIC), "{file}");
        assert_eq!(read.findings.len(), usize::from(file.contains("name")), "{:?}", read.findings);
    }
    let ignored = &plain(files[6]).unwrap().findings[0];
    assert_eq!(ignored.code, "particles.ignored-columns");
    assert!(ignored.message.ends_with("name, or number"), "{}", ignored.message);
}

#[test]
fn a_unit_below_one_rounds_once() {
    let read = plain("mass_g,x_mm,y_um,z_in\n0.3,0.7,1.1,1\n").unwrap();
    let (mass, place) = (read.particles[0].mass(), read.particles[0].position().to_array());
    assert_eq!((mass, place), (0.0003, [0.0007, 0.0000011, 0.0254]));
}

#[test]
fn units_that_the_header_leaves_out_are_asked_and_told() {
    let told = ParticleOptions { mass_unit: Some(1e-3), length_unit: Some(1e-3), total_mass: None };
    let rows = "1500,250,-3125,62.5\n375,-1750,2500,-875\n20250,4062.5,125,7500\n";
    for header in ["m,x,y,z\n", "m,x,y_mm,z\n", ""] {
        let text = format!("{header}{rows}");
        let (kind, ..) = refused(&text, &ParticleOptions::default());
        assert!(matches!(&kind, ContentErrorKind::Unclear { .. }), "{kind:?}");
        let read = read(text.as_bytes(), &told).unwrap();
        assert_eq!(read.particles, expected(&GENERIC));
        assert_eq!(read.findings.len(), usize::from(header.is_empty()));
    }
    let (kind, marked, hint) = refused("m_kg,x,y,z\n1,2,3,4\n", &ParticleOptions::default());
    assert_eq!(kind.to_string(), "in which unit is x? The file does not say");
    assert!(marked == "x" && hint.contains("x_m"));
    let (kind, ..) = refused("1,2\n", &told);
    assert!(matches!(kind, ContentErrorKind::Value { .. }));
}

#[test]
fn points_without_masses_share_a_told_mass() {
    let cloud = "x_m,y_m,z_m\n0.25,-3.125,0.0625\n-1.75,2.5,-0.875\n";
    let (kind, _, hint) = refused(cloud, &ParticleOptions::default());
    assert_eq!(kind, ContentErrorKind::Missing { what: "column of masses".to_owned() });
    assert!(hint.contains("share"));
    let options = ParticleOptions { total_mass: Some(4.5), ..ParticleOptions::default() };
    let file = read(cloud.as_bytes(), &options).unwrap();
    assert_eq!(file.particles, expected(&[[2.25, 0.25, -3.125, 0.0625], [2.25, -1.75, 2.5, -0.875]]));
    assert_eq!(file.findings[0].code, "particles.equal-masses");
    let nameless = ParticleOptions { length_unit: Some(1.0), ..options };
    assert_eq!(read(&cloud.as_bytes()[12..], &nameless).unwrap().particles, file.particles);
    // Two values for the same quantity.
    assert!(read(b"mass_kg,x_m,y_m,z_m\n1,2,3,4\n", &options).is_err());
}

#[test]
fn what_is_wrong_is_marked() {
    let header = "mass_kg,x_m,y_m,z_m\n1,2,3,4\n";
    for (line, marked) in [
        ("1,2,three,4", "three"),
        ("1,2,,4", ""),
        ("1,2,3", "1,2,3"),
        ("1,2,3,4,5", "1,2,3,4,5"),
        ("1,2,NaN,4", "NaN"),
        ("1,2,1e999,4", "1e999"),
        ("1,-inf,3,4", "-inf"),
        ("0,2,3,4", "0,2,3,4"),
        ("-1,2,3,4", "-1,2,3,4"),
        ("1,\"2,3,4", "1,\"2,3,4"),
        ("1 2 3 4", "1 2 3 4"),
        ("1,2 3,4,5", "2 3"),
    ] {
        let text = format!("{header}{line}\n7,8,9,10\n");
        let (kind, found, _) = refused(&text, &ParticleOptions::default());
        assert_eq!(found, marked, "{line}: {kind}");
    }
    for text in [
        "",
        "\n\n# nothing\n",
        "mass_kg,x_m,y_m,z_m\n",
        "mass_kg,x_m,y_m\n1,2,3\n",
        "mass_kg,x_m,x_mm,y_m,z_m\n1,2,3,4,5\n",
        "mass_kg,x_stone,y_m,z_m\n1,2,3,4\n",
        "mass_m,x_m,y_m,z_m\n1,2,3,4\n",
        "mass_kg;x_m;y_m;z_m\n1,5;2;3;4\n1.5;2;3;4\n",
        "mass_kg;x_m;y_m;z_m\n1.234,5;2;3;4\n",
    ] {
        assert!(plain(text).is_err(), "{text}");
    }
    assert!(read(b"mass_kg,x_m,y_m,z_m\n1,2,3,\xff\n", &ParticleOptions::default()).is_err());
}

#[test]
fn line_and_column_are_those_of_the_file() {
    let mut text = String::from("mass_kg,x_m,y_m,z_m\n");
    for k in 1..1000 {
        writeln!(text, "{k}.5,{k},-{k},0.{k}").unwrap();
    }
    text.push_str("1,2,3,here\n");
    let error = plain(&text).unwrap_err();
    let at = text.find("here").unwrap();
    assert_eq!(error.place, ContentPlace::Text(at..at + 4));
    assert_eq!(error.kind.to_string(), "expected a number, found \"here\"");
}

/// Two parts in general position: mass, position, and Ixx, Iyy, Izz, ∫xy dm, ∫xz dm, ∫yz dm about
/// their own centres.
const PARTS: [[f64; 10]; 2] = [
    [1.5, 0.25, -3.125, 0.0625, 2.0, 3.5, 4.25, 0.5, -0.375, 0.25],
    [20.25, 4.0625, 0.125, 7.5, 9.0, 7.0, 5.5, -1.25, 0.75, 2.0],
];

const PART_HEADER: &str =
    "name,mass_kg,x_m,y_m,z_m,Ixx_kg_m2,Iyy [kg m^2],I_zz (kg*m^2),ixy_kg_m2,Ixz_kg.m2,Iyz_kg_m^2\n";

fn part_rows(sign: f64) -> String {
    let mut rows = String::new();
    for (name, [m, x, y, z, xx, yy, zz, products @ ..]) in ["beam", "motor"].iter().zip(PARTS) {
        let [xy, xz, yz] = products.map(|p| sign * p);
        writeln!(rows, "{name},{m},{x},{y},{z},{xx},{yy},{zz},{xy},{xz},{yz}").unwrap();
    }
    rows
}

#[test]
fn parts_with_tensors_are_bodies_and_not_points() {
    // I_o = Σ [I_k + m (r² 1 − r rᵀ)], with products −∫xy dm.
    let mut about_origin = [[0.0; 3]; 3];
    for [m, x, y, z, xx, yy, zz, xy, xz, yz] in PARTS {
        let (r, own) = ([x, y, z], [[xx, -xy, -xz], [-xy, yy, -yz], [-xz, -yz, zz]]);
        for (i, row) in about_origin.iter_mut().enumerate() {
            for (j, element) in row.iter_mut().enumerate() {
                let square = if i == j { r.iter().map(|c| c * c).sum() } else { 0.0 };
                *element += own[i][j] + m * (square - r[i] * r[j]);
            }
        }
    }
    for (declared, sign) in [
        ("# products = negative_integral\n", -1.0),
        ("# products: \"positive_integral\"\n# a comment\n", 1.0),
    ] {
        let file = plain(&format!("{declared}{PART_HEADER}{}", part_rows(sign))).unwrap();
        assert_eq!((file.tensors.len(), file.findings.len()), (2, 0), "{:?}", file.findings);
        let body = file.mass_properties().unwrap();
        let found = body.inertia_about(Position::ZERO).matrix();
        for (found, want) in found.iter().flatten().zip(about_origin.iter().flatten()) {
            assert!((found - want).abs() < 1e-12, "{declared}: {found} {want}");
        }
    }
}

#[test]
fn the_sign_of_products_is_declared_and_never_guessed() {
    let text = format!("{PART_HEADER}{}", part_rows(1.0));
    let (kind, marked, hint) = refused(&text, &ParticleOptions::default());
    assert!(matches!(kind, ContentErrorKind::Unclear { .. }) && marked.starts_with("beam"), "{kind}");
    // Following the hint makes the file readable.
    let line = hint.split("write a line ").nth(1).and_then(|rest| rest.split(" (").next()).unwrap();
    assert!(plain(&format!("{line}\n{text}")).is_ok(), "{line}");
    let (kind, ..) = refused(&format!("# products = minus\n{text}"), &ParticleOptions::default());
    assert!(kind.to_string().contains("negative_integral"), "{kind}");
    // Zero products need no sign.
    let header = "mass_kg,x_m,y_m,z_m,Ixx_kg_m2,Iyy_kg_m2,Izz_kg_m2,Ixy_kg_m2,Ixz_kg_m2,Iyz_kg_m2\n";
    let plates = format!("{header}10,0,1,0,1,2,2.5,0,0,0\n10,0,-1,0,1,2,2.5,0,0,0\n");
    let body = plain(&plates).unwrap().mass_properties().unwrap();
    assert_eq!(body.inertia().matrix(), [[22.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 25.0]]);
}

#[test]
fn units_of_tensors_are_named_or_follow_from_those_that_are_told() {
    let rows = "2,3,4,5,6,7,8,0,0,0\n";
    let header = "mass_g,x_mm,y_mm,z_mm,Ixx_g_mm2,Iyy_g_mm2,Izz_g_mm2,Ixy_g_mm2,Ixz_g_mm2,Iyz_g_mm2\n";
    let named = plain(&format!("{header}{rows}")).unwrap();
    let bare = format!("mass,x,y,z,Ixx,Iyy,Izz,Ixy,Ixz,Iyz\n{rows}");
    let told = ParticleOptions { mass_unit: Some(1e-3), length_unit: Some(1e-3), total_mass: None };
    let told = read(bare.as_bytes(), &told).unwrap();
    for file in [&named, &told] {
        let moments = file.tensors[0].matrix();
        for (k, want) in [6e-9, 7e-9, 8e-9].into_iter().enumerate() {
            assert!((moments[k][k] / want - 1.0_f64).abs() < 1e-15);
        }
    }
    let half = "mass_g,x_mm,y_mm,z_mm,Ixx,Iyy,Izz,Ixy,Ixz,Iyz\n";
    let text = format!("{half}{rows}");
    let (kind, marked, hint) = refused(&text, &ParticleOptions::default());
    assert!(matches!(kind, ContentErrorKind::Unclear { .. }) && marked == "Ixx", "{kind}");
    assert!(hint.contains("Ixx_kg_m2") && hint.contains("--mass-unit and --unit"), "{hint}");
}

#[test]
fn hints_for_units_name_the_flag_that_answers() {
    let told = ParticleOptions { length_unit: Some(1e-3), ..ParticleOptions::default() };
    for text in ["1,2,3,4\n", "mass,x,y,z\n1,2,3,4\n"] {
        let (_, _, hint) = refused(text, &told);
        assert!(hint.contains("--mass-unit"), "{hint}");
        let both = ParticleOptions { mass_unit: Some(1e-3), ..told };
        assert_eq!(read(text.as_bytes(), &both).unwrap().particles[0].mass(), 0.001);
    }
}

#[test]
fn columns_that_change_the_body_are_refused() {
    let points = "mass_kg,x_m,y_m,z_m";
    for column in [
        "inertia",
        "MomentOfInertia_kgm2",
        "Jxx",
        "I1",
        "massKg",
        "part_mass_g",
        "weight_N",
        "density",
        "volume_mm3",
        "unit",
        "Units",
        "radius_mm",
        "com_x",
        "time_s",
        "Gewicht",
        "Izz_cad",
        "I xx",
        "J (zz)",
        "J",
        "peso",
        "质量 kg",
    ] {
        let text = format!("{points},{column}\n1,2,3,4,5\n");
        let (kind, marked, hint) = refused(&text, &ParticleOptions::default());
        assert!(marked == column && !hint.is_empty(), "{column}: {kind} {marked}");
    }
    // A tensor needs all six elements, along the axes of the table.
    for column in ["Ixx_kg_m2", "Iyz_kg_m2"] {
        assert!(plain(&format!("{points},{column}\n1,2,3,4,5\n")).is_err(), "{column}");
    }
    let turned = format!("{}{}", PART_HEADER.replace("name", "roll_deg"), part_rows(1.0));
    assert!(refused(&turned, &ParticleOptions::default()).1 == "roll_deg");
    // Labels do not indicate physical quantities.
    for column in ["material", "colour", "id", "vx", "supplier", "country", "account", "roll_deg"] {
        let file = plain(&format!("{points},{column}\n1,2,3,4,5\n")).unwrap();
        assert_eq!(file.findings[0].code, "particles.ignored-columns");
    }
}

#[test]
fn a_line_is_one_piece() {
    for column in ["quantity", "Qty", "count", "Anzahl", "pcs"] {
        let one = plain(&format!("mass_kg,x_m,y_m,z_m,{column}\n1,2,3,4,1\n")).unwrap();
        assert!(one.findings.is_empty());
        for quantity in ["4", "0", "1.5", "-1"] {
            let text = format!("mass_kg,x_m,y_m,z_m,{column}\n1,2,3,4,{quantity}\n");
            let (kind, marked, _) = refused(&text, &ParticleOptions::default());
            assert!(marked == quantity && kind.to_string().contains("one piece"), "{kind}");
        }
    }
}

#[test]
fn parts_of_one_name_count_each_unless_they_are_at_one_place() {
    let bolts = "name,mass_kg,x_m,y_m,z_m\nbolt,1,2,3,0\nbolt,1,2,3,4\nnut,2,0,0,0\n,1,1,1,1\n,1,1,1,1\n";
    let file = plain(bolts).unwrap();
    assert_eq!(file.mass_properties().unwrap().mass(), 6.0);
    assert_eq!(file.findings[0].code, "particles.repeated-names");
    assert!(file.findings[0].message.starts_with("\"bolt\" is on 2 lines"), "{:?}", file.findings);
    let twice = format!("{bolts}bolt,3,2,3,-0\n");
    let (kind, marked, _) = refused(&twice, &ParticleOptions::default());
    assert!(marked == "bolt" && kind.to_string().contains("same position"), "{kind}");
}

#[test]
fn numbers_are_read_as_they_are_printed() {
    let first = |text: &str| {
        let file = plain(text).unwrap();
        let particle = &file.particles[0];
        (particle.mass(), particle.position().to_array())
    };
    let want = (8.273_333e-5, [1234.5, -2.093_33, 4e-9]);
    for (separator, text) in [
        (",", "8.273 333e-5,1 234.5,\u{2212}2.093 33,4×10⁻⁹"),
        (";", "8.273\u{202f}333e-5;1\u{2009}234.5;-2.093 33;4e-9"),
        (";", "8,273 333e-5;1 234,5;\u{2212}2,093 33;4e-9"),
    ] {
        let header = ["mass_kg", "x_m", "y_m", "z_m"].join(separator);
        assert_eq!(first(&format!("{header}\n{text}\n")), want, "{text}");
    }
    for several in ["1 2", "12 34.5", "1 kg", "1.234,5"] {
        let text = format!("mass_kg;x_m;y_m;z_m\n{several};2;3;4\n");
        assert_eq!(refused(&text, &ParticleOptions::default()).1, several);
    }
}
