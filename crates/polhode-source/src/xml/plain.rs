//! Copy of an XML text that a strict parser accepts quickly, with unchanged byte offsets.
//!
//! Readers of models are namespace-unaware and accept `--` in comments; the parser of the tree is
//! strict. It therefore gets a copy of the text of the same length. In the copy, comments and
//! processing instructions are blank, and the colons of names are underscores. Offsets in the copy
//! are offsets in the text, and attribute values are unchanged. The copy also avoids inputs that
//! make a strict parser slow: thousands of namespaces, and elements with more attributes than any
//! supported language has, which the parser compares pairwise.

use std::ops::Range;

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

/// Limit on attributes per element, several times the largest number in the supported languages.
const MOST_ATTRIBUTES: usize = 256;

/// Returns the text with comments, instructions and namespaces blanked, of the same length in
/// bytes.
pub fn plain(text: &str) -> Result<String, ContentError> {
    let mut copy = String::with_capacity(text.len());
    while let Some(rest) = text.get(copy.len()..).filter(|rest| !rest.is_empty()) {
        let here = copy.len();
        if let Some(comment) = rest.strip_prefix("<!--") {
            let length = 4 + end(comment, "-->", here, 4, "the end of the comment, -->")?;
            blank(&mut copy, rest, length);
        } else if let Some(instruction) = rest.strip_prefix("<?") {
            let length = 2 + end(instruction, "?>", here, 2, "the end of the instruction, ?>")?;
            blank(&mut copy, rest, length);
        } else if let Some(section) = rest.strip_prefix("<![CDATA[") {
            let length = 9 + end(section, "]]>", here, 9, "the end of the CDATA section, ]]>")?;
            copy.push_str(rest.get(..length).unwrap_or(rest));
        } else if rest.starts_with("<!") {
            let what = "document type definitions (<!DOCTYPE …>): they can refer to other files and entities"
                .to_owned();
            return Err(ContentError::new(
                ContentErrorKind::Unsupported { what },
                ContentPlace::Text(here..here + 9),
            )
            .hint("remove the DOCTYPE: models do not need it"));
        } else if rest.starts_with('<') {
            tag(&mut copy, rest)?;
        } else {
            copy.push_str(rest.split_once('<').map_or(rest, |(words, _)| words));
        }
    }
    Ok(copy)
}

/// Returns the number of bytes up to and including `close`, or an error if it is missing.
fn end(rest: &str, close: &str, at: usize, opening: usize, what: &str) -> Result<usize, ContentError> {
    rest.find(close).map(|found| found + close.len()).ok_or_else(|| missing(what, at..at + opening))
}

fn missing(what: &str, span: Range<usize>) -> ContentError {
    let kind = ContentErrorKind::Expected { what: what.to_owned(), found: String::new() };
    ContentError::new(kind, ContentPlace::Text(span))
}

/// Appends as many blanks as bytes; line ends are kept.
fn blank(copy: &mut String, rest: &str, length: usize) {
    let bytes = rest.bytes().take(length);
    copy.extend(bytes.map(|byte| if byte == b'\n' || byte == b'\r' { char::from(byte) } else { ' ' }));
}

/// Copies a tag up to its `>`; colons outside quotes become underscores.
fn tag(copy: &mut String, rest: &str) -> Result<(), ContentError> {
    let here = copy.len();
    let mut attributes = 0;
    let mut rest = rest;
    // Each pass reads the text before a quote or the end, and the quoted text.
    while let Some((outside, from_mark, mark)) = up_to_mark(rest, copy.len() == here) {
        if outside.contains(':') {
            copy.push_str(&outside.replace(':', "_"));
        } else {
            copy.push_str(outside);
        }
        match mark {
            b'>' => {
                copy.push('>');
                return Ok(());
            }
            b'<' => return Ok(()), // the parser of the tree reports it with its place
            quote => {
                attributes += 1;
                if attributes > MOST_ATTRIBUTES {
                    let value = format!("more than {MOST_ATTRIBUTES}");
                    let rule = "those of a model, which are fewer".to_owned();
                    let kind = ContentErrorKind::Value {
                        what: "the attributes of the element".to_owned(),
                        value,
                        rule,
                    };
                    return Err(ContentError::new(kind, ContentPlace::Text(here..here + 1)));
                }
                let quote = char::from(quote);
                let length = from_mark.get(1..).and_then(|value| value.find(quote));
                let length = length
                    .ok_or_else(|| missing("the quote that ends the value", copy.len()..copy.len() + 1))?;
                let (value, after) = from_mark.split_at(length + 2);
                copy.push_str(value);
                rest = after;
            }
        }
    }
    Err(missing("the end of the tag, >", here..here + 1))
}

/// Splits at the next quote or angle bracket: text before it, text from it, and the mark itself.
/// Skips the opening bracket of the tag.
fn up_to_mark(rest: &str, is_first: bool) -> Option<(&str, &str, u8)> {
    let from = usize::from(is_first);
    let stop = from + rest.get(from..)?.find(['"', '\'', '>', '<'])?;
    let (outside, from_mark) = rest.split_at_checked(stop)?;
    Some((outside, from_mark, *from_mark.as_bytes().first()?))
}

/// Returns the offset of a second root element in a plain text; `None` if there is none.
pub fn second_root(copy: &str) -> Option<usize> {
    let (mut depth, mut at) = (0_usize, 0);
    let mut is_over = false;
    loop {
        at += copy.get(at..)?.find('<')?;
        let rest = copy.get(at..)?;
        if is_over {
            return Some(at);
        }
        if rest.starts_with("<![CDATA[") {
            at += rest.find("]]>")?;
            continue;
        }
        let mut length = 0;
        // The tag ends at the first > outside quotes.
        loop {
            length += rest.get(length..)?.find(['"', '\'', '>'])?;
            let mark = *rest.as_bytes().get(length)?;
            length += 1;
            if mark == b'>' {
                break;
            }
            length += rest.get(length..)?.find(char::from(mark))? + 1;
        }
        let tag = rest.get(..length)?;
        if tag.starts_with("</") {
            depth = depth.checked_sub(1)?;
        } else if !tag.ends_with("/>") {
            depth += 1;
        }
        is_over = depth == 0;
        at += length;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_keeps_its_place() {
        let text = "\u{feff}<?xml?>\r\n<!-- -- é\n --><a b:c = 'x:\"&gt;<!-- é' xmlns:q=\"u:v\">t:u<![CDATA[<x:y>]]></a>\n";
        let copy = plain(text).unwrap();
        let expected = "\u{feff}       \r\n          \n    <a b_c = 'x:\"&gt;<!-- é' xmlns_q=\"u:v\">t:u<![CDATA[<x:y>]]></a>\n";
        assert_eq!(copy, expected);
        assert_eq!(copy.len(), text.len());
    }

    #[test]
    fn a_second_root_begins_after_the_first() {
        for (text, at) in [
            ("<a x='</a>'><a/><![CDATA[</a><b>]]></a> <b/>", Some(40)),
            ("<a/><b/>", Some(4)),
            ("<a><b></b></a>\n", None),
            ("<a><b></a>", None),
            ("</a><b/>", None),
        ] {
            assert_eq!(second_root(text), at, "{text}");
        }
    }

    #[test]
    fn what_has_no_end_is_said_where_it_begins() {
        for (text, start) in [
            ("<a/><!-- <b/>", 4),
            ("<?xml ", 0),
            ("<a> <![CDATA[ ]]", 4),
            ("<a ><b x='", 9),
            ("<a><b x='' ", 3),
        ] {
            let error = plain(text).unwrap_err();
            assert!(
                matches!(&error.place, ContentPlace::Text(span) if span.start == start),
                "{text} {error:?}"
            );
        }
    }
}
