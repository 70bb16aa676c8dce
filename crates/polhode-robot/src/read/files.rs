//! Files that a model includes. In MJCF, `<include>` inserts the elements of another file, once per
//! file, and `<model>` is a separate model. In SDF, `<include>` inserts a model and may be
//! repeated.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use polhode_source::FormatError;
use polhode_source::files::Files;
use polhode_source::read_text_file;
use polhode_source::xml::{plain, second_root};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use crate::model::{Note, Source, Span};
use crate::read::uri::Roots;
use crate::read::xml::{Document, Element, Forest, Links};

/// True in builds that read languages with includes: SDF and MJCF.
const INCLUDES: bool = cfg!(feature = "languages");

/// Maximum number of files of a model.
const MOST_FILES: usize = 1000;

/// Include syntax of a language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Naming {
    /// Language without include elements.
    Nothing,
    Sdf,
    Mjcf,
}

/// Texts of a model, the main one first.
pub(super) struct ModelFiles {
    pub(super) sources: Vec<Source>,
    /// Preprocessed texts.
    copies: Vec<String>,
    links: Links,
    /// True if included elements replace the element that includes them.
    splices: bool,
    /// Base folder of the paths in each text: that of the including model.
    pub(super) folders: Vec<PathBuf>,
    /// Notes about files that cannot be read.
    pub(super) notes: Vec<Note>,
}

/// File that waits to be read.
struct Waiting {
    source: Source,
    /// Index of the main file of its model.
    main: usize,
}

impl ModelFiles {
    /// Reads all files of a model.
    pub(super) fn of(
        text: String,
        path: &Path,
        roots: &Roots<'_>,
        naming: Naming,
    ) -> Result<Self, FormatError> {
        let mut files = Self {
            sources: vec![],
            copies: vec![],
            links: Links::new(),
            splices: false,
            folders: vec![],
            notes: vec![],
        };
        let mut next = text.len() + 1;
        let mut waiting = vec![Waiting { source: Source { path: path.to_owned(), text, start: 0 }, main: 0 }];
        let mut included = HashSet::new();
        // Files that are read once but may be named several times.
        let mut models = HashMap::new();
        if naming == Naming::Sdf
            && let Ok(own) = roots.files.canonical(path)
        {
            models.insert(own, 0);
        }
        // Files are numbered in the order in which they are named.
        let mut number = 0;
        while number < waiting.len() {
            let Some(Waiting { source, main }) = waiting.get(number) else { break };
            let (main, folder) = (*main, folder(roots.files, &source.path));
            let main_folder = files.folders.get(main).unwrap_or(&folder).clone();
            let (copy, named) = files.named(source, naming)?;
            for Named { byte, element, file, is_model } in named.into_iter().filter(|_| INCLUDES) {
                let span = source_span(&waiting, number, &element);
                let resolved = |within: &Path| match naming {
                    Naming::Sdf => roots.resolve_model(&file, within),
                    _ => roots.resolve(&file, within),
                };
                let found = resolved(&main_folder).or_else(|why| resolved(&folder).map_err(|_| why));
                let found = match found {
                    Ok(found) => found,
                    Err(why) => {
                        let message =
                            format!("<include> of {file:?} is not read, so its content is unknown: {why}");
                        let is_asset = is_model && naming == Naming::Mjcf;
                        let code = if is_asset { "read.left_out" } else { "read.include" };
                        files.notes.push(Note::new(code, "", span, message));
                        continue;
                    }
                };
                if is_model && let Some(&target) = models.get(&found) {
                    files.links.insert((number, byte), target);
                    continue;
                }
                let is_own =
                    waiting.get(main).is_some_and(|file| same(roots.files, &file.source.path, &found));
                let is_known = !is_model && (is_own || !included.insert((main, found.clone())));
                if is_known || waiting.len() >= MOST_FILES {
                    return Err(refused(&waiting, number, element, &file, is_known));
                }
                let text = read_text_file(roots.files, &found, |text| Ok(text.to_owned()))?;
                let target = waiting.len();
                let start = next;
                next += text.len() + 1;
                if is_model {
                    models.insert(found.clone(), target);
                }
                let main = if is_model { target } else { main };
                waiting.push(Waiting { source: Source { path: found, text, start }, main });
                files.links.insert((number, byte), target);
            }
            files.copies.push(copy);
            files.folders.push(if main == number { folder } else { main_folder });
            number += 1;
        }
        files.sources = waiting.into_iter().map(|file| file.source).collect();
        if INCLUDES && naming == Naming::Sdf {
            files.require_no_circle()?;
        }
        files.splices = naming == Naming::Mjcf;
        Ok(files)
    }

    /// Returns an error if a model includes itself, directly or through other models.
    fn require_no_circle(&self) -> Result<(), FormatError> {
        // Repeatedly removes files that include none of the remaining files; the remainder is
        // circular.
        let mut left: Vec<((usize, usize), usize)> =
            self.links.iter().map(|(&from, &to)| (from, to)).collect();
        left.sort_unstable();
        loop {
            let open: HashSet<usize> = left.iter().map(|((file, _), _)| *file).collect();
            let before = left.len();
            left.retain(|(_, target)| open.contains(target));
            if left.len() == before {
                break;
            }
        }
        let Some(&((file, byte), _)) = left.first() else { return Ok(()) };
        let Some(source) = self.sources.get(file) else { return Ok(()) };
        let what = "a model that includes itself";
        let place = ContentPlace::Text(byte..byte + 1);
        let error = ContentError::new(ContentErrorKind::unsupported(what), place);
        Err(FormatError::of_content(&source.path, source.text.as_bytes(), error))
    }

    /// Returns the preprocessed text and the files that it names.
    fn named(&mut self, source: &Source, naming: Naming) -> Result<(String, Vec<Named>), FormatError> {
        let located = |error| FormatError::of_content(&source.path, source.text.as_bytes(), error);
        let mut copy = plain(&source.text).map_err(located)?;
        if INCLUDES
            && naming == Naming::Mjcf
            && let Some(second) = second_root(&copy)
        {
            let rest = copy.split_off(second);
            let span = source.start + second..source.start + second + 1;
            let message = "a second root element: MuJoCo reads only the first".to_owned();
            self.notes.push(Note::new("read.left_out", "", span, message));
            copy.extend(rest.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }));
        }
        let document = Document::parse(&source.text, &copy).map_err(located)?;
        let forest = Forest::of_one(&document);
        let mut named = Vec::new();
        let mut elements = vec![(forest.root(), false)];
        while let Some((element, in_assets)) = elements.pop() {
            let is_asset = element.name() == "model" && in_assets;
            let file = match naming {
                _ if !INCLUDES => None,
                Naming::Mjcf if element.name() == "include" || is_asset => element.attribute("file"),
                Naming::Sdf if element.name() == "include" => element.child_text("uri"),
                _ => None,
            };
            if let Some(file) = file {
                let (byte, is_model) = (element.span().start, is_asset || naming == Naming::Sdf);
                named.push(Named { byte, element: element.span(), file: file.value.to_owned(), is_model });
            }
            elements.extend(element.children().map(|child| (child, element.name() == "asset")));
        }
        named.sort_by_key(|named| named.byte);
        Ok((copy, named))
    }

    /// Returns the maximum total bytes of names joined by `::`. Models nested a thousand levels
    /// deep would otherwise exhaust the memory.
    pub(super) fn most_name_bytes(&self) -> usize {
        const FOR_EACH_BYTE: usize = 16;
        const WITH_INCLUDED: usize = 1 << 26;
        let all: usize = self.sources.iter().map(|source| source.text.len()).sum();
        FOR_EACH_BYTE * all + if self.sources.len() > 1 { WITH_INCLUDED } else { 0 }
    }

    /// Returns the base folder for the paths of an element.
    pub(super) fn folder(&self, element: Element<'_>) -> &Path {
        self.folders.get(element.tree()).map_or(Path::new(""), PathBuf::as_path)
    }

    /// Applies a function to the root of the main file. An error in any file is reported with that
    /// file.
    pub(super) fn with_root<T>(
        &self,
        read: impl FnOnce(Element<'_>) -> Result<T, ContentError>,
    ) -> Result<T, FormatError> {
        let mut documents = Vec::new();
        for (source, copy) in self.sources.iter().zip(&self.copies) {
            let document = Document::parse(&source.text, copy);
            documents.push(
                document
                    .map_err(|error| FormatError::of_content(&source.path, source.text.as_bytes(), error))?,
            );
        }
        let starts = self.sources.iter().map(|source| source.start);
        let forest = Forest::of(documents.iter().zip(starts), self.links.clone(), self.splices)
            .map_err(|error| self.located(error))?;
        read(forest.root()).map_err(|error| self.located(error))
    }

    fn located(&self, mut error: ContentError) -> FormatError {
        let start = if let ContentPlace::Text(span) = &error.place { span.start } else { 0 };
        let source = self.sources.iter().rev().find(|source| source.start <= start);
        let Some(source) = source.or(self.sources.first()) else {
            return FormatError::of_content(Path::new(""), b"", error);
        };
        if let ContentPlace::Text(span) = &mut error.place {
            *span = span.start - source.start..span.end - source.start;
        }
        FormatError::of_content(&source.path, source.text.as_bytes(), error)
    }
}

/// File that an element names.
struct Named {
    /// First byte of the element in its file.
    byte: usize,
    element: Span,
    file: String,
    is_model: bool,
}

fn source_span(files: &[Waiting], number: usize, span: &Span) -> Span {
    let start = files.get(number).map_or(0, |file| file.source.start);
    start + span.start..start + span.end
}

/// Returns the folder of a file.
fn folder(files: &dyn Files, path: &Path) -> PathBuf {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    files.canonical(folder).unwrap_or_else(|_| folder.to_owned())
}

fn same(files: &dyn Files, path: &Path, canonical: &Path) -> bool {
    files.canonical(path).is_ok_and(|path| path == canonical)
}

/// Returns the error for a file that is included twice, which MuJoCo rejects and which could
/// recurse without end.
fn refused(files: &[Waiting], number: usize, span: Span, file: &str, is_known: bool) -> FormatError {
    let what = if is_known {
        format!("{file:?} included a second time, which MuJoCo refuses")
    } else {
        format!("a model with more than {MOST_FILES} files")
    };
    let error = ContentErrorKind::unsupported(what).at(span);
    match files.get(number) {
        Some(Waiting { source, .. }) => FormatError::of_content(&source.path, source.text.as_bytes(), error),
        None => FormatError::of_content(Path::new(file), b"", error),
    }
}
