//! PLY files as other programs write them: with faces before and behind the vertices, and properties nobody asked for.

use mesh_io::Dimension;

/// The values of the header's format line.
pub(crate) const PLY_KINDS: [&str; 3] = ["ascii", "binary_little_endian", "binary_big_endian"];

/// A file of vertices, the numbers of each in one row.
pub(crate) fn ply_file(
    kind: &str,
    dimension: Dimension,
    weighted: bool,
    rows: &[Vec<f64>],
) -> Vec<u8> {
    let mut names = vec!["x", "y"];
    names.extend((dimension == Dimension::Space).then_some("z"));
    names.extend(weighted.then_some("weight"));
    let properties: String = names
        .iter()
        .map(|name| format!("property double {name}\n"))
        .collect();
    let mut file = format!(
        "ply\nformat {kind} 1.0\ncomment by hand\nelement face 1\nproperty list uchar short corners\n\
         element vertex {}\n{properties}property uchar red\nelement nothing 5\nelement edge 1\nproperty int a\nend_header\n",
        rows.len()
    )
    .into_bytes();
    let mut out = Numbers {
        kind,
        file: &mut file,
    };
    out.put(&[2], &[2]);
    out.put(&[-1, 7], &[-1i16, 7].map(i16::to_le_bytes).concat());
    for row in rows {
        row.iter()
            .for_each(|number| out.put(&[format!("{number:?}")], &number.to_le_bytes()));
        out.put(&[255], &[255]);
    }
    out.put(&[-9], &(-9i32).to_le_bytes());
    file
}

struct Numbers<'a> {
    kind: &'a str,
    file: &'a mut Vec<u8>,
}

impl Numbers<'_> {
    /// Numbers as they read, or their bytes from the least significant on.
    fn put<T: std::fmt::Display>(&mut self, words: &[T], bytes: &[u8]) {
        match self.kind {
            "ascii" => words
                .iter()
                .for_each(|word| self.file.extend(format!("{word}\n").bytes())),
            "binary_little_endian" => self.file.extend(bytes),
            _ => {
                let width = bytes.len() / words.len();
                bytes
                    .chunks(width)
                    .for_each(|number| self.file.extend(number.iter().rev()));
            }
        }
    }
}
