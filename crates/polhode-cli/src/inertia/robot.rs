//! The mass properties of a robot's links: of one, of those that fixed joints hold together, or of all.

use std::fmt;
use std::path::Path;

use clap::{Args, ValueEnum};
use polhode::body::Finding;
use polhode::math::{Body, Rotation};
use polhode_formats::unit::Dimension;
use polhode_report::plain::{number, printable};
use polhode_report::{InertiaReport, SourceInfo};
use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::line_index::{FilePlace, Places};
use polhode_robot::lump::{Lump, Lumping, lump};
use polhode_robot::model::{JointKind, Link, ModelFormat, RobotModel, Span};
use polhode_robot::read::{ReadOptions, read_model};
use polhode_robot::remarks::remarks;

use crate::failure::Failure;
use crate::numbers::quantity;
use crate::stderr::shown;

/// Flags for robot models.
#[derive(Debug, Args)]
pub(super) struct RobotFlags {
    /// A link of a robot, in its own frame.
    #[arg(long, value_name = "NAME", conflicts_with = "lump")]
    link: Option<String>,
    /// The links of a robot joined: "fixed", those that fixed joints hold together, or "all" [default: all].
    #[arg(long, value_name = "WHICH", num_args = 0..=1, default_missing_value = "all")]
    lump: Option<Which>,
    /// The value of a joint, in rad or m or with its unit: elbow="30 deg"; others are at zero.
    #[arg(long = "joint", value_name = "NAME=VALUE", requires = "lump", conflicts_with = "link", value_parser = joint, allow_hyphen_values = true)]
    joints: Vec<(String, String)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Which {
    /// A body for each group of links that fixed joints hold together, in the frame of its first link.
    Fixed,
    /// One body, in the frame of the model.
    All,
}

impl RobotFlags {
    /// The first that is given.
    pub(super) const fn given(&self) -> Option<&'static str> {
        match self {
            Self { link: Some(_), .. } => Some("--link"),
            Self { lump: Some(_), .. } => Some("--lump"),
            _ => None,
        }
    }
}

/// One report for the link, or for each body that is asked for.
pub(super) fn reports(file: &Path, flags: &RobotFlags) -> Result<Vec<InertiaReport>, Failure> {
    let model = read_model(file, &ReadOptions::default())?;
    match (&flags.link, flags.lump) {
        (Some(name), _) => Ok(vec![of_link(&model, name)?]),
        (None, Some(Which::Fixed)) if !flags.joints.is_empty() => Err(Failure::usage(
            "--joint is for --lump all: what fixed joints hold together has the same inertia in every position",
            "leave it out",
        )),
        (None, Some(which)) => lumped(&model, which, &flags.joints),
        (None, None) => Err(Failure::usage(
            format!("{} is a robot of {} links", shown(file), model.links.len()),
            format!(
                "name one by --link, or join them by --lump fixed or --lump all; its links are {}",
                names(&model)
            ),
        )),
    }
}

fn of_link(model: &RobotModel, name: &str) -> Result<InertiaReport, Failure> {
    let Some(link) = model.links.iter().find(|link| link.name.text == name) else {
        return Err(Failure::usage(
            format!("{} has no link {name:?}", shown(&model.path)),
            format!("its links are {}", names(model)),
        ));
    };
    let findings = noticed(model, Some(name))?;
    let body = match link_mass(model.format, link) {
        Ok(LinkMass::Body(body)) => body,
        Ok(LinkMass::None) => {
            let hint = "name another, or join it to others by --lump fixed";
            return Err(located(model, &link.span, format!("the link {name:?} has no mass"), hint));
        }
        Err(error) => {
            let message = format!("the link {name:?} is no body: {error}");
            return Err(located(model, &error.span(), message, error.hint()));
        }
    };
    // The link's axes are the body's.
    let properties = body.properties.in_frame::<Body>(Rotation::identity());
    let source = source(model)
        .described(format!("link {name} {}, in the link's frame", of_model(model)))
        .with("link", name)
        .with("frame", "link");
    Ok(InertiaReport { findings, ..InertiaReport::new(rounded(source, body.rounding), properties) })
}

fn lumped(
    model: &RobotModel,
    which: Which,
    joints: &[(String, String)],
) -> Result<Vec<InertiaReport>, Failure> {
    let twice = (1..joints.len()).find(|&k| joints[..k].iter().any(|(name, _)| *name == joints[k].0));
    if let Some(twice) = twice {
        let message = format!("--joint {} is given twice", joints[twice].0);
        return Err(Failure::usage(message, "a joint has one value: leave one of them out"));
    }
    let positions =
        joints.iter().map(|(name, value)| position(model, name, value)).collect::<Result<Vec<_>, _>>()?;
    let lumping = match which {
        Which::Fixed => Lumping::Fixed,
        Which::All => Lumping::All,
    };
    let lumps = lump(model, lumping, &positions).map_err(|error| {
        let (message, hint) = (error.to_string(), error.hint());
        match error.span() {
            Some(span) => located(model, &span, message, hint),
            None => Failure::usage(message, hint),
        }
    })?;
    let findings = noticed(model, None)?;
    let report = |lump| {
        let report = of_lump(model, which, &positions, lump);
        InertiaReport { findings: findings.clone(), ..report }
    };
    Ok(lumps.into_iter().map(report).collect())
}

fn of_lump(model: &RobotModel, which: Which, positions: &[(String, f64)], lump: Lump) -> InertiaReport {
    let Lump { frame, links, massless, rounding, properties } = lump;
    let frame_words = match &frame {
        Some(link) => format!("in the frame of {link}"),
        None => "in the model's frame".to_owned(),
    };
    let count = links.len();
    let links_words = if count == 1 { "1 link".to_owned() } else { format!("{count} links") };
    let words = match which {
        Which::Fixed => {
            format!("{links_words} {} held together by fixed joints, {frame_words}", of_model(model))
        }
        Which::All if positions.is_empty() => {
            format!("all {links_words} {}, joints at zero, {frame_words}", of_model(model))
        }
        Which::All => {
            let at: Vec<_> = positions.iter().map(|(name, q)| at(model, name, *q)).collect();
            format!(
                "all {links_words} {}, {} and other joints at zero, {frame_words}",
                of_model(model),
                at.join(", ")
            )
        }
    };
    let joints: serde_json::Map<String, serde_json::Value> =
        positions.iter().map(|(name, q)| (name.clone(), (*q).into())).collect();
    let source = source(model)
        .described(words)
        .with("link", frame.clone())
        .with("frame", if frame.is_some() { "link" } else { "model" })
        .with("links", links)
        .with("massless", massless)
        .with("joints", joints);
    InertiaReport::new(rounded(source, rounding), properties)
}

/// `elbow = 0.523599 rad`
fn at(model: &RobotModel, name: &str, q: f64) -> String {
    let unit = if slides(model, name) { "m" } else { "rad" };
    format!("{name} = {} {unit}", number(q, 6))
}

fn slides(model: &RobotModel, name: &str) -> bool {
    model.joints.iter().any(|joint| joint.name.text == name && joint.kind == JointKind::Prismatic)
}

/// The source, and that digits were too few for a possible tensor.
fn rounded(source: SourceInfo, rounding: f64) -> SourceInfo {
    if rounding == 0.0 {
        return source;
    }
    let words = format!(
        "{}; tensor brought to the edge of the possible, {rounding:.1e} kg·m² away by its digits",
        source.description
    );
    source.described(words).with("rounding", rounding)
}

fn source(model: &RobotModel) -> SourceInfo {
    let format = match model.format {
        ModelFormat::Urdf => "urdf",
        ModelFormat::Sdf => "sdf",
        ModelFormat::Mjcf => "mjcf",
        ModelFormat::Usd => "usd",
        ModelFormat::Osim => "osim",
    };
    SourceInfo::new(model.path.display().to_string(), format)
}

fn of_model(model: &RobotModel) -> String {
    model.name.as_ref().map_or_else(|| "of the model".to_owned(), |name| format!("of {name}"))
}

/// The links by name, those with an inertial first; of very many, some.
fn names(model: &RobotModel) -> String {
    /// Links that a hint lists.
    const MOST: usize = 40;
    let (with, without): (Vec<&Link>, Vec<&Link>) =
        model.links.iter().partition(|link| link.inertial.is_some());
    let names: Vec<_> = with.iter().chain(&without).map(|link| printable(&link.name.text)).collect();
    let more = if names.len() > MOST { ", …" } else { "" };
    names.iter().take(MOST).map(String::as_str).collect::<Vec<_>>().join(", ") + more
}

/// NAME=VALUE, apart; the value waits for its joint to say whether it is an angle or a length.
fn joint(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.rsplit_once('=').ok_or("NAME=VALUE belongs here, such as elbow=0.5")?;
    Ok((name.trim().to_owned(), value.trim().to_owned()))
}

/// The value of a joint, rad or m.
fn position(model: &RobotModel, name: &str, value: &str) -> Result<(String, f64), Failure> {
    let slides = slides(model, name);
    let dimension = if slides { Dimension::LENGTH } else { Dimension::ANGLE };
    match quantity(value, dimension) {
        Ok(q) => Ok((name.to_owned(), q)),
        Err(why) => Err(Failure::usage(
            format!("--joint {name}: {why}"),
            if slides {
                "it slides: a length, such as 0.02 or \"20 mm\""
            } else {
                "it turns: an angle, such as 0.5 or \"30 deg\""
            },
        )),
    }
}

/// What the reader noticed of a link, or of all; what says a number twice is no body.
fn noticed(model: &RobotModel, link: Option<&str>) -> Result<Vec<Finding>, Failure> {
    remarks(model, link).map_err(|twice| located(model, &twice.span, &twice, twice.hint()))
}

/// A failure with its place in the model.
fn located(model: &RobotModel, span: &Span, message: impl fmt::Display, hint: impl Into<String>) -> Failure {
    let FilePlace { file, line, column, .. } = Places::of(model).place(span);
    Failure::located(message.to_string(), file, [line, column], hint)
}
