//! Letters: Greek names, superscripts, subscripts and bold forms of Unicode.

/// Names of letters; capitals that look Latin have none in LaTeX.
const NAMES: &str = "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau \
                     upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega ell";
const LETTERS: &str = "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΥΦΨΩℓ";

/// Characters of indices. Unicode has more, but not all letters of any set: Nₓ next to N_y, or mₐ next
/// to m_b, would look like different things.
const PLAIN: &str = "0123456789+−=ijklmn";
const SUBSCRIPTS: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌ᵢⱼₖₗₘₙ";
const RAISED: &str = "0123456789+−=()abcdefghijklmnoprstuvwxyz";
const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻ";

/// Returns the letter with a name such as `omega`.
pub(super) fn greek(name: &str) -> Option<char> {
    NAMES.split(' ').zip(LETTERS.chars()).find(|(other, _)| *other == name).map(|(_, letter)| letter)
}

/// Returns the name of a Greek letter, which is its command in LaTeX.
pub(super) fn name(letter: char) -> Option<&'static str> {
    NAMES.split(' ').zip(LETTERS.chars()).find(|(_, other)| *other == letter).map(|(name, _)| name)
}

/// Returns the digit, or letter, of a subscript.
pub(super) fn from_subscript(c: char) -> Option<char> {
    SUBSCRIPTS.chars().zip(PLAIN.chars()).find(|(sub, _)| *sub == c).map(|(_, plain)| plain)
}

/// Returns a text as an index: `ᵢⱼ`, or `_xy` if Unicode lacks a character.
pub(super) fn subscript(text: &str) -> String {
    let tight = tight(text);
    small(&tight, PLAIN, SUBSCRIPTS).unwrap_or_else(|| match tight.chars().all(char::is_alphanumeric) {
        true => format!("_{tight}"),
        false => format!("_({tight})"),
    })
}

/// Returns a text as an exponent: `²`, or `^θ` if Unicode lacks a character.
pub(super) fn superscript(text: &str) -> String {
    let tight = tight(text);
    small(&tight, RAISED, SUPERSCRIPTS).unwrap_or_else(|| match tight.chars().count() {
        1 => format!("^{tight}"),
        _ => format!("^({tight})"),
    })
}

fn tight(text: &str) -> String {
    text.chars().filter(|c| *c != ' ').collect()
}

fn small(text: &str, plain: &str, small: &str) -> Option<String> {
    let of = |c: char| plain.chars().zip(small.chars()).find(|(p, _)| *p == c).map(|(_, s)| s);
    text.chars().map(of).collect()
}

/// Returns a letter or digit in bold, which MathML Core has as separate characters.
pub(super) fn bold(c: char) -> char {
    let from = |start: u32, first: char| char::from_u32(start + u32::from(c) - u32::from(first)).unwrap_or(c);
    match c {
        'A'..='Z' => from(0x1d400, 'A'),
        'a'..='z' => from(0x1d41a, 'a'),
        'Α'..='Ω' => from(0x1d6a8, 'Α'),
        'α'..='ω' => from(0x1d6c2, 'α'),
        '0'..='9' => from(0x1d7ce, '0'),
        _ => c,
    }
}
