//! Why links cannot be joined.

use std::error::Error;
use std::fmt;

use polhode::body::BodyError;
use polhode_report::plain::printable;

use crate::body::LinkError;
use crate::model::Span;

/// Why links cannot be joined to one body.
#[derive(Clone, Debug, PartialEq)]
pub enum LumpError {
    /// A link's numbers are not a body.
    Link {
        /// The link.
        link: String,
        /// Why not.
        error: LinkError,
    },
    /// No link has mass.
    Massless,
    /// A joint that names a link that is not there.
    NoLink {
        /// The joint.
        joint: String,
        /// The name.
        link: String,
        /// Where.
        span: Span,
    },
    /// Two links of one name.
    Twice {
        /// The name.
        link: String,
        /// Where it stands again.
        span: Span,
    },
    /// A link that hangs on two others: the joints are no tree.
    TwoParents {
        /// The link.
        link: String,
        /// The second joint.
        joint: String,
        /// Where.
        span: Span,
    },
    /// Two links that hang on no other, in a language that says where links are by their joints alone.
    TwoRoots {
        /// They.
        links: [String; 2],
        /// Where the second is.
        span: Span,
    },
    /// Joints in a circle.
    Circle {
        /// A link on it, or hanging from it.
        link: String,
        /// Where.
        span: Span,
    },
    /// A value for a joint that is not there, or does not take one.
    Joint {
        /// The name.
        joint: String,
        /// Those that take one.
        movable: Vec<String>,
    },
    /// An axis without a direction, or a pose that is none.
    Pose {
        /// The joint or link.
        subject: String,
        /// Where.
        span: Span,
    },
    /// A link whose numbers are too large to be added to the others.
    Joined {
        /// The link.
        link: String,
        /// Why not.
        error: BodyError,
    },
}

impl LumpError {
    /// Where in the model's text, if it is a place.
    pub fn span(&self) -> Option<Span> {
        match self {
            Self::Link { error, .. } => Some(error.span()),
            Self::NoLink { span, .. }
            | Self::Twice { span, .. }
            | Self::TwoParents { span, .. }
            | Self::TwoRoots { span, .. }
            | Self::Circle { span, .. }
            | Self::Pose { span, .. } => Some(span.clone()),
            Self::Massless | Self::Joint { .. } | Self::Joined { .. } => None,
        }
    }

    /// What to do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::Link { error, .. } => error.hint().to_owned(),
            Self::Massless => "give a link an inertial".to_owned(),
            Self::NoLink { .. } | Self::Twice { .. } => "check the spelling of the names".to_owned(),
            Self::TwoRoots { .. } => "join them; --lump fixed needs no common frame".to_owned(),
            Self::TwoParents { .. } | Self::Circle { .. } => {
                "only a tree has a place for each link: leave out the joint that closes it".to_owned()
            }
            Self::Joint { movable, .. } if movable.is_empty() => {
                "no joint of this model takes a value".to_owned()
            }
            Self::Joint { movable, .. } => {
                let names: Vec<_> = movable.iter().map(|name| printable(name)).collect();
                format!("those that take a value are {}", names.join(", "))
            }
            Self::Pose { .. } => "give it numbers that are finite, and an axis a length".to_owned(),
            Self::Joined { .. } => "check the units of its mass and of the poses above it".to_owned(),
        }
    }
}

impl fmt::Display for LumpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Link { link, error } => write!(f, "the link {link:?} is no body: {error}"),
            Self::Massless => f.write_str("no link has mass"),
            Self::NoLink { joint, link, .. } => {
                write!(f, "the joint {joint:?} names {link:?}, and there is no such link")
            }
            Self::Twice { link, .. } => write!(f, "two links are called {link:?}"),
            Self::TwoParents { link, joint, .. } => {
                write!(f, "the link {link:?} hangs on two others: the second time by the joint {joint:?}")
            }
            Self::TwoRoots { links: [a, b], .. } => {
                write!(f, "{a:?} and {b:?} both hang on nothing: where one stands from the other is not said")
            }
            Self::Circle { link, .. } => write!(f, "the joints above the link {link:?} run in a circle"),
            Self::Joint { joint, .. } => write!(f, "there is no joint {joint:?} that takes a value"),
            Self::Pose { subject, .. } => write!(f, "the pose or axis of {subject:?} is none"),
            Self::Joined { link, error } => {
                write!(f, "the link {link:?} cannot be joined to the others: {error}")
            }
        }
    }
}

impl Error for LumpError {}
