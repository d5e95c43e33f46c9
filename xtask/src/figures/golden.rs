//! Golden figures: insta snapshots in `docs/figures`, pictures compared with a tolerance and summaries exactly.

use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use insta::internals::SnapshotContents;
use insta::{Comparator, DefaultComparator, Settings, Snapshot};

use super::tolerance::same_picture;
use super::{Figure, Rendered};

/// What becomes of a figure's name in the name of its summary.
const SUMMARY: &str = "_summary";

/// The folder of the golden figures.
#[must_use]
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/figures")
}

/// A figure as `docs/figures` has it.
#[derive(Clone, Debug, Default)]
pub struct Golden {
    /// The picture, if there is one.
    pub svg: Option<String>,
    /// The summary, if there is one.
    pub summary: Option<String>,
}

/// How a figure stands to its golden.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Picture and summary agree.
    Fresh,
    /// The picture, the summary or both have changed.
    Stale,
    /// There is no golden picture or no golden summary.
    Missing,
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Fresh => "fresh",
            Self::Stale => "stale",
            Self::Missing => "missing",
        })
    }
}

impl Golden {
    /// Reads the golden of a figure; what cannot be read is missing.
    #[must_use]
    pub fn of(figure: &Figure) -> Self {
        let read = |name: &str| Snapshot::from_file(&folder().join(format!("{name}.snap"))).ok();
        Self {
            svg: read(figure.name).as_ref().and_then(picture_of),
            summary: read(&format!("{}{SUMMARY}", figure.name))
                .as_ref()
                .and_then(text_of),
        }
    }

    /// How `rendered` stands to this golden.
    #[must_use]
    pub fn standing(&self, rendered: &Rendered) -> Standing {
        match (&self.svg, &self.summary) {
            (Some(svg), Some(summary)) => {
                let fresh = same_picture(svg, &rendered.svg)
                    && summary.trim_end() == rendered.summary.trim_end();
                if fresh {
                    Standing::Fresh
                } else {
                    Standing::Stale
                }
            }
            _ => Standing::Missing,
        }
    }
}

/// Asserts that a figure's picture is what its golden shows; insta decides what a difference leads to (`INSTA_UPDATE`).
///
/// # Panics
/// When insta finds a difference and is not told to accept it.
pub fn assert_picture(figure: &Figure, rendered: &Rendered) {
    let picture = format!("{}.svg", figure.name);
    settings(figure)
        .bind(|| insta::assert_binary_snapshot!(&picture, rendered.svg.clone().into_bytes()));
}

/// The same for its summary.
///
/// # Panics
/// When insta finds a difference and is not told to accept it.
pub fn assert_summary(figure: &Figure, rendered: &Rendered) {
    let summary = format!("{}{SUMMARY}", figure.name);
    settings(figure).bind(|| insta::assert_snapshot!(summary, rendered.summary));
}

fn settings(figure: &Figure) -> Settings {
    let mut settings = Settings::new();
    settings.set_snapshot_path(folder());
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_description(figure.caption);
    settings.set_comparator(Box::new(PicturesAlike));
    settings
}

/// Files in `docs/figures` that belong to no figure.
///
/// # Errors
/// When the folder cannot be read.
pub fn orphans() -> io::Result<Vec<PathBuf>> {
    let owned: BTreeSet<String> = super::all()
        .flat_map(|figure| {
            [
                format!("{}.snap", figure.name),
                format!("{}.snap.svg", figure.name),
                format!("{}{SUMMARY}.snap", figure.name),
            ]
        })
        .collect();
    let mut orphans = Vec::new();
    for entry in fs::read_dir(folder())? {
        let path = entry?.path();
        let name = path
            .file_name()
            .and_then(|name| name.to_str())
            .unwrap_or_default();
        // Snapshots that wait for review are no orphans.
        if name.contains(".snap") && !name.contains(".snap.new") && !owned.contains(name) {
            orphans.push(path);
        }
    }
    orphans.sort();
    Ok(orphans)
}

fn picture_of(snapshot: &Snapshot) -> Option<String> {
    match snapshot.contents() {
        SnapshotContents::Binary(Some(bytes)) => String::from_utf8(bytes.to_vec()).ok(),
        _ => None,
    }
}

fn text_of(snapshot: &Snapshot) -> Option<String> {
    snapshot.as_text().map(ToString::to_string)
}

/// Compares pictures with a tolerance and everything else as insta does.
struct PicturesAlike;

impl Comparator for PicturesAlike {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        match (picture_of(reference), picture_of(test)) {
            (Some(a), Some(b)) => same_picture(&a, &b),
            _ => DefaultComparator.matches(reference, test),
        }
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(Self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn golden(svg: &str, summary: &str) -> Golden {
        Golden {
            svg: Some(svg.to_owned()),
            summary: Some(summary.to_owned()),
        }
    }

    fn rendered() -> Rendered {
        Rendered {
            svg: "<path d=\"M1 2\"/>".to_owned(),
            summary: "angle 1.0\n".to_owned(),
        }
    }

    #[test]
    fn a_figure_is_fresh_up_to_what_the_eye_cannot_see() {
        assert_eq!(
            golden("<path d=\"M1.001 2\"/>", "angle 1.0").standing(&rendered()),
            Standing::Fresh
        );
    }

    #[test]
    fn a_summary_that_differs_at_all_is_stale() {
        assert_eq!(
            golden("<path d=\"M1 2\"/>", "angle 1.001").standing(&rendered()),
            Standing::Stale
        );
    }

    #[test]
    fn a_figure_without_picture_or_without_summary_is_missing() {
        let whole = golden("", "");
        for part in [
            Golden {
                svg: None,
                ..whole.clone()
            },
            Golden {
                summary: None,
                ..whole
            },
        ] {
            assert_eq!(part.standing(&rendered()), Standing::Missing);
        }
    }
}
