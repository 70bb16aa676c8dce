//! SDFormat's `<inertial auto="true">`: mass properties from collisions and densities.

use polhode::body::MassProperties;
use polhode::math::Part;
use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::model::RobotModel;
use polhode_robot::read::{ReadOptions, read_model};

use crate::common::{Folder, assert_close, assert_near, matrix_about, read, require_says, times, transposed};

fn link(name: &str, inner: &str) -> String {
    format!("<link name=\"{name}\"><pose>1 2 3 0 0 0</pose>{inner}</link>")
}

fn model(links: &str) -> RobotModel {
    read(&format!("<sdf version=\"1.12\"><model name=\"m\">{links}</model></sdf>"))
}

fn body(model: &RobotModel, name: &str) -> MassProperties<Part> {
    let link = model.links.iter().find(|link| link.name.text == name).unwrap();
    match link_mass(model.format, link) {
        Ok(LinkMass::Body(body)) => body.properties,
        other => panic!("{other:?}"),
    }
}

fn computed(model: &RobotModel) -> Vec<(Severity, String)> {
    let findings = inspect(model, &Shapes::default()).findings.into_iter();
    let own = findings.filter(|found| found.code == "inertia.computed");
    own.map(|Finding { severity, message, .. }| (severity, message)).collect()
}

#[track_caller]
fn assert_body(body: &MassProperties<Part>, mass: f64, center: [f64; 3], moments: [f64; 3]) {
    assert!((body.mass() / mass - 1.0).abs() < 1e-13, "{}", body.mass());
    assert_close(body.center_of_mass().to_array(), center, 1e-15);
    let [a, b, c] = moments;
    assert_near(&body.inertia().matrix(), &[[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]], 6e-12);
}

#[test]
fn density_and_mass_give_the_link_its_inertia() {
    let model = read(
        r#"<?xml version="1.0"?><sdf version="1.12"><model name="m">
        <link name="by_density"><inertial auto="true"/><collision name="c"><density>2710</density><geometry><box><size>0.2 0.1 0.05</size></box></geometry></collision></link>
        <link name="by_mass"><pose>1 0 0 0 0 0</pose><inertial auto="true"><mass>3</mass></inertial>
         <collision name="c1"><pose>0 0 0.1 0 0 0</pose><density>1000</density><geometry><sphere><radius>0.05</radius></sphere></geometry></collision>
         <collision name="c2"><pose>0 0 -0.1 0 0 0</pose><density>3000</density><geometry><cylinder><radius>0.04</radius><length>0.12</length></cylinder></geometry></collision></link>
        <joint name="j" type="revolute"><parent>by_density</parent><child>by_mass</child><axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"#,
    );
    let moments = [0.00282291667, 0.00959791667, 0.01129166667];
    assert_body(&body(&model, "by_density"), 2.71, [0.0; 3], moments);
    let moments = [0.02528249954, 0.02528249954, 0.00253464991];
    assert_body(&body(&model, "by_mass"), 3.0, [0.0, 0.0, -0.05511669658886894], moments);
    let told = computed(&model);
    assert!(told.iter().all(|(severity, _)| *severity == Severity::Note), "{told:?}");
    assert_eq!(
        told[0].1,
        "computed from 1 collision: 2.71 kg at (0, 0, 0) m, ixx 0.00282292 iyy 0.00959792 izz 0.0112917 ixy 0 ixz 0 iyz 0 kg·m²"
    );
}

#[test]
fn densities_are_the_collisions_then_the_inertials_then_that_of_water() {
    let collision = |density: &str| {
        format!(
            "<collision name=\"c\">{density}<geometry><box><size>0.2 0.3 0.5</size></box></geometry></collision>"
        )
    };
    let of = |own: &str, inertial: &str| {
        let inner = format!("<inertial auto=\"1\">{inertial}</inertial>{}", collision(own));
        model(&link("a", &inner))
    };
    for (own, inertial, mass, is_assumed) in [
        ("<density>2000</density>", "<density>3000</density>", 60.0, false),
        ("", "<density>3000</density>", 90.0, false),
        ("", "", 30.0, true),
        ("<density>2000</density>", "<density>3000</density><mass>7.5</mass>", 7.5, false),
        ("", "<mass>7.5</mass>", 7.5, false),
    ] {
        let model = of(own, inertial);
        let moments = [0.34, 0.29, 0.13].map(|sum| mass * sum / 12.0);
        assert_body(&body(&model, "a"), mass, [0.0; 3], moments);
        assert_eq!(computed(&model)[0].1.contains("with the default density 1000 kg/m³"), is_assumed);
    }
}

#[test]
fn each_shape_stands_where_its_collision_is() {
    // Cone: apex up, centre a quarter of its height below the middle (libsdformat,
    // Cone::CalculateInertial).
    let (radius, height, density) = (0.3, 0.8, 700.0);
    let cone = format!(
        "<inertial auto=\"true\"/><collision name=\"c\"><density>{density}</density><pose>0.1 -0.2 0.3 0.4 0 0</pose>\
         <geometry><cone><radius>{radius}</radius><length>{height}</length></cone></geometry></collision>"
    );
    let body_of_cone = body(&model(&link("a", &cone)), "a");
    let mass = density * std::f64::consts::PI * radius * radius * height / 3.0;
    assert!((body_of_cone.mass() / mass - 1.0).abs() < 1e-14);
    let across = mass * (3.0 / 80.0 * height * height + 3.0 / 20.0 * radius * radius);
    let own = [[across, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, 0.3 * mass * radius * radius]];
    let turn = matrix_about(0, 0.4);
    assert_near(&body_of_cone.inertia().matrix(), &times(times(turn, own), transposed(turn)), 1e-14);
    let below = 0.25 * height;
    let center = [0.1, -0.2 + below * 0.4_f64.sin(), 0.3 - below * 0.4_f64.cos()];
    assert_close(body_of_cone.center_of_mass().to_array(), center, 1e-15);

    // Other shapes agree with the solids of the library; a visual has no mass.
    let both = "<inertial auto=\"true\"/><visual name=\"v\"><geometry><sphere><radius>9</radius></sphere></geometry></visual>\
        <collision name=\"e\"><density>800</density><pose>0.5 0 0 0 0.3 0</pose><geometry><ellipsoid><radii>0.1 0.2 0.3</radii></ellipsoid></geometry></collision>\
        <collision name=\"k\"><density>900</density><pose>0 0.4 0 0 0 0</pose><geometry><capsule><radius>0.1</radius><length>0.5</length></capsule></geometry></collision>";
    let both = body(&model(&link("a", both)), "a");
    let ellipsoid = 800.0 * 4.0 / 3.0 * std::f64::consts::PI * 0.006;
    let capsule = 900.0 * std::f64::consts::PI * (0.01 * 0.5 + 4.0 / 3.0 * 0.001);
    assert!((both.mass() / (ellipsoid + capsule) - 1.0).abs() < 1e-14);
    let center = [0.5 * ellipsoid, 0.4 * capsule, 0.0].map(|moment| moment / (ellipsoid + capsule));
    assert_close(both.center_of_mass().to_array(), center, 1e-15);
}

#[test]
fn meshes_are_integrated_if_they_are_closed() {
    // A box of 1 × 2 × 3 with a corner at the origin, and the same without its last triangle.
    let corner = |k: usize| [(k & 1) as f64, 2.0 * (k >> 1 & 1) as f64, 3.0 * (k >> 2 & 1) as f64];
    let faces = [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ];
    let obj = |faces: &[[usize; 3]]| {
        let corners = (0..8).map(corner).map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect::<String>();
        corners
            + &faces.iter().map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1)).collect::<String>()
    };
    let sdf = |mesh: &str| {
        format!(
            "<sdf version=\"1.12\"><model name=\"m\"><link name=\"a\"><inertial auto=\"true\"><density>500</density></inertial>\
             <collision name=\"c\"><pose>1 0 0 0 0 0</pose><geometry><mesh><uri>{mesh}</uri><scale>0.1 0.1 0.2</scale></mesh></geometry></collision>\
             </link></model></sdf>"
        )
    };
    let folder = Folder::of(
        "auto-mesh",
        &[
            ("closed.obj", &obj(&faces)),
            ("open.obj", &obj(&faces[..11])),
            ("closed.sdf", &sdf("closed.obj")),
            ("open.sdf", &sdf("open.obj")),
            ("none.sdf", &sdf("none.obj")),
        ],
    );
    let of = |name: &str| read_model(&folder.path(name), &ReadOptions::default()).unwrap();
    let mass = 500.0 * 0.1 * 0.2 * 0.6;
    let moments = [[0.2_f64, 0.6], [0.1, 0.6], [0.1, 0.2]].map(|[a, b]| mass * (a * a + b * b) / 12.0);
    assert_body(&body(&of("closed.sdf"), "a"), mass, [1.05, 0.1, 0.3], moments);
    for (name, why) in [("open.sdf", "not closed"), ("none.sdf", "does not exist")] {
        let model = of(name);
        let error = link_mass(model.format, &model.links[0]).unwrap_err();
        require_says(&error, "its mass cannot be computed: ");
        require_says(&error, why);
        let told = computed(&model);
        assert!(matches!(&told[..], [(Severity::Note, message)] if message.contains(why)), "{told:?}");
    }
}

#[test]
fn what_sdformat_refuses_is_impossible() {
    let cube = "<geometry><box><size>0.1 0.1 0.1</size></box></geometry>";
    for (inner, why) in [
        ("<inertial auto=\"true\"/>".to_owned(), "the link has no collision"),
        (
            format!("<inertial auto=\"true\"/><collision name=\"c\"><density>0</density>{cube}</collision>"),
            "its density is \"0\"",
        ),
        (
            format!("<inertial auto=\"true\"><density>light</density></inertial><collision name=\"c\">{cube}</collision>"),
            "its density is \"light\"",
        ),
        (
            format!("<inertial auto=\"true\"><mass>-2</mass></inertial><collision name=\"c\">{cube}</collision>"),
            "its mass is \"-2\"",
        ),
        (
            "<inertial auto=\"true\"/><collision name=\"c\"><geometry><sphere><radius>0</radius></sphere></geometry></collision>"
                .to_owned(),
            "radius",
        ),
    ] {
        let model = model(&link("a", &inner));
        let told = computed(&model);
        assert!(matches!(&told[..], [(Severity::Impossible, message)] if message.contains(why)), "{told:?}");
        assert!(link_mass(model.format, &model.links[0]).is_err());
    }
    // An overwritten pose, and a density that no solid has.
    let inner = format!(
        "<inertial auto=\"true\"><pose>0 0 1 0 0 0</pose></inertial><collision name=\"c\"><density>2e6</density>{cube}</collision>"
    );
    let found = inspect(&model(&link("a", &inner)), &Shapes::default()).findings;
    let of = |code: &str| found.iter().filter(|f| f.code == code && f.severity == Severity::Suspect).count();
    assert_eq!((of("inertia.computed"), of("density.implausible")), (1, 1), "{found:?}");
}

#[test]
fn a_word_that_is_neither_true_nor_false_is_an_error() {
    let shape = "<geometry><box><size>0.2 0.1 0.05</size></box></geometry>";
    for word in ["yes", "on", "2", ""] {
        let inner = format!("<inertial auto=\"{word}\"/><collision name=\"c\">{shape}</collision>");
        let model = model(&link("l", &inner));
        let found = computed(&model);
        assert_eq!(found.len(), 1, "{word} {found:?}");
        assert_eq!(found[0].0, Severity::Impossible);
        assert!(found[0].1.contains("neither \"true\" nor \"false\""), "{found:?}");
        let error = link_mass(model.format, &model.links[0]).unwrap_err();
        assert!(error.to_string().starts_with("its mass cannot be computed: auto="), "{error}");
    }
}
