//! Logs of motions that other programs wrote: times, attitudes and optional angular velocities, in
//! CSV, Parquet or JSON lines.
//!
//! The format follows from the contents of a file. Text has a line of names, then a line for each
//! time. Commas, semicolons, tabs or blanks separate the fields, and the decimal mark is a point.
//! Lines that begin with `#` are comments, except `# key = value` above the names. Below the names,
//! a key is an error.
//!
//! | key | meaning |
//! |---|---|
//! | `scenario` | the scenario that the program computed, a path relative to the log |
//! | `step` | the program's time step, in s or with a unit |
//! | `engine` | name of the program |
//! | `units` | units of columns whose names have none: `ms, deg, deg/s`, or `SI` |
//! | `columns` | meaning of the columns, in the notation below |
//!
//! JSON lines have an object for each time, with numbers, arrays and objects. The first number of
//! the array `"q": [1, 0, 0, 0]` has the name `q[0]`, and a member of an object has a name such as
//! `orientation.w`. A first line without a time is the head. Parquet has the keys in the file's
//! metadata, as `polhode.scenario` and so on.
//!
//! # Columns by their names
//!
//! | quantity | names |
//! |---|---|
//! | time | `t`, `time`, `time_s`, `sim_time_ms`; `timestamp` with a unit |
//! | quaternion | `attitude_w` …, `qw` …, `orientation.w` …: order by the letters |
//! | quaternion, scalar last | the same names, if the columns are in the order x, y, z, w |
//! | quaternion | `q0` … `q3`: the order is not known |
//! | matrix | `r11` … `r33`, `R_00` … `R_22`, `R[0][0]` …, `xmat_0` … `xmat_8`: row by row |
//! | Euler angles | `roll`, `pitch`, `yaw` (3-2-1), `precession`, `nutation`, `spin` (3-1-3) |
//! | Euler angles | other names: the sequence is not known |
//! | angular velocity | `wx` …, `gyro_x` …, `angular_velocity.x` … |
//! | angular velocity | `omega_body_x` along body axes, `omega_world_x` along space axes |
//!
//! Other words may precede a name (`robot.qw`), and a unit may follow it (`wx_deg_s`,
//! `wx [deg/s]`). The default units are s for a time and rad/s for an angular velocity; angles need
//! a unit. A property that the names do not determine remains open ([`RunLog::says`]). A file is
//! refused if two sets of columns are equally likely, or if a set is not complete. Angular
//! velocities along body axes are preferred to those along space axes. [`RunLog::ignored`] lists
//! the columns that are not read.
//!
//! # Columns as a user names them
//!
//! [`Columns::parse`] reads parts separated by commas. Each part has the meaning of columns, `=`,
//! and the names of the columns:
//!
//! ```text
//! time ms = t, quaternion xyzw body-to-space = q0 q1 q2 q3, omega space deg/s = w1 w2 w3
//! ```
//!
//! | part | words | columns |
//! |---|---|---|
//! | `time`, `t` | a unit | one |
//! | `quaternion`, `q` | `wxyz`, `xyzw`; `body-to-space`, `space-to-body` | four, in this order |
//! | `matrix`, `R` | `body-to-space`, `space-to-body` | nine, row by row |
//! | `euler`, `e` | `3-2-1`, `zyx` …; `extrinsic`; `deg`, `rad`; the sense | three, in this order |
//! | `omega`, `w` | `body`, `space`; a unit | three, or `none` |
//!
//! Columns are separated by blanks. A name with blanks or commas is in quotes. `q0..q3` are the
//! columns from the first to the last, and `q` is the array `q` of JSON lines. A file with numbers
//! only has the columns `1`, `2`, and so on. The words override the names of the columns.
//! Everything that they do not state follows from the names.

mod blocks;
mod candidate;
mod choice;
mod columns;
mod csv;
mod euler;
mod foreign;
mod head;
mod json_lines;
mod matrix;
mod measured;
mod name;
#[cfg(feature = "parquet")]
pub mod parquet;
#[cfg(not(feature = "parquet"))]
#[path = "no_parquet.rs"]
pub mod parquet;
mod rows;

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use ::bytes::Bytes;
use polhode::infer::judge::{DeclaredReading, LogError, MotionLog};
use polhode_source::FormatError;
use polhode_source::csv::Separator;
use polhode_source::file;
use polhode_source::files::Files;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use blocks::{Blocks, Failure};
use choice::{Plan, Wanted};
use head::Head;
use name::{Kind, Name};
use rows::Rows;

pub use columns::{Columns, ColumnsError};
pub use matrix::{MatrixError, matrix_quaternion};
pub use measured::MeasuredLog;

/// Log of a motion, with its own statements.
#[derive(Clone, Debug, PartialEq)]
pub struct RunLog {
    /// Motion in SI. Attitudes in other forms are converted to quaternions.
    pub log: MotionLog,
    /// Unambiguous statements of the user and of the names of columns.
    pub says: DeclaredReading,
    /// Scenario that the log states, as a path relative to the log.
    pub scenario: Option<PathBuf>,
    /// Time step of the program, s.
    pub step: Option<f64>,
    /// Name of the program.
    pub engine: Option<String>,
    /// Columns that were read, with their meaning.
    pub read: Vec<ReadColumns>,
    /// Columns that were not read.
    pub ignored: Vec<String>,
    /// Keys of the head that are not known here.
    pub ignored_keys: Vec<String>,
}

impl RunLog {
    /// Returns everything that was not read: names of columns, and keys of the head as `# key`.
    pub fn not_read(&self) -> Vec<String> {
        let keys = self.ignored_keys.iter().map(|key| format!("# {key}"));
        self.ignored.iter().cloned().chain(keys).collect()
    }
}

/// Columns that were read, with their meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadColumns {
    /// Meaning, such as `"angular velocity along body axes, deg/s"`.
    pub what: String,
    /// Names of the columns.
    pub columns: Vec<String>,
}

/// Reads a log. Statements of the user about its columns override those of the log.
///
/// # Errors
/// [`FormatError`] with its position: if the file cannot be read, if columns are missing or
/// ambiguous, if a row is incomplete or not finite, if the time does not increase, or if an
/// attitude is invalid.
pub fn read(files: &dyn Files, path: &Path, columns: Option<&Columns>) -> Result<RunLog, FormatError> {
    of_file(files, path, columns, Wanted::Attitude, finished)
}

/// Reads the log of an instrument: angular velocities, attitudes, or both. Otherwise the same as
/// [`read()`].
///
/// # Errors
/// Same as [`read()`].
pub fn read_measured(
    files: &dyn Files,
    path: &Path,
    columns: Option<&Columns>,
) -> Result<MeasuredLog, FormatError> {
    of_file(files, path, columns, Wanted::Either, |_, plan, rows| Ok(MeasuredLog::of(plan, rows)))
}

/// Reads the numbers of a file, and applies `finish` to them.
fn of_file<T>(
    files: &dyn Files,
    path: &Path,
    columns: Option<&Columns>,
    wanted: Wanted,
    finish: impl Fn(Head, Plan, Rows) -> Result<T, ContentError>,
) -> Result<T, FormatError> {
    let whole = || {
        file::bytes(files, path, &path.to_string_lossy(), u64::MAX)
            .map_err(|kind| FormatError::new(path, None, kind))
    };
    let failed =
        |error: &io::Error| FormatError::new(path, None, file::failed(&path.to_string_lossy(), error));
    let streamed = match files.is_file(path) {
        true => streamed(files, path, columns, wanted).map_err(|error| failed(&error))?,
        false => None,
    };
    let finish = |(head, plan, rows)| finish(head, plan, rows);
    match streamed {
        // The whole text is needed to show an error with its line.
        Some(read) => {
            read.and_then(finish).or_else(|error| Err(FormatError::of_content(path, &whole()?, error)))
        }
        None => {
            let bytes = Bytes::from(whole()?);
            let read = numbers(&bytes, columns, wanted).and_then(finish);
            read.map_err(|error| FormatError::of_content(path, &bytes, error))
        }
    }
}

/// Head of a file, meaning of its columns, and its numbers.
type Numbers = (Head, Plan, Rows);

/// Reads a text file block by block. Returns `None` for a file that must be in memory as a whole.
fn streamed(
    files: &dyn Files,
    path: &Path,
    columns: Option<&Columns>,
    wanted: Wanted,
) -> io::Result<Option<Result<Numbers, ContentError>>> {
    let mut file = files.open(path)?;
    let before = file.look()?;
    let mut start = Vec::new();
    (&mut file).take(PARQUET.len() as u64).read_to_end(&mut start)?;
    if start == PARQUET {
        return Ok(None);
    }
    let read = of_text(start.as_slice().chain(&mut file), Some(before.length), columns, wanted);
    file::unchanged(file.look()?, &before)?;
    match read {
        Ok(log) => Ok(Some(Ok(log))),
        Err(Failure::Content(error)) => Ok(Some(Err(error))),
        Err(Failure::Io(error)) => Err(error),
    }
}

/// First bytes of a Parquet file.
pub const PARQUET: &[u8] = b"PAR1";

/// Reads a log from the bytes of a file.
///
/// ```
/// use polhode::infer::judge::{OmegaAxes, QuaternionOrder};
/// use polhode_table::log;
/// let text = "# engine = \"MuJoCo, RK4\"\ntime_ms,qx,qy,qz,qw,gyro_x,gyro_y,gyro_z,note\n\
///     0,0,0,0.6,0.8,0,1,2,a\n250,0,0.6,0,0.8,0,1,2,b\n";
/// let read = log::from_bytes(text.as_bytes(), None)?;
/// assert_eq!(read.log.times(), [0.0, 0.25]);
/// assert_eq!(read.log.attitude()[0], [0.0, 0.0, 0.6, 0.8]);
/// assert_eq!(read.says.order, Some(QuaternionOrder::ScalarLast));
/// assert_eq!(read.says.omega_axes, Some(OmegaAxes::Body));
/// assert_eq!(read.engine.as_deref(), Some("MuJoCo, RK4"));
/// assert_eq!(read.ignored, ["note"]);
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// Same as [`read()`].
pub fn from_bytes(bytes: &[u8], columns: Option<&Columns>) -> Result<RunLog, ContentError> {
    let (head, plan, rows) = numbers(&Bytes::copy_from_slice(bytes), columns, Wanted::Attitude)?;
    finished(head, plan, rows)
}

fn numbers(bytes: &Bytes, columns: Option<&Columns>, wanted: Wanted) -> Result<Numbers, ContentError> {
    if bytes.starts_with(PARQUET) {
        return parquet::read(bytes.clone(), columns, wanted);
    }
    of_text(&**bytes, Some(bytes.len() as u64), columns, wanted).map_err(|failure| match failure {
        Failure::Content(error) => error,
        Failure::Io(error) => {
            let kind = ContentErrorKind::Unsupported { what: format!("these bytes ({error})") };
            ContentError::new(kind, ContentPlace::Whole)
        }
    })
}

/// Reads a log from text. `length` is its number of bytes, if known.
fn of_text(
    stream: impl Read,
    length: Option<u64>,
    told: Option<&Columns>,
    wanted: Wanted,
) -> Result<Numbers, Failure> {
    let blocks = Blocks::new(stream)?;
    let text = blocks.first();
    if let Some(error) = foreign::refusal(text) {
        return Err(error.into());
    }
    if is_json(text) {
        let opening = json_lines::opening(text, told.unwrap_or(&Columns::default()))?;
        let columns = told.or(opening.head.columns.as_ref()).cloned().unwrap_or_default();
        let mut plan = choice::choose(&opening.header, &columns, &opening.head.units, wanted)?;
        let objects = json_lines::Objects::new(&plan, &opening);
        let rows = blocks.rows(opening.rows, length, &plan, &objects)?;
        let others = objects.others();
        plan.ignored.extend(others);
        return Ok((opening.head, plan, rows));
    }
    let opening = csv::opening(text, told.is_some())?;
    let columns = told.or(opening.head.columns.as_ref()).cloned().unwrap_or_default();
    let mut plan = choice::choose(&opening.header, &columns, &opening.head.units, wanted)?;
    plan.has_commas = opening.separator == Separator::Byte(b',');
    let rows = blocks.rows(opening.rows, length, &plan, &csv::Table::new(&plan, &opening))?;
    Ok((opening.head, plan, rows))
}

fn is_json(text: &[u8]) -> bool {
    let unmarked = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    unmarked.trim_ascii_start().starts_with(b"{")
}

/// Quantities that the columns of a log have by their names, complete or not.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NamedQuantities {
    /// True if the log has attitudes, or columns that may be attitudes.
    pub attitude: bool,
    /// True if the log has angular velocities.
    pub omega: bool,
    /// Scenario that the log states, as a path relative to the log.
    pub scenario: Option<PathBuf>,
}

/// Returns the quantities in a log in text. Without a time it has none.
pub fn named_quantities(text: &[u8]) -> NamedQuantities {
    let opened = match is_json(text) {
        true => json_lines::opening(text, &Columns::default()).map(|opening| (opening.head, opening.header)),
        false => csv::opening(text, false).map(|opening| (opening.head, opening.header)),
    };
    let Ok((head, header)) = opened else { return NamedQuantities::default() };
    let told = head.columns.is_some();
    let names: Vec<Name> = header.names.iter().filter_map(|name| Name::of(name)).collect();
    let has = |kind| names.iter().any(|name| name.kind == kind);
    let is_log = has(Kind::Time);
    // Plain x, y and z are a position; with w they are a quaternion.
    let is_attitude = |name: &Name| {
        name.kind == Kind::Attitude && !(name.group.is_empty() && ["x", "y", "z"].contains(&&*name.label))
    };
    NamedQuantities {
        attitude: told || is_log && (names.iter().any(is_attitude) || has(Kind::Euler)),
        omega: is_log && has(Kind::Omega),
        scenario: head.scenario,
    }
}

fn finished(head: Head, plan: Plan, rows: Rows) -> Result<RunLog, ContentError> {
    let log = MotionLog::new(rows.times, rows.attitude);
    let log = match plan.omega {
        Some(_) => log.and_then(|log| log.with_omega(rows.omega)),
        None => log,
    };
    let log = log.map_err(|error| {
        let (value, hint) = match error {
            LogError::TooShort { rows } => (format!("{rows} rows"), "log the motion until its end"),
            _ => ("its numbers".to_owned(), "check the units"),
        };
        let (what, rule) = ("the log".to_owned(), format!("a motion: {error}"));
        ContentError::new(ContentErrorKind::Value { what, value, rule }, ContentPlace::Whole).hint(hint)
    })?;
    Ok(RunLog {
        log,
        says: plan.says,
        scenario: head.scenario,
        step: head.step,
        engine: head.engine,
        read: plan.read,
        ignored: plan.ignored,
        ignored_keys: head.ignored,
    })
}
