//! Texts of models: where an inertial is written, and where it cannot be.

use polhode_document::Report as _;
use polhode_robot::inertials::write_inertials;
use polhode_source::files::Memory;

use super::{of, request, why_not, written};

const CUBE: &str = "<visual><geometry><box size=\"0.1 0.1 0.1\"/></geometry></visual>";

#[test]
fn an_element_is_written_in_the_form_of_the_file() {
    let new = |text: &str| written("r.urdf", text, &["*=1000 kg/m^3"]).text().to_owned();
    let inertial = "<inertial><origin xyz=\"0 0 0\" rpy=\"0 0 0\"/><mass value=\"1\"/><inertia ixx=\"0.00166666666666667\" ixy=\"0\" ixz=\"0\" iyy=\"0.00166666666666667\" iyz=\"0\" izz=\"0.00166666666666667\"/></inertial>";
    // On one line.
    let line = format!("<robot><link name='a>b'>{CUBE}</link></robot>");
    assert_eq!(new(&line), line.replace("'a>b'>", &format!("'a>b'>{inertial}")));
    // With tabs, CRLF and a byte order mark; a comment and other bytes stay.
    let tabs = format!(
        "\u{feff}<robot>\r\n\t<link name=\"a\">\r\n\t\t<!-- ½ -->\r\n\t\t{CUBE}\r\n\t</link>\r\n</robot>"
    );
    let lines = inertial.replace("><", ">\r\n\t\t\t<").replace("\t\t\t</inertial>", "\t\t</inertial>");
    assert_eq!(new(&tabs), tabs.replace("\"a\">", &format!("\"a\">\r\n\t\t{lines}")));
    // With classic line ends.
    let classic = format!("<robot>\r <link name=\"a\">\r  {CUBE}\r </link>\r</robot>");
    let lines = inertial.replace("><", ">\r   <").replace("   </inertial>", "  </inertial>");
    assert_eq!(new(&classic), classic.replace("\"a\">", &format!("\"a\">\r  {lines}")));
    // An old inertial is replaced at its place, with its comment and its attitude.
    let old = format!(
        "<robot>\n <link name=\"a\">\n  {CUBE}\n  <inertial> <!-- ? --><origin rpy=\"1 2 3\"/><mass value=\"7\"/></inertial>\n </link>\n</robot>\n"
    );
    let start = old.find("<inertial>").unwrap();
    let end = old.find("</inertial>").unwrap() + "</inertial>".len();
    assert_eq!(new(&old), format!("{}{inertial}{}", &old[..start], &old[end..]));
}

#[test]
fn computed_masses_of_sdf_and_mjcf_are_kept() {
    let sdf = "<sdf version=\"1.11\"><model name=\"m\"><link name=\"a\"><inertial auto=\"true\"><mass>3</mass></inertial>\
               <collision name=\"c\"><geometry><box><size>0.1 0.2 0.3</size></box></geometry></collision></link></model></sdf>";
    let inertials = written("m.sdf", sdf, &[]);
    assert_eq!(of(&inertials, "a").properties.mass(), 3.0);
    assert!(
        !inertials.text().contains("auto") && inertials.text().contains("<mass>3</mass>"),
        "{}",
        inertials.text()
    );
    let mjcf = "<mujoco><worldbody><body name=\"a\"><freejoint/><geom type=\"box\" size=\"0.1 0.2 0.3\" mass=\"4.5\"/></body></worldbody></mujoco>";
    let inertials = written("m.xml", mjcf, &[]);
    assert_eq!((of(&inertials, "a").properties.mass(), of(&inertials, "a").mass_by.as_str()), (4.5, "kept"));
    assert!(
        inertials
            .text()
            .contains("<inertial pos=\"0 0 0\" mass=\"4.5\" fullinertia=\"0.195 0.15 0.075 0 0 0\"/>"),
        "{}",
        inertials.text()
    );
}

#[test]
fn attributes_of_prims_are_replaced_and_added() {
    let usda = |own: &str, schemas: &str| {
        format!(
            "#usda 1.0\n(\n    metersPerUnit = 1\n)\ndef Xform \"a\" {schemas}\n{{\n{own}    def Cube \"c\"\n    {{\n        double size = 0.2\n    }}\n}}\n"
        )
    };
    let stated = "    float physics:mass = 2.5\n    float3 physics:diagonalInertia = (1, 2, 2.5)\n";
    let rigid = "(\n    prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]\n)";
    let inertials = written("a.usda", &usda(stated, rigid), &[]);
    let added =
        "\n    point3f physics:centerOfMass = (0, 0, 0)\n    quatf physics:principalAxes = (1, 0, 0, 0)";
    let new = usda(stated, rigid)
        .replace("(1, 2, 2.5)", "(0.016666667, 0.016666667, 0.016666667)")
        .replace("\n{\n    float", &format!("\n{{{added}\n    float"));
    let new = new.replace("\"PhysicsRigidBodyAPI\"]", "\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]");
    assert_eq!(inertials.text(), new);
    // A schema in metadata without a list, and a prim without metadata.
    for schemas in ["(\n    kind = \"component\"\n)", ""] {
        let inertials = written("a.usda", &usda(stated, schemas), &["/a=500 kg/m^3"]);
        assert!((of(&inertials, "/a").properties.mass() - 4.0).abs() < 1e-14);
        assert!(
            inertials.text().contains("(\n    prepend apiSchemas = [\"PhysicsMassAPI\"]\n"),
            "{}",
            inertials.text()
        );
    }
    let declared = "    float physics:mass.timeSamples = { 0: 1, 1: 2 }\n";
    let inertials = written("a.usda", &usda(declared, rigid), &["/a=500 kg/m^3"]);
    assert_eq!(why_not(&inertials, "/a"), "it has physics:mass without a single value");
    let plane = usda("", rigid).replace("Cube", "Plane");
    assert!(why_not(&written("a.usda", &plane, &["/a=500 kg/m^3"]), "/a").contains("plane has no volume"));
}

#[test]
fn what_cannot_be_written_is_listed() {
    let body = "<body name=\"a\"><freejoint/><geom type=\"box\" size=\"0.1 0.2 0.3\"/></body>";
    // In an included file.
    let files = Memory::from([
        ("m.xml", "<mujoco><include file=\"b.xml\"/></mujoco>".to_owned()),
        ("b.xml", format!("<mujoco><worldbody>{body}</worldbody></mujoco>")),
    ]);
    let inertials = write_inertials(&request("m.xml", &[]), &files).unwrap();
    assert_eq!(why_not(&inertials, "a"), "it is in an included file; write that file");
    let mjcf = |inner: &str, settings: &str| {
        format!("<mujoco><compiler {settings}/><worldbody>{inner}</worldbody></mujoco>")
    };
    let copies = mjcf(&format!("<replicate count=\"3\" offset=\"1 0 0\">{body}</replicate>"), "");
    let inertials = written("m.xml", &copies, &[]);
    assert!(
        inertials
            .links
            .iter()
            .all(|link| why_not(&inertials, &link.link).contains("makes 3 links of its element"))
    );
    assert!(inertials.has_failed());
    // Settings that replace the inertial, and a frame that moves it.
    let inertials = written("m.xml", &mjcf(body, "inertiafromgeom=\"true\""), &["a=500 kg/m^3"]);
    assert!(why_not(&inertials, "a").contains("programs read other numbers"), "{}", inertials.to_text(None));
    let framed = body.replace(
        "<freejoint/>",
        "<freejoint/><frame pos=\"1 0 0\"><inertial pos=\"0 0 0\" mass=\"2\" diaginertia=\"1 1 1\"/></frame>",
    );
    let inertials = written("m.xml", &mjcf(&framed, ""), &[]);
    assert_eq!(why_not(&inertials, "a"), "its inertial is in a <frame>, which places it");
    // A kept mass that the geometry contradicts.
    let heavy = format!(
        "<robot><link name=\"a\"><inertial><mass value=\"900\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>{CUBE}</link></robot>"
    );
    let inertials = written("r.urdf", &heavy, &[]);
    assert!(
        why_not(&inertials, "a").starts_with("its new inertial has a finding, density.implausible: "),
        "{}",
        inertials.to_text(None)
    );
    assert_eq!(inertials.text(), heavy);
    let osim = "<OpenSimDocument Version=\"40000\"><Model name=\"m\"/></OpenSimDocument>";
    let failure = write_inertials(&request("m.osim", &[]), &Memory::from([("m.osim", osim)])).unwrap_err();
    assert!(failure.message().contains("OpenSim"), "{failure}");
}
