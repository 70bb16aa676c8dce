//! Name patterns: `*` matches any characters, `?` one character, and `**` between slashes any
//! folders.

use std::fmt;

/// Pattern of file names. A pattern without a slash matches files of that name in any folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Glob(String);

impl Glob {
    /// Returns a pattern; `None` if it is empty or has glob syntax that is not supported: `[`, `]`,
    /// `{`, `}`, `\`, or a leading `!`.
    pub fn new(pattern: &str) -> Option<Self> {
        let foreign = pattern.contains(['[', ']', '{', '}', '\\']) || pattern.starts_with('!');
        (!pattern.is_empty() && !foreign).then(|| Self(pattern.trim_start_matches("./").to_owned()))
    }

    /// Returns true if a file name matches. The name is relative, with slashes.
    pub fn matches(&self, file: &str) -> bool {
        let parts: Vec<&str> = file.split('/').collect();
        if !self.0.contains('/') {
            return parts.last().is_some_and(|name| name_matches(&self.0, name));
        }
        let pattern: Vec<&str> = self.0.split('/').collect();
        is_match(&pattern, &parts, |part| *part == "**", |part, name| name_matches(part, name))
    }

    /// Returns the name if the pattern matches exactly one file.
    pub(crate) fn plain(&self) -> Option<&str> {
        Some(self.0.as_str()).filter(|name| name.contains('/') && !name.contains(['*', '?']))
    }
}

impl fmt::Display for Glob {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Returns true if a name without folders, or a link name, matches a pattern.
pub(crate) fn name_matches(pattern: &str, name: &str) -> bool {
    let (pattern, name): (Vec<char>, Vec<char>) = (pattern.chars().collect(), name.chars().collect());
    is_match(&pattern, &name, |c| *c == '*', |p, c| *p == '?' || p == c)
}

/// Returns true if a list matches a pattern, some elements of which are wildcards for any number of
/// list elements.
///
/// A wildcard first matches as few elements as possible. After a mismatch, the last wildcard takes
/// one more element. Earlier wildcards need no backtracking: the last one can take any element that
/// they could take.
fn is_match<P, T>(
    pattern: &[P],
    list: &[T],
    is_any: impl Fn(&P) -> bool,
    is_one: impl Fn(&P, &T) -> bool,
) -> bool {
    let (mut p, mut k) = (0, 0);
    let mut last: Option<(usize, usize)> = None;
    while let Some(element) = list.get(k) {
        match pattern.get(p) {
            Some(part) if is_any(part) => {
                last = Some((p, k));
                p += 1;
            }
            Some(part) if is_one(part, element) => {
                p += 1;
                k += 1;
            }
            _ => {
                let Some((any, taken)) = last else { return false };
                last = Some((any, taken + 1));
                (p, k) = (any + 1, taken + 1);
            }
        }
    }
    pattern.get(p..).unwrap_or_default().iter().all(is_any)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_are_of_folders_and_names() {
        let of = |pattern: &str, file: &str| Glob::new(pattern).unwrap().matches(file);
        for (pattern, file) in [
            ("arm.urdf", "arm.urdf"),
            ("arm.urdf", "src/robots/arm.urdf"),
            ("*.urdf", "src/a.b.urdf"),
            ("src/*.urdf", "src/arm.urdf"),
            ("./src/*.urdf", "src/arm.urdf"),
            ("src/**", "src/a/b/arm.urdf"),
            ("src/**/arm.urdf", "src/arm.urdf"),
            ("**/old/**/*_v?.urdf", "x/old/y/z/arm_v2.urdf"),
            ("**/a/**/a/b", "a/a/c/a/b"),
            ("*", "ä"),
        ] {
            assert!(of(pattern, file), "{pattern} {file}");
        }
        for (pattern, file) in [
            ("arm.urdf", "arm.urdf.bak"),
            ("src/*.urdf", "src/a/arm.urdf"),
            ("src/arm.urdf", "old/src/arm.urdf"),
            ("*/arm.urdf", "arm.urdf"),
            ("arm_?.urdf", "arm_.urdf"),
            ("**/a/**/a/b", "a/b"),
            ("Arm.urdf", "arm.urdf"),
        ] {
            assert!(!of(pattern, file), "{pattern} {file}");
        }
        for foreign in ["", "a[bc]", "{a,b}", "!a", "a\\b"] {
            assert_eq!(Glob::new(foreign), None, "{foreign}");
        }
        // Matching time stays bounded for patterns with many wildcards.
        assert!(!of(&format!("x/{}b", "*a".repeat(40)), &format!("x/{}", "a".repeat(4000))));
    }
}
