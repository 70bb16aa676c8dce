//! OpenSim models: bodies with mass, centre and tensor, and joints between frames fixed to them.
//!
//! Lengths are in metres, masses in kilograms, angles in radians about rotating axes (x, y, z). The
//! tensor is about the centre of mass, along the body's axes, in the order xx yy zz xy xz yz. It is
//! written as six numbers, or until version 4.0 as six elements. `ground` is the world. Geometry
//! shows bones, which do not carry the mass, so it is not read.
//!
//! Source: simtk-confluence.stanford.edu, "OpenSim Models"; the properties of `Body`, `Joint` and
//! `PhysicalOffsetFrame`.

mod coordinate;
mod frame;
mod joint;
mod transform;

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use crate::model::{Inertial, Link, Name, Pose, RobotModel, Slot, Tensor};
use crate::read::pose::Reading;
use crate::read::unread;
use crate::read::xml::{Element, child_slot};
use frame::Frames;

/// Oldest supported version.
const FIRST_VERSION: u64 = 20302;
const GROUND: &str = "ground";

/// Fills the model from the root element.
pub(super) fn read(root: Element<'_>, model: &mut RobotModel) -> Result<(), ContentError> {
    let start = root.span().start;
    let place = || ContentPlace::Text(start..start + 1);
    let version = root.word("Version").and_then(|version| version.parse().ok()).unwrap_or(0);
    if version < FIRST_VERSION {
        let what = format!("OpenSim files before version {FIRST_VERSION}");
        let error = ContentError::new(ContentErrorKind::unsupported(what), place());
        return Err(
            error.hint("open the file in OpenSim and save it, which converts it to the current version")
        );
    }
    let Some(own) = root.child("Model") else {
        let what = "<Model>: this is another kind of OpenSim document";
        return Err(ContentError::new(ContentErrorKind::missing(what), place()));
    };
    model.name = own.word("name").map(str::to_owned);
    let frames = Frames::of(own);
    for body in set(own, "BodySet").chain(own.named("components").flat_map(|part| part.named("Body"))) {
        let name = body.attribute("name").map_or_else(
            || Name {
                text: format!("body {}", model.links.len() + 1),
                span: body.span().start..body.span().start + 1,
            },
            |name| name.name(),
        );
        if let Some(holder) = body.child("Joint").and_then(|joint| joint.children().next())
            && name.text != GROUND
        {
            model.joints.push(joint::old(holder, &name));
        }
        if name.text != GROUND {
            unread::osim(body, &name.text, &mut model.notes);
            model.links.push(link(body, name));
        }
    }
    for element in set(own, "JointSet") {
        let joint = joint::new(element, &frames, &mut model.notes);
        model.joints.extend(joint);
    }
    coordinate::couple(own, set(own, "ConstraintSet"), &mut model.joints);
    Ok(())
}

/// Returns the objects of a set.
fn set<'a>(model: Element<'a>, name: &'a str) -> impl Iterator<Item = Element<'a>> {
    model.named(name).flat_map(|set| set.named("objects")).flat_map(Element::children)
}

fn link(body: Element<'_>, name: Name) -> Link {
    let mut reading = Reading::default();
    let center = reading.numbers(body.child_text("mass_center").as_ref(), [0.0; 3]);
    let tensor = match body.child_text("inertia") {
        Some(six) => {
            let mut numbers = six.numbers();
            let names = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];
            Tensor::Six(Box::new(names.map(|name| match numbers.next() {
                Some(number) => Slot::Given(number),
                None => Slot::Missing { span: six.span.clone(), name: name.to_owned() },
            })))
        }
        None if body.child("inertia_xx").is_some() => Tensor::Six(Box::new(
            ["xx", "yy", "zz", "xy", "xz", "yz"]
                .map(|element| child_slot(body, &format!("inertia_{element}"))),
        )),
        None => Tensor::Missing(body.span()),
    };
    let pose = reading.pose(center, Pose::IDENTITY.rotation);
    let inertial = Inertial { span: body.span(), mass: child_slot(body, "mass"), pose, tensor };
    Link {
        name,
        span: body.span(),
        inertial: Some(inertial),
        geometry: Vec::new(),
        pose: Pose::IDENTITY,
        is_static: false,
        from_geometry: false,
        computed: None,
    }
}
