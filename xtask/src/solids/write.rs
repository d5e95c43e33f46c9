//! `cargo xtask solids`: writes hard surfaces as OFF files.

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use clap::Args;
use glam::DVec3;
use mesh_io::{Cell, Cells, Mesh, write_mesh};

use super::check::{defect, defect_but_intersection};
use super::{FAMILIES, Family, Solid};

/// Arguments of `cargo xtask solids`.
#[derive(Args, Clone, Debug)]
pub struct SolidsArgs {
    /// Where the files go; the folder is made when it is not there.
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// How many surfaces.
    #[arg(long, default_value_t = 3000)]
    count: usize,
    /// What everything random is drawn from.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Only this family.
    #[arg(long, value_name = "NAME")]
    family: Option<String>,
    /// Judge every surface exactly before it is written, those of more than 20,000 triangles but for intersections; fail at the first
    /// that is not valid.
    #[arg(long)]
    check: bool,
}

/// Runs the chore.
///
/// # Errors
/// No such family, a folder that cannot be written, and with `--check` a surface that is not valid.
pub fn solids(args: &SolidsArgs) -> Result<(), Box<dyn Error>> {
    let families = families(args.family.as_deref())?;
    fs::create_dir_all(&args.folder)?;
    let mut triangles = 0;
    for index in 0..args.count {
        let family = families[index % families.len()];
        let solid = family.solid(index / families.len(), args.seed);
        if args.check
            && let Some(defect) = judged(&solid)
        {
            return Err(format!("{}: {defect}", solid.name).into());
        }
        triangles += solid.triangles.len();
        write_mesh(
            &args.folder.join(format!("{}.off", solid.name)),
            &mesh(&solid),
        )?;
    }
    println!(
        "{} surfaces of {} families, {triangles} triangles",
        args.count,
        families.len()
    );
    Ok(())
}

/// Whole only where needles, whose boxes all overlap, do not take hours.
fn judged(solid: &Solid) -> Option<String> {
    const FEW: usize = 20_000;
    if solid.triangles.len() <= FEW {
        defect(solid)
    } else {
        defect_but_intersection(solid)
    }
}

fn families(name: Option<&str>) -> Result<Vec<&'static Family>, Box<dyn Error>> {
    let wanted: Vec<&Family> = FAMILIES
        .iter()
        .filter(|family| name.is_none_or(|name| name == family.name))
        .collect();
    if wanted.is_empty() {
        let names: Vec<&str> = FAMILIES.iter().map(|family| family.name).collect();
        return Err(format!("there is no such family; there are {}", names.join(", ")).into());
    }
    Ok(wanted)
}

/// The solid as a file holds it; written as OFF and read, its coordinates have the same bits.
fn mesh(solid: &Solid) -> Mesh {
    let points = solid.points.iter().map(DVec3::to_array).collect();
    let cells: Cells = solid
        .triangles
        .iter()
        .copied()
        .map(Cell::Triangle)
        .collect();
    Mesh::new(points, cells)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mesh_io::off;

    #[test]
    fn files_read_back_bit_for_bit() {
        for family in &FAMILIES {
            let mesh = mesh(&family.solid(3, 5));
            let mut file = Vec::new();
            off::write(&mut file, &mesh).unwrap();
            let read = off::parse(&file).unwrap();
            let bits = |mesh: &Mesh| -> Vec<[u64; 3]> {
                mesh.points.iter().map(|p| p.map(f64::to_bits)).collect()
            };
            assert_eq!(bits(&read), bits(&mesh), "{}", family.name);
            assert_eq!(read.cells, mesh.cells);
        }
    }

    #[test]
    fn an_unknown_family_is_named_beside_those_that_there_are() {
        let error = families(Some("klein")).unwrap_err().to_string();
        assert!(error.contains("there are csg, rotated, gears"), "{error}");
    }
}
