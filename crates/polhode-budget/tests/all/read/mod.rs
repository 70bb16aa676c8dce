//! Reading of parts lists: statements of columns and heads, and refusals with their places.

mod book;
mod confined;
mod forms;
mod joined;
mod limits;
mod liquids;
mod refusals;
mod sections;
mod signs;
mod tanks;
mod workbook;
mod workbook_file;

use std::fs;
use std::path::{Path, PathBuf};

use polhode::math::Body;
use polhode_budget::read::{BudgetFile, from_text, read};
use polhode_budget::{Basis, Budget, Estimate};
use polhode_source::FormatError;

/// Temporary folder, which is removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("polhode-budget-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn write(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, bytes).unwrap();
        path
    }

    /// Returns the message and the hint of an error, without the folder.
    fn message(&self, error: &FormatError) -> String {
        let folder = format!("{}/", self.0.display());
        let hint = error.hint().unwrap_or_default();
        format!("{error} | {hint}").replace(&folder, "")
    }

    fn read(&self, name: &str, bytes: impl AsRef<[u8]>) -> Result<BudgetFile, String> {
        read(&self.write(name, bytes)).map_err(|error| self.message(&error))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn csv(text: &str) -> Result<BudgetFile, FormatError> {
    from_text(Path::new("list.csv"), text)
}

/// Returns the only budget of a list.
fn budget(text: &str) -> Budget {
    let file = csv(text).unwrap_or_else(|error| panic!("{error}\n{:?}\n{text}", error.hint()));
    assert_eq!(file.configurations.len(), 1);
    file.configurations[0].budget.clone()
}

fn estimate(budget: &Budget) -> Estimate<Body> {
    budget.estimate(Basis::Basic).unwrap()
}

/// Checks that two lists make the same body with the same errors, relative to the scale of each
/// number.
fn same(a: &Budget, b: &Budget, what: &str) {
    let (a, b) = (estimate(a), estimate(b));
    let numbers = |e: &Estimate<Body>| {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = e.properties.inertia().matrix();
        let mut all = vec![e.properties.mass()];
        all.extend(e.properties.center_of_mass().to_array());
        all.extend([xx, yy, zz, xy, xz, yz]);
        all
    };
    let close = |a: f64, b: f64, scale: f64| (a - b).abs() <= 1e-12 * scale + 1e-300;
    let (x, y) = (numbers(&a), numbers(&b));
    let length = x[1..4].iter().fold(0.0_f64, |l, c| l.max(c.abs()));
    let moment = x[4..7].iter().fold(0.0_f64, |l, c| l.max(c.abs()));
    for k in 0..10 {
        let scale = if k == 0 {
            x[0]
        } else if k < 4 {
            length
        } else {
            moment
        };
        assert!(close(x[k], y[k], scale), "{what}: number {k}, {} and {}", x[k], y[k]);
        for j in 0..10 {
            let scale = a.sd(k).max(b.sd(k)) * a.sd(j).max(b.sd(j));
            let (p, q) = (a.covariance[k][j], b.covariance[k][j]);
            assert!(close(p, q, 10.0 * scale), "{what}: covariance {k}, {j}, {p} and {q}");
        }
    }
}
