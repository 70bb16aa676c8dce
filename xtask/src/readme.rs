//! Runs the commands of the README and of the book's first steps.

use std::path::Path;
use std::process::Command;

use crate::process::{copy, empty_folder, output, polhode};
use crate::{Outcome, installation, read, root};

/// Runs every `polhode` command of the README and of `book/start.md` in a copy of examples/.
/// `cargo run` is replaced by the built command.
pub(crate) fn check() -> Outcome {
    installation::check()?;
    let start = read(&root().join("book/start.md"))?;
    programs_are_tested(&start, &read(&root().join("crates/polhode/README.md"))?)?;
    let first_steps = commands(&start);
    let mut commands = commands(&read(&root().join("README.md"))?);
    if commands.is_empty() {
        return Err("README.md has no command in a ```console block".into());
    }
    let new: Vec<String> = first_steps.into_iter().filter(|step| !commands.contains(step)).collect();
    commands.extend(new);
    let polhode = polhode()?;
    let folder = empty_folder("readme")?;
    copy(&root().join("examples"), &folder.join("examples"))?;
    let programs = polhode.parent().into_iter().map(Path::to_owned);
    let found = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(programs.chain(std::env::split_paths(&found)))
        .map_err(|error| format!("PATH: {error}"))?;
    for command in commands {
        output(Command::new("sh").args(["-euc", &shell(&command)]).current_dir(&folder).env("PATH", &path))?;
        println!("   {command}");
    }
    Ok(())
}

/// Returns a shell command that fails unless the exit status is as stated.
///
/// The default is 0; `polhode check arm.urdf # exit status 1` states another one.
fn shell(command: &str) -> String {
    match command.split_once("# exit status ") {
        Some((run, status)) => {
            let status: String = status.chars().take_while(char::is_ascii_digit).collect();
            format!("if {run}; then exit 9; else test $? -eq {status}; fi")
        }
        None => command.to_owned(),
    }
}

/// Checks that the Rust programs of `book/start.md` are in the crate's README too, where doc tests
/// run them.
fn programs_are_tested(page: &str, tested: &str) -> Outcome {
    let programs: Vec<&str> =
        page.split("```rust\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    match programs.iter().find(|program| !tested.contains(*program)) {
        _ if programs.is_empty() => Err("book/start.md has no program in a ```rust block".into()),
        Some(program) => {
            Err(format!("crates/polhode/README.md does not have this program of book/start.md:\n{program}"))
        }
        None => Ok(()),
    }
}

/// Returns the lines `$ polhode …` and `$ cargo run … -- …` of ```console blocks, both as `polhode
/// …`.
fn commands(markdown: &str) -> Vec<String> {
    let mut inside = false;
    let mut found = Vec::new();
    for line in markdown.lines() {
        if let Some(language) = line.strip_prefix("```") {
            inside = language == "console";
        } else if let Some(typed) = line.strip_prefix("$ ").filter(|_| inside) {
            if typed.starts_with("polhode ") {
                found.push(typed.to_owned());
            } else if let Some((_, arguments)) =
                typed.strip_prefix("cargo run").and_then(|t| t.split_once(" -- "))
            {
                found.push(format!("polhode {arguments}"));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_ends_as_it_says() {
        let status = |command: &str| {
            let ended = Command::new("sh").args(["-euc", &shell(command)]).status();
            ended.ok().and_then(|status| status.code())
        };
        assert_eq!(status("true"), Some(0));
        assert_eq!(status("sh -c 'exit 3' # exit status 3: it is wrong"), Some(0));
        assert_eq!(status("sh -c 'exit 2' # exit status 3"), Some(1));
        assert_eq!(status("true # exit status 1"), Some(9));
    }

    #[test]
    fn commands_are_found_in_console_blocks_and_only_there() {
        let markdown = "\
$ polhode not-in-a-block
```console
$ polhode inertia examples/a.toml
mass 1 kg
$ cargo run --release -- simulate examples/a.toml
$ cargo xtask test
```
```toml
$ polhode not-in-a-console
```
```console
$ polhode explain b.toml | head -3
```
";
        let wanted = [
            "polhode inertia examples/a.toml",
            "polhode simulate examples/a.toml",
            "polhode explain b.toml | head -3",
        ];
        assert_eq!(commands(markdown), wanted);
    }
}
