//! `<composite type="cable">`: a chain of bodies, one for each edge between vertices. MuJoCo before version 4 makes it, and has made no
//! other type since version 3.
//!
//! The first body stands at the first vertex, each other at the end of the one before, with x along its edge; the frame turns from edge to
//! edge no more than it must.
//!
//! Source: MuJoCo 3.12, `mjCComposite::MakeCable`, `mjuu_updateFrame`; what version 3.17 makes.

use std::f64::consts::PI;

use polhode_formats::ContentError;

use crate::model::{ComputedMass, Coordinate, Geometry, GeometryShape, JointKind, Link, Name, Pose, Role};
use crate::moments::{rotated, scaled};
use crate::pose::{about, about_axis, cross, direction, dot, of_x_and_y, unit};
use crate::read::xml::Element;

use super::flexcomp::{exactly, whole};
use super::geom::WATER;
use super::mass::{BodyMass, LEAST};
use super::{Branch, Reader, made_up, measure};

/// What this reads, or what has no part in masses.
const ATTRIBUTES: &[&str] =
    &["count", "curve", "initial", "offset", "prefix", "quat", "size", "type", "vertex"];

/// A cable that can be made.
struct Cable<'a> {
    prefix: &'a str,
    offset: [f64; 3],
    vertices: Vec<[f64; 3]>,
    first_joint: Option<JointKind>,
    segment: Segment<'a>,
}

/// The geom of each body.
struct Segment<'a> {
    kind: &'a str,
    size: [f64; 3],
    mass: Option<f64>,
    density: f64,
}

impl<'a> Reader<'_, 'a, '_> {
    /// The bodies of a cable, as links.
    pub(super) fn composite(&mut self, branch: &Branch<'a>) -> Result<(), ContentError> {
        let element = branch.element;
        // as many vertices as a hundred bytes can ask for
        let count = exactly(element, "count", [1.0; 3]).and_then(|count| whole("count", count));
        self.elements = self.elements.saturating_add(count.as_ref().map_or(0, |[count, ..]| *count));
        self.require_few(element)?;
        match count.and_then(|[count, ..]| Cable::of(branch, count)) {
            Ok(cable) => {
                let subject = self.name_of(branch.link).to_owned();
                let message =
                    "<composite> is read as MuJoCo 3 reads it: version 4 refuses the file".to_owned();
                self.note("read.unknown", &subject, element.span(), message);
                self.add_cable(branch, &cable)
            }
            Err(why) => {
                self.not_made(branch, &why);
                Ok(())
            }
        }
    }

    fn add_cable(&mut self, branch: &Branch<'a>, cable: &Cable<'a>) -> Result<(), ContentError> {
        let element = branch.element;
        let (mut link, mut before) = (branch.link, Pose::IDENTITY);
        let last = cable.vertices.len() - 2;
        for (k, frame) in cable.frames().into_iter().enumerate() {
            self.elements += 2;
            let place = match k {
                0 => "first".to_owned(),
                _ if k == last => "last".to_owned(),
                _ => k.to_string(),
            };
            let named = |kind: &str| {
                let text = format!("{}{kind}_{place}", cable.prefix);
                branch.name(Name { text, span: made_up(String::new(), element).span })
            };
            let (name, joint) = (named("B"), named("J"));
            self.name_bytes += name.text.len() + joint.text.len();
            let in_parent = if k == 0 {
                let position = [0, 1, 2].map(|axis| cable.offset[axis] + frame.position[axis]);
                branch.frame.then(&Pose::new(position, frame.rotation))
            } else {
                before.inverse().then(&frame)
            };
            let length = cable.length(k);
            let body = BodyMass {
                context: branch.context,
                from_geoms: true,
                position: in_parent.position,
                ..match cable.segment.mass(length) {
                    Ok(part) => BodyMass { parts: part.into_iter().collect(), ..Default::default() },
                    Err(why) => BodyMass { unknown: Some(why), ..Default::default() },
                }
            };
            let made = Link {
                name,
                span: element.span(),
                inertial: None,
                geometry: vec![Geometry {
                    span: element.span(),
                    role: Role::Collision,
                    pose: along_x(length),
                    shape: cable.segment.shape(length),
                }],
                pose: self.pose_of(link).then(&in_parent),
                is_static: false,
                from_geometry: true,
                computed: None,
            };
            let index = self.take_up(made, link, in_parent, body);
            if let Some(kind) = if k == 0 { cable.first_joint } else { Some(JointKind::Other) } {
                let place = ([0.0, 0.0, 1.0], [0.0; 3]);
                self.add_joint(index, branch, joint, kind, place, Coordinate::default());
            }
            (link, before) = (Some(index), frame);
            self.require_few(element)?;
        }
        Ok(())
    }
}

impl<'a> Cable<'a> {
    fn of(branch: &Branch<'a>, count: usize) -> Result<Self, String> {
        let element = branch.element;
        if element.word("type") != Some("cable") {
            return Err("MuJoCo makes cables alone".to_owned());
        }
        if let Some(name) = element.attribute_names().find(|name| !ATTRIBUTES.contains(name)) {
            return Err(format!("{name}=… is no attribute of it"));
        }
        if !branch.suffix.is_empty() || !branch.frame.unreadable.is_empty() {
            return Err("it is copied, and MuJoCo refuses the file".to_owned());
        }
        let vertices = match element.attribute("vertex") {
            Some(written) => {
                let numbers: Vec<f64> = written.values().collect();
                let (vertices, rest) = numbers.as_chunks();
                if !rest.is_empty() || count > 1 {
                    return Err("vertex has not three numbers for each, or there is a count, too".to_owned());
                }
                vertices.to_vec()
            }
            None => curve(element, count)?,
        };
        let vertices: Vec<_> = vertices.into_iter().map(|v| v.map(|c| f64::from(c as f32))).collect();
        if vertices.len() < 4 {
            return Err("it has fewer than three edges, and MuJoCo refuses the file".to_owned());
        }
        let cable = Self {
            prefix: element.word("prefix").unwrap_or(""),
            offset: exactly(element, "offset", [0.0; 3])?,
            vertices,
            first_joint: match element.word("initial").unwrap_or("ball") {
                "free" => Some(JointKind::Free),
                "none" => None,
                _ => Some(JointKind::Other),
            },
            segment: Segment::of(element.child("geom").ok_or("it has no geom")?)?,
        };
        let has_length = |k: usize| cable.length(k).is_finite() && cable.length(k) > 0.0;
        match (0..cable.vertices.len() - 1).all(has_length) {
            true => Ok(cable),
            false => Err("two of its vertices are at one place, or are none".to_owned()),
        }
    }

    fn edge(&self, k: usize) -> [f64; 3] {
        let [a, b] = [k, k + 1].map(|k| self.vertices.get(k).copied().unwrap_or([f64::NAN; 3]));
        [0, 1, 2].map(|axis| b[axis] - a[axis])
    }

    fn length(&self, k: usize) -> f64 {
        let edge = self.edge(k);
        dot(edge, edge).sqrt()
    }

    /// The frame of each edge at its first vertex, in that of the cable.
    fn frames(&self) -> Vec<Pose> {
        let axis = |k: usize| direction(self.edge(k)).unwrap_or([1.0, 0.0, 0.0]);
        let normal_of = |v: [f64; 3]| direction(v).filter(|_| dot(v, v).sqrt() > 1e-14);
        let x = axis(0);
        // a cable that begins straight has no normal at all
        let mut normal = normal_of(cross(x, axis(1))).map(|binormal| cross(binormal, x));
        let mut frames = Vec::new();
        for (k, vertex) in self.vertices.iter().take(self.vertices.len() - 1).enumerate() {
            let x = axis(k);
            if k > 0
                && let Some(before) = normal
            {
                let (last, binormal) = (axis(k - 1), cross(axis(k - 1), x));
                let angle = libm::atan2(dot(binormal, binormal).sqrt(), dot(last, x));
                let turn = about_axis(binormal, angle).unwrap_or(Pose::IDENTITY.rotation);
                normal = direction(Pose::new([0.0; 3], turn).turned(before));
            }
            frames.push(Pose::new(*vertex, attitude(x, normal)));
        }
        frames
    }
}

/// The turn that takes x and y to two axes; without the second, the shortest that takes x to the first as far as MuJoCo has it.
fn attitude(x: [f64; 3], normal: Option<[f64; 3]>) -> [f64; 4] {
    let turn = match normal {
        Some(y) => of_x_and_y(x, y),
        None if x[0] > 0.0 => unit([1.0 + x[0], 0.0, -x[2], x[1]]),
        None => unit([x[1], x[2], 0.0, 1.0 - x[0]]),
    };
    turn.unwrap_or(Pose::IDENTITY.rotation)
}

/// Vertices on a curve: a line, cosines and sines along the axes, then turned.
fn curve(element: Element<'_>, count: usize) -> Result<Vec<[f64; 3]>, String> {
    let sizes: Vec<f64> = element.attribute("size").map_or_else(Vec::new, |sizes| sizes.values().collect());
    let [length, radius, turns] =
        [(0, 1.0), (1, 0.0), (2, 0.0)].map(|(k, default)| sizes.get(k).copied().unwrap_or(default));
    let words: Vec<_> = element.word("curve").unwrap_or("").split_ascii_whitespace().collect();
    if words.len() > 3 || words.iter().any(|word| !["s", "cos(s)", "sin(s)", "0"].contains(word)) {
        return Err(format!("curve={:?} is not read", element.word("curve").unwrap_or("")));
    }
    let quat = unit(exactly(element, "quat", [1.0, 0.0, 0.0, 0.0])?).ok_or("its quat is no rotation")?;
    let turn = Pose::new([0.0; 3], quat);
    let last = count.saturating_sub(1) as f64;
    let place = |k: usize| {
        let angle = PI * k as f64 * turns / last;
        turn.placed([0, 1, 2].map(|axis| match words.get(axis).copied() {
            Some("s") => k as f64 * length / last,
            Some("cos(s)") => radius * libm::cos(angle),
            Some("sin(s)") => radius * libm::sin(angle),
            _ => 0.0,
        }))
    };
    Ok((0..count).map(place).collect())
}

impl<'a> Segment<'a> {
    fn of(geom: Element<'a>) -> Result<Self, String> {
        let kind = geom.word("type").unwrap_or("sphere");
        if !["cylinder", "capsule", "box"].contains(&kind) {
            return Err(format!("its geom is a {kind}, and MuJoCo refuses the file"));
        }
        let sizes: Vec<f64> = geom.attribute("size").map_or_else(Vec::new, |sizes| sizes.values().collect());
        let one = |name: &str| geom.attribute(name).map(|_| exactly(geom, name, [0.0])).transpose();
        Ok(Self {
            kind,
            size: [0, 1, 2].map(|k| sizes.get(k).copied().unwrap_or(0.0)),
            mass: one("mass")?.map(|[mass]| mass),
            density: one("density")?.map_or(WATER, |[density]| density),
        })
    }

    /// MuJoCo's sizes along z, of an edge of that length.
    fn sizes(&self, length: f64) -> [f64; 3] {
        let [radius, y, z] = self.size;
        match self.kind {
            // the frame of a box is the body's; here its z is along the edge, so its x is against the body's z
            "box" => [z, y, 0.5 * length],
            _ => [radius, 0.5 * length, 0.0],
        }
    }

    fn shape(&self, length: f64) -> GeometryShape {
        let size = self.sizes(length);
        match self.kind {
            "box" => GeometryShape::Box(size.map(|half| 2.0 * half)),
            "capsule" => GeometryShape::Capsule { radius: size[0], length },
            _ => GeometryShape::Cylinder { radius: size[0], length },
        }
    }

    fn mass(&self, length: f64) -> Result<Option<ComputedMass>, String> {
        let size = self.sizes(length);
        let measure = measure::of(self.kind, size, false).filter(|measure| measure.amount > 0.0);
        let measure = measure.ok_or("the size of its geom is no positive number")?;
        let mass = self.mass.unwrap_or(self.density * measure.amount);
        if !(mass >= 0.0 && mass.is_finite()) {
            return Err("the mass or density of its geom is no positive number".to_owned());
        }
        let [xx, yy, zz] = measure.moments;
        let frame = along_x(length);
        let tensor = rotated(&scaled(&[xx, yy, zz, 0.0, 0.0, 0.0], mass), &frame.matrix());
        Ok((mass > LEAST).then_some(ComputedMass { mass, center: frame.position, tensor }))
    }
}

/// The frame in the middle of an edge, its z along the edge: a quarter of a turn about y.
fn along_x(length: f64) -> Pose {
    Pose::new([0.5 * length, 0.0, 0.0], about(1, 0.5 * PI))
}
