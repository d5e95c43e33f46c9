//! Pages of figures: `docs/figures/README.md` for readers, `target/figures/index.html` to judge changes.

use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use similar::{ChangeTag, TextDiff};

use crate::figures::golden::{Golden, Standing, folder};
use crate::figures::{self, Figure, Rendered};

/// A figure as it was and as it is.
#[derive(Clone, Debug)]
pub struct Exhibit {
    /// The figure.
    pub figure: &'static Figure,
    /// What `docs/figures` has of it.
    pub old: Golden,
    /// What it is now.
    pub new: Rendered,
    /// How the two compare.
    pub standing: Standing,
}

const PAGE_HEAD: &str = "<!doctype html>
<meta charset=\"utf-8\">
<title>Figures: old, new, difference</title>
<style>
body { font: 15px/1.4 Helvetica, Arial, sans-serif; margin: 2em; color: #1c2026; }
.row { display: grid; grid-template-columns: repeat(3, 1fr); gap: 1em; align-items: start; }
.row img { width: 100%; border: 1px solid #e9ecf0; }
.difference { position: relative; background: #fff; isolation: isolate; }
.difference img + img { position: absolute; inset: 0; mix-blend-mode: difference; }
pre { background: #f6f7f9; padding: 1em; overflow-x: auto; }
ins { background: #d9f2dd; text-decoration: none; } del { background: #f5d9d3; text-decoration: none; }
.fresh { color: #2e7d4f; } .stale, .missing { color: #b53a2e; }
</style>
<h1>Figures: old, new, difference</h1>
";

/// Writes `target/figures/index.html` with old, new and difference of every figure, and returns its path.
///
/// # Errors
/// When the folder cannot be written.
pub fn write_comparison(exhibits: &[Exhibit]) -> io::Result<PathBuf> {
    let folder = target_folder().join("figures");
    fs::create_dir_all(&folder)?;
    let mut page = PAGE_HEAD.to_owned();
    // What has changed comes first.
    let (fresh, changed): (Vec<&Exhibit>, Vec<&Exhibit>) = exhibits
        .iter()
        .partition(|exhibit| exhibit.standing == Standing::Fresh);
    for exhibit in changed.into_iter().chain(fresh) {
        write_section(&mut page, &folder, exhibit)?;
    }
    let path = folder.join("index.html");
    fs::write(&path, page)?;
    Ok(path)
}

fn write_section(page: &mut String, folder: &Path, exhibit: &Exhibit) -> io::Result<()> {
    let name = exhibit.figure.name;
    let none = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1\" height=\"1\"/>";
    fs::write(
        folder.join(format!("{name}.old.svg")),
        exhibit.old.svg.as_deref().unwrap_or(none),
    )?;
    fs::write(folder.join(format!("{name}.new.svg")), &exhibit.new.svg)?;
    let standing = exhibit.standing;
    let _ = write!(
        page,
        "<h2>{name} <small class=\"{standing}\">{standing}</small></h2>\n<p>{caption}</p>\n<div class=\"row\">\
         <img src=\"{name}.old.svg\" alt=\"old\"><img src=\"{name}.new.svg\" alt=\"new\">\
         <div class=\"difference\"><img src=\"{name}.old.svg\" alt=\"old\"><img src=\"{name}.new.svg\" alt=\"difference\"></div>\
         </div>\n<pre>{summary}</pre>\n",
        caption = html(exhibit.figure.caption),
        summary = marked_difference(
            exhibit.old.summary.as_deref().unwrap_or(""),
            &exhibit.new.summary
        ),
    );
    Ok(())
}

/// The new text with what has gone and what has come marked.
fn marked_difference(old: &str, new: &str) -> String {
    let difference = TextDiff::from_lines(old.trim_end(), new.trim_end());
    let mark = |tag, line: &str| match tag {
        ChangeTag::Equal => html(line),
        ChangeTag::Delete => format!("<del>{}</del>", html(line)),
        ChangeTag::Insert => format!("<ins>{}</ins>", html(line)),
    };
    difference
        .iter_all_changes()
        .map(|change| mark(change.tag(), change.value()))
        .collect()
}

fn html(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

/// The folder of this build: the program lies in `target/PROFILE`.
fn target_folder() -> PathBuf {
    let program = std::env::current_exe().ok();
    let target = program
        .as_deref()
        .and_then(|program| program.ancestors().nth(2))
        .map(Path::to_owned);
    target.unwrap_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../target"))
}

/// Writes `docs/figures/README.md`: every figure with its caption.
///
/// # Errors
/// When it cannot be written.
pub fn write_readme() -> io::Result<()> {
    fs::write(readme_path(), readme())
}

/// Whether `docs/figures/README.md` is what it would be written as.
#[must_use]
pub fn readme_is_fresh() -> bool {
    fs::read_to_string(readme_path()).is_ok_and(|text| text == readme())
}

fn readme_path() -> PathBuf {
    folder().join("README.md")
}

fn readme() -> String {
    let mut page = "# Figures\n\n\
        Made by `cargo xtask figures` from the data sets in `fixtures`; beside each picture, `NAME_summary.snap` has our numbers and the\n\
        paper's. `cargo test` compares both with what the code gives. Written by the same command: change captions in `xtask/src/figures`.\n"
        .to_owned();
    for figure in figures::all() {
        let (name, caption) = (figure.name, figure.caption);
        let _ = write!(
            page,
            "\n## {name}\n\n![{name}]({name}.snap.svg)\n\n{caption} [Numbers]({name}_summary.snap)\n"
        );
    }
    page
}

#[cfg(test)]
mod tests {
    use super::marked_difference;

    #[test]
    fn lines_that_go_and_come_are_marked_and_escaped() {
        let marked = marked_difference("blocks 36\nangle < 46", "blocks 36\nangle < 47");
        assert_eq!(
            marked,
            "blocks 36\n<del>angle &lt; 46</del><ins>angle &lt; 47</ins>"
        );
    }
}
