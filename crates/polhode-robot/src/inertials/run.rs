//! Computes, writes, reads back and checks the inertials of a model.

use std::collections::{BTreeMap, HashMap};

use polhode::math::Rotation;
use polhode_source::files::Files;
use polhode_source::{Failure, FormatError};

use super::choice::{Chosen, Unusable, choose};
use super::digits::{Digits, InertialDigits};
use super::element::LinkElements;
use super::outcome::{Inertials, LinkOutcome, Outcome, Written};
#[cfg(feature = "usd")]
use super::prim;
use super::request::InertialsRequest;
use super::selection::{chosen, has_inertial};
use super::substance::{LinkBody, Substances, Weighed};
use crate::body::{LinkMass, link_mass};
use crate::finding::{Finding, Severity};
use crate::geometry::{Shapes, mesh_files};
use crate::inspect::inspect;
use crate::line_index::LineIndex;
use crate::model::{Link, ModelFormat, RobotModel, Span};
use crate::moments::elements;
use crate::parallel;
#[cfg(feature = "usd")]
use crate::read::usd::{MassSite, mass_sites};
use crate::read::{ReadOptions, read_model, read_text};
use crate::repair::{Repaired, edited};

/// Relative tolerance of an inertial that is right as it is.
const SAME: f64 = 1e-12;

/// Relative tolerance of an inertial that is read back: single precision in USD.
const SINGLE: f64 = 1e-6;

/// Inertial that is ready to be written.
struct Ready {
    written: Written,
    digits: InertialDigits,
    edits: Vec<(Span, String)>,
}

/// Places of the links in the text.
enum Places {
    Elements(LinkElements),
    #[cfg(feature = "usd")]
    Prims(HashMap<String, MassSite>),
}

impl Places {
    fn of(model: &RobotModel) -> Result<Self, FormatError> {
        let places = match model.format {
            #[cfg(feature = "usd")]
            ModelFormat::Usd => mass_sites(&model.text).map(Self::Prims),
            _ => LinkElements::of(&model.text).map(Self::Elements),
        };
        places.map_err(|error| FormatError::of_content(&model.path, model.text.as_bytes(), error))
    }
}

/// Computes the inertials of the chosen links, and edits the model's text.
///
/// # Errors
/// [`Failure`] if the model cannot be read or edited, if the request contradicts itself, or if a
/// name matches nothing. [`Inertials::links`] lists the links that get no inertial.
pub fn write_inertials(request: &InertialsRequest, files: &dyn Files) -> Result<Inertials, Failure> {
    polhode_source::file::require_folders(files, &request.roots)?;
    let reading = ReadOptions { files, roots: request.roots.clone(), ..ReadOptions::default() };
    let model = read_model(&request.file, &reading)?;
    require_writable(&model)?;
    let meshes = mesh_files(files, [&model].into_iter());
    let threads = parallel::threads();
    let shapes = Shapes::with_threads((threads / meshes.len().max(1)).max(1)).from_files(files);
    parallel::map(meshes, threads, |mesh| shapes.read_ahead(&mesh), |_| ());
    let before = inspect(&model, &shapes).findings;
    let selected = chosen(&model, request, &before)?;
    let measure =
        |k: usize| model.links.get(k).map(|link| (k, choose(link, &shapes, request.options.geometry)));
    let measured: Vec<(usize, Result<Chosen, Unusable>)> =
        parallel::map(selected, threads, measure, |_| ()).into_iter().flatten().collect();
    let mut ready: BTreeMap<usize, Ready> = BTreeMap::new();
    let mut outcomes: BTreeMap<usize, Outcome> = BTreeMap::new();
    let mut solids: Vec<(usize, Weighed<'_>)> = Vec::new();
    for (k, chosen) in measured {
        let Some(link) = model.links.get(k) else { continue };
        let had_inertial = is_usable(&model, link);
        match chosen {
            Ok(chosen) => solids.push((k, Weighed { link, chosen })),
            Err(Unusable::NoGeometry) => {
                let is_named = request.link.as_ref().is_some_and(|name| *name == link.name.text);
                outcomes.insert(k, Outcome::NoGeometry { is_missed: is_named && !had_inertial });
            }
            Err(Unusable::NoSolid(why)) => {
                outcomes
                    .insert(k, Outcome::NotWritten { why: format!("no usable solid: {why}"), had_inertial });
            }
        }
    }
    let unusable = outcomes.iter().find(|(_, outcome)| matches!(outcome, Outcome::NotWritten { .. }));
    let unusable = unusable.and_then(|(k, _)| model.links.get(*k)).map(|link| link.name.text.as_str());
    let (numbers, solids): (Vec<usize>, Vec<Weighed<'_>>) = solids.into_iter().unzip();
    let substances = Substances::of(&model, request, &solids, unusable)?;
    let places = Places::of(&model)?;
    let mut counts: HashMap<usize, usize> = HashMap::new();
    model.links.iter().for_each(|link| *counts.entry(link.span.start).or_default() += 1);
    for (k, solid) in numbers.into_iter().zip(solids) {
        let had_inertial = is_usable(&model, solid.link);
        let made = require_own(&model, solid.link, &counts)
            .and_then(|()| substances.body(&model, &solid))
            .and_then(|body| made(&model, &places, &solid, body));
        match made {
            Ok(made) => drop(ready.insert(k, made)),
            Err(why) => drop(outcomes.insert(k, Outcome::NotWritten { why, had_inertial })),
        }
    }
    let (edited, after) = proved(&model, &reading, &shapes, &before, &mut ready, &mut outcomes)?;
    outcomes.extend(ready.into_iter().map(|(k, ready)| (k, Outcome::Written(Box::new(ready.written)))));
    let lines = LineIndex::new(&model.text);
    let outcome = |(k, outcome): (usize, Outcome)| {
        let link = model.links.get(k)?;
        let line = lines.place(link.span.start).0;
        Some(LinkOutcome { link: link.name.text.clone(), line, outcome })
    };
    let links = outcomes.into_iter().filter_map(outcome).collect();
    let has_total = request.substance.mass.is_some();
    Ok(Inertials { links, out: None, edited, after, has_total, model })
}

/// Returns true if a link states mass properties that a body can have.
fn is_usable(model: &RobotModel, link: &Link) -> bool {
    has_inertial(link) && matches!(link_mass(model.format, link), Ok(LinkMass::Body(_)))
}

/// Refuses a format without shapes that bound solids.
fn require_writable(model: &RobotModel) -> Result<(), Failure> {
    model.require_text("no inertials are written")?;
    if model.format != ModelFormat::Osim {
        return Ok(());
    }
    let message = "inertials are not written into OpenSim models: their geometry is for display, and polhode does not read it";
    Err(Failure::usage(message, "convert the model to URDF, SDF, MJCF or USD").in_file(&model.path))
}

/// Refuses a link whose element is in another file, or stands for several links; `counts` has the
/// number of links by the first byte of their element.
fn require_own(model: &RobotModel, link: &Link, counts: &HashMap<usize, usize>) -> Result<(), String> {
    if model.is_included(&link.span) {
        return Err("it is in an included file; write that file".to_owned());
    }
    match counts.get(&link.span.start) {
        None | Some(1) => Ok(()),
        Some(count) => Err(format!("the model makes {count} links of its element")),
    }
}

/// Returns the inertial of a link with its edits.
fn made(model: &RobotModel, places: &Places, solid: &Weighed<'_>, body: LinkBody) -> Result<Ready, String> {
    let Weighed { link, chosen: Chosen { solid, role, reason } } = solid;
    let extent = solid.whole().map_or(0.0, |whole| whole.extent);
    let LinkBody { properties, mass_by, kept } = body;
    #[cfg(feature = "usd")]
    let is_kept = kept.is_some();
    let digits = InertialDigits::of(&properties, solid.error, extent, kept);
    let states_it = has_inertial(link) && link.computed.is_none();
    let is_unchanged = states_it && misread(model, link, &digits, SAME).is_none();
    let edits = match places {
        _ if is_unchanged => Vec::new(),
        Places::Elements(elements) => elements.edits(model, link, &digits)?,
        #[cfg(feature = "usd")]
        Places::Prims(sites) => prim::edits(model, sites, link, &properties, &digits, is_kept)?,
    };
    let written = Written {
        properties: properties.in_frame(Rotation::identity()),
        volume: solid.volume(),
        role: *role,
        reason: reason.clone(),
        mass_by,
        error: solid.error,
        is_unchanged,
    };
    Ok(Ready { written, digits, edits })
}

/// Applies the edits, reads the text back, and withdraws inertials that do not read back with their
/// numbers, or that have a finding.
fn proved(
    model: &RobotModel,
    reading: &ReadOptions<'_>,
    shapes: &Shapes<'_>,
    before: &[Finding],
    ready: &mut BTreeMap<usize, Ready>,
    outcomes: &mut BTreeMap<usize, Outcome>,
) -> Result<(Repaired, RobotModel), Failure> {
    // Each iteration withdraws at least one inertial, so the loop ends.
    loop {
        let edits = ready.values().flat_map(|ready| ready.edits.iter().cloned()).collect();
        let edited = edited(model, edits).ok_or_else(|| unreadable("its edits overlap"))?;
        let after =
            read_text(&edited.text, &model.path, reading).map_err(|error| unreadable(&error.message()))?;
        let findings = inspect(&after, shapes).findings;
        let mut withdrawn = Vec::new();
        for (&k, ready) in &*ready {
            let Some(link) = after.links.get(k) else { continue };
            let fault =
                misread(&after, link, &ready.digits, SINGLE).or_else(|| fault(link, before, &findings));
            withdrawn.extend(fault.map(|why| (k, why)));
        }
        if withdrawn.is_empty() {
            return Ok((edited, after));
        }
        for (k, why) in withdrawn {
            ready.remove(&k);
            let had_inertial = model.links.get(k).is_some_and(|link| is_usable(model, link));
            outcomes.insert(k, Outcome::NotWritten { why, had_inertial });
        }
    }
}

/// Returns the reason why programs do not read the intended numbers of a link, within a relative
/// tolerance; `None` if they do.
fn misread(model: &RobotModel, link: &Link, digits: &InertialDigits, tolerance: f64) -> Option<String> {
    let body = match link_mass(model.format, link) {
        Ok(LinkMass::Body(body)) => body.properties,
        Ok(LinkMass::None) => return Some("programs do not read its inertial".to_owned()),
        Err(error) => return Some(format!("its new inertial cannot be used: {error}")),
    };
    let (centers, own) = (body.center_of_mass().to_array(), elements(&body.inertia().matrix()));
    let [mass, center, tensor] = digits.errors;
    let largest = own.iter().fold(0.0, |most: f64, element| most.max(element.abs()));
    // The size of the body and the position of its centre bound the rounding of the centre.
    let size = (largest / body.mass()).sqrt();
    let near =
        |a: f64, b: &Digits, error: f64, scale: f64| (a - b.value).abs() <= 2.0 * error + tolerance * scale;
    let is_read = near(body.mass(), &digits.mass, mass, body.mass())
        && centers.iter().zip(&digits.center).all(|(c, new)| near(*c, new, center, size + c.abs()))
        && own.iter().zip(&digits.tensor).all(|(element, new)| near(*element, new, tensor, largest));
    (!is_read).then(|| {
        "programs read other numbers than its inertial: settings of the model change them".to_owned()
    })
}

/// Returns a finding about the new inertial of a link that it did not have before, or that is about
/// its mass properties.
fn fault(link: &Link, before: &[Finding], after: &[Finding]) -> Option<String> {
    let is_own = |finding: &&Finding| {
        finding.severity > Severity::Note
            && (finding.subject == link.name.text || finding.others.contains(&link.name.text))
    };
    let is_of_mass = |code: &str| {
        ["mass.", "density.", "inertia.", "gyration.", "number."].iter().any(|start| code.starts_with(start))
    };
    let count = |all: &[Finding], code: &str| {
        all.iter().filter(is_own).filter(|finding| finding.code == code).count()
    };
    let mut own = after.iter().filter(is_own);
    let finding = own.find(|finding| {
        is_of_mass(finding.code) || count(after, finding.code) > count(before, finding.code)
    })?;
    Some(format!("its new inertial has a finding, {}: {}", finding.code, finding.message))
}

fn unreadable(why: &str) -> Failure {
    Failure::usage(
        format!("the new model could not be read again, so it was not written: {why}"),
        "this is a bug in polhode: please report it, with the model",
    )
}
