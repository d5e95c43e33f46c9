//! What `docs/papers.md` names exists. A test of the package `xtask` that lies here because `cargo insta review` looks for
//! snapshots that wait for review only beside the sources of a package: this is how it finds `docs/figures`.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The pieces of `docs/papers.md` in backticks that name a source file, with the item in it if there is one.
fn named_places(text: &str) -> Vec<(String, Option<String>)> {
    let quoted = text
        .split('`')
        .skip(1)
        .step_by(2)
        .filter(|piece| piece.contains(".rs"));
    quoted
        .map(|piece| match piece.split_once("::") {
            Some((file, item)) => (file.to_owned(), Some(item.to_owned())),
            None => (piece.to_owned(), None),
        })
        .collect()
}

fn read(file: &str) -> Option<String> {
    [root().join("crates").join(file), root().join(file)]
        .iter()
        .find_map(|path| fs::read_to_string(path).ok())
}

fn defines(source: &str, item: &str) -> bool {
    ["fn", "struct", "enum", "trait", "const", "type"]
        .iter()
        .any(|keyword| {
            source
                .match_indices(&format!("{keyword} {item}"))
                .any(|(at, found)| {
                    !source[at + found.len()..]
                        .starts_with(|c: char| c.is_alphanumeric() || c == '_')
                })
        })
}

#[test]
fn every_file_and_item_that_papers_md_names_exists() {
    let text = fs::read_to_string(root().join("docs/papers.md")).unwrap();
    let places = named_places(&text);
    assert!(places.len() > 80, "{} places", places.len());
    let lost: Vec<_> = places
        .iter()
        .filter(|(file, item)| {
            !read(file)
                .is_some_and(|source| item.as_ref().is_none_or(|item| defines(&source, item)))
        })
        .collect();
    assert!(lost.is_empty(), "{lost:?}");
}

#[test]
fn every_link_of_papers_md_leads_to_a_file() {
    let text = fs::read_to_string(root().join("docs/papers.md")).unwrap();
    let targets = text
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next());
    let lost: Vec<&str> = targets
        .filter(|target| !root().join("docs").join(target).exists())
        .collect();
    assert!(lost.is_empty(), "{lost:?}");
}
