//! Plots: assignment of figures to files.

use std::fs;
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_document::Picture;
use polhode_scenario::report::{Figure, MotionFigures, PlotError};
use polhode_source::shown;

use crate::failure::Failure;
use crate::partial;

#[derive(Debug, Args)]
#[command(next_help_heading = "Plots")]
pub(crate) struct PlotFlags {
    /// Draw all figures of the motion into FILE.svg or FILE.png; NAME=FILE draws one of them:
    /// omega, euler, pointing, axis, energy, momentum, wheels, torque, drift, polhodes or
    /// herpolhode. May be repeated.
    #[arg(long, value_name = "[NAME=]FILE", value_parser = plot)]
    plot: Vec<Plot>,
}

/// Figure, or all figures, with the output file.
#[derive(Clone, Debug, PartialEq)]
struct Plot {
    figure: Option<Figure>,
    path: PathBuf,
    format: Format,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Format {
    Svg,
    Png,
}

impl PlotFlags {
    pub(crate) const fn wanted(&self) -> bool {
        !self.plot.is_empty()
    }

    /// Refuses existing files, unless they may be replaced or are plots of the same command, and
    /// one file for two plots.
    pub(crate) fn check(&self, force: bool, maker: Option<&str>) -> Result<(), Failure> {
        for (k, Plot { path, .. }) in self.plot.iter().enumerate() {
            let shown = shown(path);
            if self.plot.iter().take(k).any(|other| other.path == *path) {
                let hint = "use a separate file for each plot";
                return Err(Failure::usage(format!("two plots have the same file, {shown}"), hint));
            }
            let is_file = match fs::symlink_metadata(path) {
                Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
                Err(error) => return Err(Failure::Output { path: shown, error }),
                Ok(meta) => meta.is_file(),
            };
            let is_own = || maker.is_some_and(|maker| is_made_by(path, maker));
            if !(is_file && (force || is_own())) {
                let hint = if is_file {
                    "choose another file, or overwrite it with --force"
                } else {
                    "choose another file"
                };
                return Err(Failure::usage(format!("{shown} already exists"), hint));
            }
        }
        Ok(())
    }

    /// Draws all figures without writing files.
    pub(crate) fn draw(
        &self,
        motion: &MotionFigures<'_>,
        force: bool,
        maker: Option<&str>,
    ) -> Result<Drawn, Failure> {
        let failed = |error: &PlotError| Failure::usage(error.to_string(), error.hint());
        let drawn: Result<Vec<_>, Failure> = self
            .plot
            .iter()
            .map(|plot| {
                let picture = plot.figure.map_or_else(|| motion.overview(), |figure| motion.draw(figure));
                let picture = picture.map_err(|error| failed(&error))?;
                let picture = if let Some(maker) = maker { picture.made_by(maker) } else { picture };
                let replaces = force || maker.is_some_and(|maker| is_made_by(&plot.path, maker));
                Ok((plot.path.clone(), plot.format.encode(&picture)?, replaces))
            })
            .collect();
        Ok(Drawn { files: drawn? })
    }
}

impl Format {
    #[cfg(feature = "png")]
    fn encode(self, picture: &Picture) -> Result<Vec<u8>, Failure> {
        match self {
            Self::Svg => Ok(picture.to_svg().into_bytes()),
            Self::Png => picture.to_png().map_err(|error| Failure::usage(error.to_string(), error.hint())),
        }
    }

    #[cfg(not(feature = "png"))]
    fn encode(self, picture: &Picture) -> Result<Vec<u8>, Failure> {
        match self {
            Self::Svg => Ok(picture.to_svg().into_bytes()),
            Self::Png => Err(Failure::usage("this polhode was built without PNG", "write SVG")),
        }
    }
}

/// Pictures to be written last, because they may go into the folder of results.
#[derive(Debug)]
pub(crate) struct Drawn {
    /// Path and contents of each picture, and true if it may replace a file.
    files: Vec<(PathBuf, Vec<u8>, bool)>,
}

impl Drawn {
    /// Writes each picture, completely or not at all; returns a line that lists them.
    pub(crate) fn publish(self) -> Result<String, Failure> {
        let mut names = Vec::new();
        for (path, bytes, replaces) in &self.files {
            if let Some(parent) = path.parent() {
                fs::create_dir_all(parent).map_err(|error| partial::output(path, error))?;
            }
            partial::write(path, *replaces, |out| out.write_all(bytes))?;
            names.push(shown(path));
        }
        Ok(if names.is_empty() { String::new() } else { format!("wrote {}\n", names.join(", ")) })
    }
}

/// Returns true if a file is a picture that states this command as its origin.
fn is_made_by(path: &Path, maker: &str) -> bool {
    /// Number of bytes searched; the statement is at the start of a picture.
    const HEAD: u64 = 1 << 14;
    let mut head = Vec::new();
    let read = fs::File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    let is_picture = head.starts_with(b"<svg ") || head.starts_with(b"\x89PNG");
    read.is_ok() && is_picture && Picture::is_made_by(&head, maker)
}

/// Parses `omega=fig.svg` or `fig.svg`. A path that contains `=` must start with its folder:
/// `./a=b.svg`.
fn plot(text: &str) -> Result<Plot, String> {
    let names = Figure::ALL.map(Figure::name).join(", ");
    let (figure, path) = match text.split_once('=') {
        Some((name, path)) if !name.contains(['/', '\\', '.']) => {
            let figure = Figure::named(name)
                .ok_or_else(|| format!("unknown figure {name:?}; the figures are {names}"))?;
            (Some(figure), path)
        }
        _ => (None, text),
    };
    let ending = Path::new(path).extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let format = match ending.as_deref() {
        Some("svg") => Format::Svg,
        Some("png") => Format::Png,
        _ if Figure::named(path).is_some() => {
            return Err(format!("the file is missing; write {path}={path}.svg"));
        }
        _ => return Err("the file name of a plot ends with .svg or .png".to_owned()),
    };
    Ok(Plot { figure, path: PathBuf::from(path), format })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_is_a_figure_and_a_file() {
        let is = |text: &str, figure, format, path: &str| {
            assert_eq!(plot(text), Ok(Plot { figure, format, path: PathBuf::from(path) }), "{text}");
        };
        is("fig.svg", None, Format::Svg, "fig.svg");
        is("omega=out/ω.PNG", Some(Figure::Omega), Format::Png, "out/ω.PNG");
        is("./a=b.svg", None, Format::Svg, "./a=b.svg");
        for (wrong, says) in [
            ("fig", "ends with .svg"),
            ("fig.pdf", "ends with .svg"),
            ("speed=fig.svg", "the figures are omega, euler"),
            ("drift", "drift=drift.svg"),
            ("drift=", "ends with .svg"),
            ("=a.svg", "unknown figure"),
        ] {
            let error = plot(wrong).unwrap_err();
            assert!(error.contains(says), "{wrong}: {error}");
        }
    }
}
