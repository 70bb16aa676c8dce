//! Rows of numbers as rows of a motion, and the errors of a row.

use std::ops::Range;

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::choice::{Form, Plan};
use super::matrix::{self, MatrixError};

/// Largest number of values in a row: the time, nine of an attitude, and an angular velocity.
pub(crate) const MOST: usize = 13;

/// Rows of a motion in SI.
#[derive(Debug, Default)]
pub(crate) struct Rows {
    pub times: Vec<f64>,
    pub attitude: Vec<[f64; 4]>,
    pub omega: Vec<[f64; 3]>,
    /// Position of the first row, in a text.
    first: Range<usize>,
}

/// Error of a row, with its index, from 0.
#[derive(Debug)]
pub(crate) struct RowError {
    pub row: usize,
    pub place: ContentPlace,
    pub problem: Problem,
}

/// Possible error of a row. Slots are those of its plan.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Problem {
    NotNumber {
        slot: usize,
        found: String,
    },
    NotFinite {
        slot: usize,
        found: String,
    },
    Missing {
        slot: usize,
    },
    Width {
        expected: usize,
        found: usize,
        line: String,
    },
    OpenQuote {
        line: String,
    },
    NotJson {
        message: String,
        line: String,
    },
    NotLater {
        time: f64,
        before: f64,
    },
    ZeroQuaternion,
    Matrix(MatrixError),
    /// A key `# key = value` is below the header.
    LateKey {
        key: String,
    },
}

impl Rows {
    /// Adds a row of finite numbers from a place in the text.
    pub(crate) fn push(&mut self, plan: &Plan, numbers: &[f64], place: Range<usize>) -> Result<(), Problem> {
        let [time, numbers @ ..] = numbers else { return Ok(()) };
        let time = plan.time.apply(*time);
        match self.times.last() {
            Some(&before) if time <= before => return Err(Problem::NotLater { time, before }),
            Some(_) => {}
            None => self.first = place,
        }
        let (attitude, omega) = numbers.split_at(plan.form.count());
        let attitude = match (plan.form, attitude) {
            (Form::None, _) => None,
            (Form::Quaternion, &[a, b, c, d]) if [a, b, c, d] == [0.0; 4] => {
                return Err(Problem::ZeroQuaternion);
            }
            (Form::Quaternion, &[a, b, c, d]) => Some([a, b, c, d]),
            (Form::Matrix, attitude) => {
                Some(matrix::matrix_quaternion(array(attitude)).map_err(Problem::Matrix)?)
            }
            (Form::Euler { sequence, unit }, attitude) => {
                Some(sequence.quaternion(array(attitude).map(|angle| unit.apply(angle))))
            }
            _ => return Ok(()),
        };
        self.times.push(time);
        self.attitude.extend(attitude);
        if let Some(unit) = plan.omega {
            self.omega.push(array(omega).map(|number| unit.apply(number)));
        }
        Ok(())
    }

    /// Adds rows that follow. An error has its row index relative to these rows.
    pub(crate) fn append(&mut self, mut next: Self) -> Result<(), RowError> {
        if let (Some(&before), Some(&time)) = (self.times.last(), next.times.first())
            && time <= before
        {
            let place = ContentPlace::Text(next.first);
            return Err(RowError { row: 0, place, problem: Problem::NotLater { time, before } });
        }
        if self.times.is_empty() {
            self.first = next.first;
        }
        self.times.append(&mut next.times);
        self.attitude.append(&mut next.attitude);
        self.omega.append(&mut next.omega);
        Ok(())
    }

    /// Reserves memory for this number of rows in total.
    pub(crate) fn reserve(&mut self, plan: &Plan, rows: usize) {
        self.times.reserve(rows.saturating_sub(self.times.len()));
        self.attitude.reserve(rows.saturating_sub(self.attitude.len()));
        if plan.omega.is_some() {
            self.omega.reserve(rows.saturating_sub(self.omega.len()));
        }
    }
}

/// Returns the first N numbers. The plan has a slot for each, so they exist.
fn array<const N: usize>(numbers: &[f64]) -> [f64; N] {
    numbers.first_chunk().copied().unwrap_or([f64::NAN; N])
}

impl RowError {
    /// Returns the error as a message with the names of the columns.
    pub(crate) fn told(self, plan: &Plan) -> ContentError {
        let row = self.row + 1;
        let of = |slot: usize| format!("{} of row {row}", plan.slots.get(slot).map_or("", |slot| &slot.name));
        let value = |what: String, value: String, rule: &str| ContentErrorKind::Value {
            what,
            value,
            rule: rule.to_owned(),
        };
        let (kind, hint) = match self.problem {
            Problem::NotNumber { slot, found } => {
                let hint = match found.as_str() {
                    "" => {
                        "write a row only where all of its columns are known, or leave the column out by --columns"
                    }
                    _ if found.contains(',') => "write decimal points: replace the commas",
                    _ if row == 1 => {
                        "below the header stand numbers: units stand in the names, such as omega_x [deg/s]"
                    }
                    _ => "a number is written as 0.25 or 2.5e-1",
                };
                let found = if found.is_empty() { "nothing".to_owned() } else { found };
                let what = format!("a number as {}", of(slot));
                (ContentErrorKind::Expected { what, found }, hint)
            }
            Problem::NotFinite { slot, found } => {
                let hint = "a program that writes NaN has lost the motion before: cut the log off there";
                (value(of(slot), found, "finite"), hint)
            }
            Problem::Missing { slot } => {
                let kind = ContentErrorKind::Missing { what: of(slot) };
                (kind, "every row has the names of the first")
            }
            Problem::Width { expected, found, line } => {
                let rule = format!("{expected} fields long, like the header; it has {found}");
                let hint = match found > expected && plan.has_commas {
                    true => "a decimal comma makes two fields of one: the decimal mark is a point",
                    false => "the program did not finish this line: delete it",
                };
                (value(format!("row {row}"), line, &rule), hint)
            }
            Problem::OpenQuote { line } => {
                let kind = ContentErrorKind::Expected { what: "a closing quote".to_owned(), found: line };
                (kind, "a quoted field ends on its line")
            }
            Problem::NotJson { message, line } => {
                let rule = format!("a line of JSON: {message}");
                (value(format!("row {row}"), line, &rule), "JSON has no NaN; a log has one object a line")
            }
            Problem::NotLater { time, before } => {
                let rule = format!("later than {before} s, that of the row before");
                let hint = match time == before {
                    true => "write the time with all of its digits, and each row once",
                    false => {
                        "a log is one run from its start to its end: cut it apart where the time goes back"
                    }
                };
                (value(format!("the time of row {row}"), format!("{time} s"), &rule), hint)
            }
            Problem::ZeroQuaternion => {
                let what = format!("the quaternion of row {row}");
                let hint = "four zeros are no attitude: begin the log where the program knows it";
                (value(what, "0, 0, 0, 0".to_owned(), "other than zero"), hint)
            }
            Problem::LateKey { key } => {
                let what = format!("the comment before row {row}");
                let hint = "move the line above the line of names, or delete it";
                (value(what, format!("{key} = …"), "above the header: below it no key is read"), hint)
            }
            Problem::Matrix(error) => {
                let (what, found, rule) = match error {
                    MatrixError::NotRotation(departure) => {
                        let rule = format!("{} or less: the matrix has to be a rotation", matrix::TOLERANCE);
                        ("|RᵀR − 1|", format!("{departure:.2e}"), rule)
                    }
                    MatrixError::Mirrored => ("det R", "−1".to_owned(), "+1: the matrix mirrors".to_owned()),
                };
                (value(format!("{what} of row {row}"), found, &rule), error.hint())
            }
        };
        ContentError::new(kind, self.place).hint(hint)
    }
}
