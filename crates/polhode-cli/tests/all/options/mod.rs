//! Every pair of options of every subcommand is either effective or refused.
//!
//! The options are those in `--help`, which is generated from the definitions of the command line.
//! An option missing from the tables here fails the test. Each pair runs on an input on which both
//! have an effect. The pair must be refused with both names, or give another output than either
//! option alone. A table lists pairs in which one has no effect next to the other, with the reason.
//! An option that requires a third one is refused without it next to every other option too.

mod budget;
mod identify;
mod inertia;
mod inputs;
mod motion;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::common::Scratch;

/// Subcommand with its inputs and options.
pub(crate) struct Subcommand {
    name: &'static str,
    /// Inputs by name: arguments without options.
    inputs: &'static [(&'static str, &'static [&'static str])],
    options: &'static [Choice],
    /// Pairs in which one option has no effect next to the other, with the reason why nothing is
    /// lost.
    independent: &'static [(&'static str, &'static str, &'static str)],
}

/// Option with a value that has an effect, the inputs for it, and the options that it requires. A
/// `+` marks options that only make its effect visible.
pub(crate) struct Choice {
    option: &'static str,
    arguments: &'static [&'static str],
    inputs: &'static [&'static str],
    needs: &'static [&'static str],
}

/// Result of a run: exit status, output, and files left.
#[derive(Clone, Debug, PartialEq)]
struct Outcome {
    code: Option<i32>,
    printed: String,
    said: String,
    files: BTreeMap<String, Vec<u8>>,
}

struct Runs {
    subcommand: &'static Subcommand,
    done: BTreeMap<(String, Vec<&'static str>), Outcome>,
}

impl Runs {
    /// Runs an input with these options and their requirements, with `beside`, and without one of
    /// those.
    fn of(&mut self, input: &str, options: &[&Choice], beside: &[&'static str], without: &str) -> Outcome {
        let mut arguments = vec![self.subcommand.name];
        let (_, given) = self.subcommand.inputs.iter().find(|(name, _)| *name == input).unwrap();
        arguments.extend(*given);
        let mut present = BTreeSet::new();
        let needed = options.iter().flat_map(|choice| choice.needs).chain(beside);
        let needed =
            needed.filter(|name| name.trim_start_matches('+') != without).map(|name| self.choice(name));
        for choice in options.iter().copied().chain(needed) {
            if present.insert(choice.option) {
                arguments.extend(choice.arguments);
            }
        }
        let key = (input.to_owned(), arguments.clone());
        if let Some(outcome) = self.done.get(&key) {
            return outcome.clone();
        }
        let scratch = Scratch::new(&format!("options-{}", self.subcommand.name));
        inputs::write(&scratch, input);
        let output = inputs::with_python(scratch.command(&arguments), &scratch).output().unwrap();
        let outcome = Outcome {
            code: output.status.code(),
            printed: String::from_utf8(output.stdout).unwrap(),
            said: String::from_utf8(output.stderr).unwrap(),
            files: files(&scratch.0),
        };
        self.done.insert(key, outcome.clone());
        outcome
    }

    fn choice(&self, option: &str) -> &'static Choice {
        let option = option.trim_start_matches('+');
        self.subcommand.options.iter().find(|choice| choice.option == option).unwrap()
    }

    /// Returns the reason why the pair is neither effective nor refused; `None` if it is fine.
    fn fault(&mut self, a: &Choice, b: &Choice) -> Option<String> {
        let (few, many) = if a.inputs.len() <= b.inputs.len() { (a, b) } else { (b, a) };
        let Some(input) = few.inputs.iter().find(|input| many.inputs.contains(input)) else {
            // The options have no common input: on the input of either, the other must be refused.
            return [(a, b), (b, a)].into_iter().find_map(|(owner, other)| {
                let both = self.of(owner.inputs[0], &[owner, other], &[], "");
                let mut named =
                    [owner, other].into_iter().flat_map(|choice| choice.needs.iter().chain([&choice.option]));
                let refused = both.code == Some(2) && named.any(|name| both.said.contains(name));
                (!refused)
                    .then(|| format!("{} on the input of {}: {}", other.option, owner.option, both.said))
            });
        };
        let both = self.of(input, &[a, b], &[], "");
        if both.code == Some(2) {
            let named = [a, b].iter().all(|choice| both.said.contains(choice.option));
            return (!named).then(|| format!("on {input}, refused without both names: {}", both.said));
        }
        let same: Vec<&str> = [(a, b), (b, a)]
            .into_iter()
            .filter(|(alone, idle)| {
                let alone = self.of(input, &[alone], idle.needs, idle.option);
                alone.code == both.code && alone.printed == both.printed && alone.files == both.files
            })
            .map(|(_, idle)| idle.option)
            .collect();
        (!same.is_empty()).then(|| format!("on {input}: nothing comes of {}", same.join(" and ")))
    }
}

impl Runs {
    /// Returns the reason if an option is accepted without its requirement but has no effect;
    /// `None` if it is fine.
    fn slip(&mut self, a: &Choice, b: &Choice) -> Option<String> {
        /// Options that write a file, which --force replaces.
        const WRITERS: [&str; 8] = [
            "--output",
            "--html",
            "--plot",
            "--write-baseline",
            "--write-mesh",
            "--write-inertials",
            "--scenario",
            "--sweep",
        ];
        let needs: Vec<&str> = a.needs.iter().copied().filter(|name| !name.starts_with('+')).collect();
        let writes =
            a.option == "--force" && [b.option].iter().chain(b.needs).any(|option| WRITERS.contains(option));
        let helps = writes || needs.iter().any(|name| *name == b.option || b.needs.contains(name));
        let input = b.inputs.iter().find(|input| a.inputs.contains(input)).or(b.inputs.first());
        let (false, false, Some(input)) = (needs.is_empty(), helps, input) else { return None };
        let bare = Choice { needs: &[], ..*a };
        let (both, alone) = (self.of(input, &[&bare, b], &[], ""), self.of(input, &[b], &[], ""));
        let nothing = both.code != Some(2) && both.printed == alone.printed && both.files == alone.files;
        nothing.then(|| format!("on {input}: {} is let pass without {}", a.option, needs.join(" and ")))
    }
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
        let (name, path) = (entry.file_name().into_string().unwrap(), entry.path());
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            found.insert(name, fs::read(path).unwrap());
        }
    }
    found
}

/// Returns the long options in the help of a subcommand.
pub(crate) fn options_of(subcommand: &str) -> BTreeSet<String> {
    let scratch = Scratch::new(&format!("help-{subcommand}"));
    let help = crate::common::stdout(&scratch.run(&[subcommand, "--help"]));
    let option = |line: &str| {
        let rest = line.strip_prefix("  ")?.trim_start();
        let rest = if rest.starts_with("--") {
            rest
        } else {
            rest.split_once(", ").filter(|(short, _)| short.starts_with('-'))?.1
        };
        let end = rest.find(|c: char| c != '-' && !c.is_ascii_alphanumeric()).unwrap_or(rest.len());
        rest.starts_with("--").then(|| rest[..end].to_owned())
    };
    help.lines().filter_map(option).filter(|option| option != "--help").collect()
}

pub(crate) fn every_pair_is_honoured_or_refused(subcommand: &'static Subcommand) {
    let listed: BTreeSet<String> = subcommand.options.iter().map(|choice| choice.option.to_owned()).collect();
    assert_eq!(options_of(subcommand.name), listed, "the options of {}", subcommand.name);
    let mut runs = Runs { subcommand, done: BTreeMap::new() };
    let mut faults = Vec::new();
    for (k, a) in subcommand.options.iter().enumerate() {
        // Each option alone has an effect on each of its inputs.
        for b in &subcommand.options[k + 1..] {
            let listed = subcommand.independent.iter().find(|(x, y, _)| {
                [(a.option, b.option), (b.option, a.option), (a.option, "*"), (b.option, "*")]
                    .contains(&(*x, *y))
            });
            for (a, b) in [(a, b), (b, a)] {
                faults.extend(runs.slip(a, b).map(|slip| format!("{} {}: {slip}", a.option, b.option)));
            }
            // An option that replaces all others is not tested against each.
            if listed.is_some_and(|(_, other, _)| *other == "*") {
                continue;
            }
            let without =
                [(a, b), (b, a)].into_iter().find(|(other, needed)| other.needs.contains(&needed.option));
            let fault = match without {
                // One option requires the other: alone it must be refused; together they are in
                // every pair of the former.
                Some((other, _)) => {
                    let alone = Choice { needs: &[], ..*other };
                    let outcome = runs.of(other.inputs[0], &[&alone], &[], "");
                    (outcome.code != Some(2)).then(|| format!("{} goes without what it needs", other.option))
                }
                None => runs.fault(a, b),
            };
            match (fault, listed) {
                (Some(fault), None) => faults.push(format!("{} {}: {fault}", a.option, b.option)),
                (None, Some(_)) => {
                    faults.push(format!("{} {}: listed as independent, and is not", a.option, b.option));
                }
                _ => {}
            }
        }
    }
    assert!(faults.is_empty(), "polhode {}:\n{}", subcommand.name, faults.join("\n"));
}

#[test]
fn every_subcommand_is_looked_at() {
    let scratch = Scratch::new("options-all");
    let help = crate::common::stdout(&scratch.run(&["--help"]));
    let commands =
        help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let commands = commands.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names: BTreeSet<&str> = commands.map(|line| line.split_whitespace().next().unwrap()).collect();
    // These have at most one option. `live`, which does not end, `mcp`, whose requests are on its
    // input, and `judge`, which detects what its options state, have tests of their own.
    let without = ["new", "schema", "completions", "man", "help", "live", "mcp", "judge"];
    let tables = [
        "inertia",
        "check",
        "compare",
        "simulate",
        "spin",
        "stability",
        "torque",
        "sweep",
        "explain",
        "exercise",
        "identify",
        "budget",
    ];
    assert_eq!(names, without.into_iter().chain(tables).collect());
    for name in &without[..3] {
        assert!(options_of(name).len() <= 1, "{name}");
    }
}
