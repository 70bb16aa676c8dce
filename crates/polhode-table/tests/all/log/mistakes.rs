//! Refusals, with their places.

use super::{read, refused};

#[test]
fn each_mistake_has_its_line_and_says_what_to_do() {
    let head = "t,qw,qx,qy,qz,wx,wy,wz\n# a comment\n\n0,1,0,0,0,1,2,3\n";
    let row = "1,1,0,0,0,1,2,3\n";
    for (rows, column, message, hint) in [
        ("1,1,0,,0,1,2,3\n", 7, "expected a number as qy of row 2, found \"nothing\"", "--columns"),
        ("1,1,0,x1,0,1,2,3\n", 7, "expected a number as qy of row 2, found \"x1\"", "0.25"),
        ("1,1,0,NaN,0,1,2,3\n", 7, "qy of row 2 = NaN must be finite", "cut the log off"),
        ("1,1,0,-inf,0,1,2,3\n", 7, "qy of row 2 = -inf must be finite", "cut the log off"),
        ("1,1,0,1e999,0,1,2,3\n", 7, "qy of row 2 = 1e999 must be finite", "cut the log off"),
        (
            "1,1,0,0,0,1,2\n",
            1,
            "row 2 = 1,1,0,0,0,1,2 must be 8 fields long, like the header; it has 7",
            "did not finish this line",
        ),
        (
            "1,1,0,0,0,1,2,3,4\n",
            1,
            "row 2 = 1,1,0,0,0,1,2,3,4 must be 8 fields long, like the header; it has 9",
            "decimal",
        ),
        (
            "0,1,0,0,0,1,2,3\n",
            1,
            "the time of row 2 = 0 s must be later than 0 s, that of the row before",
            "digits",
        ),
        (
            "-1,1,0,0,0,1,2,3\n",
            1,
            "the time of row 2 = -1 s must be later than 0 s, that of the row before",
            "cut it apart",
        ),
        (
            "1,0,0,-0.0,0,1,2,3\n",
            1,
            "the quaternion of row 2 = 0, 0, 0, 0 must be other than zero",
            "no attitude",
        ),
        ("1,1,0,\"0,0,1,2,3\n", 7, "expected a closing quote, found \"\\\"0,0,1,2,3\"", "on its line"),
        ("1,1,0,0 0,0,1,2,3\n", 7, "expected a number as qy of row 2, found \"0 0\"", "0.25"),
    ] {
        let error = refused(format!("{head}{rows}{row}"));
        assert_eq!(error.message(), message, "{rows}");
        let place = error.place().unwrap();
        assert_eq!((place.line, place.column), (5, column), "{rows}");
        assert!(error.hint().unwrap().contains(hint), "{rows}: {:?}", error.hint());
        // Only that line is refused.
        read(format!("{head}{row}"));
    }
}

#[test]
fn a_key_of_the_head_stands_once() {
    let rows = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n";
    read(format!("# step = 0.1\n# note = a\n# note = b\n{rows}"));
    for (head, key) in [
        ("# step = 0.1\n# step = 0.2\n", "step"),
        ("# engine = a\n# polhode.engine = b\n", "engine"),
        ("# scenario = a.toml\n# scenario = a.toml\n", "scenario"),
        ("# units = ms\n# units = s\n", "units"),
    ] {
        let error = refused(format!("{head}{rows}"));
        assert!(
            error.message().contains(key) && error.message().ends_with("given once"),
            "{}",
            error.message()
        );
        assert_eq!(error.place().unwrap().line, 2);
    }
}

/// A key below the line of names is not read. It is an error, so that it is not ignored silently.
#[test]
fn a_key_below_the_header_is_refused() {
    let head = "t,qw,qx,qy,qz\n0,1,0,0,0\n# a comment = of several words\n";
    let row = "1,0.8,0.6,0,0\n";
    read(format!("{head}{row}"));
    for line in ["# step = 0.1\n", "## scenario = a.toml\n", "# note = a\n"] {
        let error = refused(format!("{head}{line}{row}"));
        assert!(error.message().contains("must be above the header"), "{}", error.message());
        assert_eq!(error.place().unwrap().line, 4);
    }
}

#[test]
fn a_key_of_an_object_stands_once() {
    let first = "{\"t\": 0, \"q\": [1, 0, 0, 0]}\n";
    read(format!("{first}{{\"t\": 1, \"q\": [1, 0, 0, 0]}}\n"));
    for line in [
        "{\"t\": 1, \"q\": [1, 0, 0, 0], \"t\": 2}\n",
        "{\"t\": 1, \"q\": [1, 0, 0, 0], \"pose\": {\"x\": 1, \"x\": 2}}\n",
    ] {
        let error = refused(format!("{first}{line}"));
        assert!(error.message().contains("duplicate key"), "{}", error.message());
        assert_eq!(error.place().unwrap().line, 2);
    }
}

#[test]
fn decimal_commas_are_refused_with_a_hint() {
    let error = refused("t;qw;qx;qy;qz\n0;1;0;0;0\n0,5;1;0;0;0\n");
    assert_eq!(error.message(), "expected a number as t of row 2, found \"0,5\"");
    assert!(error.hint().unwrap().contains("write decimal points"));
    let error = refused("t,qw,qx,qy,qz\n0,0,1,0,0,0,0,0,0,0\n0,5,1,0,0,0,0,0,0,0\n");
    assert!(error.hint().unwrap().contains("decimal mark is a point"), "{:?}", error.hint());
}

#[test]
fn files_that_are_no_log_are_refused() {
    for (text, message) in [
        ("", "the file has no rows"),
        ("# nothing\n\n", "the file has no rows"),
        ("t,qw,qx,qy,qz\n", "0 rows must be a motion"),
        ("t,qw,qx,qy,qz\n0,1,0,0,0\n", "1 rows must be a motion"),
        ("t,qw,qx,qy,qz\ns,-,-,-,-\n0,1,0,0,0\n", "expected a number as t of row 1, found \"s\""),
        ("t,qw,qx,qy,qz\r0,1,0,0,0\r1,1,0,0,0\r", "lines that end in \\r alone"),
        ("[{\"t\": 0}]", "one array of JSON"),
        ("{\"a\": 1}\n", "the file has no rows with a time"),
        ("{\"a\": 1}\n{\"b\": 1}\n", "the file has no column of the time"),
        ("{\"t\": 0, \"q\": [1,0,0,0]}\n{\"t\": 1, \"q\": [1,0,0]}\n", "the file has no q[3] of row 2"),
        ("{\"t\": 0, \"q\": [1,0,0,0]}\n{\"t\": 1, \"q\": [1,0,0,null]}\n", "found \"null\""),
        ("{\"t\": 0, \"q\": [1,0,0,0]}\n{\"t\": 1, \"q\": [1,0,0,NaN]}\n", "a line of JSON: expected value"),
        ("{\"t\": 0, \"q\": [1,0,0,NaN]}\n", "expected an object of JSON (expected value)"),
        ("PAR1 and no more", "this Parquet file"),
        ("PK\u{3}\u{4}", "archives"),
    ] {
        let error = refused(text);
        assert!(error.message().contains(message), "{text:?}: {error}");
        assert!(error.hint().is_some(), "{text:?}");
    }
    let utf16: Vec<u8> = "t,qw,qx,qy,qz\n0,1,0,0,0\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert!(refused(utf16).message().contains("UTF-16"));
    let json = refused("{\"t\": 0, \"q\": [1,0,0,0]}\n\n{\"t\": 1, \"q\": [1,0,0,NaN]}\n");
    assert_eq!(json.place().map(|place| (place.line, place.column)), Some((3, 22)));
}
