//! What a user allows.

use super::{Example, Rule};
use crate::finding::Severity::{Note, Suspect};

pub(super) const RULES: [Rule; 4] = [
    Rule {
        code: "allow.malformed",
        severity: Suspect,
        title: "an allowance names a rule and says why",
        why: "Without a reason nobody knows later whether it still holds, and a rule that does not exist allows nothing.",
        mend: "Write <!-- polhode: allow RULE: REASON -->.",
        example: Some(Example {
            model: "<!-- polhode: allow tree.empty -->\n<link name=\"a\"/>",
            old: "<!-- polhode: allow tree.empty -->\n",
            new: "",
        }),
    },
    Rule {
        code: "allow.unused",
        severity: Note,
        title: "an allowance allows something",
        why: "What it was for is mended, or it stands at another place, and it would hide the next finding of its kind.",
        mend: "Leave it out. A comment is for the link or joint that it is in or right before; before the root element, for the whole file.",
        example: Some(Example {
            model: "<!-- polhode: allow inertia.zero: a point mass, on purpose -->\n<link name=\"a\"/>",
            old: "<!-- polhode: allow inertia.zero: a point mass, on purpose -->\n",
            new: "",
        }),
    },
    Rule {
        code: "allow.expired",
        severity: Note,
        title: "an allowance is used before it expires",
        why: "It allows nothing from that day on, so that what it was for is looked at again.",
        mend: "Mend what it was for, or set another date in polhode.toml.",
        example: None,
    },
    Rule {
        code: "baseline.gone",
        severity: Note,
        title: "what a baseline knows is there",
        why: "The finding is mended, and the baseline would hide it if it came back.",
        mend: "Write the baseline again: --write-baseline FILE.",
        example: None,
    },
];
