//! `--plot`: files, errors, and the figures of the book.
//!
//! `POLHODE_GOLDEN=write cargo test -p polhode-cli --test all plot` redraws the figures of the
//! book; look at them.

use std::fs;
use std::path::Path;

use crate::common::{Scratch, example, refused, stdout};

#[test]
fn plots_are_written_beside_the_results() {
    let scratch = Scratch::new("plots");
    let scenario = example("t-handle.toml");
    let run = |more: &[&str]| {
        let all: Vec<&str> = ["simulate", &scenario, "-o", "out"].iter().chain(more).copied().collect();
        scratch.run(&all)
    };
    let text = stdout(&run(&["--plot", "all.svg", "--plot", "polhodes=fig/sphere.SVG"]));
    assert!(text.contains("\nwrote all.svg, fig/sphere.SVG\nopen out/report.html in a browser"), "{text}");
    assert_eq!(scratch.entries(), ["all.svg", "fig", "out"]);
    let svg = fs::read_to_string(scratch.0.join("all.svg")).unwrap();
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n") && svg.len() < 200_000);

    // If one target file exists, nothing is written; with permission to replace, all files are.
    fs::write(scratch.0.join("all.svg"), "old").unwrap();
    let text = refused(&scratch.run(&["simulate", &scenario, "--plot", "all.svg"]), 2);
    assert!(text.contains("all.svg already exists") && text.contains("--force"), "{text}");
    assert_eq!(fs::read_to_string(scratch.0.join("all.svg")).unwrap(), "old");
    assert_eq!(scratch.entries(), ["all.svg", "fig", "out"]);
    stdout(&run(&["--plot", "all.svg", "--force"]));
    assert_eq!(fs::read_to_string(scratch.0.join("all.svg")).unwrap(), svg);
}

#[test]
fn a_figure_that_there_is_not_is_refused_before_anything_is_written() {
    let scratch = Scratch::new("no-plots");
    let heavy = example("heavy-top.toml");
    let text = refused(&scratch.run(&["simulate", &heavy, "--plot", "a.svg", "--plot", "polhodes=b.svg"]), 2);
    assert!(text.contains("a torque acts on the body: it has no polhode"), "{text}");
    let prescribed = example("notes/11-10-dumbbell.toml");
    let text = refused(&scratch.run(&["simulate", &prescribed, "--plot", "drift=a.svg"]), 2);
    assert!(text.contains("prescribed"), "{text}");
    let spin = |plot: &str| {
        let flags = ["spin", "--moments", "1.3,2.7,3.1", "--omega", "0.3,-0.7,0.9", "--plot", plot];
        refused(&scratch.run(&flags), 2)
    };
    assert!(spin("torque=a.svg").contains("no torque acts"));
    assert!(spin("a.pdf").contains(".svg or .png"));
    assert!(spin("speed=a.svg").contains("the figures are omega"));
    let heavy = ["simulate", &heavy, "--plot", "a.svg", "--plot", "energy=a.svg"];
    assert!(refused(&scratch.run(&heavy), 2).contains("two plots"));
    assert!(scratch.entries().is_empty(), "{:?}", scratch.entries());
}

#[test]
fn a_spin_is_drawn_without_a_folder_and_a_pipe_has_no_picture() {
    let scratch = Scratch::new("spin-plots");
    let flags = ["spin", "--moments", "1.3,2.7,3.1", "--omega", "0.3,-0.7,0.9"];
    let plain = stdout(&scratch.run(&flags));
    assert!(!plain.contains('█'));
    let with: Vec<&str> =
        flags.iter().copied().chain(["--plot", "all.png", "--plot", "euler=e.svg"]).collect();
    let text = stdout(&scratch.run(&with));
    assert_eq!(text, plain + "wrote all.png, e.svg\n");
    assert_eq!(scratch.entries(), ["all.png", "e.svg"]);
    let png = fs::read(scratch.0.join("all.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n") && png.len() > 50_000);
    fs::remove_file(scratch.0.join("all.png")).unwrap();
    fs::remove_file(scratch.0.join("e.svg")).unwrap();
    let json: Vec<&str> = with.iter().copied().chain(["--json"]).collect();
    assert!(stdout(&scratch.run(&json)).ends_with("}\n"));
}

#[test]
fn the_figures_of_the_book_are_what_its_commands_draw() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let scratch = Scratch::new("book-plots");
    for folder in ["examples", "book"] {
        fs::create_dir(scratch.0.join(folder)).unwrap();
    }
    for name in ["t-handle.toml", "heavy-top.toml", "top-loops.toml"] {
        fs::copy(example(name), scratch.0.join("examples").join(name)).unwrap();
    }
    let page = fs::read_to_string(root.join("book/plots.md")).unwrap();
    let commands: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("$ polhode ")).collect();
    assert_eq!(commands.len(), 4);
    for command in commands {
        let words: Vec<&str> = command.split_whitespace().collect();
        stdout(&scratch.command(&words).current_dir(scratch.0.join("book")).output().unwrap());
    }
    let drawn = crate::common::entries(&scratch.0.join("book/figures"));
    for name in &drawn {
        let figure = fs::read_to_string(scratch.0.join("book/figures").join(name)).unwrap();
        let path = root.join("book/figures").join(name);
        if std::env::var_os("POLHODE_GOLDEN").is_some() {
            fs::create_dir_all(root.join("book/figures")).unwrap();
            fs::write(&path, &figure).unwrap();
        }
        let committed = fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
        assert!(figure == committed, "book/figures/{name} is not what is drawn today");
        assert!(page.contains(&format!("(figures/{name})")), "book/plots.md does not show {name}");
    }
    assert_eq!(drawn.len(), 8);
}
