//! Values that must agree: units in a list, and the orbit of several torques.

use super::{BALL, RUN, parse, refuses};
use polhode_source::files::Disk;

#[test]
fn numbers_of_a_list_have_their_units_all_or_none() {
    refuses(
        &format!("[body]\npivot = ['0 mm', '0 mm', «'150'»]\n{BALL}"),
        "pivot = '150' must be given with its unit, like the other element \"0 mm\"",
        "write \"150 mm\", or \"150 m\"",
    );
    refuses(
        &format!("{BALL}position = ['1 mm', «2», 0]"),
        "position = 2 must be given with its unit, like the other element \"1 mm\"",
        "write \"2 mm\", or \"2 m\"",
    );
    refuses(
        "[[body.part]]\nshape='tensor'\nmass='2 kg'\ninertia=[['3 kg m^2','0.1 kg m^2',0],['0.1 kg m^2',«4»,0],[0,0,'5 kg m^2']]",
        "inertia = 4 must be given with its unit, like the other element \"3 kg m^2\"",
        "write \"4 kg m^2\"",
    );
    let plan = "[sweep]\nmembers=3\nsampling='monte carlo'\n[[sweep.vary]]\nkey='body.part[0].radius'\n";
    refuses(
        &format!("{BALL}{plan}uniform={{from='10 mm',to=«20»}}"),
        "to = 20 must be given with its unit, like the other element \"10 mm\"",
        "write \"20 mm\", or \"20 m\"",
    );
    refuses(
        &format!("{BALL}{plan}list=['10 mm',«2.5e1»]"),
        "list = 2.5e1 must be given with its unit, like the other element \"10 mm\"",
        "write \"2.5e1 mm\", or \"2.5e1 m\"",
    );
    // Zero is zero in every unit, and a formula has its own units.
    for right in
        ["position = ['1 mm', 0, '0']", "position = [0.001, 2, 3]", "position = ['1 mm', '-0.0', '2 in']"]
    {
        assert!(parse(&format!("{BALL}{right}")).is_ok(), "{right}");
    }
    let formulas = "[[torque]]\nmodel='formula'\naxes='body'\ntorque=['3[N m/s]*t', 2, 0]\n";
    assert!(parse(&format!("{BALL}{formulas}{RUN}")).is_ok());
}

#[test]
fn numbers_are_read_as_they_are_printed() {
    let place = |text: &str| {
        parse(&format!("{BALL}position=['{text}',0,0]")).unwrap().body().center_of_mass().to_array()[0]
    };
    for (text, want) in [
        ("8.273 333e-5", 8.273_333e-5),
        ("12 345.678 9 mm", 12.345_678_9),
        ("−4.5×10⁻⁵ m", -4.5e-5),
        ("123\u{a0}456\u{202f}mm", 123.456),
    ] {
        assert_eq!(place(text).to_bits(), f64::to_bits(want), "{text}");
    }
}

const GRADIENT: &str = "[[torque]]\nmodel='gravity_gradient'\n";
const MAGNET: &str = "[[torque]]\nmodel='magnetic'\nmoment=[0,0,1]\ndipole=[0,0,-7.8e22]\n";

#[test]
fn a_satellite_has_one_orbit() {
    refuses(
        &format!("{BALL}[[torque]]\nmodel='gravity_gradient'\n«orbit»={{radius='6900 km'}}\n{RUN}"),
        "unknown key \"orbit\" in [[torque]] of model \"gravity_gradient\"",
        "write [orbit] on a line of its own",
    );
    let plan = "[sweep]\nmembers=3\nsampling='monte carlo'\n[[sweep.vary]]\n";
    let uniform = "uniform={from='6900 km',to='7100 km'}";
    // A variation of the orbit applies to both torques, to the start and to the duration of the
    // run.
    let start = "[orbit]\nradius='7000 km'\n[start]\nrelative_to='orbit'\n";
    let run = "[run]\nduration='2 orbits'\nsamples=2\n";
    let plan = format!("{BALL}{start}{GRADIENT}{MAGNET}{run}{plan}key='orbit.radius'\n{uniform}");
    let template = polhode_scenario::read::Template::parse(&Disk, plan, "plan.toml".as_ref()).unwrap();
    let target = template.sweep().unwrap().vary[0].target.clone();
    let member = template.scenario([(&target, &[6.95e6][..])]).unwrap();
    let shown = format!("{:?}", member.torques());
    assert_eq!(shown.matches("periapsis: 6950000.0").count(), 2, "{shown}");
    let orbit = member.orbit().unwrap();
    assert_eq!(orbit.periapsis(), 6.95e6);
    let (rate, end) = (orbit.mean_motion().unwrap(), member.run().unwrap().times[1]);
    assert!((rate * end / (4.0 * std::f64::consts::PI) - 1.0).abs() < 1e-14);
    assert!((member.start().omega.norm() / rate - 1.0).abs() < 1e-14);
}

#[test]
fn a_rate_that_no_orbit_about_the_earth_has_is_asked_for_its_unit() {
    let gradient =
        |orbit: &str| parse(&format!("orbit={{{orbit}}}\n{BALL}[[torque]]\nmodel='gravity_gradient'\n{RUN}"));
    let findings = gradient("rate='0.002 rad/s'").unwrap().findings().to_vec();
    assert_eq!(findings[0].code, "orbit.underground");
    assert!(
        findings[0].message.contains("has the rate 0.002 rad/s: its radius would be 4636.2 km"),
        "{}",
        findings[0].message
    );
    assert!(!findings[0].message.contains("height"));
    assert!(gradient("rate='0.0011 rad/s'").unwrap().findings().is_empty());
    assert!(gradient("rate='0.002 rad/s',mu='4.9e12 m^3/s^2'").unwrap().findings().is_empty());
}

/// Returns a box with these edges as OBJ.
fn obj([a, b, c]: [f64; 3]) -> String {
    let vertices: String = (0..8)
        .map(|k| {
            format!("v {} {} {}\n", a * f64::from(k & 1), b * f64::from(k >> 1 & 1), c * f64::from(k >> 2))
        })
        .collect();
    vertices + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
}

#[test]
fn a_mesh_in_metres_that_nobody_gave_is_asked_beside_the_other_parts() {
    let folder = std::env::temp_dir().join(format!("polhode-assumed-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("plate.obj"), obj([120.0, 80.0, 9.6])).unwrap();
    std::fs::write(folder.join("small.obj"), obj([1.2, 0.8, 0.3])).unwrap();
    let asked = |file: &str, rest: &str| {
        let part =
            format!("[[body.part]]\nname='it'\nshape='mesh'\nfile='{file}'\ndensity='700 kg/m^3'\n{rest}");
        let scenario =
            polhode_scenario::read::parse(&format!("{BALL}{part}"), &folder.join("body.toml")).unwrap();
        let asked = scenario.findings().iter().filter(|&finding| finding.code == "mesh.unit").cloned();
        asked.map(|finding| (finding.message, finding.place)).collect::<Vec<_>>()
    };
    let found = asked("plate.obj", "");
    assert_eq!(found.len(), 1);
    let (message, place) = &found[0];
    assert!(message.contains("about 120 m long, its mass is 64500 t"), "{message}");
    assert!(message.contains("unit = \"mm\""), "{message}");
    assert_eq!(place.as_deref(), Some("part \"it\""));
    for declared in ["mm", "m", "in"] {
        assert_eq!(asked("plate.obj", &format!("unit='{declared}'")), [], "{declared}");
    }
    // The box with the ball's moments has edges of 31 mm. A body 39 times as long is accepted on a
    // ball.
    assert_eq!(asked("small.obj", ""), []);
    std::fs::remove_dir_all(&folder).unwrap();
}
