//! Robots without inertials get the exact ones back.

use polhode_document::Report as _;
use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::finding::Severity;
use polhode_robot::geometry::Shapes;
use polhode_robot::inertials::{Inertials, write_inertials};
use polhode_robot::inspect::inspect;
use polhode_source::files::Memory;

use super::request;
use super::robot::{Exact, Link, links, links_and_egg, mjcf, sdf, urdf, usda, wedge};

/// Writes the inertials of a robot with the density of each link.
fn rebuild(file: &str, text: &str, links: &[Link], prefix: &str) -> (Inertials, Memory) {
    let parts: Vec<String> =
        links.iter().map(|link| format!("{prefix}{}={} kg/m^3", link.name, link.density)).collect();
    let files = Memory::from([(file, text), ("wedge.obj", &wedge())]);
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    (write_inertials(&request(file, &parts), &files).unwrap(), files)
}

/// Requires that each link of the new text has its exact inertial, and that `check` has no finding.
#[track_caller]
fn require_exact(inertials: &Inertials, files: &Memory, links: &[Link], prefix: &str, tolerance: f64) {
    assert!(!inertials.has_failed(), "{}", inertials.to_text(None));
    for link in links {
        let Exact(mass, center, tensor) = link.exact();
        let name = format!("{prefix}{}", link.name);
        let read = inertials.after().links.iter().find(|read| read.name.text == name).unwrap();
        let Ok(LinkMass::Body(body)) = link_mass(inertials.after().format, read) else { panic!("{name}") };
        let body = body.properties;
        let (size, norm) = (
            (tensor[0][0] / mass).sqrt(),
            tensor.as_flattened().iter().fold(0.0, |m: f64, x| m.max(x.abs())),
        );
        assert!((body.mass() / mass - 1.0).abs() < tolerance, "{name}: {} {mass}", body.mass());
        for (own, exact) in body.center_of_mass().to_array().iter().zip(center) {
            let off = (own - exact).abs();
            assert!(off < tolerance * (size + exact.abs()), "{name}: {off:e}");
        }
        for (own, exact) in body.inertia().matrix().as_flattened().iter().zip(tensor.as_flattened()) {
            assert!((own - exact).abs() < tolerance * norm, "{name}: {own} {exact}");
        }
    }
    let shapes = Shapes::default().from_files(files);
    let worst = inspect(inertials.after(), &shapes)
        .findings
        .into_iter()
        .filter(|found| found.severity > Severity::Note);
    assert_eq!(worst.collect::<Vec<_>>(), []);
}

/// Removes everything from each opening to its closing.
fn without(text: &str, opening: &str, closing: &str) -> String {
    let mut rest = text;
    let mut left = String::new();
    while let Some((before, after)) = rest.split_once(opening) {
        left += before;
        rest = after.split_once(closing).unwrap().1;
    }
    left + rest
}

#[test]
fn a_urdf_is_rebuilt() {
    let links = links();
    let text = urdf(&links);
    let (inertials, files) = rebuild("r.urdf", &text, &links, "");
    require_exact(&inertials, &files, &links, "", 1e-12);
    assert_eq!(without(inertials.text(), "\n    <inertial>", "</inertial>"), text);
    assert!(inertials.text().contains("\">\n    <inertial>\n      <origin xyz="), "{}", inertials.text());
    // Writing them again changes nothing.
    let (again, _) = rebuild("r.urdf", inertials.text(), &links, "");
    assert_eq!(again.text(), inertials.text());
    assert_eq!(again.to_diff("r.urdf"), "");
}

#[test]
fn an_sdf_is_rebuilt() {
    let links = links_and_egg();
    let text = sdf(&links);
    let (inertials, files) = rebuild("r.sdf", &text, &links, "");
    require_exact(&inertials, &files, &links, "", 1e-12);
    assert_eq!(without(inertials.text(), "\r\n\t\t\t<inertial>", "</inertial>"), text);
    assert!(inertials.text().contains("\r\n\t\t\t\t<inertia>\r\n\t\t\t\t\t<ixx>"), "{}", inertials.text());
}

#[test]
fn an_mjcf_is_rebuilt() {
    let links = links_and_egg();
    let text = mjcf(&links);
    let (inertials, files) = rebuild("r.xml", &text, &links, "");
    require_exact(&inertials, &files, &links, "", 1e-12);
    assert_eq!(without(inertials.text(), "<inertial pos=", "/>"), text);
}

/// USD stores single precision: numbers have the digits that identify it.
#[test]
fn a_usd_is_rebuilt_to_single_precision() {
    let links = links_and_egg();
    let text = usda(&links);
    let (inertials, files) = rebuild("r.usda", &text, &links, "/r/");
    require_exact(&inertials, &files, &links, "/r/", 3e-7);
    let new = inertials.text();
    let kept =
        new.lines().filter(|line| !line.contains("physics:mass") && !line.contains("physics:centerOfMass"));
    let kept = kept
        .filter(|line| !line.contains("physics:diagonalInertia") && !line.contains("physics:principalAxes"));
    let kept = kept.map(|line| line.replace(", \"PhysicsMassAPI\"", "") + "\n").collect::<String>();
    assert_eq!(kept, text);
}
