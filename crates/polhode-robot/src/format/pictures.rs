//! Pictures of a model: all links with their equivalent boxes, and single links with their shapes.

use polhode::body::{MassProperties, PlacedPart, PrincipalFrame, assemble};
use polhode::math::{Frame, Part, Rotation};
use polhode_document::Section;
use polhode_document::drawing::{Drawing, Solid, Solids};
use polhode_document::layout::printable;
use polhode_document::number::number;
use polhode_source::text::counted;

use crate::at_rest::AtRest;
use crate::body::{LinkMass, link_mass};
use crate::check::LinkGeometry;
use crate::finding::Severity;
use crate::geometry::ShapeBox;
use crate::lump::Place;
use crate::model::{Link, Pose, RobotModel};
use crate::placement::Placement;
use crate::report::CheckReport;

/// Largest number of links with a picture of their own.
const MOST: usize = 24;

/// Largest drawn size of an equivalent box relative to the shapes: beyond it, a wrong unit would
/// hide everything else.
const FAR: f64 = 5.0;

/// Groups of the picture of all links, by verdict.
const VERDICTS: [&str; 3] = ["no finding", "suspect", "impossible"];

/// Groups of the picture of one link.
const KINDS: [&str; 2] = ["equivalent box", "boxes around the shapes"];

/// Link with its shapes, its worst finding and its body.
type Shown<'a> = (&'a Link, &'a LinkGeometry, Option<Severity>, &'a MassProperties<Part>);

impl CheckReport {
    /// Returns the picture of all links and, `with_each`, those of single links; `None` if no link
    /// has a body to draw.
    pub(super) fn pictures(&self, with_each: bool) -> Option<Section> {
        let bodies: Vec<Option<MassProperties<Part>>> =
            self.model.links.iter().map(|link| body(&self.model, link)).collect();
        let whole = self.whole(&bodies).map(Drawing::Solids);
        let (links, rest) = if with_each { self.each(&bodies) } else { (Vec::new(), 0) };
        let mut section = Section::new(0, "Pictures");
        let is_empty = whole.is_none() && links.is_empty();
        whole.into_iter().chain(links).for_each(|drawing| section.draw(drawing));
        if rest > 0 {
            let rest = counted(rest, "link");
            section.say(format!("{MOST} links are drawn, those with findings first; {rest} are not."));
        }
        (!is_empty).then_some(section)
    }

    /// Returns the pictures of single links, and the number of links that are left out.
    fn each(&self, bodies: &[Option<MassProperties<Part>>]) -> (Vec<Drawing>, usize) {
        let verdicts = self.verdicts();
        let verdict = |link: &Link| verdicts.get(link.name.text.as_str()).copied();
        let mut drawn: Vec<Shown<'_>> = Vec::new();
        for ((link, geometry), body) in self.model.links.iter().zip(&self.geometry).zip(bodies) {
            if let Some(body) = body {
                drawn.push((link, geometry, verdict(link), body));
            }
        }
        // The worst come first; the sort keeps the order of the file.
        drawn.sort_by_key(|(_, _, verdict, _)| std::cmp::Reverse(*verdict));
        let picture = |(link, geometry, verdict, body): &Shown<'_>| {
            Drawing::Solids(of_link(link, geometry, *verdict, body))
        };
        (drawn.iter().take(MOST).map(picture).collect(), drawn.len().saturating_sub(MOST))
    }

    /// Returns the picture of all links with a body; `None` if there is none.
    fn whole(&self, bodies: &[Option<MassProperties<Part>>]) -> Option<Solids> {
        let AtRest { poses, .. } = AtRest::of(&self.model);
        let verdicts = self.verdicts();
        let placed_boxes = self.geometry.iter().zip(&poses);
        let size = extent(placed_boxes.flat_map(|(geometry, pose)| {
            geometry.boxes.iter().map(|around| placed(of_shape(around, ""), pose))
        }));
        let (mut solids, mut parts, mut undrawn) = (Vec::new(), Vec::new(), Vec::new());
        for ((link, pose), body) in self.model.links.iter().zip(&poses).zip(bodies) {
            let name = printable(&link.name.text);
            let Some(body) = body else {
                if link.inertial.is_some() {
                    undrawn.push(format!("{name}: no body has its numbers"));
                }
                continue;
            };
            let group = match verdicts.get(link.name.text.as_str()) {
                Some(Severity::Impossible) => 2,
                Some(Severity::Suspect) => 1,
                _ => 0,
            };
            let solid = placed(equivalent(&name, body, group), pose);
            if let Some(words) = beyond(&solid, size) {
                undrawn.push(format!("{name}: {words}"));
                continue;
            }
            let Ok(Placement { position, rotation }) = Place::of(pose) else { continue };
            let Ok(part) = PlacedPart::new(*body, position, rotation * Rotation::identity()) else {
                continue;
            };
            parts.push(part);
            solids.push(solid);
        }
        let whole = assemble(&parts).ok()?;
        let without = match undrawn.len() {
            0 => String::new(),
            _ => format!(" Not drawn: {}.", undrawn.join("; ")),
        };
        let (center, axes) = frame(&whole);
        Some(Solids {
            title: "All links, joints at zero".to_owned(),
            caption: format!(
                "Each link is drawn as its equivalent box: the uniform box with the same mass, centre of mass and inertia tensor. Black: the centre of mass of these links, with their principal axes.{without}"
            ),
            solids,
            groups: VERDICTS.map(str::to_owned).to_vec(),
            center,
            axes,
        })
    }
}

/// Returns the picture of one link, in its own frame.
fn of_link(
    link: &Link,
    geometry: &LinkGeometry,
    verdict: Option<Severity>,
    body: &MassProperties<Part>,
) -> Solids {
    let name = printable(&link.name.text);
    let shapes: Vec<Solid> =
        geometry.boxes.iter().map(|around| Solid { group: 1, ..of_shape(around, &name) }).collect();
    let own = equivalent(&name, body, 0);
    let far = beyond(&own, extent(shapes.iter().cloned()));
    let about = match (&far, verdict) {
        _ if shapes.is_empty() => "It has no shape that can be measured.".to_owned(),
        (Some(words), _) => format!("Not drawn: {words}."),
        (None, Some(Severity::Impossible | Severity::Suspect)) => {
            "The boxes are about equal if the numbers belong to these shapes.".to_owned()
        }
        (None, _) => "The boxes are about equal in size and place if the mass fills the shapes.".to_owned(),
    };
    let solids = far.is_none().then_some(own).into_iter().chain(shapes).collect();
    let (center, axes) = frame(body);
    Solids {
        title: verdict.map_or_else(|| name.clone(), |verdict| format!("{name}: {}", verdict.name())),
        caption: format!("Link {name} in its own frame. {about}"),
        solids,
        groups: KINDS.map(str::to_owned).to_vec(),
        center,
        axes,
    }
}

/// Returns the mass properties of a link in its frame; `None` if it has none, or unphysical ones.
fn body(model: &RobotModel, link: &Link) -> Option<MassProperties<Part>> {
    match link_mass(model.format, link) {
        Ok(LinkMass::Body(body)) => Some(body.properties),
        Ok(LinkMass::None) | Err(_) => None,
    }
}

/// Returns the centre of mass and the principal axes of a body.
fn frame<F: Frame>(body: &MassProperties<F>) -> ([f64; 3], [[f64; 3]; 3]) {
    let principal = PrincipalFrame::of(body.inertia());
    (body.center_of_mass().to_array(), [0, 1, 2].map(|k| principal.axis(k).to_array()))
}

/// Returns the uniform box with the mass properties of a body: half edge_k = √(3 S_k / m), with the
/// second moments S_k = ½(i1 + i2 + i3) − i_k along the principal axes.
fn equivalent(name: &str, body: &MassProperties<Part>, group: usize) -> Solid {
    let principal = PrincipalFrame::of(body.inertia());
    let moments = principal.moments();
    let sum: f64 = moments.iter().sum();
    let halves = [0, 1, 2].map(|k| {
        let half = (3.0 * (0.5 * sum - moments[k]).max(0.0) / body.mass()).sqrt();
        principal.axis(k).to_array().map(|x| half * x)
    });
    Solid { name: printable(name), center: body.center_of_mass().to_array(), halves, group }
}

/// Returns the box around a shape.
fn of_shape(around: &ShapeBox, name: &str) -> Solid {
    Solid { name: name.to_owned(), center: around.center, halves: around.halves, group: 1 }
}

/// Returns the length of the diagonal of the box around all boxes, along the frame's axes, m.
fn extent(solids: impl Iterator<Item = Solid>) -> f64 {
    let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for solid in solids {
        for (k, [low, high]) in ends.iter_mut().enumerate() {
            let reach: f64 = solid.halves.iter().map(|half| half[k].abs()).sum();
            (*low, *high) = (low.min(solid.center[k] - reach), high.max(solid.center[k] + reach));
        }
    }
    let squares: f64 = ends.iter().map(|[low, high]| (high - low).max(0.0).powi(2)).sum();
    squares.sqrt()
}

/// Returns words for an equivalent box that is much larger than shapes of this extent;
/// `None` for one that can be drawn with them.
fn beyond(solid: &Solid, extent: f64) -> Option<String> {
    let reach = |half: &[f64; 3]| half.iter().map(|x| x * x).sum::<f64>().sqrt();
    let edge = 2.0 * solid.halves.iter().map(reach).fold(0.0, f64::max);
    (extent > 0.0 && edge > FAR * extent).then(|| {
        format!(
            "its equivalent box has an edge of {} m, {} times the extent of the shapes",
            number(edge, 3),
            number(edge / extent, 3)
        )
    })
}

fn placed(solid: Solid, pose: &Pose) -> Solid {
    let center = pose.placed(solid.center);
    Solid { center, halves: solid.halves.map(|half| pose.turned(half)), ..solid }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Shapes;
    use crate::read::{ReadOptions, read_text};

    /// A box of 0.3 × 0.5 × 0.2 m and 4.1 kg whose geometry and inertial frame are turned alike.
    const MODEL: &str = r#"<robot name="r"><link name="a">
        <inertial><origin xyz="0.1 -0.2 0.3" rpy="0.3 -0.4 0.5"/><mass value="4.1"/>
          <inertia ixx="0.09908333333333333" iyy="0.04441666666666667" izz="0.11616666666666667" ixy="0" ixz="0" iyz="0"/></inertial>
        <visual><origin xyz="0.1 -0.2 0.3" rpy="0.3 -0.4 0.5"/><geometry><box size="0.3 0.5 0.2"/></geometry></visual>
      </link></robot>"#;

    #[test]
    fn the_equivalent_box_of_a_turned_box_is_the_box_around_its_shape() {
        let model = read_text(MODEL, "a.urdf".as_ref(), &ReadOptions::default()).unwrap();
        let link = &model.links[0];
        let shapes = Shapes::default().boxes(link);
        let own = equivalent("a", &body(&model, link).unwrap(), 0);
        assert_eq!(shapes.len(), 1);
        // The moments are sorted: axis 1 is y (longest), 2 is x, 3 is z.
        for (half, k) in own.halves.iter().zip([1, 0, 2]) {
            let other = shapes[0].halves[k];
            let sign = half.iter().zip(other).map(|(a, b)| a * b).sum::<f64>().signum();
            for (a, b) in half.iter().zip(other) {
                assert!((a - sign * b).abs() < 1e-12, "{own:?} {shapes:?}");
            }
        }
        for (a, b) in own.center.iter().zip(shapes[0].center) {
            assert!((a - b).abs() < 1e-15);
        }
        let size = extent(std::iter::once(of_shape(&shapes[0], "a")));
        assert!(size > 0.5 && size < 1.0 && beyond(&own, size).is_none());
        let huge = Solid { halves: own.halves.map(|half| half.map(|x| 1e3 * x)), ..own };
        assert!(beyond(&huge, size).is_some_and(|words| words.contains("an edge of 500 m")));
    }
}
