//! The page and its files as they are served.

use polhode_live::{Live, LiveError, LiveOptions, lessons};
use serde_json::{Value, json};

use crate::client::{Folder, Page, repository};
use crate::models::{SCENARIO, SOLID, model};

#[test]
fn the_page_requests_its_files_from_its_own_address() {
    let page = Page::open(&[]);
    let html = page.get("");
    assert_eq!((html.status, html.headers["content-type"].as_str()), (200, "text/html; charset=utf-16le"));
    let text = html.text();
    assert!(
        text.contains("<meta name=\"polhode-files\" content=\"files\">")
            && !text.contains("<!--polhode-files-->")
    );
    assert!(text.contains("connect-src 'self'") && !text.contains("connect-src 'none'"));
    assert_eq!(html.headers["content-length"], html.body.len().to_string());
    let head = page.request("HEAD", "", "");
    assert_eq!((head.status, &head.headers, head.body.len()), (200, &html.headers, 0));
    // Without a file and a lesson the page opens its example.
    let pack = page.pack();
    assert_eq!((pack.open, pack.lesson, pack.files), (Vec::new(), Value::Null, Vec::new()));
}

#[test]
fn the_pack_has_the_named_files_and_all_files_that_they_name() {
    let folder = model("pack");
    let [scenario, robot] = ["scenarios/one.toml", "urdf/arm.urdf"].map(|name| folder.0.join(name));
    let pack = Page::open(&[robot, scenario]).pack();
    assert_eq!(pack.open, [folder.path("urdf/arm.urdf"), folder.path("scenarios/one.toml")]);
    let expected = ["meshes/solid.obj", "package.xml", "scenarios/one.toml", "urdf/arm.urdf"];
    assert_eq!(pack.paths(), expected.map(|name| folder.path(name)));
    assert_eq!([0, 2].map(|k| &pack.files[k].1[..]), [SOLID, SCENARIO].map(str::as_bytes));
    // A relative path is that of the same file.
    let example = Page::open(&["../../examples/t-handle.toml".into()]).pack();
    let path = std::fs::canonicalize(repository("examples/t-handle.toml")).unwrap();
    assert_eq!((example.open, example.files.len()), (vec![path.to_str().unwrap().to_owned()], 1));
}

#[test]
fn what_is_wrong_in_a_file_is_shown_on_the_page() {
    let folder = model("wrong");
    let wrong = SCENARIO.replace("[[body.part]]", "[[body.part]]\nshape = \"spere\"\n[[body.part]]");
    for (name, bytes) in [
        ("scenarios/part.toml", wrong.as_bytes()),
        ("scenarios/none.toml", b"[[[" as &[u8]),
        ("urdf/none.urdf", b"<robot"),
        ("urdf/gone.urdf", b"<robot name=\"r\"><link name=\"a\"><visual><geometry><mesh filename=\"gone.stl\"/></geometry></visual></link></robot>"),
    ] {
        let path = folder.file(name, bytes);
        let pack = Page::open(&[path]).pack();
        assert_eq!(pack.open, [folder.path(name)]);
        assert!(pack.files.contains(&(folder.path(name), bytes.to_vec())), "{name}");
        // The mesh named after a wrong part is there for a text that is corrected on the page.
        let others: Vec<_> = pack.paths().into_iter().filter(|path| *path != folder.path(name)).collect();
        let expected = match name {
            "scenarios/part.toml" => vec![folder.path("meshes/solid.obj")],
            "scenarios/none.toml" => vec![],
            _ => vec![folder.path("package.xml")],
        };
        assert_eq!(others, expected, "{name}");
    }
}

#[test]
#[cfg(unix)]
fn a_file_is_at_every_path_under_which_it_is_looked_for() {
    let folder = model("links");
    let link =
        |from: &str, to: &str| std::os::unix::fs::symlink(folder.0.join(from), folder.0.join(to)).unwrap();
    std::fs::create_dir(folder.0.join("linked")).unwrap();
    link("meshes", "linked/meshes");
    link("package.xml", "linked/package.xml");
    link("urdf", "linked/urdf");
    let pack = Page::open(&[folder.0.join("linked/urdf/arm.urdf")]).pack();
    assert_eq!(pack.open, [folder.path("linked/urdf/arm.urdf")]);
    assert_eq!(shown_meshes(&pack.files, &pack.open[0]), 1);
}

/// Returns the number of shapes of a robot, read from these files only.
#[cfg(unix)]
fn shown_meshes(files: &[(String, Vec<u8>)], robot: &str) -> usize {
    let mut memory = polhode_source::files::Memory::default();
    files.iter().for_each(|(path, bytes)| memory.insert(path, bytes.as_slice()));
    let engine = polhode_web::Engine::default();
    let id = engine.open(robot.as_ref(), None, &memory, &|| true).unwrap().id;
    let message = json!({ "document": { "id": id } }).to_string();
    let answer: Value =
        serde_json::from_slice(&engine.answer(message.as_bytes(), &memory, &|| true)).unwrap();
    answer["robot"]["links"][0]["shapes"].as_array().unwrap().len()
}

#[test]
fn a_lesson_is_named_and_a_file_of_ones_own_has_its_scenario() {
    let of = |lesson: &str| LiveOptions { lesson: Some(lesson.to_owned()), ..LiveOptions::default() };
    for info in lessons() {
        let pack = Page::of(&of(&info.id)).pack();
        assert_eq!((pack.lesson, pack.files.len()), (json!({ "id": info.id }), 0));
    }
    let folder = model("lesson");
    let lesson =
        "title = \"A\"\nsummary = \"B.\"\nscenario = \"scenarios/one.toml\"\n[[step]]\ntext = \"C.\"\n";
    folder.file("mine.toml", lesson);
    let pack = Page::of(&of(&folder.path("mine.toml"))).pack();
    assert_eq!((&pack.lesson, pack.open.len()), (&json!({ "path": folder.path("mine.toml") }), 0));
    let expected = ["meshes/solid.obj", "mine.toml", "scenarios/one.toml"];
    assert_eq!(pack.paths(), expected.map(|name| folder.path(name)));
    let wrong = folder.file("wrong.toml", lesson.replace("[[step]]", "[[stop]]"));
    let error = Live::bind(&of(wrong.to_str().unwrap())).unwrap_err();
    assert!(matches!(&error, LiveError::Lesson(error) if error.place == Some([4, 3])), "{error}");
    let error = Live::bind(&of("cubes")).unwrap_err();
    assert!(error.to_string().contains("unknown lesson"), "{error}");
}

#[test]
fn a_client_that_has_the_files_gets_no_more() {
    let page = Page::open(&[repository("examples/t-handle.toml")]);
    let first = page.get("files");
    let etag = &first.headers["etag"];
    let known = page.request("GET", "files", &format!("If-None-Match: {etag}\r\n"));
    assert_eq!((known.status, &known.headers["etag"], known.body.len()), (304, etag, 0));
    let other = page.request("GET", "files", "If-None-Match: \"0\"\r\n");
    assert_eq!((other.status, other.body), (200, first.body));
    let head = page.request("HEAD", "files", "");
    assert_eq!((head.status, &head.headers, head.body.len()), (200, &first.headers, 0));
}

#[test]
fn only_the_page_and_its_files_have_an_address() {
    let page = Page::open(&[]);
    for path in ["files/", "files?a", "document/0", "polhode.html", "../", "etc/passwd", "live.js"] {
        assert_eq!(page.get(path).status, 404, "{path}");
    }
    for method in ["POST", "PUT", "DELETE", "OPTIONS", "TRACE"] {
        let refused = page.request(method, "files", "");
        assert_eq!((refused.status, refused.headers["allow"].as_str()), (405, "GET, HEAD"));
    }
    assert_eq!(page.request("POST", "files", "Content-Length: 5\r\n\r\nabcde").status, 413);
}

#[test]
fn a_file_that_cannot_be_shown_is_an_error() {
    let folder = Folder::new("refused");
    folder.file("notes.txt", "private");
    folder.file("torn.stl", "solid");
    folder.file("folder.toml/a", "");
    for (name, says) in [
        ("gone.toml", "\"gone.toml\" cannot be read"),
        ("notes.txt", "\"notes.txt\" cannot be read: its file extension is unknown"),
        ("torn.stl", "\"torn.stl\" cannot be read"),
        ("folder.toml", "folder.toml cannot be read: it is not a regular file"),
    ] {
        let options = LiveOptions { files: vec![folder.0.join(name)], ..LiveOptions::default() };
        let error = Live::bind(&options).unwrap_err();
        assert!(error.to_string().contains(says), "{error}");
    }
}
