//! Verdict of a report.

/// Level of a verdict; the worst is the greatest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Nothing needs attention.
    Ok,
    /// Result with a restriction.
    Warning,
    /// Result that fails a requirement.
    Failure,
}

impl Level {
    /// Returns the sign, the word and the CSS class of the level, for readers without colours too.
    pub(super) const fn shown(self) -> [&'static str; 3] {
        match self {
            Self::Ok => ["✓", "OK", "ok"],
            Self::Warning => ["!", "Warning", "warning"],
            Self::Failure => ["✗", "Fail", "fail"],
        }
    }

    /// Returns the level of a table cell that is a verdict; `None` for other cells.
    pub(super) fn of_cell(cell: &str) -> Option<Self> {
        match cell {
            "ok" | "met" | "passed" => Some(Self::Ok),
            "suspect" | "not run" | "likely" => Some(Self::Warning),
            "impossible" | "not met" | "failed" | "unreadable" => Some(Self::Failure),
            _ => None,
        }
    }
}

/// Verdict of a report, shown above its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// Level, which determines colour, sign and word.
    pub level: Level,
    /// Reason, one sentence with a capital letter, without a full stop.
    pub reason: String,
}

impl Verdict {
    /// Creates a verdict.
    pub fn new(level: Level, reason: impl Into<String>) -> Self {
        Self { level, reason: reason.into() }
    }
}
