//! `cargo xtask figures`: makes figures, shows what has changed, accepts it or, with `--check`, complains about it.

use std::env;
use std::error::Error;
use std::fs;
use std::process::Command;

use clap::Args;

use crate::figures::golden::{Golden, Standing, assert_picture, assert_summary, orphans};
use crate::figures::{self, Figure, Rendered};
use crate::gallery::{self, Exhibit};

/// What insta reads to learn whether it may overwrite snapshots.
const INSTA_UPDATE: (&str, &str) = ("INSTA_UPDATE", "always");

/// Arguments of `cargo xtask figures`.
#[derive(Args, Clone, Debug)]
pub struct FiguresArgs {
    /// Only figures whose name contains this.
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
    /// Change nothing in docs/figures; fail when a figure there is stale, missing or orphaned.
    #[arg(long)]
    check: bool,
}

impl FiguresArgs {
    fn selects(&self, figure: &Figure) -> bool {
        self.only
            .as_ref()
            .is_none_or(|part| figure.name.contains(part.as_str()))
    }
}

/// Runs the chore; `false` when `--check` found something.
///
/// # Errors
/// A figure that cannot be made, a name that no figure has, a folder that cannot be read or written.
pub fn figures(args: &FiguresArgs) -> Result<bool, Box<dyn Error>> {
    if !args.check && env::var_os(INSTA_UPDATE.0).is_none_or(|value| value != INSTA_UPDATE.1) {
        return accepting();
    }
    let exhibits = exhibits(args)?;
    let page = gallery::write_comparison(&exhibits)?;
    let in_order = if args.check {
        check(&exhibits, args)?
    } else {
        accept(&exhibits, args)?
    };
    println!(
        "{} figures; old, new and difference: {}",
        exhibits.len(),
        page.display()
    );
    Ok(in_order)
}

/// Runs this program again with insta told to accept, which is read from the environment only.
fn accepting() -> Result<bool, Box<dyn Error>> {
    let (name, value) = INSTA_UPDATE;
    let status = Command::new(env::current_exe()?)
        .args(env::args_os().skip(1))
        .env(name, value)
        .status()?;
    Ok(status.success())
}

fn exhibits(args: &FiguresArgs) -> Result<Vec<Exhibit>, Box<dyn Error>> {
    let exhibits: Vec<Exhibit> = figures::all()
        .filter(|figure| args.selects(figure))
        .map(exhibit)
        .collect::<Result<_, _>>()?;
    match &args.only {
        Some(part) if exhibits.is_empty() => {
            Err(format!("no figure's name contains `{part}`; there are {}", names()).into())
        }
        _ => Ok(exhibits),
    }
}

fn exhibit(figure: &'static Figure) -> Result<Exhibit, Box<dyn Error>> {
    let new: Rendered = (figure.render)().map_err(|error| format!("{}: {error}", figure.name))?;
    let old = Golden::of(figure);
    Ok(Exhibit {
        figure,
        standing: old.standing(&new),
        old,
        new,
    })
}

fn names() -> String {
    figures::all()
        .map(|figure| figure.name)
        .collect::<Vec<_>>()
        .join(", ")
}

/// Lists what is not in order; `true` when there is nothing.
fn check(exhibits: &[Exhibit], args: &FiguresArgs) -> Result<bool, Box<dyn Error>> {
    let mut complaints: Vec<String> = exhibits
        .iter()
        .filter(|exhibit| exhibit.standing != Standing::Fresh)
        .map(|exhibit| format!("{}: {}", exhibit.standing, exhibit.figure.name))
        .collect();
    if args.only.is_none() {
        complaints.extend(
            orphans()?
                .iter()
                .map(|path| format!("orphaned: {}", path.display())),
        );
        if !gallery::readme_is_fresh() {
            complaints.push("stale: docs/figures/README.md".to_owned());
        }
    }
    for complaint in &complaints {
        println!("{complaint}");
    }
    Ok(complaints.is_empty())
}

/// Accepts every figure, removes orphans and writes the gallery page.
fn accept(exhibits: &[Exhibit], args: &FiguresArgs) -> Result<bool, Box<dyn Error>> {
    for exhibit in exhibits {
        assert_picture(exhibit.figure, &exhibit.new);
        assert_summary(exhibit.figure, &exhibit.new);
    }
    if args.only.is_none() {
        for orphan in orphans()? {
            fs::remove_file(&orphan)?;
            println!("removed {}", orphan.display());
        }
    }
    gallery::write_readme()?;
    Ok(true)
}
