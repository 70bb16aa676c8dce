//! Accuracy page of the book, measured against references of at least 30 digits.
//!
//! `POLHODE_GOLDEN=write cargo test -p polhode --test all accuracy` rewrites `book/accuracy.md`.
//! Review the difference.

mod distant;
mod elliptic;
mod exact;
mod free_motion;
mod meshes;
mod page;
mod principal_axes;
mod random;

use std::path::Path;

/// All measurements of the page.
struct Measured {
    groups: [free_motion::Worst; free_motion::GROUPS.len()],
    distant: Vec<f64>,
    functions: [elliptic::Function; elliptic::FUNCTIONS.len()],
    meshes: Vec<meshes::Row>,
    axes: [principal_axes::Worst; principal_axes::GROUPS.len()],
}

impl Measured {
    fn new() -> Self {
        Self {
            groups: free_motion::measured(),
            distant: distant::measured(),
            functions: elliptic::measured(),
            meshes: meshes::measured(),
            axes: principal_axes::measured(),
        }
    }

    /// Checks that every number is within its bound.
    fn require_promised(&self) {
        for ((name, _), worst) in free_motion::GROUPS.iter().zip(&self.groups) {
            assert!(worst.cases > 0, "no case in {name}");
            for error in worst.omega.into_iter().chain(worst.attitude) {
                assert!(error <= free_motion::PROMISED, "{name}: {error:e}");
            }
        }
        for (name, function) in elliptic::FUNCTIONS.iter().zip(&self.functions) {
            assert!(function.values > 0 && function.ulps <= 3.0, "{name}: {} ulp", function.ulps);
        }
        for mesh in &self.meshes {
            for error in mesh.errors.into_iter().flatten() {
                assert!(error <= meshes::PROMISED, "{} triangles: {error:e}", mesh.triangles);
            }
        }
        for ((name, _), worst) in principal_axes::GROUPS.iter().zip(&self.axes) {
            for error in [worst.rebuilt, worst.orthonormal] {
                assert!(error <= principal_axes::PROMISED, "{name}: {error:e}");
            }
        }
    }
}

#[test]
fn the_page_says_what_is_measured() {
    let measured = Measured::new();
    let got = page::page(&measured);
    measured.require_promised();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/accuracy.md");
    if std::env::var_os("POLHODE_GOLDEN").is_some() {
        std::fs::write(&path, &got).unwrap();
    }
    let want = std::fs::read_to_string(&path).unwrap_or_default();
    for (k, (got, want)) in got.lines().zip(want.lines()).enumerate() {
        assert_eq!(got, want, "book/accuracy.md, line {}", k + 1);
    }
    assert_eq!(got.lines().count(), want.lines().count(), "book/accuracy.md: lines are missing or new");
}
