//! Exported files are read back, by an independent parser or by a few lines from the rules of the
//! format.

use std::collections::BTreeMap;

use polhode::prelude::*;
use polhode_document::SourceInfo;
use polhode_shape::export;
use polhode_shape::report::InertiaReport;
use polhode_shape::{ExportBody, ExportError, ExportFormat};
use roxmltree::{Document, Node};

type Matrix = [[f64; 3]; 3];

/// Particles at generic positions away from the origin.
const PARTICLES: [(f64, [f64; 3]); 5] = [
    (0.7, [0.31, -0.12, 0.83]),
    (1.3, [-0.45, 0.27, 0.19]),
    (0.2, [1.1, 0.9, -0.6]),
    (0.9, [0.05, -0.71, 0.4]),
    (0.4, [-0.3, 0.66, 1.2]),
];

const NAME: &str = "bracket";

fn generic() -> ExportBody {
    let particles = PARTICLES.map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap());
    ExportBody::new(NAME, mass_properties_of_particles(&particles).unwrap())
}

/// Returns a body with these tensor elements; products are negative integrals.
fn tensor(moments: [f64; 3], products: [f64; 3], mass: f64, center: [f64; 3]) -> ExportBody {
    let inertia = InertiaTensor::with_negative_products(moments, products).unwrap();
    ExportBody::new(NAME, MassProperties::new(mass, Position::from_array(center), inertia).unwrap())
}

/// Returns the tensor about the origin from its definition: Σ m (r² δ_ij − x_i x_j).
fn about_origin() -> Matrix {
    let element = |i: usize, j: usize| -> f64 {
        let term = |(m, p): &(f64, [f64; 3])| {
            let square: f64 = p.iter().map(|x| x * x).sum();
            m * (if i == j { square } else { 0.0 } - p[i] * p[j])
        };
        PARTICLES.iter().map(term).sum()
    };
    std::array::from_fn(|i| std::array::from_fn(|j| element(i, j)))
}

/// Returns J_ij = I_ij + M (c² δ_ij − c_i c_j).
fn moved_to_origin(central: Matrix, mass: f64, c: [f64; 3]) -> Matrix {
    let square: f64 = c.iter().map(|x| x * x).sum();
    let steiner = |i: usize, j: usize| mass * (if i == j { square } else { 0.0 } - c[i] * c[j]);
    std::array::from_fn(|i| std::array::from_fn(|j| central[i][j] + steiner(i, j)))
}

/// Returns R diag(moments) Rᵀ, with R from a quaternion (w, x, y, z).
fn rebuilt(moments: [f64; 3], [w, x, y, z]: [f64; 4]) -> Matrix {
    let r = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let element = |i: usize, j: usize| (0..3).map(|k| r[i][k] * moments[k] * r[j][k]).sum();
    std::array::from_fn(|i| std::array::from_fn(|j| element(i, j)))
}

/// Returns the matrix with the elements ixx, ixy, ixz, iyy, iyz, izz.
fn symmetric([ixx, ixy, ixz, iyy, iyz, izz]: [f64; 6]) -> Matrix {
    [[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]
}

#[track_caller]
fn close(got: Matrix, want: Matrix, tolerance: f64) {
    let scale = want.iter().flatten().fold(0.0_f64, |max, x| max.max(x.abs()));
    for (got, want) in got.as_flattened().iter().zip(want.as_flattened()) {
        assert!((got - want).abs() <= tolerance * scale, "{got} is not {want}");
    }
}

fn write(format: ExportFormat, body: &ExportBody) -> String {
    export(format, std::slice::from_ref(body)).unwrap()
}

fn floats<const N: usize>(text: &str) -> [f64; N] {
    let all: Vec<f64> = text
        .split([' ', ',', '(', ')'])
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().unwrap())
        .collect();
    all.try_into().unwrap()
}

fn node<'a>(document: &'a Document<'_>, tag: &str) -> Node<'a, 'a> {
    document.descendants().find(|node| node.has_tag_name(tag)).unwrap()
}

/// Mass, centre of mass, and central tensor along the body axes.
type Read = (f64, [f64; 3], Matrix);

fn read_urdf(text: &str) -> Read {
    let document = Document::parse(text).unwrap();
    let inertia = node(&document, "inertia");
    let element = |name| inertia.attribute(name).unwrap().parse().unwrap();
    let origin = node(&document, "origin");
    assert_eq!(origin.attribute("rpy"), Some("0 0 0"));
    let mass = node(&document, "mass").attribute("value").unwrap().parse().unwrap();
    let elements = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"].map(element);
    (mass, floats(origin.attribute("xyz").unwrap()), symmetric(elements))
}

fn read_sdf(text: &str) -> Read {
    let document = Document::parse(text).unwrap();
    let text = |tag| node(&document, tag).text().unwrap();
    let [x, y, z, roll, pitch, yaw] = floats(text("pose"));
    assert_eq!([roll, pitch, yaw], [0.0; 3]);
    let elements = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"].map(|tag| text(tag).parse().unwrap());
    (text("mass").parse().unwrap(), [x, y, z], symmetric(elements))
}

fn read_mjcf(text: &str) -> Read {
    let document = Document::parse(text).unwrap();
    let inertial = node(&document, "inertial");
    let attribute = |name| inertial.attribute(name).unwrap();
    let central = match inertial.attribute("fullinertia") {
        Some(full) => {
            let [m11, m22, m33, m12, m13, m23] = floats(full);
            symmetric([m11, m12, m13, m22, m23, m33])
        }
        None => rebuilt(floats(attribute("diaginertia")), floats(attribute("quat"))),
    };
    (attribute("mass").parse().unwrap(), floats(attribute("pos")), central)
}

fn usd_value<'a>(text: &'a str, name: &str) -> &'a str {
    let line = text.lines().find(|line| line.contains(&format!("physics:{name} = "))).unwrap();
    line.split_once(" = ").unwrap().1
}

fn read_usd(text: &str) -> Read {
    let value = |name| usd_value(text, name);
    let central = rebuilt(floats(value("diagonalInertia")), floats(value("principalAxes")));
    (value("mass").parse().unwrap(), floats(value("centerOfMass")), central)
}

/// Returns the texts before and after each `=`.
fn read_solidworks(text: &str) -> BTreeMap<String, String> {
    let cells = text.lines().flat_map(|line| line.split('\t'));
    let pair = |cell: &str| {
        let (label, value) = cell.split_once(" = ")?;
        Some((label.trim().to_owned(), value.trim().to_owned()))
    };
    cells.filter_map(pair).collect()
}

/// Returns the cells of the rows by column name.
fn read_csv(text: &str) -> Vec<BTreeMap<String, String>> {
    let split = |line: &str| {
        let (mut cells, mut quoted) = (vec![String::new()], false);
        let mut characters = line.chars().peekable();
        while let Some(c) = characters.next() {
            match c {
                '"' if quoted && characters.peek() == Some(&'"') => {
                    characters.next();
                    cells.last_mut().unwrap().push('"');
                }
                '"' => quoted = !quoted,
                ',' if !quoted => cells.push(String::new()),
                _ => cells.last_mut().unwrap().push(c),
            }
        }
        cells
    };
    let mut lines = text.lines();
    let header = split(lines.next().unwrap());
    let row = |line| {
        let cells = split(line);
        assert_eq!(cells.len(), header.len());
        header.iter().cloned().zip(cells).collect()
    };
    lines.map(row).collect()
}

/// Reads JSBSim data. Pounds, slugs and feet are defined by the international yard and pound and by
/// standard gravity.
fn read_jsbsim(text: &str) -> Read {
    let document = Document::parse(text).unwrap();
    let value = |tag, unit| {
        let node = node(&document, tag);
        assert_eq!(node.attribute("unit"), Some(unit), "{tag}");
        node.text().unwrap().parse::<f64>().unwrap()
    };
    assert_eq!(node(&document, "mass_balance").attribute("negated_crossproduct_inertia"), Some("true"));
    assert_eq!(node(&document, "location").attribute("unit"), Some("IN"));
    let center =
        ["x", "y", "z"].map(|tag| node(&document, tag).text().unwrap().parse::<f64>().unwrap() * 0.0254);
    // 1 slug·ft² = 1.355 817 948 331 400 4 kg·m²
    let elements = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"]
        .map(|tag| value(tag, "SLUG*FT2") * 1.355_817_948_331_400_4);
    (value("emptywt", "LBS") * 0.453_592_37, center, symmetric(elements))
}

/// Returns the numbers after `name = `, without brackets.
fn python<const N: usize>(text: &str, name: &str) -> [f64; N] {
    let line = text.lines().find(|line| line.trim_start().starts_with(&format!("{name} = "))).unwrap();
    floats(&line.split_once(" = ").unwrap().1.replace(['[', ']'], " "))
}

fn read(format: ExportFormat, text: &str) -> Read {
    match format {
        ExportFormat::JsbSim => read_jsbsim(text),
        ExportFormat::RocketPy => {
            let [i11, i22, i33, i12, i13, i23] = python(text, "inertia");
            let ([mass], [z]) = (python(text, "mass"), python(text, "center_of_mass_without_motor"));
            let [x, y] = python(text, "center_of_mass_eccentricity");
            (mass, [x, y, z], symmetric([i11, i12, i13, i22, i23, i33]))
        }
        ExportFormat::Basilisk => {
            let [a, b, c, d, e, f, g, h, i] = python(text, "spacecraft.hub.IHubPntBc_B");
            let [mass] = python(text, "spacecraft.hub.mHub");
            (mass, python(text, "spacecraft.hub.r_BcB_B"), [[a, b, c], [d, e, f], [g, h, i]])
        }
        ExportFormat::Urdf => read_urdf(text),
        ExportFormat::Sdf => read_sdf(text),
        ExportFormat::Mjcf | ExportFormat::MjcfPrincipal => read_mjcf(text),
        ExportFormat::Usd => read_usd(text),
        ExportFormat::SolidWorks => {
            let values = read_solidworks(text);
            let value = |label: &str| values[label].split(' ').next().unwrap().parse::<f64>().unwrap();
            let center = ["X", "Y", "Z"].map(value);
            // Products with the positive-tensor sign convention.
            let [lxy, lxz, lyz] = ["Lxy", "Lxz", "Lyz"].map(|label| -value(label));
            let [lxx, lyy, lzz] = ["Lxx", "Lyy", "Lzz"].map(value);
            (value("Mass"), center, symmetric([lxx, lxy, lxz, lyy, lyz, lzz]))
        }
        ExportFormat::Csv => {
            let rows = read_csv(text);
            let value = |name: &str| rows[0][name].parse().unwrap();
            let center = ["x", "y", "z"].map(|axis| value(&format!("center_of_mass_{axis}_m")));
            let elements = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"].map(|e| value(&format!("{e}_kg_m2")));
            (value("mass_kg"), center, symmetric(elements))
        }
    }
}

/// Returns true for formats with a tensor along principal axes, for which the reconstruction
/// rounds.
fn principal(format: ExportFormat) -> bool {
    matches!(format, ExportFormat::MjcfPrincipal | ExportFormat::Usd)
}

#[test]
fn every_format_says_the_body_that_the_particles_are() {
    let body = generic();
    for &format in ExportFormat::ALL {
        let (mass, center, central) = read(format, &write(format, &body));
        close(moved_to_origin(central, mass, center), about_origin(), 2e-15);
    }
}

#[test]
fn numbers_read_back_bit_for_bit() {
    let bodies = [
        generic(),
        tensor([3.1, 4.2, 5.3], [0.4, -0.3, 0.2], 2.3, [0.11, -0.07, 0.23]),
        tensor([3.1e-15, 4.2e-15, 5.3e-15], [4e-16, -3e-16, 2e-16], 1.0 / 3.0, [1e5 / 3.0, -1e-9 / 7.0, 0.1]),
        tensor([3.1e30, 4.2e30, 5.3e30], [4e29, -3e29, 2e29], 6e24 / 7.0, [1e7 / 3.0, -2e22 / 7.0, 0.1]),
    ];
    for body in &bodies {
        for &format in ExportFormat::ALL {
            let (mass, center, central) = read(format, &write(format, body));
            let properties = &body.properties;
            if format == ExportFormat::JsbSim {
                // Formats with other units round.
                assert!((mass / properties.mass() - 1.0).abs() < 1e-15);
                close([center; 3], [properties.center_of_mass().to_array(); 3], 1e-15);
                close(central, properties.inertia().matrix(), 1e-15);
                continue;
            }
            assert_eq!(mass.to_bits(), properties.mass().to_bits());
            assert_eq!(center.map(f64::to_bits), properties.center_of_mass().to_array().map(f64::to_bits));
            if principal(format) {
                close(central, properties.inertia().matrix(), 2e-15);
            } else {
                assert_eq!(central, properties.inertia().matrix(), "{}", format.name());
            }
        }
    }
}

#[test]
fn usd_is_still_the_body_in_single_precision() {
    let body = generic();
    let text = write(ExportFormat::Usd, &body);
    // USD attributes are f32.
    let single = |x: f64| f64::from(x as f32);
    let moments = floats(usd_value(&text, "diagonalInertia")).map(single);
    let quaternion = floats(usd_value(&text, "principalAxes")).map(single);
    close(rebuilt(moments, quaternion), body.properties.inertia().matrix(), 4.0 * f64::from(f32::EPSILON));
}

#[test]
fn solidworks_proves_its_sign() {
    let body = ExportBody { volume: Some(0.02), density: Some(175.0), surface_area: Some(0.7), ..generic() };
    let text = write(ExportFormat::SolidWorks, &body);
    assert_eq!(text.matches("(Using positive tensor notation.)").count(), 2);
    let values = read_solidworks(&text);
    let value = |label: &str| values[label].split(' ').next().unwrap().parse::<f64>().unwrap();
    // Ixy = +Σ m x y, the convention of SolidWorks.
    let product: f64 = PARTICLES.iter().map(|(m, p)| m * p[0] * p[1]).sum();
    assert!((value("Ixy") - product).abs() < 1e-15);
    let [i12, i23] = [about_origin()[0][1], about_origin()[1][2]];
    assert!((value("Ixy") + i12).abs() < 1e-15 && (value("Izy") + i23).abs() < 1e-15);
    // Ixz = Lxz + M x z holds for this sign only.
    let steiner = value("Mass") * value("X") * value("Z");
    assert!((value("Ixz") - value("Lxz") - steiner).abs() < 1e-15);
    assert!((value("Ixz") - value("Lxz") + steiner).abs() > 0.1);
    assert!(value("Px") <= value("Py") && value("Py") <= value("Pz"));
    for (line, unit) in [
        ("Density = 175 ", "kilograms per cubic meter"),
        ("Volume = 0.02 ", "cubic meters"),
        ("Surface area = 0.7 ", "square meters"),
    ] {
        assert!(text.contains(&format!("\n{line}{unit}\n")), "{text}");
    }
    // The axes correspond to the moments: R diag Rᵀ is the tensor.
    let axes: [[f64; 3]; 3] = ["Ix", "Iy", "Iz"].map(|label| floats(&values[label]));
    let moments = ["Px", "Py", "Pz"].map(value);
    let element = |i: usize, j: usize| (0..3).map(|k| axes[k][i] * moments[k] * axes[k][j]).sum();
    let again = std::array::from_fn(|i| std::array::from_fn(|j| element(i, j)));
    close(again, body.properties.inertia().matrix(), 2e-15);
}

#[test]
fn a_table_has_a_row_for_each_body_and_says_what_it_holds() {
    let second = ExportBody::new("the \"other\", ω", *crate::common::t_handle().body());
    let text = export(ExportFormat::Csv, &[generic(), second.clone()]).unwrap();
    assert!(!text.contains('\r') && text.ends_with('\n'));
    let rows = read_csv(&text);
    assert_eq!(rows.len(), 2);
    assert_eq!([&rows[0]["name"], &rows[1]["name"]], ["bracket", "the \"other\", ω"]);
    for (row, body) in rows.iter().zip([generic(), second]) {
        assert_eq!(row["inertia_about"], "center_of_mass");
        assert_eq!(row["inertia_axes"], "body");
        assert_eq!(row["inertia_products"], "negative_integral");
        assert_eq!(row["volume_m3"], "");
        let value = |name: &str| row[name].parse::<f64>().unwrap();
        let moments = ["i1_kg_m2", "i2_kg_m2", "i3_kg_m2"].map(value);
        let quaternion = ["w", "x", "y", "z"].map(|c| value(&format!("principal_quaternion_{c}")));
        close(rebuilt(moments, quaternion), body.properties.inertia().matrix(), 2e-15);
    }
}

#[test]
fn zeros_have_no_sign() {
    let body = tensor([1.1, 1.7, 2.3], [-0.0, 0.0, -0.0], 2.3, [-0.0, 0.0, -0.0]);
    for &format in ExportFormat::ALL {
        let text = write(format, &body);
        for word in text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == '.')) {
            assert_ne!(word, "-0", "{text}");
        }
        let (_, center, central) = read(format, &text);
        assert_eq!(center, [0.0; 3]);
        close(central, [[1.1, 0.0, 0.0], [0.0, 1.7, 0.0], [0.0, 0.0, 2.3]], 4e-16);
    }
}

#[test]
fn names_survive_xml() {
    let name = "a<b> & \"c\" 'd' Größe, 慣性 😀\tx\ny\r\u{85}--";
    let body = ExportBody { name: name.to_owned(), ..generic() };
    for (format, tag) in [
        (ExportFormat::Urdf, "link"),
        (ExportFormat::Urdf, "robot"),
        (ExportFormat::Sdf, "link"),
        (ExportFormat::Sdf, "model"),
        (ExportFormat::MjcfPrincipal, "body"),
    ] {
        let text = write(format, &body);
        let document = Document::parse(&text).unwrap();
        assert_eq!(node(&document, tag).attribute("name"), Some(name));
    }
    // Characters that XML cannot contain are written in words, so that the file is valid XML.
    let body = ExportBody { name: "bell \u{7}, null \u{0}, \u{ffff}".to_owned(), ..generic() };
    for format in [ExportFormat::Urdf, ExportFormat::Sdf, ExportFormat::Mjcf] {
        let text = write(format, &body);
        let document = Document::parse(&text).unwrap();
        let links = |node: &Node<'_, '_>| node.has_tag_name("link") || node.has_tag_name("body");
        let link = document.descendants().find(links).unwrap();
        assert_eq!(link.attribute("name"), Some(r"bell \u{7}, null \u{0}, \u{ffff}"));
    }
}

#[test]
fn names_stay_on_one_line_in_text_and_become_identifiers_in_usd() {
    let names = ["3 \"cm\" bolt\\", "3 'cm' bolt/", "慣性", "plain_Name2", "a\u{1b}[31m\nb", ""];
    let bodies = names.map(|name| ExportBody { name: name.to_owned(), ..generic() });
    let usd = export(ExportFormat::Usd, &bodies).unwrap();
    let quoted = |start: &str| -> Vec<&str> {
        let value = |line: &'_ str| line.trim().strip_prefix(start).map(str::len).map(|n| line.len() - n);
        usd.lines().filter_map(|line| Some(&line[value(line)?..])).collect()
    };
    let prims: Vec<_> = quoted("def Xform ").iter().map(|rest| rest.split('"').nth(1).unwrap()).collect();
    assert_eq!(prims, ["_3__cm__bolt_", "_3__cm__bolt__2", "__", "plain_Name2", "a__31m_b", "_"]);
    assert_eq!(
        quoted("displayName = "),
        [
            r#""3 \"cm\" bolt\\""#,
            r#""3 'cm' bolt/""#,
            r#""慣性""#,
            r#""plain_Name2""#,
            r#""a\\u{1b}[31m\\nb""#,
            r#""""#
        ]
    );
    assert!(usd.starts_with("#usda 1.0\n") && usd.contains("    defaultPrim = \"_3__cm__bolt_\"\n"));
    let text = export(ExportFormat::SolidWorks, &bodies).unwrap();
    assert!(text.contains("\nMass properties of a\\u{1b}[31m\\nb\n"));
    assert_eq!(read_csv(&export(ExportFormat::Csv, &bodies).unwrap())[4]["name"], r"a\u{1b}[31m\nb");
}

#[test]
fn several_bodies_are_several_links() {
    let bodies = [generic(), ExportBody::new("other", *crate::common::t_handle().body())];
    let sdf = export(ExportFormat::Sdf, &bodies).unwrap();
    let document = Document::parse(&sdf).unwrap();
    let names = |tag: &str| -> Vec<_> {
        document.descendants().filter(|n| n.has_tag_name(tag)).filter_map(|n| n.attribute("name")).collect()
    };
    assert_eq!(names("link"), [NAME, "other"]);
    let mjcf = export(ExportFormat::Mjcf, &bodies).unwrap();
    let document = Document::parse(&mjcf).unwrap();
    let inertials = document.descendants().filter(|n| n.has_tag_name("inertial"));
    let masses: Vec<f64> = inertials.map(|n| n.attribute("mass").unwrap().parse().unwrap()).collect();
    assert_eq!(masses, bodies.each_ref().map(|body| body.properties.mass()));
    let several = export(ExportFormat::Urdf, &bodies).unwrap_err();
    assert_eq!(several, ExportError::Several { format: ExportFormat::Urdf, bodies: 2 });
    assert_eq!(several.to_string(), "2 bodies in one urdf file: its links would need joints");
}

#[test]
fn names_that_a_format_keeps_for_itself_are_refused() {
    let named = |name: &str| ExportBody { name: name.to_owned(), ..generic() };
    for (format, names) in [
        (ExportFormat::Urdf, &[""][..]),
        (ExportFormat::Sdf, &["", "world", "__model__", "a::b"][..]),
        (ExportFormat::Mjcf, &["", "world"][..]),
    ] {
        for name in names {
            let error = export(format, &[named(name)]).unwrap_err();
            assert!(matches!(&error, ExportError::Name { name: n, .. } if n == name), "{error}");
        }
    }
    for format in [ExportFormat::Sdf, ExportFormat::Mjcf, ExportFormat::MjcfPrincipal] {
        let error = export(format, &[named("a"), named("b"), named("a")]).unwrap_err();
        assert!(error.to_string().contains("another body has the same name"), "{error}");
    }
    for &format in ExportFormat::ALL {
        assert_eq!(export(format, &[]), Err(ExportError::Empty));
    }
}

#[test]
fn what_single_precision_cannot_hold_is_not_written_as_usd() {
    let center = [0.1, -0.2, 0.3];
    let molecule = tensor([1e-46, 2e-46, 2.5e-46], [1e-47, 0.0, -2e-47], 3e-26, center);
    let heavy = tensor([1e30, 2e30, 2.5e30], [1e29, 0.0, -2e29], 1e39, center);
    let far = tensor([1.0, 2.0, 2.5], [0.1, 0.0, -0.2], 2.3, [1.0, -1e40, 2.0]);
    let point = tensor([0.0; 3], [0.0; 3], 2.3, center);
    for (body, wrong) in [
        (molecule, "a principal moment"),
        (heavy, "the mass"),
        (far, "the centre of mass"),
        (point, "the greatest principal moment"),
    ] {
        match export(ExportFormat::Usd, std::slice::from_ref(&body)) {
            Err(ExportError::Range { what, .. }) => assert_eq!(what, wrong),
            other => panic!("{other:?}"),
        }
        assert!(export(ExportFormat::Urdf, &[body]).is_ok());
    }
    let beyond = tensor([1e120, 2e120, 2.5e120], [1e119, 0.0, -2e119], 1e300, [1e9, -2e9, 3e9]);
    let error = export(ExportFormat::SolidWorks, &[beyond]).unwrap_err();
    assert!(matches!(&error, ExportError::Range { value, .. } if !value.is_finite()), "{error}");
    assert!(error.hint().contains("csv"));
}

#[test]
fn rods_and_points_carry_a_warning() {
    let rod = ExportBody::new("rod", *crate::common::rod().body());
    let point = ExportBody::new("point", *crate::common::point().body());
    for format in [ExportFormat::Urdf, ExportFormat::Sdf, ExportFormat::Mjcf, ExportFormat::MjcfPrincipal] {
        assert!(write(format, &rod).contains("<!-- a rod without moment of inertia about its axis, "));
        assert!(write(format, &point).contains("<!-- a point mass without moments of inertia, "));
        assert!(!write(format, &generic()).contains("refuse"));
    }
}

#[test]
fn every_file_says_what_it_is_and_who_wrote_it() {
    let body = generic();
    let version = format!("polhode {}: mass properties", polhode_document::VERSION);
    for &format in ExportFormat::ALL {
        assert_eq!(ExportFormat::named(&format.name().to_uppercase()), Some(format));
        let text = write(format, &body);
        if format != ExportFormat::Csv {
            assert!(text.lines().take(2).any(|line| line.contains(&version)), "{text}");
            // The text around the numbers is ASCII only.
            assert!(text.is_ascii());
        }
    }
    let distinct: std::collections::BTreeSet<_> = ExportFormat::ALL.iter().map(|f| f.name()).collect();
    assert_eq!(distinct.len(), ExportFormat::ALL.len());
    assert_eq!(ExportFormat::named("stl"), None);
}

#[test]
fn a_report_gives_its_volume_and_area() {
    let report = InertiaReport {
        volume: Some(0.25),
        surface_area: Some(1.5),
        density: Some(14.0),
        ..InertiaReport::new(SourceInfo::new("a.stl", "stl"), generic().properties)
    };
    let row = &read_csv(&write(ExportFormat::Csv, &ExportBody::of_report("a", &report)))[0];
    assert_eq!(
        ["volume_m3", "surface_area_m2", "density_kg_m3"].map(|k| row[k].as_str()),
        ["0.25", "1.5", "14"]
    );
}
