//! All refusals, with their places and messages.

mod besides;
mod rows;

use polhode_budget::Basis;

use super::Folder;
use besides::BESIDES;
use rows::ROWS;

#[test]
fn each_mistake_is_named_where_it_is() {
    let folder = Folder::new("refusals");
    folder.write("open.txt", "Mass = 2.50 kilograms\nno more\n");
    folder.write("bad.stl", "solid x\nfacet nonsense\n");
    let mut wrong = Vec::new();
    for (list, expected) in ROWS.iter().chain(BESIDES) {
        let found = match folder.read("list.csv", list) {
            Ok(_) => String::new(),
            Err(error) => error,
        };
        if !found.starts_with(expected) || expected.is_empty() != found.is_empty() {
            wrong.push(format!("{list}\n  found    {found}\n  expected {expected}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_hint_is_empty() {
    for (list, _) in ROWS.iter().chain(BESIDES) {
        if let Err(error) = super::csv(list) {
            assert_ne!(error.hint().as_deref(), Some(""), "{list}");
        }
    }
    let draws = super::budget("name,mass\na,1 ± 0.1\n").draws(Basis::Basic, 1, 5).unwrap_err();
    assert!(draws.hint().is_some_and(|hint| !hint.is_empty()));
}

#[test]
fn a_list_has_so_many_configurations_at_most() {
    let folder = Folder::new("many");
    let list = |count: usize| {
        let rows: String = (0..count).map(|k| format!("a,1,number {k}\n")).collect();
        folder.read("list.csv", format!("name,mass,configuration\n{rows}"))
    };
    assert_eq!(list(100).unwrap().configurations.len(), 100);
    let error = list(101).unwrap_err();
    assert!(
        error.starts_with("list.csv:102:1: polhode does not read more than 100 configurations"),
        "{error}"
    );
}

#[test]
fn an_error_in_a_file_says_where_it_is_named() {
    let folder = Folder::new("named");
    folder.write("bad.stl", "solid x\nfacet nonsense\n");
    folder.write("open.txt", "Mass = 2.50 kilograms\nno more\n");
    for (list, end) in [
        ("name,mass,mesh\na,1,bad.stl\n", "(named in list.csv:2:5)"),
        ("name,cad\na,open.txt\n", "(named in list.csv:2:3)"),
    ] {
        let error = folder.read("list.csv", list).unwrap_err();
        assert!(error.contains(end), "{error}");
    }
}

#[test]
fn other_files_are_named_for_what_they_are() {
    let folder = Folder::new("kinds");
    let compound = folder.read("old.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 and more").unwrap_err();
    assert!(compound.starts_with("old.xls: polhode does not read workbooks of this kind: XLS"), "{compound}");
    let latin = folder.read("latin.csv", b"name,mass\nst\xfctze,1\n").unwrap_err();
    assert!(latin.starts_with("latin.csv:2:3: the file is not valid UTF-8"), "{latin}");
    let wide = folder.read("wide.csv", b"\xff\xfen\0a\0m\0e\0").unwrap_err();
    assert!(wide.starts_with("wide.csv: the file is text in UTF-16"), "{wide}");
}
