//! A hint, when followed, gives a valid file. Every example is changed at every place in several
//! ways, and the hint is followed literally. The result is read; it has the original meaning
//! wherever the hint can know it.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use polhode_scenario::read as scenario;
use polhode_source::files::Disk;
use polhode_source::{FormatError, FormatErrorKind};

use crate::obey;

/// A valid example, its text, and its meaning.
struct Example {
    path: PathBuf,
    text: String,
    meaning: String,
}

fn examples() -> Vec<Example> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let folders = [folder.clone(), folder.join("notes"), folder.join("sweeps")];
    let paths =
        folders.iter().flat_map(|folder| fs::read_dir(folder).unwrap()).map(|entry| entry.unwrap().path());
    let mut all: Vec<Example> = paths
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .map(|path| (fs::read_to_string(&path).unwrap(), path))
        // A mistake in these may leave a symbol without a formula, which is another mistake.
        .filter(|(text, _)| !text.contains("[symbols]"))
        .map(|(text, path)| {
            let meaning = meaning(&text, &path).unwrap();
            Example { path, text, meaning }
        })
        .collect();
    all.sort_by(|a, b| a.path.cmp(&b.path));
    assert!(all.len() > 20);
    all
}

fn meaning(text: &str, path: &Path) -> Result<String, FormatError> {
    let scenario = scenario::parse(text, path)?;
    let plan = match text.contains("[sweep]") {
        true => format!(
            "{:?}",
            scenario::Template::parse(&Disk, text.to_owned(), path)?
                .sweep()?
                .vary
                .iter()
                .map(|v| &v.law)
                .collect::<Vec<_>>()
        ),
        false => String::new(),
    };
    Ok(format!(
        "{:?} {:?} {:?} {plan}",
        scenario.body(),
        scenario.torques(),
        (&scenario.start(), &scenario.run(), scenario.events().len())
    ))
}

fn replaced(text: &str, place: &Range<usize>, with: &str) -> String {
    [&text[..place.start], with, &text[place.end..]].concat()
}

/// Returns the words before ` = `, outside comments and strings.
fn keys(text: &str) -> Vec<Range<usize>> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.match_indices(" = ")
        .map(|(end, _)| (text[..end].rfind(|c| !is_word(c)).map_or(0, |at| at + 1), end))
        .filter(|(start, end)| {
            let line = &text[text[..*start].rfind('\n').map_or(0, |at| at + 1)..*start];
            start < end && !line.contains('#') && line.matches('"').count().is_multiple_of(2)
        })
        .map(|(start, end)| start..end)
        .collect()
}

/// Returns the strings after ` = `, without their quotes, and those in arrays.
fn strings(text: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let quotes: Vec<usize> = line.match_indices('"').map(|(k, _)| at + k).collect();
        let commented =
            line.find('#').is_some_and(|mark| line[..mark].matches('"').count().is_multiple_of(2));
        if !commented && !line.contains('\'') {
            found.extend(quotes.chunks_exact(2).map(|pair| pair[0] + 1..pair[1]));
        }
        at += line.len();
    }
    found
}

/// Simulates a typing error: the second and third letters swapped.
fn slip(word: &str) -> Option<String> {
    let mut letters: Vec<char> = word.chars().collect();
    let differ = letters.len() >= 4
        && letters[1] != letters[2]
        && letters.iter().all(|c| c.is_ascii_alphabetic() || *c == '_');
    differ.then(|| {
        letters.swap(1, 2);
        letters.iter().collect()
    })
}

/// Returns the text between `did you mean ` and the question mark.
fn meant(hint: &str) -> Option<&str> {
    Some(hint.strip_prefix("did you mean ")?.split_once('?')?.0)
}

/// Returns the first text that the hint says to write.
fn to_write(hint: &str) -> Option<&str> {
    let rest = hint.strip_prefix("write ")?;
    let (mut depth, mut quoted) = (0, false);
    let end = rest.char_indices().find(|&(at, c)| {
        quoted ^= c == '"';
        depth += i32::from("[{".contains(c)) - i32::from("]}".contains(c));
        let ends = [" and ", ", or", ", and", ", about", ", along", ": ", "; ", " for ", " if ", " along"];
        !quoted && depth == 0 && ends.iter().any(|mark| rest[at..].starts_with(mark))
    });
    Some(&rest[..end.map_or(rest.len(), |(at, _)| at)])
}

#[test]
fn a_misspelt_key_is_told_its_name() {
    let mut count = 0;
    for Example { path, text, meaning: was } in &examples() {
        for place in keys(text) {
            let Some(wrong) = slip(&text[place.clone()]) else { continue };
            // Keys of this section are names that the user chooses.
            if text[..place.start]
                .rfind("\n[")
                .is_some_and(|at| text[at..].starts_with("\n[sweep.questions]"))
            {
                continue;
            }
            let spoilt = replaced(text, &place, &wrong);
            let Err(error) = meaning(&spoilt, path) else { panic!("{}: {wrong} is read", path.display()) };
            let hint = error.hint().unwrap_or_default();
            let key = meant(&hint).unwrap_or_else(|| panic!("{}: {wrong}: {error}; {hint}", path.display()));
            let at = error.place().unwrap().span.clone();
            assert_eq!(&spoilt[at.clone()], wrong, "{error}");
            assert_eq!(
                meaning(&replaced(&spoilt, &at, key), path).as_ref(),
                Ok(was),
                "{}: {wrong}: {hint}",
                path.display()
            );
            count += 1;
        }
    }
    assert!(count > 500, "{count}");
}

#[test]
fn a_misspelt_name_is_told_its_own() {
    let mut count = 0;
    for Example { path, text, meaning: was } in &examples() {
        for place in strings(text) {
            let Some(wrong) = slip(&text[place.clone()]) else { continue };
            let spoilt = replaced(text, &place, &wrong);
            // Titles and names of parts may be any text.
            let Err(error) = meaning(&spoilt, path) else { continue };
            let hint = error.hint().unwrap_or_default();
            let Some(name) = meant(&hint) else { panic!("{}: {wrong}: {error}; {hint}", path.display()) };
            let at = error.place().unwrap().span.clone();
            let name = if name.starts_with(['"', '\'']) { name.to_owned() } else { format!("\"{name}\"") };
            assert_eq!(
                meaning(&replaced(&spoilt, &at, &name), path).as_ref(),
                Ok(was),
                "{}: {wrong}: {hint}",
                path.display()
            );
            count += 1;
        }
    }
    assert!(count > 80, "{count}");
}

/// Omits a key, writes the text of the hint in its place, and reads the result.
#[test]
fn a_missing_key_comes_with_a_line_that_will_do() {
    let mut count = 0;
    for Example { path, text, .. } in examples().iter().filter(|example| !example.text.contains("[sweep]")) {
        for place in keys(text) {
            let line = text[..place.start].rfind('\n').map_or(0, |at| at + 1)
                ..text[place.start..].find('\n').map_or(text.len(), |at| place.start + at);
            let closed = |open, close| {
                text[line.clone()].matches(open).count() == text[line.clone()].matches(close).count()
            };
            if line.start != place.start || !closed('[', ']') || !closed('{', '}') {
                continue;
            }
            let Err(error) = meaning(&replaced(text, &line, ""), path) else { continue };
            let FormatErrorKind::MissingKey { key, .. } = error.kind() else { continue };
            let hint = error.hint().unwrap_or_default();
            // If one line is not enough, the hint has both lines, in the order of the file or not.
            let example = to_write(&hint).unwrap_or_else(|| panic!("{error}; {hint}"));
            let other = hint
                .split_once(" and ")
                .and_then(|(_, rest)| to_write(&format!("write {rest}")).map(str::to_owned));
            let both = other
                .filter(|other| other.contains(" = ") && !text.contains(other.split(' ').next().unwrap()));
            let example = &[example, both.as_deref().unwrap_or_default()].join("\n");
            if let Err(again) = meaning(&replaced(text, &line, example), path) {
                // The body of this example differs from the one in the file, whose size or place
                // still limits it.
                let of_others = matches!(
                    again.kind(),
                    FormatErrorKind::Body(_)
                        | FormatErrorKind::Motion(_)
                        | FormatErrorKind::Io { .. }
                        | FormatErrorKind::Unit(_)
                );
                // The velocity of another table may replace `rolls`.
                let bound = ["shape", "model", "measure", "duration", "rolls"].contains(key);
                assert!(
                    of_others || bound || matches!(again.kind(), FormatErrorKind::Conflict { .. }),
                    "{}: {key}: {hint}: {again}",
                    path.display()
                );
            }
            count += 1;
        }
    }
    assert!(count > 100, "{count}");
}

/// Tests a list or a number in the place of a table.
#[test]
fn a_table_is_shown_where_something_else_stands() {
    let mut count = 0;
    for Example { path, text, .. } in examples().iter().filter(|example| !example.text.contains("[sweep]")) {
        for place in keys(text).into_iter().filter(|place| text[place.end..].starts_with(" = { ")) {
            let open = place.end + 3;
            let mut depth = 0;
            let length = text[open..].find(|c: char| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                depth == 0
            });
            let value = open..open + length.unwrap() + 1;
            for wrong in ["[1, 2, 3]", "[1, 0, 0, 0]", "12.5"] {
                let spoilt = replaced(text, &value, wrong);
                let Err(error) = meaning(&spoilt, path) else { continue };
                let hint = error.hint().unwrap_or_default();
                if !matches!(error.kind(), FormatErrorKind::WrongType { .. }) {
                    continue;
                }
                let example = to_write(&hint).unwrap_or_else(|| panic!("{error}; {hint}"));
                let whole = if example.contains(" = ") && !example.starts_with('{') {
                    place.start..value.start + wrong.len()
                } else {
                    value.start..value.start + wrong.len()
                };
                if let Err(again) = meaning(&replaced(&spoilt, &whole, example), path) {
                    let of_others = matches!(
                        again.kind(),
                        FormatErrorKind::Body(_) | FormatErrorKind::Motion(_) | FormatErrorKind::Unit(_)
                    );
                    assert!(of_others, "{}: {error}: {hint}: {again}", path.display());
                }
                count += 1;
            }
        }
    }
    assert!(count > 30, "{count}");
}

/// Tests one number of a list without the unit that the others have.
#[test]
fn a_number_without_its_unit_is_refused_among_those_with_one() {
    let mut count = 0;
    for Example { path, text, meaning: was } in &examples() {
        for place in strings(text) {
            let Some((number, unit)) = text[place.clone()].split_once(' ') else { continue };
            let line = text[..place.start].rfind('\n').map_or(0, |at| at + 1);
            let in_list =
                text[line..place.start].matches('[').count() > text[line..place.start].matches(']').count();
            let zero = number.parse::<f64>().is_ok_and(|number| number == 0.0);
            if !in_list || zero || number.parse::<f64>().is_err() {
                continue;
            }
            let spoilt = replaced(text, &(place.start - 1..place.end + 1), number);
            let Err(error) = meaning(&spoilt, path) else { continue };
            let hint = error.hint().unwrap_or_default();
            let at = error.place().unwrap().span.clone();
            assert_eq!(&spoilt[at.clone()], number, "{error}");
            let others = to_write(&hint).unwrap_or_else(|| panic!("{error}; {hint}"));
            let again = meaning(&replaced(&spoilt, &at, others), path);
            assert!(again.is_ok(), "{hint}: {again:?}");
            if others.ends_with(&format!(" {unit}\"")) {
                assert_eq!(again.as_ref(), Ok(was), "{hint}");
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count}");
}

/// Tests names used by other programs.
#[test]
fn words_of_others_are_told_ours() {
    const BODY: &str = "[[body.part]]\nshape = 'box'\nsize = [1, 2, 3]\nmass = '12 kg'\n";
    const RUN: &str = "[run]\nduration = '1 s'\nsamples = 3\n";
    const VARY: &str = "[[sweep.vary]]\nkey = 'body.part[0].mass'\nuniform = { from = 1, to = 2 }\n";
    let spun = |rest: &str| format!("{BODY}[start]\n{rest}\n{RUN}");
    let turned = |rest: &str| format!("{BODY}[[torque]]\n{rest}\n{RUN}");
    for (wrong, right) in [
        (spun("spin = [1, 2, 3]"), spun("spin = { body = [1, 2, 3] }")),
        (spun("attitude = [0, 1, 0, 0]"), spun("attitude = { quaternion = [0, 1, 0, 0] }")),
        (
            spun("attitude = { xyzw = [0, 0.6, 0, 0.8] }"),
            spun("attitude = { quaternion_xyzw = [0, 0.6, 0, 0.8] }"),
        ),
        (
            spun("attitude = { wxyz = [0.8, 0, 0.6, 0] }"),
            spun("attitude = { quaternion = [0.8, 0, 0.6, 0] }"),
        ),
        (spun("attitude = { rpy = [1, 2, 3] }"), spun("attitude = { roll_pitch_yaw = [1, 2, 3] }")),
        (
            spun("orientation = { quaternion = [0.8, 0, 0.6, 0] }"),
            spun("attitude = { quaternion = [0.8, 0, 0.6, 0] }"),
        ),
        (
            turned("model = 'spring'\nstiffness = '1 N m/rad'"),
            turned("model = 'torsion'\nstiffness = '1 N m/rad'"),
        ),
        (
            format!("{BODY}[sweep]\nmembers = 3\nsampling = 'lhs'\n{VARY}"),
            format!("{BODY}[sweep]\nmembers = 3\nsampling = 'latin hypercube'\n{VARY}"),
        ),
        (
            format!("{BODY}[run]\nduration = '1 s'\nmethod = 'leapfrog'\nstep = 1e-2\n"),
            format!("{BODY}[run]\nduration = '1 s'\nmethod = 'splitting'\nstep = 1e-2\n"),
        ),
    ] {
        let path = Path::new("test.toml");
        let error = meaning(&wrong, path).unwrap_err();
        let hint = error.hint().unwrap_or_default();
        let at = error.place().unwrap().span.clone();
        let obeyed = match (meant(&hint), to_write(&hint)) {
            (Some(name), _) => replaced(&wrong, &at, name),
            (_, Some(line)) => {
                let start = wrong[..at.start].rfind('\n').map_or(0, |k| k + 1);
                replaced(&wrong, &(start..at.end), line)
            }
            _ => panic!("{error}; {hint}"),
        };
        assert_eq!(meaning(&obeyed, path), meaning(&right, path), "{hint}");
        assert!(meaning(&right, path).is_ok(), "{right}");
    }
    for (wrong, says) in [
        (spun("attitude = { euler321 = [1, 2, 3] }"), "write euler313 = [\"30 deg\", \"20 deg\", \"10"),
        (spun("euler321 = [1, 2, 3]"), "write the angles in attitude ="),
        (spun("altitude = '500 km'"), "write [orbit] on a line of its own, and under it altitude"),
        (
            spun("frame = 'lvlh'").replace("[run]", "[orbit]\naltitude = '500 km'\n[run]"),
            "write relative_to = \"orbit\"",
        ),
        (spun("damping = 0.1"), "damping is a [[torque]]:"),
        (spun("attitude = { euler_zyx = [1, 2, 3] }"), "write euler313 = ["),
        (format!("orbit = {{ period = '90 min' }}\n{BODY}"), "write rate = \"0.0011 rad/s\""),
        (
            format!("orbit = {{ radius = '3790 km', central_body = 'mars' }}\n{BODY}"),
            "write mu = \"398600.44 km^3/s^2\"",
        ),
        (
            turned("model = 'gravity_gradient'\norbit = { altitude = '400 km' }"),
            "write [orbit] on a line of its own",
        ),
        (
            turned("model = 'damping'"),
            "use model = \"drag\" for air drag, or \"energy_sink\" for internal friction",
        ),
        (
            turned("model = 'constant'\nbody = ['1 N m', '0 N m', '1 N m']"),
            "write axes = \"body\" and, on the next line, torque = [",
        ),
        (
            turned("model = 'constant'\nspace = ['1 N m', '0 N m', '1 N m']"),
            "write axes = \"space\" and, on the next line, torque = [",
        ),
        (spun("omega = [1, 2, 3]"), "write spin = { body = [0, 0, \"12 rad/s\"] }"),
        (format!("{BODY}[run]\nduration = '1 s'\nmethod = 'rk4'"), "\"dop853\", of order 8"),
    ] {
        let error = meaning(&wrong, Path::new("test.toml")).unwrap_err();
        let (hint, place) = (error.hint().unwrap_or_default(), error.place().unwrap());
        assert!(hint.contains(says) && !hint.contains("did you mean"), "{hint}");
        let read = |text: &str| meaning(text, Path::new("test.toml")).map(drop);
        let parts = |error: &FormatError| (error.message(), error.place().map(|place| place.span.clone()));
        obey::check(&wrong, (&error.message(), &place.span, &hint), read, parts);
    }
}
