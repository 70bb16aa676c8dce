//! Letters: Greek names, superscripts, subscripts and bold forms of Unicode.

/// Greek letters with their names; capitals that look Latin have no name in LaTeX.
const GREEK: [(&str, char); 35] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
    ("ell", 'ℓ'),
];

/// Characters of indices. Unicode has more, but not all letters of any set: Nₓ next to N_y, or mₐ next
/// to m_b, would look like different things.
const PLAIN: &str = "0123456789+−=ijklmn";
const SUBSCRIPTS: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌ᵢⱼₖₗₘₙ";
const RAISED: &str = "0123456789+−=()abcdefghijklmnoprstuvwxyz";
const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻ";

/// Returns the letter with a name such as `omega`.
pub(super) fn greek(name: &str) -> Option<char> {
    GREEK.iter().find(|(other, _)| *other == name).map(|&(_, letter)| letter)
}

/// Returns the name of a Greek letter, which is its command in LaTeX.
pub(super) fn name(letter: char) -> Option<&'static str> {
    GREEK.iter().find(|(_, other)| *other == letter).map(|&(name, _)| name)
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
