//! Meshes written as JavaScript modules become OFF files beside them.

use std::path::Path;
use std::process::Command;

use super::client::run;

/// Loads the module in the first argument and writes its positions and triangles to the second: nested lists, or flat ones in threes.
const SCRIPT: &str = "
const fs = require('fs');
const mesh = require(process.argv[1]);
const rows = list => typeof list[0] === 'number'
    ? Array.from({ length: list.length / 3 }, (_, row) => Array.from(list.slice(3 * row, 3 * row + 3)))
    : Array.from(list, row => Array.from(row));
const [points, cells] = [rows(mesh.positions), rows(mesh.cells)];
const lines = points.map(point => point.join(' ')).concat(cells.map(cell => `${cell.length} ${cell.join(' ')}`));
fs.writeFileSync(process.argv[2], `OFF\\n${points.length} ${cells.length} 0\\n${lines.join('\\n')}\\n`);
";

/// Converts the module of an unpacked package, if it is one that holds a mesh: otherwise there is no file.
pub(super) fn convert(unpacked: &Path) {
    let package = unpacked.join("package");
    let mut node = Command::new("node");
    node.arg("-e")
        .arg(SCRIPT)
        .args([&package, &package.join("module.off")]);
    // A package that holds no mesh, or a machine without the program, leaves no file, which is the answer.
    let _ = run(&mut node);
}
