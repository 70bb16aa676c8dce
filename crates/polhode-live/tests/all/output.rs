//! The page as one file with its files inside.

use std::io::Read as _;

use flate2::read::ZlibDecoder;
use polhode_live::{LiveOptions, page};
use serde_json::{Value, json};

use crate::client::{Folder, Pack, utf16};
use crate::models::{SCENARIO, model};

fn of(folder: &Folder, names: &[&str]) -> LiveOptions {
    let files = names.iter().map(|name| folder.0.join(name)).collect();
    LiveOptions { files, ..LiveOptions::default() }
}

/// Returns the text of a page and the pack in it.
fn read(options: &LiveOptions) -> (String, Pack) {
    let html = utf16(&page(options).unwrap());
    let begins = "<script type=\"application/octet-stream\" id=\"polhode-files\" data-length=\"";
    let (_, rest) = html.split_once(begins).unwrap();
    let (length, rest) = rest.split_once("\">").unwrap();
    let (text, _) = rest.split_once("</script>").unwrap();
    let bits =
        text.encode_utf16().flat_map(|code| (0..15).rev().map(move |bit| (code - 0x4000) >> bit & 1 == 1));
    let bits: Vec<bool> = bits.collect();
    let byte = |bits: &[bool]| bits.iter().fold(0, |byte, &bit| byte << 1 | u8::from(bit));
    let packed: Vec<u8> = bits.chunks_exact(8).map(byte).take(length.parse().unwrap()).collect();
    let mut bytes = Vec::new();
    ZlibDecoder::new(&packed[..]).read_to_end(&mut bytes).unwrap();
    assert!(!String::from_utf8_lossy(&bytes).contains(std::env::temp_dir().to_str().unwrap()));
    let pack = Pack::parse(&bytes);
    (html, pack)
}

#[test]
fn a_page_has_its_files_inside_with_paths_below_their_common_folder() {
    let folder = model("output");
    let (html, pack) = read(&of(&folder, &["scenarios/one.toml", "urdf/arm.urdf"]));
    assert_eq!(pack.open, ["scenarios/one.toml", "urdf/arm.urdf"]);
    assert_eq!(pack.paths(), ["meshes/solid.obj", "package.xml", "scenarios/one.toml", "urdf/arm.urdf"]);
    assert_eq!(pack.files[2].1, SCENARIO.as_bytes());
    assert!(html.contains("connect-src 'none'") && !html.contains("<!--polhode-files-->"));
    let (_, mesh) = read(&of(&folder, &["meshes/solid.obj"]));
    assert_eq!((mesh.open, mesh.files.len()), (vec!["solid.obj".to_owned()], 1));
    let (_, none) = read(&LiveOptions::default());
    assert_eq!((none.open.len(), none.lesson, none.files.len()), (0, Value::Null, 0));
}

#[test]
fn a_page_of_a_lesson_names_it() {
    let folder = model("output-lesson");
    let lesson =
        "title = \"A\"\nsummary = \"B.\"\nscenario = \"scenarios/one.toml\"\n[[step]]\ntext = \"C.\"\n";
    let own = folder.file("mine.toml", lesson).to_str().unwrap().to_owned();
    let (_, pack) = read(&LiveOptions { lesson: Some(own), ..LiveOptions::default() });
    assert_eq!(pack.lesson, json!({ "path": "mine.toml" }));
    assert_eq!(pack.paths(), ["meshes/solid.obj", "mine.toml", "scenarios/one.toml"]);
    let (_, pack) = read(&LiveOptions { lesson: Some("racket".to_owned()), ..LiveOptions::default() });
    assert_eq!((pack.lesson, pack.files.len()), (json!({ "id": "racket" }), 0));
}

#[test]
fn a_file_that_is_named_by_its_absolute_path_is_refused() {
    let folder = model("absolute");
    let mesh = folder.path("meshes/solid.obj");
    folder.file("scenarios/absolute.toml", SCENARIO.replace("../meshes/solid.obj", &mesh));
    let error = page(&of(&folder, &["scenarios/absolute.toml"])).unwrap_err();
    assert!(error.to_string().contains(&mesh) && error.hint().unwrap().contains("relative"), "{error}");
}

#[test]
#[cfg(unix)]
fn a_link_in_a_path_does_not_lead_out_of_the_page() {
    let folder = model("output-links");
    std::os::unix::fs::symlink(folder.0.join("meshes"), folder.0.join("urdf/meshes")).unwrap();
    let robot = "<robot name=\"r\"><link name=\"a\"><visual><geometry><mesh filename=\"meshes/solid.obj\"/></geometry></visual></link></robot>";
    folder.file("urdf/linked.urdf", robot);
    std::fs::remove_file(folder.0.join("package.xml")).unwrap();
    let (_, pack) = read(&of(&folder, &["urdf/linked.urdf"]));
    assert_eq!((pack.open, pack.files.len()), (vec!["linked.urdf".to_owned()], 2));
    assert!(pack.files.iter().any(|(path, _)| path == "meshes/solid.obj"));
}
