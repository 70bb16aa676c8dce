//! Pictures of the book, extracted from pages printed by commands.

use std::path::Path;

use super::{Scratch, stdout};

/// Returns the picture with this title from a page.
pub fn picture<'a>(page: &'a str, title: &str) -> &'a str {
    let at = page.find(&format!("<title>{title}")).unwrap_or_else(|| panic!("{title}"));
    let from = page[..at].rfind("<svg").unwrap();
    let to = at + page[at..].find("</svg>").unwrap() + "</svg>".len();
    &page[from..to]
}

/// Splits a picture into its text and its numbers.
fn parts(svg: &str) -> (String, Vec<f64>) {
    let is_number = |c: char| c.is_ascii_digit() || c == '.';
    let words = svg.split(is_number).filter(|word| !word.is_empty()).collect::<Vec<_>>().join("#");
    let all = svg.split(|c| !is_number(c)).filter(|digits| digits.chars().any(|c| c != '.'));
    (words, all.map(|digits| digits.parse().unwrap_or(f64::NAN)).collect())
}

/// Compares the pictures of the book with those on the pages of commands, given as (command, title,
/// file). `POLHODE_GOLDEN=write cargo test -p polhode-cli --test all books_pictures` updates the
/// files.
pub fn compare(scratch: &Scratch, pictures: &[(&[&str], &str, &str)]) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/figures");
    for (command, title, file) in pictures {
        let page = stdout(&scratch.run(command));
        let drawn = picture(&page, title).to_owned() + "\n";
        let path = folder.join(file);
        if std::env::var_os("POLHODE_GOLDEN").is_some() {
            std::fs::write(&path, &drawn).unwrap();
        }
        let kept =
            std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let ((words, numbers), (kept_words, kept_numbers)) = (parts(&drawn), parts(&kept));
        assert_eq!(words, kept_words, "{file}");
        // Coordinates may differ by a rounding of 0.01 px.
        let far = numbers.iter().zip(&kept_numbers).filter(|(a, b)| !((*a - *b).abs() < 0.06)).count();
        assert!(numbers.len() == kept_numbers.len() && far == 0, "{file}: {far} numbers differ");
    }
}
