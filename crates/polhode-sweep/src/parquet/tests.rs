#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use super::*;
use crate::batch::{Column, Values};

fn rows() -> Batch {
    let column = |name: &str, unit: &str, values| Column {
        name: name.to_owned(),
        unit: unit.to_owned(),
        description: format!("what \"{name}\" is"),
        values,
    };
    Batch::new(vec![
        column("member", "", Values::Whole(vec![7, 8, 9, 1 << 40])),
        column("x_m", "m", Values::Numbers(vec![-0.0, 1e-310, 3.5, f64::MAX])),
        column("period_s", "s", Values::Perhaps(vec![None, Some(2.5), None, Some(-1e9)])),
        column("cause", "", Values::Text(vec![None, Some("ω → ∞\n".to_owned()), Some(String::new()), None])),
        column("none", "s", Values::Perhaps(vec![None; 4])),
    ])
    .unwrap()
}

fn bytes(batch: &Batch, metadata: &Pairs) -> Vec<u8> {
    write(batch, metadata).unwrap()
}

#[test]
fn what_is_written_is_read() {
    let metadata = vec![("polhode.digest".to_owned(), "0123".to_owned())];
    let written = bytes(&rows(), &metadata);
    assert_eq!(written, bytes(&rows(), &metadata));
    assert_eq!(read::metadata(written.clone()).unwrap(), metadata);
    let batch = read::read(written).unwrap();
    assert_eq!(batch, rows());
    let Values::Numbers(x) = &batch.columns()[1].values else { panic!() };
    assert!(x[0].is_sign_negative());
}

#[test]
fn no_byte_of_a_file_can_change_unseen() {
    let metadata = vec![("polhode.digest".to_owned(), "0123".to_owned())];
    let written = bytes(&rows(), &metadata);
    assert!(is_sound(&written, &metadata));
    for k in 0..written.len() {
        let mut damaged = written.clone();
        damaged[k] ^= 0x10;
        assert!(!is_sound(&damaged, &metadata), "byte {k}");
        assert!(!is_sound(&written[..k], &metadata), "{k} bytes");
    }
    let other = vec![("polhode.digest".to_owned(), "0124".to_owned())];
    assert!(!is_sound(&written, &other));
}
