//! `<flexcomp>`: what can be bent, as particles: a body at each of its points that is not pinned, with an equal share of the mass.
//!
//! A particle slides along the axes of the body that it hangs in, and has the moments of a box: ⅔ m b², where b is `inertiabox`.
//!
//! Source: MuJoCo 3.12, `mjCFlexcomp`; what versions 3.17 and 4.0 make of the same files.

mod gmsh;
mod mesh;
mod pin;
mod points;

use polhode_formats::ContentError;

use crate::model::{ComputedMass, Coordinate, JointKind, Link, Name, Pose};
use crate::pose::direction;
use crate::read::xml::{Element, is_true};

use super::defaults::Source;
use super::mass::{BodyMass, LEAST};
use super::{Branch, Reader, made_up};
use points::Form;

/// What this reads, or what has no part in masses.
const ATTRIBUTES: &[&str] = &[
    "axisangle",
    "cellcount",
    "count",
    "dim",
    "dof",
    "element",
    "euler",
    "file",
    "flatskin",
    "group",
    "inertiabox",
    "mass",
    "material",
    "mesh",
    "name",
    "origin",
    "point",
    "pos",
    "quat",
    "radius",
    "rgba",
    "rigid",
    "scale",
    "spacing",
    "texcoord",
    "type",
    "xyaxes",
    "zaxis",
];
const CHILDREN: &[&str] = &["edge", "elasticity", "contact", "pin", "plugin"];

/// About as many bytes say a point, in a file or an attribute. Copies read theirs again, and what that takes counts as elements do.
const TEXT_OF_A_POINT: usize = 50;

/// Points, and elements between them of dim + 1 points each.
#[derive(Debug, Default)]
struct Lattice {
    dim: usize,
    points: Vec<[f64; 3]>,
    /// `None` where the elements have all points.
    elements: Option<Vec<usize>>,
}

/// Particles of equal mass.
struct Particles {
    name: Name,
    /// Where they are in the frame of the element; those that are pinned are not there.
    places: Vec<(usize, [f64; 3])>,
    mass: f64,
    moment: f64,
    freedom: Freedom,
}

/// How particles move.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Freedom {
    /// Along so many axes.
    Axes(usize),
    /// Away from the origin of the body that they hang in.
    Radial,
}

impl<'a> Reader<'_, 'a, '_> {
    /// The particles of an element, as links.
    pub(super) fn flexcomp(&mut self, branch: &Branch<'a>) -> Result<(), ContentError> {
        match self.particles(branch)? {
            Ok(Some(particles)) => self.add_particles(branch, &particles),
            Ok(None) => Ok(()),
            Err(why) => {
                self.not_made(branch, &why);
                Ok(())
            }
        }
    }

    /// Notes that the bodies of an element are missing.
    pub(super) fn not_made(&mut self, branch: &Branch<'a>, why: &str) {
        let what = branch.element.name();
        self.incomplete = Some(format!("<{what}> is not read"));
        let subject = self.name_of(branch.link).to_owned();
        let message = format!("<{what}> is not read, and what it makes is not checked: {why}");
        self.note("read.left_out", &subject, branch.element.span(), message);
    }

    /// What moves of an element, if anything does, or in words why that is not known.
    fn particles(&mut self, branch: &Branch<'a>) -> Result<Result<Option<Particles>, String>, ContentError> {
        let flex = match Flex::of(branch) {
            Ok(flex) => flex,
            Err(why) => return Ok(Err(why)),
        };
        // as many points as a hundred bytes can ask for
        self.elements = self.elements.saturating_add(flex.form.number(flex.dim, flex.count));
        self.require_few(branch.element)?;
        let moving = self.moving(branch, &flex);
        self.require_few(branch.element)?;
        Ok(moving)
    }

    fn moving(&mut self, branch: &Branch<'a>, flex: &Flex<'a>) -> Result<Option<Particles>, String> {
        let mut lattice = self.lattice(branch, flex)?;
        let mut pinned = pin::pinned(flex, lattice.dim, lattice.points.len())?;
        lattice.keep_used(&mut pinned)?;
        if flex.is_rigid || pinned.iter().all(|pinned| *pinned) {
            return Ok(None);
        }
        let length =
            flex.element.attribute("quat").and_then(|quat| quat.array()).map(|quat: [f64; 4]| norm(quat));
        if length.is_some_and(|length| (length - 1.0).abs() > 1e-6) {
            return Err("its quat is not of length 1, and MuJoCo stretches it by that".to_owned());
        }
        let pose = self.pose(flex.element, &Source::of(flex.element), branch.context);
        if !pose.unreadable.is_empty() || !branch.frame.unreadable.is_empty() {
            return Err("its frame has a number that is none".to_owned());
        }
        let frame = branch.frame.then(&pose);
        let mass = flex.mass / lattice.points.len() as f64;
        let places: Vec<_> = lattice.points.iter().map(|point| frame.placed(*point)).enumerate().collect();
        if !places.iter().flat_map(|(_, place)| place).all(|c| c.is_finite()) {
            return Err("it has points that are no numbers".to_owned());
        }
        let places = places.into_iter().zip(&pinned).filter(|(_, pinned)| !**pinned).map(|(place, _)| place);
        Ok(Some(Particles {
            name: flex.name.clone(),
            places: places.collect(),
            mass,
            moment: mass * (2.0 * flex.inertia_box * flex.inertia_box) / 3.0,
            freedom: flex.freedom,
        }))
    }

    fn lattice(&mut self, branch: &Branch<'a>, flex: &Flex<'a>) -> Result<Lattice, String> {
        let element = flex.element;
        let mut lattice = match flex.form {
            Form::Direct => {
                let texts = ["point", "element"].map(|name| element.word(name).map_or(0, str::len));
                self.elements += (texts[0] + texts[1]) / TEXT_OF_A_POINT;
                Lattice { dim: flex.dim, ..Lattice::direct(element)? }
            }
            Form::Mesh => self.of_mesh(branch, flex)?,
            Form::Gmsh => {
                let path = self.flex_file(branch)?;
                gmsh::read(&std::fs::read(&path).map_err(|error| error.to_string())?)?
            }
            _ => return points::made(flex),
        };
        for point in &mut lattice.points {
            *point = [0, 1, 2].map(|k| flex.scale[k] * point[k]);
        }
        Ok(lattice)
    }

    fn add_particles(&mut self, branch: &Branch<'a>, particles: &Particles) -> Result<(), ContentError> {
        let Particles { name, places, mass, moment, freedom } = particles;
        let element = branch.element;
        let parent = self.pose_of(branch.link);
        let axes = match freedom {
            Freedom::Axes(count) => *count,
            Freedom::Radial => 1,
        };
        for (number, place) in places {
            self.elements += 1;
            let own =
                Name { text: format!("{}_{number}", name.text), span: made_up(String::new(), element).span };
            let name = branch.name(own);
            self.name_bytes += name.text.len();
            let in_parent = Pose::new(*place, Pose::IDENTITY.rotation);
            let link = Link {
                name,
                span: element.span(),
                inertial: None,
                geometry: Vec::new(),
                pose: parent.then(&in_parent),
                is_static: false,
                from_geometry: true,
                computed: None,
            };
            let tensor = [*moment, *moment, *moment, 0.0, 0.0, 0.0];
            let part = ComputedMass { mass: *mass, center: [0.0; 3], tensor };
            let body = BodyMass {
                context: branch.context,
                from_geoms: true,
                parts: vec![part],
                position: *place,
                ..Default::default()
            };
            let index = self.take_up(link, branch.link, in_parent, body);
            for axis in 0..axes {
                self.elements += 1;
                let name = made_up(format!("joint {}", self.model.joints.len() + 1), element);
                let axis = match freedom {
                    Freedom::Axes(_) => [0, 1, 2].map(|k| if k == axis { 1.0 } else { 0.0 }),
                    Freedom::Radial => direction(*place).unwrap_or([1.0, 0.0, 0.0]),
                };
                let coordinate = Coordinate::default();
                self.add_joint(index, branch, name, JointKind::Prismatic, (axis, [0.0; 3]), coordinate);
            }
            self.require_few(element)?;
        }
        Ok(())
    }
}

/// What an element says.
struct Flex<'a> {
    element: Element<'a>,
    name: Name,
    form: Form,
    dim: usize,
    count: [usize; 3],
    spacing: [f64; 3],
    scale: [f64; 3],
    mass: f64,
    inertia_box: f64,
    is_rigid: bool,
    freedom: Freedom,
}

impl<'a> Flex<'a> {
    fn of(branch: &Branch<'a>) -> Result<Self, String> {
        let element = branch.element;
        if !branch.is_named {
            return Err("the body that it stands in has no name, and MuJoCo refuses the file".to_owned());
        }
        if let Some(name) = element.attribute_names().find(|name| !ATTRIBUTES.contains(name)) {
            return Err(format!("{name}=… is no attribute of it"));
        }
        if let Some(child) = element.children().find(|child| !CHILDREN.contains(&child.name())) {
            return Err(format!("<{}> in it is not known", child.name()));
        }
        let name = element.attribute("name").ok_or("it has no name, and MuJoCo refuses the file")?.name();
        let kind = element.word("type").unwrap_or("grid");
        let form = Form::of(kind).ok_or_else(|| format!("{kind:?} is no type of it"))?;
        let count = whole("count", exactly(element, "count", [10.0; 3])?)?;
        let [dim] = whole("dim", exactly(element, "dim", [2.0])?)?;
        let dim = if matches!(form, Form::Square | Form::Disc) { 2 } else { dim };
        let freedom = match element.word("dof").unwrap_or("full") {
            "full" => Freedom::Axes(3),
            "2d" => Freedom::Axes(2),
            "radial" => Freedom::Radial,
            dof @ ("trilinear" | "quadratic") => {
                return Err(format!("how mass is shared by dof={dof:?} depends on the version of MuJoCo"));
            }
            dof => return Err(format!("dof={dof:?} is not known")),
        };
        let [mass] = exactly(element, "mass", [1.0])?;
        let [inertia_box] = exactly(element, "inertiabox", [0.005])?;
        let [radius] = exactly(element, "radius", [0.005])?;
        let [margin] =
            element.child("contact").map_or(Ok([0.0]), |contact| exactly(contact, "margin", [0.0]))?;
        let flex = Self {
            element,
            name,
            form,
            dim,
            count,
            spacing: exactly(element, "spacing", [0.02; 3])?,
            scale: exactly(element, "scale", [1.0; 3])?,
            mass,
            inertia_box,
            is_rigid: element.word("rigid").is_some_and(is_true),
            freedom,
        };
        let refused = |what: &str| Err(format!("{what}, and MuJoCo refuses the file"));
        let is_generated = !matches!(form, Form::Direct | Form::Mesh | Form::Gmsh);
        if !(1..=3).contains(&dim) {
            refused("dim is not 1, 2 or 3")
        } else if count.contains(&0) || freedom == Freedom::Radial && dim == 3 && count.contains(&1) {
            refused("count is too small")
        } else if is_generated && !flex.spacing.iter().all(|spacing| *spacing >= 2.0 * radius + margin) {
            refused("spacing is less than the size of its points")
        } else if !flex.scale.iter().all(|scale| *scale >= LEAST) {
            refused("scale is not positive")
        } else if !(mass >= LEAST && inertia_box >= LEAST) {
            refused("mass or inertiabox is not positive")
        } else {
            Ok(flex)
        }
    }
}

impl Lattice {
    /// What `point` and `element` say.
    fn direct(element: Element<'_>) -> Result<Self, String> {
        let points: Vec<f64> = element.attribute("point").map_or_else(Vec::new, |all| all.values().collect());
        let (points, rest) = points.as_chunks();
        if !rest.is_empty() {
            return Err("point has not three numbers for each, and MuJoCo refuses the file".to_owned());
        }
        Ok(Self { dim: 0, points: points.to_vec(), elements: Some(integers(element, "element")?) })
    }

    /// Leaves out the points that no element has.
    fn keep_used(&mut self, pinned: &mut Vec<bool>) -> Result<(), String> {
        let Some(elements) = &self.elements else { return Ok(()) };
        if self.points.is_empty() || elements.is_empty() {
            return Err("it has no points or no elements, and MuJoCo refuses the file".to_owned());
        }
        if !elements.len().is_multiple_of(self.dim + 1) {
            return Err("element has not dim + 1 numbers for each, and MuJoCo refuses the file".to_owned());
        }
        let mut used = vec![false; self.points.len()];
        for &point in elements {
            *used.get_mut(point).ok_or("an element of it has a point that is not there")? = true;
        }
        let mut is_used = used.iter().copied();
        self.points.retain(|_| is_used.next().unwrap_or(true));
        let mut is_used = used.iter().copied();
        pinned.retain(|_| is_used.next().unwrap_or(true));
        Ok(())
    }
}

fn norm(quat: [f64; 4]) -> f64 {
    quat.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// The numbers of an attribute, neither fewer nor more.
pub(super) fn exactly<const N: usize>(
    element: Element<'_>,
    name: &str,
    default: [f64; N],
) -> Result<[f64; N], String> {
    let Some(written) = element.attribute(name) else { return Ok(default) };
    let numbers = written.array().filter(|numbers| numbers.iter().all(|number: &f64| number.is_finite()));
    numbers.ok_or_else(|| format!("{name}={:?} does not have {N} numbers", written.value))
}

/// Numbers that count.
pub(super) fn whole<const N: usize>(name: &str, numbers: [f64; N]) -> Result<[usize; N], String> {
    let is_whole = |number: &f64| (0.0..1e9).contains(number) && number.trunc() == *number;
    match numbers.iter().all(is_whole) {
        true => Ok(numbers.map(|number| number as usize)),
        false => Err(format!("{name} is not whole")),
    }
}

/// The indices that an attribute says.
fn integers(element: Element<'_>, name: &str) -> Result<Vec<usize>, String> {
    let Some(written) = element.attribute(name) else { return Ok(Vec::new()) };
    let all: Option<Vec<usize>> =
        written.value.split_ascii_whitespace().map(|word| word.parse().ok()).collect();
    all.ok_or_else(|| format!("{name} has what is no index"))
}
