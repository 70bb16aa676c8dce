//! Columns that may be the time, the attitude or the angular velocity, by their names.

use polhode::infer::judge::{AttitudeSense, OmegaAxes, QuaternionOrder};

use super::columns::{Key, Said};
use super::euler::Sequence;
use super::name::{Kind, Name};

/// Columns that may be the time, the attitude or the angular velocity.
#[derive(Clone, Debug)]
pub(crate) struct Candidate {
    /// Rank of the candidate; the least is chosen. The distance of the names from plain ones counts
    /// first, then the preference for a form.
    pub rank: (u8, u8),
    pub numbers: Numbers,
    /// Indices of the columns, in the order of their meaning.
    pub columns: Vec<usize>,
    pub sense: Option<AttitudeSense>,
    pub axes: Option<OmegaAxes>,
    /// Index of a column with the same meaning as another.
    pub twice: Option<usize>,
    /// Statement of the user about the columns.
    pub said: Option<Said>,
}

/// Meaning of the numbers in columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Numbers {
    /// Time, or angular velocity.
    Vector,
    Quaternion(Option<QuaternionOrder>),
    Matrix,
    Euler(Option<Sequence>),
}

/// Sets of labels, in the order of their meaning.
const QUATERNIONS: [(&str, Option<QuaternionOrder>); 4] = [
    ("w x y z", Some(QuaternionOrder::ScalarFirst)),
    ("real i j k", Some(QuaternionOrder::ScalarFirst)),
    ("0 1 2 3", None),
    ("1 2 3 4", None),
];
const MATRICES: [&str; 5] = [
    "11 12 13 21 22 23 31 32 33",
    "00 01 02 10 11 12 20 21 22",
    "0 1 2 3 4 5 6 7 8",
    "1 2 3 4 5 6 7 8 9",
    "xx xy xz yx yy yz zx zy zz",
];
const EULERS: [(&str, Option<Sequence>); 6] = [
    ("yaw pitch roll", Some(Sequence::YAW_PITCH_ROLL)),
    ("precession nutation spin", Some(Sequence::PRECESSION_NUTATION_SPIN)),
    ("phi theta psi", None),
    ("x y z", None),
    ("0 1 2", None),
    ("1 2 3", None),
];
const VECTORS: [&str; 3] = ["x y z", "0 1 2", "1 2 3"];

impl Candidate {
    /// Returns a column as a candidate for the time.
    pub(crate) fn time(column: usize, names: &[Option<Name>]) -> Self {
        let distance = names[column].as_ref().map_or(u8::MAX, |name| name.distance);
        Self::of(&[column], names, Numbers::Vector, (distance, 0))
    }

    fn of(columns: &[usize], names: &[Option<Name>], numbers: Numbers, rank: (u8, u8)) -> Self {
        let first = columns.first().and_then(|column| names[*column].as_ref());
        let same = |column: &usize| {
            names[*column].as_ref().map(|n| (n.axes, n.sense)) == first.map(|n| (n.axes, n.sense))
        };
        let first = first.filter(|_| columns.iter().all(same));
        Self {
            rank,
            numbers,
            columns: columns.to_vec(),
            sense: first.and_then(|name| name.sense),
            axes: first.and_then(|name| name.axes),
            twice: None,
            said: None,
        }
    }

    /// Returns a candidate from a statement of the user. The names of columns are used for
    /// everything that the user does not state. Angles in another order than their names are an
    /// error.
    pub(crate) fn said(
        said: &Said,
        columns: Vec<usize>,
        names: &[Option<Name>],
    ) -> Result<Self, (String, String)> {
        let labels: Vec<&str> =
            columns.iter().map(|c| names[*c].as_ref().map_or("", |name| name.label.as_str())).collect();
        let (numbers, columns) = match said.key {
            Key::Time | Key::Omega => (Numbers::Vector, columns),
            Key::Matrix => (Numbers::Matrix, columns),
            Key::Quaternion => match (said.order, arranged("w x y z", &labels)) {
                (None, Some(order)) => {
                    let columns = order.iter().map(|k| columns[*k]).collect();
                    (Numbers::Quaternion(Some(QuaternionOrder::ScalarFirst)), columns)
                }
                (order, _) => (Numbers::Quaternion(order), columns),
            },
            Key::Euler => match (said.sequence, arranged("yaw pitch roll", &labels)) {
                (None, Some(order)) => {
                    let columns = order.iter().map(|k| columns[*k]).collect();
                    (Numbers::Euler(Some(Sequence::YAW_PITCH_ROLL)), columns)
                }
                (Some(sequence), Some(_)) if !agrees(sequence, &labels) => {
                    let rule = format!(
                        "in the order of the turns {}: yaw turns about 3, pitch about 2, roll about 1",
                        sequence.shown()
                    );
                    return Err((labels.join(" "), rule));
                }
                (sequence, _) => (Numbers::Euler(sequence), columns),
            },
        };
        let named = Self::of(&columns, names, numbers, (0, 0));
        let (sense, axes) = (said.sense.or(named.sense), said.axes.or(named.axes));
        Ok(Self { sense, axes, said: Some(said.clone()), ..named })
    }

    /// Keeps the order of the file if the columns are named x, y, z, w. An order that the user
    /// states has priority.
    ///
    /// A header may use these names for numbers in the order w, x, y, z. In the order of the file,
    /// the numbers are a quaternion in any case, and the motion determines which order it is.
    pub(crate) fn in_file_order(self) -> Self {
        let is_scalar_first = self.numbers == Numbers::Quaternion(Some(QuaternionOrder::ScalarFirst));
        match self.columns[..] {
            [w, x, y, z]
                if is_scalar_first
                    && x < y
                    && y < z
                    && z < w
                    && self.said.as_ref().is_none_or(|said| said.order.is_none()) =>
            {
                let numbers = Numbers::Quaternion(Some(QuaternionOrder::ScalarLast));
                Self { numbers, columns: vec![x, y, z, w], ..self }
            }
            _ => self,
        }
    }

    /// Returns the order of the quaternion. Other forms are converted to a quaternion with the
    /// scalar first.
    pub(crate) const fn order(&self) -> Option<QuaternionOrder> {
        match self.numbers {
            Numbers::Quaternion(order) => order,
            _ => Some(QuaternionOrder::ScalarFirst),
        }
    }
}

/// Returns true if roll, pitch and yaw are about the axes of a sequence.
fn agrees(sequence: Sequence, labels: &[&str]) -> bool {
    let axis = |label: &str| ["roll", "pitch", "yaw"].iter().position(|known| *known == label);
    labels.iter().zip(sequence.axes).all(|(label, own)| axis(label) == Some(own))
}

/// Returns columns that may be the attitude.
pub(crate) fn attitudes(names: &[Option<Name>]) -> Vec<Candidate> {
    let mut found = Vec::new();
    for group in groups(names, Kind::Attitude) {
        for (labels, order) in QUATERNIONS {
            found.extend(group.candidate(names, labels, Numbers::Quaternion(order), 0));
        }
        for labels in MATRICES {
            found.extend(group.candidate(names, labels, Numbers::Matrix, 1));
        }
    }
    for group in groups(names, Kind::Euler) {
        for (labels, sequence) in EULERS {
            found.extend(group.candidate(names, labels, Numbers::Euler(sequence), 2));
        }
    }
    found
}

/// Returns the missing label of an incomplete attitude, and the columns that exist.
pub(crate) fn incomplete(names: &[Option<Name>]) -> Option<(&'static str, Vec<usize>)> {
    let groups = groups(names, Kind::Attitude).into_iter().chain(groups(names, Kind::Euler));
    groups
        .filter_map(|group| {
            [QUATERNIONS[0].0, EULERS[0].0].into_iter().find_map(|labels| {
                let column = |label: &str| {
                    let is_it = |c: &&usize| names[**c].as_ref().is_some_and(|name| name.label == label);
                    group.columns.iter().find(is_it).copied()
                };
                let there: Vec<usize> = labels.split(' ').filter_map(column).collect();
                let missing = labels.split(' ').find(|label| column(label).is_none())?;
                (there.len() >= 2).then_some((missing, there))
            })
        })
        .max_by_key(|(_, there)| there.len())
}

/// Returns columns that may be the angular velocity. Body axes have the highest preference,
/// followed by space axes and unknown axes.
pub(crate) fn omegas(names: &[Option<Name>]) -> Vec<Candidate> {
    let mut found = Vec::new();
    for group in groups(names, Kind::Omega) {
        for labels in VECTORS {
            found.extend(group.candidate(names, labels, Numbers::Vector, 0).map(|candidate| {
                let preference = match candidate.axes {
                    Some(OmegaAxes::Body) => 0,
                    Some(OmegaAxes::Space) => 1,
                    None => 2,
                };
                Candidate { rank: (candidate.rank.0, preference), ..candidate }
            }));
        }
    }
    found
}

/// Columns of one kind whose names differ only in the label.
struct Group {
    columns: Vec<usize>,
}

fn groups(names: &[Option<Name>], kind: Kind) -> Vec<Group> {
    let mut groups: Vec<(&str, Group)> = Vec::new();
    for (column, name) in names.iter().enumerate() {
        let Some(name) = name.as_ref().filter(|name| name.kind == kind) else { continue };
        match groups.iter_mut().find(|(own, _)| *own == name.group) {
            Some((_, group)) => group.columns.push(column),
            None => groups.push((&name.group, Group { columns: vec![column] })),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

impl Group {
    /// Returns the columns in the order of the labels, if all labels exist. If the labels are
    /// numbers, other numbers are not allowed.
    fn candidate(
        &self,
        names: &[Option<Name>],
        labels: &str,
        numbers: Numbers,
        form: u8,
    ) -> Option<Candidate> {
        let own: Vec<&str> =
            self.columns.iter().map(|c| names[*c].as_ref().map_or("", |n| &n.label)).collect();
        let order = arranged_within(labels, &own)?;
        let is_number = |label: &str| label.bytes().all(|b| b.is_ascii_digit());
        let others = own.iter().filter(|label| is_number(label) && !labels.split(' ').any(|l| l == **label));
        if is_number(labels.split(' ').next()?) && others.count() > 0 {
            return None;
        }
        let columns: Vec<usize> = order.iter().map(|k| self.columns[*k]).collect();
        let twice =
            (0..own.len()).find(|k| !order.contains(k) && labels.split(' ').any(|label| label == own[*k]));
        let distance = columns.iter().filter_map(|c| names[*c].as_ref()).map(|n| n.distance).max()?;
        let candidate = Candidate::of(&columns, names, numbers, (distance, form));
        Some(Candidate { twice: twice.map(|k| self.columns[k]), ..candidate })
    }
}

/// Returns the position of each label, if all exist.
fn arranged_within(labels: &str, own: &[&str]) -> Option<Vec<usize>> {
    labels.split(' ').map(|label| own.iter().position(|own| *own == label)).collect()
}

/// Returns the position of each label, if all exist and no others do.
fn arranged(labels: &str, own: &[&str]) -> Option<Vec<usize>> {
    arranged_within(labels, own).filter(|order| order.len() == own.len())
}
