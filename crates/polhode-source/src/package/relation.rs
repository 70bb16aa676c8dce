//! Which entries of a package belong to which.

use super::archive::Archive;
use super::xml::{Token, Xml};
use crate::content::ContentError;

/// An entry that belongs to another.
#[derive(Debug, Default)]
pub struct Relation {
    /// Identifier, by which entries refer to it.
    pub id: String,
    /// What it is, an address.
    pub kind: String,
    /// Its name; relative to the folder of the other, or absolute.
    pub target: String,
}

/// The relations in an entry; none if it is not there.
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
