//! Relationships between the entries of a package.

use super::archive::Archive;
use super::xml::{Token, Xml};
use crate::content::ContentError;

/// Relationship of an entry to another entry.
#[derive(Debug, Default)]
pub struct Relation {
    /// Identifier used by other entries to refer to it.
    pub id: String,
    /// Type of the relationship, a URI.
    pub kind: String,
    /// Name of the target entry, relative to the folder of the source entry, or absolute.
    pub target: String,
}

/// Reads the relationships in an entry; none if the entry does not exist.
pub fn relations(archive: &mut Archive<'_>, path: &str) -> Result<Vec<Relation>, ContentError> {
    let mut all = Vec::new();
    if !archive.has(path) {
        return Ok(all);
    }
    let mut xml = Xml::new(archive.stream(path)?, path);
    let mut buffer = Vec::new();
    loop {
        match xml.next(&mut buffer)? {
            Token::Start(element) if element.local_name().into_inner() == "Relationship" => {
                let values = xml.values(&element, ["Id", "Type", "Target"])?;
                let [id, kind, target] = values.map(|value| value.unwrap_or_default().into_owned());
                all.push(Relation { id, kind, target });
            }
            Token::Eof => return Ok(all),
            Token::Start(_) | Token::Text(_) | Token::End | Token::Other => {}
        }
    }
}
