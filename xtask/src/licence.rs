//! SPDX licence expressions, and whether they permit linking.

/// Accepted licences, without conditions other than attribution.
const ACCEPTED: [&str; 11] = [
    "MIT",
    "Apache-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "ISC",
    "Zlib",
    "Unicode-3.0",
    "Unicode-DFS-2016",
    "0BSD",
    "CC0-1.0",
    "MIT-0",
];

/// Returns true if the expression can be satisfied with accepted licences only.
///
/// `AND` binds more tightly than `OR`; the `/` of old manifests means `OR`. `WITH` adds a
/// permission, so only the licence before it counts. An invalid expression is not satisfied.
pub(crate) fn is_satisfied(expression: &str) -> bool {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    let mut words = Words { words: spaced.split_whitespace().collect(), next: 0 };
    let satisfied = words.any();
    satisfied == Some(true) && words.next == words.words.len()
}

/// Words of an expression, from left to right; parsers return `None` for invalid syntax.
struct Words<'a> {
    words: Vec<&'a str>,
    next: usize,
}

impl Words<'_> {
    /// Parses `all (OR all)*`.
    fn any(&mut self) -> Option<bool> {
        let mut satisfied = self.all()?;
        while self.skip("OR") {
            satisfied |= self.all()?;
        }
        Some(satisfied)
    }

    /// Parses `one (AND one)*`.
    fn all(&mut self) -> Option<bool> {
        let mut satisfied = self.one()?;
        while self.skip("AND") {
            satisfied &= self.one()?;
        }
        Some(satisfied)
    }

    /// Parses `( any )`, or a licence, optionally with `WITH` and an exception.
    fn one(&mut self) -> Option<bool> {
        if self.skip("(") {
            let satisfied = self.any();
            return if self.skip(")") { satisfied } else { None };
        }
        let satisfied = ACCEPTED.contains(&self.word()?);
        if self.skip("WITH") {
            self.word()?;
        }
        Some(satisfied)
    }

    fn word(&mut self) -> Option<&str> {
        let word = self.words.get(self.next)?;
        self.next += 1;
        Some(word)
    }

    fn skip(&mut self, word: &str) -> bool {
        let found = self.words.get(self.next) == Some(&word);
        self.next += usize::from(found);
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions_are_read_as_spdx_means_them() {
        let satisfied = [
            "MIT",
            "GPL-3.0-only OR MIT",
            "MIT/Apache-2.0",
            "MIT AND BSD-3-Clause",
            "(MIT OR Apache-2.0) AND Unicode-3.0",
            "Apache-2.0 WITH LLVM-exception OR GPL-2.0-only",
            "GPL-3.0-only AND MPL-2.0 OR Zlib",
            "Zlib OR GPL-3.0-only AND MPL-2.0",
        ];
        for expression in satisfied {
            assert!(is_satisfied(expression), "{expression}");
        }
        let not = [
            "",
            "AGPL-3.0-only",
            "MIT AND GPL-3.0-only",
            "(MIT OR Apache-2.0) AND MPL-2.0",
            "GPL-2.0-only WITH Classpath-exception-2.0",
            "MIT OR",
            "(MIT",
            "MIT)",
            "MIT Apache-2.0",
            "mit",
        ];
        for expression in not {
            assert!(!is_satisfied(expression), "{expression}");
        }
    }
}
