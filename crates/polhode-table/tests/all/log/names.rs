//! Choice of columns if several are possible.

use polhode::infer::judge::{AttitudeSense, QuaternionOrder};
use polhode_table::log::{Columns, ColumnsError};

use super::{read, refused, told};

const TWO: &str = "0,1,0,0,0,5,6\n1,0.8,0.6,0,0,7,8\n";

#[test]
fn the_plain_name_comes_first_and_a_tie_is_refused() {
    let log = read(format!("time_s,qw,qx,qy,qz,target_qw,robot.time\n{TWO}"));
    assert_eq!(log.ignored, ["target_qw", "robot.time"]);
    assert_eq!(log.read[0].columns, ["time_s"]);
    for (header, message) in [
        ("time_s,qw,qx,qy,qz,time_ms,n", "the time = time_s; time_ms must be one thing: these are as likely"),
        ("t,a.qw,a.qx,a.qy,a.qz,n,m", ""),
        ("stamp,qw,qx,qy,qz,n,m", "in which unit is stamp? The file does not say"),
        ("t,qw,qx,qy,QW,qz,m", "the column = QW must be named once"),
        ("n,qw,qx,qy,qz,n,m", "the file has no column of the time"),
        ("t,qw,qx,qy,n,m,k", "the file has no column of z beside qw, qx, qy"),
        ("t,a,b,c,n,m,k", "the file has no columns of an attitude"),
        ("t,pitch [deg],n,m,k,l,yaw [deg]", "the file has no column of roll beside yaw [deg], pitch [deg]"),
    ] {
        let text = format!("{header}\n{TWO}");
        if message.is_empty() {
            assert_eq!(read(text).log.attitude()[1], [0.8, 0.6, 0.0, 0.0], "{header}");
        } else {
            let error = refused(text);
            assert_eq!(error.message(), message);
            assert_eq!(error.place().unwrap().line, 1);
        }
    }
    let two = "t,a.qw,a.qx,a.qy,a.qz,b.qw,b.qx,b.qy,b.qz\n0,1,0,0,0,1,0,0,0\n1,1,0,0,0,0,1,0,0\n";
    let hint = refused(two).hint().unwrap();
    assert_eq!(hint, "say which: --columns \"quaternion = a.qw a.qx a.qy a.qz\"");
    let said = told(two, "quaternion = b.qw b.qx b.qy b.qz").unwrap();
    assert_eq!(said.log.attitude()[1], [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(said.says.order, Some(QuaternionOrder::ScalarFirst));
}

#[test]
fn a_user_names_what_names_do_not_say() {
    let text = "tick;\"a, or so\";b;c;d\n0;0.6;0;0;0.8\n250;0;0.6;0.8;0\n";
    let log = told(text, "time ms = tick, q xyzw body-to-space = \"a, or so\" b c d").unwrap();
    assert_eq!(log.log.times(), [0.0, 0.25]);
    assert_eq!(log.log.attitude()[1], [0.0, 0.6, 0.8, 0.0]);
    assert_eq!(log.says.sense, Some(AttitudeSense::BodyToSpace));
    let nameless = "0 0.6 0 0 0.8\n0.25 0 0.6 0.8 0\n";
    assert_eq!(told(nameless, "t=1, q xyzw body-to-space = 2..5").unwrap().log, log.log);
    assert!(refused(nameless).message().contains("names of its columns"));
    let head = "# columns = \"t = tick, q wxyz = a b c d\"\n";
    let own = read(format!("{head}tick,a,b,c,d\n0,1,0,0,0\n1,0,1,0,0\n"));
    assert_eq!(own.says.order, Some(QuaternionOrder::ScalarFirst));
    let error = told(text, "t = tik, q = b b c d").unwrap_err();
    assert_eq!(error.hint.as_deref(), Some("did you mean tick?"));
    assert!(error.to_string().contains("tick, a, or so, b, c, d"), "{error}");
    let twice = "t,a,b,b,c\n0,1,0,0,0\n1,1,0,0,0\n";
    assert!(told(twice, "q wxyz = a b c c").unwrap_err().to_string().contains("b must be named once"));
    let error = told(text, "t = tick, q = b b c d").unwrap_err();
    assert!(error.to_string().contains("the column = b must be read as one thing"), "{error}");
    let error = told(text, "t = tick, q = b..d").unwrap_err();
    assert!(error.to_string().contains("4 columns; here are 3"), "{error}");
}

#[test]
fn the_notation_says_what_does_not_belong() {
    let error = |text: &str| Columns::parse(text).unwrap_err();
    assert_eq!(error("t"), ColumnsError::Form { part: "t".to_owned() });
    assert_eq!(error("t ="), ColumnsError::Form { part: "t =".to_owned() });
    assert_eq!(error("t = 'a"), ColumnsError::Quote);
    let key = |suggestion| ColumnsError::Key { key: "quatrenion".to_owned(), suggestion };
    assert_eq!(error("quatrenion = a b c d"), key(Some("quaternion")));
    assert_eq!(error("w = a b"), ColumnsError::Count { key: "omega", expected: 3, found: 2 });
    assert_eq!(error("q = a b c d, R = a..i"), ColumnsError::Twice { what: "the attitude" });
    for text in
        ["t deg = a", "q deg = a b c d", "e 3-3-1 = a b c", "w wxyz = a b c", "R rows = a..i", "t body = a"]
    {
        assert!(matches!(error(text), ColumnsError::Word { .. }), "{text}");
        assert!(!error(text).hint().is_empty());
    }
    assert_eq!(Columns::parse(" ; ,"), Ok(Columns::default()));
}
