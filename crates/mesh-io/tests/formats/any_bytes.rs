//! Any bytes, alone or behind the start of a file, are an error or a sound mesh in every format.

use mesh_io::{Mesh, ReadError, medit, msh, obj, off, ply, stl, tetgen, triangle, vtk};
use proptest::prelude::*;

type Parse = fn(&[u8]) -> Result<Mesh, ReadError>;

/// Starts of files, and the readers that they are for.
const STARTS: [(&[u8], Parse); 17] = [
    (b"", off::parse),
    (b"STCNOFF\n1 1 0\n0 0 0 ", off::parse),
    (b"1 1 0\n0 0 0\n", off::parse),
    (b"v 0 0 0\nl ", obj::parse),
    (b"solid\nfacet\n", stl::parse),
    (&[1; 84], stl::parse),
    (b"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nelement edge 2\nproperty int vertex1\nproperty uchar vertex2\nend_header\n\0\0", ply::parse_mesh),
    (b"MeshVersionFormatted 1 Dimension 3 ", medit::parse),
    (b"MeshVersionFormatted 1\nDimension 2\nVertices 1\n0 0 0\nTriangles ", medit::parse),
    (b"# vtk DataFile Version 3.0\n\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 char\n\0\0\0\nCELLS 1 2\n", vtk::parse),
    (b"# vtk DataFile Version 5.1\n\nBINARY\nDATASET POLYDATA\nPOINTS 0 char\nPOINT_DATA 0\n", vtk::parse),
    (b"# vtk DataFile Version 5.1\n\nASCII\nDATASET POLYDATA\n", vtk::parse),
    (b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n", |bytes| Ok(msh::parse(bytes)?.mesh)),
    (b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n1\n\x01\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0$EndNodes\n$Elements\n3\n\x0f\0\0\0", |bytes| Ok(msh::parse(bytes)?.mesh)),
    (b"1 3 0 0\n1 0 0 0\n", complex),
    (b"1 3 0 0\n1 0 0 0\n2 1\n1 1 7\n", complex),
    (b"1 3 0 0\n1 0 0 0\n1 1\n", |bytes| {
        Ok(tetgen::parse_smesh(bytes, none_beside)?.into_mesh()?)
    }),
];

fn complex(bytes: &[u8]) -> Result<Mesh, ReadError> {
    Ok(tetgen::parse_poly(bytes, none_beside)?.into_mesh()?)
}

fn none_beside() -> Result<triangle::Nodes, ReadError> {
    Ok(triangle::Nodes::default())
}

/// Numbers and words that files are made of, and bytes that they are not.
fn pieces() -> impl Strategy<Value = Vec<u8>> {
    const WORDS: [&[u8]; 20] = [
        b"0 ",
        b"1 ",
        b"3 ",
        b"-1 ",
        b"0.5 ",
        b"nan ",
        b"99999999999999999999 ",
        b"4294967296 ",
        b"\n",
        b"\n#",
        b"f ",
        b"vertex ",
        b"endsolid\n",
        b"Vertices ",
        b"Edges ",
        b"End ",
        b"CELLS ",
        b"FIELD ",
        b"METADATA\n",
        b"OFFSETS int\n",
    ];
    let word = prop::sample::select(&WORDS[..]).prop_map(<[u8]>::to_vec);
    let bytes = prop::collection::vec(any::<u8>(), 0..20);
    prop::collection::vec(prop_oneof![4 => word, 1 => bytes], 0..30).prop_map(|all| all.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn any_bytes_are_an_error_or_a_sound_mesh(pieces in pieces()) {
        for (start, parse) in STARTS {
            let mesh = parse(&[start, &pieces].concat());
            prop_assert_eq!(mesh.unwrap_or_default().check(), Ok(()));
        }
    }
}
