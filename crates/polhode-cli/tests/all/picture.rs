//! The picture of the README is up to date with its program.
//!
//! `POLHODE_GOLDEN=write cargo test -p polhode-cli --test all picture` redraws it; look at it.

#[allow(dead_code, reason = "main is for cargo run")]
#[path = "../../examples/picture.rs"]
mod program;

use std::path::Path;

#[test]
fn the_picture_is_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let drawn = program::draw(&root.join("examples/t-handle.toml")).unwrap();
    let path = root.join("docs/t-handle.svg");
    if std::env::var_os("POLHODE_GOLDEN").is_some() {
        std::fs::write(&path, &drawn).unwrap();
    }
    // Git may change line ends.
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    for (k, (drawn, committed)) in drawn.lines().zip(committed.lines()).enumerate() {
        assert_eq!(drawn, committed, "docs/t-handle.svg, line {}", k + 1);
    }
    assert_eq!(
        drawn.lines().count(),
        committed.lines().count(),
        "docs/t-handle.svg: lines are missing or new"
    );
}
