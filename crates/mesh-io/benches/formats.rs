//! VTU and MSH of square grids of quads, written to memory and parsed: time per cell stays the same from 10^4 to 10^6 cells.

#![allow(missing_docs, reason = "criterion writes the main function")]
#![allow(clippy::unwrap_used, reason = "a bench may panic")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use mesh_io::{Cell, Encoding, Mesh, msh, vtu};

/// A bent square of `side` by `side` quads with markers.
fn quads(side: u32) -> Mesh {
    let row = side + 1;
    let node = |k: u32| {
        let (x, y) = (
            f64::from(k % row) / f64::from(side),
            f64::from(k / row) / f64::from(side),
        );
        [x + 0.1 * y * y, y + 0.1 * x * x, 0.0]
    };
    let points = (0..row * row).map(node).collect();
    let cell = |k: u32| {
        let corner = k / side * row + k % side;
        Cell::Quad([corner, corner + 1, corner + 1 + row, corner + row])
    };
    Mesh {
        cell_markers: Some((0..side * side).map(|k| (k / side % 8) as i32).collect()),
        ..Mesh::new(points, (0..side * side).map(cell).collect())
    }
}

type Write = fn(&mut Vec<u8>, &Mesh);
type Parse = fn(&[u8]) -> Mesh;

const FORMATS: [(&str, Write, Parse); 3] = [
    (
        "vtu",
        |out, mesh| vtu::write(out, mesh).unwrap(),
        |bytes| vtu::parse(bytes).unwrap(),
    ),
    (
        "msh ascii",
        |out, mesh| msh::write(out, mesh, &[], Encoding::Ascii).unwrap(),
        |bytes| msh::parse(bytes).unwrap().mesh,
    ),
    (
        "msh binary",
        |out, mesh| msh::write(out, mesh, &[], Encoding::Binary).unwrap(),
        |bytes| msh::parse(bytes).unwrap().mesh,
    ),
];

fn formats(criterion: &mut Criterion) {
    for (format, write, parse) in FORMATS {
        let mut group = criterion.benchmark_group(format);
        group.sample_size(10);
        for side in [100, 1000] {
            let mesh = quads(side);
            let cells = u64::from(side) * u64::from(side);
            let mut file = Vec::new();
            write(&mut file, &mesh);
            group.throughput(Throughput::Elements(cells));
            group.bench_function(BenchmarkId::new("write", cells), |bencher| {
                bencher.iter(|| {
                    let mut out = Vec::with_capacity(file.len());
                    write(&mut out, black_box(&mesh));
                    out
                });
            });
            group.bench_function(BenchmarkId::new("parse", cells), |bencher| {
                bencher.iter(|| parse(black_box(&file)));
            });
        }
        group.finish();
    }
}

criterion_group!(benches, formats);
criterion_main!(benches);
