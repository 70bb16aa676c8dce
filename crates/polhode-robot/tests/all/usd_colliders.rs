//! Masses that a USD body does not state: computed from its colliders, or the reason why not.
//! `usd_stages` compares them with OpenUSD.

use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::finding::Severity;
use polhode_robot::model::RobotModel;

use crate::common::{assert_close, read};

/// Returns a layer with a body in centimetres and grams: its own lines, and those in it.
fn robot(own: &str, inner: &str) -> RobotModel {
    read(&format!(
        "#usda 1.0\n(\n    metersPerUnit = 0.01\n    kilogramsPerUnit = 0.001\n)\ndef Material \"steel\" (apiSchemas = [\"PhysicsMaterialAPI\"])\n\
         {{\n    float physics:density = 7.5\n}}\ndef Xform \"arm\" (apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"])\n\
         {{\n{own}\n{inner}\n}}\n"
    ))
}

/// Returns a collider of 4 × 4 × 4 cm at (3, -5, 2) cm with more lines and schemas.
fn cube(lines: &str, schema: &str) -> String {
    format!(
        "def Cube \"c\" (apiSchemas = [\"PhysicsCollisionAPI\"{schema}])\n{{\n    double size = 4\n    \
         double3 xformOp:translate = (3, -5, 2)\n    uniform token[] xformOpOrder = [\"xformOp:translate\"]\n{lines}\n}}"
    )
}

/// Returns mass and centre of the body, or the reason why it has none.
fn mass(model: &RobotModel) -> Result<(f64, [f64; 3]), String> {
    assert_eq!(model.links.len(), 1, "a material is not a body");
    match link_mass(model.format, &model.links[0]) {
        Ok(LinkMass::Body(body)) => Ok((body.properties.mass(), body.properties.center_of_mass().to_array())),
        other => Err(format!("{other:?}")),
    }
}

#[test]
fn a_density_is_the_nearest_stated() {
    let material = "    rel material:binding:physics = </steel>";
    let mass_api = ", \"PhysicsMassAPI\"";
    for (own, lines, schema, density) in [
        ("", "", "", 1000.0),
        ("", material, "", 7500.0),
        (material, "", "", 7500.0),
        ("    rel material:binding = <../steel>", "", "", 7500.0),
        ("    float physics:density = 2.5", material, "", 2500.0),
        ("    float physics:density = 2.5", "    float physics:density = 0.5", mass_api, 500.0),
        ("    float physics:density = 0", "    float physics:density = 0", mass_api, 1000.0),
    ] {
        let (found, center) = mass(&robot(own, &cube(lines, schema))).unwrap();
        assert!((found / (density * 0.04_f64.powi(3)) - 1.0).abs() < 1e-14, "{own} {lines}: {found}");
        assert_close(center, [0.03, -0.05, 0.02], 1e-16);
    }
    let (found, _) = mass(&robot("", &cube("    float physics:mass = 350", mass_api))).unwrap();
    assert!((found - 0.35).abs() < 1e-15);
}

#[test]
fn a_computed_mass_is_noted() {
    let model = robot("    float physics:mass = 350", &cube("", ""));
    let note = model.notes.iter().find(|note| note.code == "inertia.computed").unwrap();
    assert_eq!((note.severity, note.subject.as_str()), (Severity::Note, "/arm"));
    assert!(
        note.message.starts_with("computed from 1 collider: 0.35 kg at (0.03, -0.05, 0.02) m"),
        "{}",
        note.message
    );
    let model = robot("", &cube("", ""));
    let note = model.notes.iter().find(|note| note.code == "inertia.computed").unwrap();
    assert!(note.message.contains("with the default density 1000 kg/m³: 0.064 kg"), "{}", note.message);
    // A stated centre moves the tensor: I' = I + m (d² 1 − d dᵀ).
    let own = "    float physics:mass = 350\n    point3f physics:centerOfMass = (3, -5, 5)";
    let model = robot(own, &cube("", ""));
    let moved = model.links[0].computed.clone().unwrap().unwrap();
    let own = 0.35 * 0.04_f64.powi(2) / 6.0;
    assert_close(
        [moved.tensor[0], moved.tensor[1], moved.tensor[2]],
        [own + 0.35 * 9e-4, own + 0.35 * 9e-4, own],
        1e-17,
    );
}

#[test]
fn what_cannot_be_computed_has_a_reason() {
    let mesh = "def Mesh \"m\" (apiSchemas = [\"PhysicsCollisionAPI\"])\n{\n}";
    for (own, inner, said) in [
        ("", mesh.to_owned(), "mesh"),
        ("", mesh.replace("Mesh", "Xform"), "the shape of /arm/m is not read"),
        ("", cube("    bool mjc:shellinertia = true", ""), "mjc:shellinertia of /arm/c is not read"),
        ("", cube("    double size.timeSamples = { 0: 1 }", "").replace("double size = 4", ""), ""),
        ("", cube("    rel material:binding:collection:all = </steel>", ""), "collection"),
        ("", cube("    rel material:binding = </iron>", ""), "its material /iron is not read"),
        ("", cube("    bool physics:collisionEnabled = 0", ""), "it is missing"),
        ("    float physics:density = nan", cube("", ""), "physics:density"),
        ("    float physics:density = -2", cube("", ""), "physics:density of /arm is negative"),
        ("    point3f physics:centerOfMass = (0, nan, 0)", cube("", ""), "physics:centerOfMass"),
        ("    float physics:mass = 2", cube("    float3 xformOp:scale = (1, nan, 2)", ""), ""),
    ] {
        let model = robot(own, &inner);
        if said.is_empty() {
            assert!(!model.notes.is_empty() || mass(&model).is_err(), "{inner}");
            continue;
        }
        let error = mass(&model).unwrap_err();
        assert!(error.contains(said), "{said}: {error}");
    }
}

#[test]
fn statements_that_engines_ignore_are_reported() {
    let suspect = |model: &RobotModel, said: &str| {
        let found = model.notes.iter().find(|note| note.message.contains(said));
        assert_eq!(found.map(|note| note.severity), Some(Severity::Suspect), "{said}: {:?}", model.notes);
    };
    let inner = "def Xform \"frame\" (apiSchemas = [\"PhysicsMassAPI\"])\n{\n    float physics:mass = 9\n}\n";
    let model = robot("    float physics:mass = 350", &(inner.to_owned() + &cube("", "")));
    suspect(&model, "UsdPhysics ignores physics:mass: the prim is neither a rigid body nor a collider");
    assert!((mass(&model).unwrap().0 - 0.35).abs() < 1e-15);
    let model = read(
        "#usda 1.0\n(metersPerUnit = 1)\ndef Xform \"a\" (apiSchemas = [\"PhysicsRigidBodyAPI\"])\n{\n    float physics:mass = 2\n}\n",
    );
    suspect(&model, "PhysicsMassAPI is not applied");
    let model =
        robot("    float mjc:compiler:setTotalMass = 12.5\n    bool mjc:compiler:balanceInertia = false", "");
    suspect(&model, "mjc:compiler:setTotalMass = 12.5 is not read");
    assert!(!model.notes.iter().any(|note| note.message.contains("balanceInertia")));
}
