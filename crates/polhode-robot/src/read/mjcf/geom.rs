//! Geoms: frames, shapes and masses.

use crate::model::{ComputedMass, Geometry, GeometryShape, Pose, Role};
use crate::moments::{rotated, scaled};
use crate::pose::{direction, of_z_axis};
use crate::read::xml::{Element, Written, is_true};

use super::defaults::Source;
use super::mass::LEAST;
use super::measure;
use super::mesh::{Asset, Fitted, Solid};
use super::{Branch, Reader};

/// Default density of a geom, kg/m³.
const WATER: f64 = 1000.0;

/// Geom with its mass, if it counts.
pub(super) struct Geom {
    pub(super) geometry: Geometry,
    pub(super) mass: Result<Option<ComputedMass>, String>,
}

/// Type, sizes and frame of a geom.
struct Form<'a> {
    kind: &'a str,
    size: [f64; 3],
    mesh: Option<&'a str>,
    pose: Pose,
    /// Reason why a primitive cannot be fitted to its mesh.
    unfitted: Option<String>,
}

impl<'c, 'a> Reader<'c, 'a, '_> {
    /// Reads a geom of a branch; `weighs` is true if its mass is needed.
    pub(super) fn geom(&mut self, element: Element<'a>, branch: &Branch<'a>, weighs: bool) -> Option<Geom> {
        let contexts = self.contexts;
        let source = contexts.get(branch.context)?.classes.geom(element, branch.class);
        let zero = |name: &str| source.word(name).is_some_and(|word| word.parse() == Ok(0_i64));
        let role = if zero("contype") && zero("conaffinity") { Role::Visual } else { Role::Collision };
        let form = self.form(element, &source, branch);
        let mut frame = branch.frame.then(&form.pose);
        frame.unreadable.extend(branch.frame.unreadable.iter().cloned());
        let mass = if weighs { self.weight(&source, &form, &frame, branch.context) } else { Ok(None) };
        let (shape, inner) = self.shape(&form, branch.context);
        let pose = match inner {
            Some(inner) => branch.frame.then(&form.pose.then(&inner)),
            None => branch.frame.then(&form.pose),
        };
        let pose = Pose { unreadable: form.pose.unreadable, span: form.pose.span, ..pose };
        Some(Geom { geometry: Geometry { span: element.span(), role, pose, shape }, mass })
    }

    fn form(&mut self, element: Element<'a>, source: &Source<'c, 'a>, branch: &Branch<'a>) -> Form<'a> {
        let ends = source.written("fromto").map(|written| written.array().unwrap_or([f64::NAN; 6]));
        let place = source.written("pos").filter(|_| ends.is_some());
        let is_placed = |written: &Written<'_>| written.values().any(|value| value != 0.0);
        if let Some(written) = place.filter(is_placed) {
            let subject = self.name_of(branch.link).to_owned();
            let message = "a geom has both pos and fromto: MuJoCo refuses the file".to_owned();
            if let Some(body) = branch.link.and_then(|link| self.masses.get_mut(link)) {
                body.unknown.get_or_insert(message.clone());
            }
            self.suspect("read.unknown", &subject, written.span, message);
        }
        let mut form = Form {
            kind: source.word("type").unwrap_or("sphere"),
            size: [f64::NAN; 3],
            mesh: source.word("mesh"),
            pose: match ends {
                Some(ends) => along(ends),
                None => self.pose(element, source, branch.context),
            },
            unfitted: None,
        };
        let sizes = source.values("size");
        let size = |k: usize| sizes.get(k).copied().unwrap_or(f64::NAN);
        form.size = [0, 1, 2].map(size);
        if let Some([ax, ay, az, bx, by, bz]) = ends {
            // Half the distance between the ends; a box or ellipsoid has equal width and depth.
            let half = 0.5 * [bx - ax, by - ay, bz - az].iter().map(|c| c * c).sum::<f64>().sqrt();
            form.size = match form.kind {
                "box" | "ellipsoid" => [size(0), size(0), half],
                _ => [size(0), half, f64::NAN],
            };
        }
        if let Some(mesh) = form.mesh
            && matches!(form.kind, "box" | "sphere" | "cylinder" | "capsule" | "ellipsoid")
        {
            let by_bounds = self.contexts.get(branch.context).is_some_and(|one| one.settings.fit_bounds);
            match self.solid(mesh, branch.context).and_then(|solid| solid.fitted(form.kind, by_bounds)) {
                Ok(Fitted { size, pose }) => {
                    let factor = source.number("fitscale").unwrap_or(1.0);
                    let written = form.pose;
                    form.pose = written.then(&pose);
                    (form.pose.unreadable, form.pose.span) = (written.unreadable, written.span);
                    form.size = size.map(|c| factor * c);
                }
                Err(why) => form.unfitted = Some(why),
            }
        }
        form
    }

    /// Returns the shape, and its frame in the geom's if it has one of its own.
    fn shape(&self, form: &Form<'a>, context: usize) -> (GeometryShape, Option<Pose>) {
        let size = form.size;
        let shape = match (form.kind, form.mesh) {
            ("mesh", Some(name)) => {
                let asset = self.contexts.get(context).and_then(|context| context.meshes.get(name));
                return match asset {
                    Some(asset) => {
                        let (shape, inner) = asset.shape(name);
                        (shape, Some(inner).filter(|_| asset.is_written()))
                    }
                    None => (
                        GeometryShape::Other(format!("the mesh {name:?}, which does not exist in this file")),
                        None,
                    ),
                };
            }
            (kind, _) if form.unfitted.is_some() => {
                GeometryShape::Other(format!("a {kind} fitted to a mesh"))
            }
            ("box", _) => GeometryShape::Box(size.map(|half| 2.0 * half)),
            ("sphere", _) => GeometryShape::Sphere(size[0]),
            ("cylinder", _) => GeometryShape::Cylinder { radius: size[0], length: 2.0 * size[1] },
            ("capsule", _) => GeometryShape::Capsule { radius: size[0], length: 2.0 * size[1] },
            ("ellipsoid", _) => GeometryShape::Ellipsoid(size),
            (other, _) => GeometryShape::Other(other.to_owned()),
        };
        (shape, None)
    }

    /// Returns the mass of a geom with this frame in the link's frame; `None` if it has none.
    fn weight(
        &mut self,
        source: &Source<'c, 'a>,
        form: &Form<'a>,
        frame: &Pose,
        context: usize,
    ) -> Result<Option<ComputedMass>, String> {
        let contexts = self.contexts;
        let Some(of) = contexts.get(context) else { return Ok(None) };
        let [first, last] = of.settings.groups;
        let group = source.number("group").unwrap_or(0.0);
        let (given, density) = (source.number("mass"), source.number("density").unwrap_or(WATER));
        if group < first || group > last || given.map_or(density == 0.0, |mass| mass == 0.0) {
            return Ok(None);
        }
        if !given.unwrap_or(density).is_finite() {
            return Err("the mass or density of a geom is not a number".to_owned());
        }
        if !form.pose.unreadable.is_empty() || !frame.unreadable.is_empty() {
            return Err("the frame of a geom has an invalid number".to_owned());
        }
        let (amount, center, per_kilogram) = match form.kind {
            "plane" => return Ok(None),
            "mesh" | "sdf" => {
                let name = form.mesh.ok_or("a geom names no mesh")?;
                let solid = self.solid(name, context)?;
                (solid.amount, solid.center, solid.tensor)
            }
            kind => {
                if let Some(why) = &form.unfitted {
                    return Err(why.clone());
                }
                let size = match kind {
                    "hfield" => {
                        let name = source.word("hfield").unwrap_or("");
                        let size = of.height_fields.get(name).copied();
                        size.ok_or_else(|| format!("the height field {name:?} does not exist in this file"))?
                    }
                    _ => form.size,
                };
                let shell = source.word("shellinertia").is_some_and(is_true);
                let measure = measure::of(kind, size, shell);
                let measure = measure.ok_or_else(|| format!("a geom is a {kind}, which is not read"))?;
                let [xx, yy, zz] = measure.moments;
                (measure.amount, [0.0; 3], [xx, yy, zz, 0.0, 0.0, 0.0])
            }
        };
        let positive = per_kilogram.iter().all(|element| element.is_finite()) && amount >= 0.0;
        if !positive || !matches!(form.kind, "mesh" | "sdf") && form.size.iter().any(|c| *c < 0.0) {
            return Err("the size of a geom is not a positive number".to_owned());
        }
        let mass = match given {
            Some(mass) if amount > LEAST => mass,
            Some(_) => 0.0,
            None => density * amount,
        };
        if mass < 0.0 {
            return Err("the mass of a geom is negative".to_owned());
        }
        let tensor = rotated(&scaled(&per_kilogram, mass), &frame.matrix());
        Ok((mass > LEAST).then(|| ComputedMass { mass, center: frame.placed(center), tensor }))
    }

    /// Returns the volume and moments of a mesh; each mesh is read once.
    fn solid(&mut self, name: &str, context: usize) -> Result<std::rc::Rc<Solid>, String> {
        let key = (context, name.to_owned());
        if let Some(known) = self.solids.get(&key) {
            return known.clone();
        }
        let files = self.files;
        let solid = self.asset(name, context).and_then(|asset| asset.solid(files)).map(std::rc::Rc::new);
        self.solids.insert(key, solid.clone());
        solid
    }

    /// Returns a mesh asset of a model before it is read or generated.
    ///
    /// # Errors
    /// If the mesh does not exist, or if too many points would be generated.
    fn asset(&mut self, name: &str, context: usize) -> Result<&'c Asset, String> {
        /// Maximum number of generated points of all meshes. Without a limit, a file could request
        /// thousands for each of its bytes.
        const MOST_POINTS: usize = 5_000_000;
        let contexts = self.contexts;
        let asset = contexts.get(context).and_then(|context| context.meshes.get(name));
        let asset = asset.ok_or_else(|| format!("the mesh {name:?} does not exist in this file"))?;
        self.made_points += asset.made_points();
        if self.made_points > MOST_POINTS {
            return Err(format!("its mesh and other generated meshes have more than {MOST_POINTS} points"));
        }
        Ok(asset)
    }
}

/// Returns the frame in the middle between two points, with z from the second to the first.
fn along([ax, ay, az, bx, by, bz]: [f64; 6]) -> Pose {
    let middle = [0.5 * (ax + bx), 0.5 * (ay + by), 0.5 * (az + bz)];
    let axis = direction([ax - bx, ay - by, az - bz]).unwrap_or([0.0, 0.0, 1.0]);
    let finite = middle.iter().all(|c| c.is_finite());
    Pose::new(if finite { middle } else { [0.0; 3] }, of_z_axis(axis).unwrap_or(Pose::IDENTITY.rotation))
}
