//! The log of a motion, as another program wrote it: times, attitudes and perhaps angular velocities, in CSV, Parquet or JSON lines.
//!
//! The contents of a file decide its format. Text has a line of names, then a line for each time; commas,
//! semicolons, tabs or blanks separate the fields, and the decimal mark is a point. Lines that begin
//! with `#` are for people, except `# key = value` above the names; below them such a line is an
//! error.
//!
//! | key | says |
//! |---|---|
//! | `scenario` | the scenario that the program was to compute, a path relative to the log |
//! | `step` | the program's time step, in s or with a unit |
//! | `engine` | which program, in words |
//! | `units` | units of columns whose names have none: `ms, deg, deg/s`, or `SI` |
//! | `columns` | what the columns are, in the notation below |
//!
//! JSON lines have an object for each time, with numbers, arrays (`"q": [1, 0, 0, 0]`, of which the first is called `q[0]`) and objects (of
//! which a member is called `orientation.w`); a first line without a time is the head. Parquet has the keys in the file's metadata, as
//! `polhode.scenario` and so on.
//!
//! # Columns by their names
//!
//! | thing | names |
//! |---|---|
//! | time | `t`, `time`, `time_s`, `sim_time_ms`; `timestamp` with a unit |
//! | quaternion | `attitude_w` …, `qw` …, `orientation.w` …: w, x, y, z by their letters, scalar
//! last if the columns are x, y, z, w; `q0` … `q3`: in an order that is not known |
//! | matrix | `r11` … `r33`, `R_00` … `R_22`, `R[0][0]` …, `xmat_0` … `xmat_8`: row by row |
//! | Euler angles | `roll`, `pitch`, `yaw` (3-2-1), `precession`, `nutation`, `spin` (3-1-3); of others the sequence is not known |
//! | angular velocity | `wx` …, `gyro_x` …, `angular_velocity.x` …; `omega_body_x` along body axes, `omega_world_x` along those of space |
//!
//! Other words may stand before a name (`robot.qw`), and a unit behind it (`wx_deg_s`, `wx [deg/s]`). A time is in s and an angular velocity
//! in rad/s if nothing else is said; angles need a unit. What a name leaves open stays open ([`RunLog::says`]); where two sets of columns are as
//! likely, or a set is not complete, the file is refused. Angular velocities along body axes are taken rather than those along space
//! axes. Columns that are not read are listed in [`RunLog::ignored`].
//!
//! # Columns as a user names them
//!
//! [`Columns::parse`] reads parts with commas between them, each of which says what columns are, `=`, and which columns:
//!
//! ```text
//! time ms = t, quaternion xyzw body-to-space = q0 q1 q2 q3, omega space deg/s = w1 w2 w3
//! ```
//!
//! | part | words | columns |
//! |---|---|---|
//! | `time`, `t` | a unit | one |
//! | `quaternion`, `q` | `wxyz`, `xyzw`; `body-to-space`, `space-to-body` | four, in the order of the words |
//! | `matrix`, `R` | `body-to-space`, `space-to-body` | nine, row by row |
//! | `euler`, `e` | `3-2-1`, `zyx` or another sequence; `extrinsic`; `deg`, `rad`; the sense | three, in the order of the turns |
//! | `omega`, `w` | `body`, `space`; a unit | three, or `none` |
//!
//! Columns have blanks between them; a name with blanks or commas stands in quotes. `q0..q3` are the columns from the one to the other, and
//! `q` is the array `q` of JSON lines. A file of numbers only has the columns `1`, `2`, and so on. What the words say holds, whatever the names
//! say; what they leave open is left to the names, and so is each of the three that has no part.

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
use rows::Rows;

pub use columns::{Columns, ColumnsError};
pub use matrix::{MatrixError, matrix_quaternion};
pub use measured::MeasuredLog;

/// A log, and what it says of itself.
#[derive(Clone, Debug, PartialEq)]
pub struct RunLog {
    /// The motion, in SI. Attitudes that are no quaternions in the file are ones here.
    pub log: MotionLog,
    /// What its columns' names say without doubt, and its user.
    pub says: DeclaredReading,
    /// The scenario that it is of, as it says, relative to the log.
    pub scenario: Option<PathBuf>,
    /// The program's time step, s.
    pub step: Option<f64>,
    /// The program.
    pub engine: Option<String>,
    /// The columns that were read, and as what.
    pub read: Vec<ReadColumns>,
    /// Columns that were not read.
    pub ignored: Vec<String>,
    /// Keys of the head that mean nothing here.
    pub ignored_keys: Vec<String>,
}

impl RunLog {
    /// All that was not read: columns by their names, and keys of the head as `# key`.
    pub fn not_read(&self) -> Vec<String> {
        let keys = self.ignored_keys.iter().map(|key| format!("# {key}"));
        self.ignored.iter().cloned().chain(keys).collect()
    }
}

/// Columns that were read, and as what.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadColumns {
    /// `"angular velocity along body axes, deg/s"`
    pub what: String,
    /// Their names.
    pub columns: Vec<String>,
}

/// Reads a log; what the user says of its columns holds against what it says itself.
///
/// # Errors
/// [`FormatError`], with the place, if the file cannot be read, lacks columns or leaves open which they are, a row is not complete or
/// not finite, the time does not go on, or an attitude is none.
pub fn read(files: &dyn Files, path: &Path, columns: Option<&Columns>) -> Result<RunLog, FormatError> {
    of_file(files, path, columns, Wanted::Attitude, finished)
}

/// Reads what an instrument logged: angular velocities or attitudes, or both. As [`read()`] otherwise.
///
/// # Errors
/// As [`read()`].
pub fn read_measured(
    files: &dyn Files,
    path: &Path,
    columns: Option<&Columns>,
) -> Result<MeasuredLog, FormatError> {
    of_file(files, path, columns, Wanted::Either, |_, plan, rows| Ok(MeasuredLog::of(plan, rows)))
}

/// The numbers of a file, and what becomes of them.
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
        // The place of an error is shown with its line.
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

/// What a file says of itself, what its columns are, and its numbers.
type Numbers = (Head, Plan, Rows);

/// Reads a file of text block by block; `None` of one that has to be in memory as a whole.
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

/// What a Parquet file begins with.
pub const PARQUET: &[u8] = b"PAR1";

/// Reads a log from the bytes of a file.
///
/// ```
/// use polhode::infer::judge::{OmegaAxes, QuaternionOrder};
/// use polhode_table::log;
/// let text = "# engine = \"MuJoCo, RK4\"\ntime_ms,qx,qy,qz,qw,gyro_x,gyro_y,gyro_z,note\n0,0,0,0.6,0.8,0,1,2,a\n250,0,0.6,0,0.8,0,1,2,b\n";
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
/// As [`read()`].
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

/// Reads a log from text of some length.
fn of_text(
    stream: impl Read,
    length: Option<u64>,
    told: Option<&Columns>,
    wanted: Wanted,
) -> Result<Numbers, Failure> {
    let blocks = Blocks::new(stream)?;
    let text = blocks.first();
    let unmarked = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let is_json = unmarked.trim_ascii_start().starts_with(b"{");
    if let Some(error) = foreign::refusal(text) {
        return Err(error.into());
    }
    if is_json {
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
