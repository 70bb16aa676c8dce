//! Moving links without mass or inertia, and the programs that reject them.

use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect_for;
use polhode_robot::program::Program;

use crate::common::read;

fn refused(text: &str, programs: &[Program]) -> Vec<(Severity, String, String)> {
    let of = |found: Finding| (found.severity, found.subject, found.message);
    let found = inspect_for(&read(text), &Shapes::default(), programs).findings;
    found.into_iter().filter(|found| found.code == "mass.refused").map(of).collect()
}

/// Returns links with this content, connected by joints of this type.
fn chain(links: &[&str], kind: &str) -> String {
    let links = links.iter().enumerate().map(|(k, inner)| format!("<link name=\"l{k}\">{inner}</link>"));
    let (count, links) = (links.len(), links.collect::<String>());
    let joint = |k: usize| {
        format!(
            "<joint name=\"j{k}\" type=\"{kind}\"><parent link=\"l{k}\"/><child link=\"l{}\"/><axis xyz=\"0 1 0\"/>\
             <limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>",
            k + 1
        )
    };
    format!("<robot name=\"r\">{links}{}</robot>", (0..count - 1).map(joint).collect::<String>())
}

const MASS: &str = r#"<inertial><mass value="1.7"/><inertia ixx="0.031" iyy="0.042" izz="0.053" ixy="0" ixz="0" iyz="0"/></inertial>"#;
const ZERO: &str =
    r#"<inertial><mass value="0"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial>"#;

#[test]
fn a_massless_link_between_joints_is_a_note_that_names_programs() {
    for massless in [ZERO, ""] {
        let text = chain(&["", massless, MASS], "revolute");
        let told = "moves without mass: MuJoCo refuses the model, Gazebo drops the link and all its descendants, \
                    Isaac Sim assumes the inertia of a small sphere";
        assert_eq!(refused(&text, &[]), [(Severity::Note, "l1".to_owned(), told.to_owned())]);
    }
    // A mass fixed to the link is sufficient.
    let text = chain(&[MASS, "", MASS], "revolute");
    let fixed = text.replace("</robot>", "<link name=\"f\">MASS</link><joint name=\"f\" type=\"fixed\"><parent link=\"l1\"/><child link=\"f\"/></joint></robot>");
    assert_eq!(refused(&fixed.replace("MASS", MASS), &Program::ALL), []);
    assert_eq!(refused(&fixed.replace("MASS", ""), &[]).len(), 1);
    // A fixed joint is also accepted.
    assert_eq!(refused(&chain(&[MASS, "", MASS], "fixed"), &Program::ALL), []);
}

#[test]
fn for_a_program_it_is_an_error() {
    let text = chain(&["", ZERO, MASS], "revolute");
    let of = |program, link: &str, what: &str| {
        let all = refused(&text, &[program]);
        let own: Vec<_> = all.iter().filter(|(severity, ..)| *severity == Severity::Impossible).collect();
        assert_eq!(own.last().map(|(_, subject, _)| subject.as_str()), Some(link));
        assert!(own.last().is_some_and(|(.., message)| message.ends_with(what)), "{own:?}");
        own.len()
    };
    assert_eq!(of(Program::Mujoco, "l1", "moves without mass: MuJoCo refuses the model"), 1);
    // The root is also rejected: all its descendants are lost.
    assert_eq!(of(Program::Gazebo, "l1", "Gazebo drops the link and all its descendants"), 2);
    assert_eq!(of(Program::Isaac, "l1", "Isaac Sim assumes the inertia of a small sphere"), 1);
    // Drake rejects only massless ends of chains.
    assert!(refused(&text, &[Program::Drake]).iter().all(|(severity, ..)| *severity == Severity::Note));
    let tip = chain(&[MASS, MASS, ZERO], "prismatic");
    let drake = refused(&tip, &[Program::Drake]);
    assert_eq!(
        drake[0],
        (Severity::Impossible, "l2".to_owned(), "moves without mass: Drake refuses the model".to_owned())
    );
    // Gazebo accepts a root named `world`.
    let world = text.replace("\"l0\"", "\"world\"");
    assert_eq!(
        refused(&world, &[Program::Gazebo])
            .iter()
            .filter(|(severity, ..)| *severity == Severity::Impossible)
            .count(),
        1
    );
}

#[test]
fn mujoco_and_isaac_take_the_mass_of_a_urdf_from_its_collisions() {
    let shape = "<collision><geometry><box size=\"0.1 0.2 0.3\"/></geometry></collision>";
    let text = chain(&[MASS, shape, MASS], "revolute");
    let only =
        |program| refused(&text, &[program]).iter().any(|(severity, ..)| *severity == Severity::Impossible);
    assert_eq!([Program::Mujoco, Program::Isaac, Program::Gazebo].map(only), [false, false, true]);
}

#[test]
fn a_moment_below_what_mujoco_takes_is_refused() {
    let body = |inertial: &str| {
        format!(
            "<mujoco><worldbody><body name=\"a\"><joint/>{inertial}<body name=\"b\">INNER</body></body></worldbody></mujoco>"
        )
    };
    let tiny = body(r#"<inertial pos="0 0 0" mass="2e-10" diaginertia="3e-15 2.5e-15 0.9e-15"/>"#);
    let told = "moves with a mass or moment of inertia below 1e-15: MuJoCo refuses the model";
    let found = refused(&tiny.replace("INNER", ""), &[Program::Mujoco]);
    assert_eq!(found, [(Severity::Impossible, "a".to_owned(), told.to_owned())]);
    // The inertia of a body fixed to it counts.
    let inner = r#"<inertial pos="0 0 0" mass="0.1" diaginertia="3e-4 2.5e-4 2e-4"/>"#;
    assert_eq!(refused(&tiny.replace("INNER", inner), &[Program::Mujoco]), []);
    // Computed from a geom of 1.7e-9 kg and 1.1e-17 kg·m².
    let small =
        "<mujoco><worldbody><body name=\"a\"><joint/><geom size=\"7.4e-5\"/></body></worldbody></mujoco>";
    assert_eq!(refused(small, &[])[0].2, told);
    let large = small.replace("7.4e-5", "7.4e-3");
    assert_eq!(refused(&large, &[Program::Mujoco]), []);
}

#[test]
fn a_body_of_usd_without_mass_and_colliders_is_refused() {
    let body = |mass: &str, shape: &str| {
        format!(
            "#usda 1.0\n(\n metersPerUnit = 1\n)\ndef Xform \"base\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\"])\n{{\n \
             bool physics:rigidBodyEnabled = 0\n}}\ndef Xform \"arm\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"])\n\
             {{\n {mass}\n {shape}\n}}\ndef PhysicsRevoluteJoint \"j\"\n{{\n rel physics:body0 = </base>\n rel physics:body1 = </arm>\n}}\n"
        )
    };
    let cube = "def Cube \"c\" (prepend apiSchemas = [\"PhysicsCollisionAPI\"]) { double size = 0.2 }";
    for mass in ["", "float physics:mass = 0"] {
        let found = refused(&body(mass, ""), &[Program::Isaac]);
        let told = "moves without mass: Isaac Sim assumes the inertia of a small sphere";
        assert_eq!(found, [(Severity::Impossible, "/arm".to_owned(), told.to_owned())], "{mass}");
        assert_eq!(refused(&body(mass, cube), &[Program::Isaac]), []);
    }
    assert_eq!(refused(&body("float physics:mass = 1.5", ""), &[Program::Isaac]), []);
}
