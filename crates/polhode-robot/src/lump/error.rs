//! Why links cannot be joined.

use std::error::Error;
use std::fmt;

use polhode::body::BodyError;
use polhode_document::layout::printable;

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
    /// Bodies that belong to what is joined and are not read.
    UnreadBodies {
        /// Name of the element that they are made from.
        element: String,
        /// Place of the element.
        span: Span,
    },
    /// No link has mass.
    Massless {
        /// The link from which they hang, if it is not all of them.
        subtree: Option<String>,
    },
    /// There is no such link.
    UnknownLink {
        /// The name.
        link: String,
        /// The one that was probably meant.
        meant: Option<String>,
        /// Those that are there, with mass first.
        links: Vec<String>,
    },
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
        /// The one that was probably meant.
        meant: Option<String>,
        /// Those that take one.
        movable: Vec<String>,
    },
    /// A value for one of two joints of the same name.
    TwoJoints {
        /// The name.
        joint: String,
        /// Where it stands again.
        span: Span,
    },
    /// A value under a name that two joints have, one of them as its coordinate's.
    Ambiguous {
        /// The name.
        name: String,
        /// The joints' own names.
        joints: [String; 2],
        /// Where the second is.
        span: Span,
    },
    /// Two values for a joint, one under its coordinate's name.
    GivenTwice {
        /// The names.
        names: [String; 2],
    },
    /// A value for a joint that follows another.
    Follower {
        /// The joint.
        joint: String,
        /// The one that it follows; `None` if it is held at a constant.
        leader: Option<String>,
        /// Where that is written.
        span: Span,
    },
    /// A value for a joint that moves nothing of what is joined.
    Idle {
        /// The joint.
        joint: String,
        /// The link from which this hangs; `None` if it is held together by fixed joints.
        subtree: Option<String>,
    },
    /// A joint that follows one that is not there, or that takes no value.
    Leader {
        /// The follower.
        joint: String,
        /// The name of the other.
        leader: String,
        /// Whether there is a joint of that name, or are several.
        is_there: bool,
        /// The one that was probably meant.
        meant: Option<String>,
        /// Where it is named.
        span: Span,
    },
    /// Joints that follow each other.
    FollowCircle {
        /// One of them, or one that follows them.
        joint: String,
        /// The one that it follows.
        leader: String,
        /// Where that is written.
        span: Span,
    },
    /// A joint of which it cannot be told how it follows another.
    Law {
        /// The follower.
        joint: String,
        /// The joint that leads, if one does.
        leader: Option<String>,
        /// Why not.
        why: String,
        /// Where it is written.
        span: Span,
    },
    /// A joint of which it is not known where it holds its child.
    Unread {
        /// The joint.
        joint: String,
        /// Why not.
        why: String,
        /// Where it stands.
        span: Span,
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
            Self::UnreadBodies { span, .. }
            | Self::NoLink { span, .. }
            | Self::Twice { span, .. }
            | Self::TwoParents { span, .. }
            | Self::TwoRoots { span, .. }
            | Self::Circle { span, .. }
            | Self::TwoJoints { span, .. }
            | Self::Ambiguous { span, .. }
            | Self::Follower { span, .. }
            | Self::Leader { span, .. }
            | Self::FollowCircle { span, .. }
            | Self::Law { span, .. }
            | Self::Unread { span, .. }
            | Self::Pose { span, .. } => Some(span.clone()),
            Self::Massless { .. }
            | Self::UnknownLink { .. }
            | Self::Joint { .. }
            | Self::GivenTwice { .. }
            | Self::Idle { .. }
            | Self::Joined { .. } => None,
        }
    }

    /// What to do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::Link { error, .. } => error.hint().to_owned(),
            Self::UnreadBodies { .. } => {
                "save the model as MuJoCo has compiled it (mj_saveLastXML), and use that".to_owned()
            }
            Self::Massless { .. } => "give a link an inertial".to_owned(),
            Self::UnknownLink { meant, links, .. } => suggested(meant.as_deref(), "its links are", links),
            Self::TwoJoints { .. } => "give each a name of its own".to_owned(),
            Self::Ambiguous { name, joints, .. } => match joints.iter().find(|joint| *joint != name) {
                Some(other) => {
                    format!("{} has that coordinate: name joints that have a name alone", printable(other))
                }
                None => "give each a name of its own".to_owned(),
            },
            Self::GivenTwice { .. } => "leave one of them out".to_owned(),
            Self::Follower { leader: Some(leader), .. } => {
                format!("leave it out, and give a value to {}", printable(leader))
            }
            Self::Follower { leader: None, .. } => "leave it out".to_owned(),
            Self::Idle { .. } => "leave it out".to_owned(),
            Self::Leader { meant: Some(meant), .. } => format!("did you mean {}?", printable(meant)),
            Self::Leader { meant: None, .. } => "name a joint that turns or slides".to_owned(),
            Self::FollowCircle { .. } => "let one of them lead, and follow none".to_owned(),
            Self::Law { .. } => "write numbers, or take the coupling out of the file".to_owned(),
            Self::Unread { .. } => "ask for what hangs on it, or for links one by one".to_owned(),
            Self::NoLink { .. } | Self::Twice { .. } => "check the spelling of the names".to_owned(),
            Self::TwoRoots { .. } => "join them; --lump fixed needs no common frame".to_owned(),
            Self::TwoParents { .. } | Self::Circle { .. } => {
                "only a tree has a place for each link: leave out the joint that closes it".to_owned()
            }
            Self::Joint { movable, .. } if movable.is_empty() => {
                "no joint of this model takes a value".to_owned()
            }
            Self::Joint { meant, movable, .. } => {
                suggested(meant.as_deref(), "those that take a value are", movable)
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
            Self::UnreadBodies { element, .. } => {
                write!(f, "the bodies of <{element}> are not read, and their mass would be missing")
            }
            Self::Massless { subtree: None } => f.write_str("no link has mass"),
            Self::Massless { subtree: Some(link) } => {
                write!(f, "neither the link {link:?} nor what hangs from it has mass")
            }
            Self::UnknownLink { link, .. } => write!(f, "there is no link {link:?}"),
            Self::TwoJoints { joint, .. } => write!(f, "two joints are called {joint:?}"),
            Self::Ambiguous { name, joints: [a, b], .. } => {
                write!(f, "the joints {a:?} and {b:?} both take a value as {name:?}")
            }
            Self::GivenTwice { names: [a, b] } => {
                write!(f, "{a:?} and {b:?} are one joint, and each is given a value")
            }
            Self::Follower { joint, leader: Some(leader), .. } => {
                write!(f, "the joint {joint:?} follows {leader:?}, and takes no value of its own")
            }
            Self::Follower { joint, leader: None, .. } => {
                write!(f, "the joint {joint:?} is held at a constant, and takes no value")
            }
            Self::Idle { joint, subtree: Some(link) } => {
                write!(f, "the joint {joint:?} moves nothing that hangs from the link {link:?}")
            }
            Self::Idle { joint, subtree: None } => {
                write!(f, "the joint {joint:?} moves nothing within what fixed joints hold together")
            }
            Self::Leader { joint, leader, is_there: false, .. } => {
                write!(f, "the joint {joint:?} follows {leader:?}, and there is no such joint")
            }
            Self::Leader { joint, leader, is_there: true, .. } => {
                write!(
                    f,
                    "the joint {joint:?} follows {leader:?}, which is not one joint that turns or slides"
                )
            }
            Self::FollowCircle { joint, leader, .. } => {
                write!(
                    f,
                    "the joint {joint:?} follows {leader:?}, and joints follow each other in a circle there"
                )
            }
            Self::Law { joint, leader: Some(leader), why, .. } => {
                write!(f, "the joint {joint:?} follows {leader:?}, but not in a way that is known: {why}")
            }
            Self::Law { joint, leader: None, why, .. } => {
                write!(f, "the joint {joint:?} is held at a value that is not known: {why}")
            }
            Self::Unread { joint, why, .. } => {
                write!(f, "where the joint {joint:?} holds its child is not known: {why}")
            }
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

/// The name that was probably meant, and those that there are; of very many, some.
fn suggested(meant: Option<&str>, introduction: &str, names: &[String]) -> String {
    /// Names that a hint lists.
    const MOST: usize = 40;
    let meant = meant.map_or_else(String::new, |meant| format!("did you mean {}? ", printable(meant)));
    let listed: Vec<_> = names.iter().take(MOST).map(|name| printable(name)).collect();
    let more = if names.len() > MOST { ", …" } else { "" };
    format!("{meant}{introduction} {}{more}", listed.join(", "))
}
