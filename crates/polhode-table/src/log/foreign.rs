//! Detection of other file formats to which programs write logs.

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

/// First bytes of a format, its name, and a hint.
const FOREIGN: [(&[u8], &str, &str); 9] = [
    (b"\x89HDF", "HDF5 files", "write the columns as CSV or Parquet: pandas.read_hdf(FILE).to_parquet(NEW)"),
    (
        b"MATLAB 5.0",
        "MAT files",
        "write the table as CSV: writetable(array2table(log, VariableNames=names), FILE)",
    ),
    (b"PK\x03\x04", "archives, such as those of Excel and NumPy", "export the table as CSV"),
    (
        b"\x93NUMPY",
        "NumPy arrays without names",
        "write a CSV with names: numpy.savetxt(FILE, log, delimiter=\",\", header=\"t,qw,qx,qy,qz\")",
    ),
    (b"#ROSBAG", "bags of ROS", "export the topic as CSV: rostopic echo -b FILE -p /TOPIC"),
    (b"\x89MCAP", "MCAP files", "export the topic as CSV or JSON lines"),
    (b"SQLite format 3", "databases", "export the table as CSV"),
    (b"\x1f\x8b", "compressed text", "unpack it: gunzip FILE"),
    (b"ULog", "logs of PX4", "export the topic as CSV: ulog2csv FILE"),
];

/// Returns the error for a file in another format, or `None`.
pub(crate) fn refusal(bytes: &[u8]) -> Option<ContentError> {
    let refused = |what: &str, hint: &str| {
        let kind = ContentErrorKind::Unsupported { what: what.to_owned() };
        ContentError::new(kind, ContentPlace::Whole).hint(hint)
    };
    let foreign = FOREIGN.iter().find(|(start, ..)| bytes.starts_with(start));
    let array = bytes.trim_ascii_start().starts_with(b"[").then(|| {
        let hint = "write an object for each row in a line of its own: to_json(FILE, orient=\"records\", lines=True) in pandas";
        refused("one array of JSON as a log", hint)
    });
    foreign.map(|(_, what, hint)| refused(what, hint)).or(array)
}
