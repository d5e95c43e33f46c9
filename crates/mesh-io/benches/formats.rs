//! VTU and MSH of square grids of quads, written to memory and parsed: time per cell stays the same from 10^4 to 10^6 cells. Points
//! of space in every format, parsed.

#![allow(missing_docs, reason = "criterion writes the main function")]
#![allow(clippy::unwrap_used, reason = "a bench may panic")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use mesh_io::{Cell, Coordinates, Dimension, Encoding, Mesh, Points, msh, ply, raw, vtu, xy};

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

/// Points of space with sixteen digits in every coordinate.
fn cloud(count: u32) -> Points {
    let point = |k: u32| [7, 11, 13].map(|step| f64::from(k * step % 1009) / f64::from(k + 1));
    Points {
        coordinates: Coordinates::Space((0..count).map(point).collect()),
        weights: None,
    }
}

fn points(criterion: &mut Criterion) {
    const COUNT: u32 = 100_000;
    let cloud = cloud(COUNT);
    let mut numbers = Vec::new();
    raw::write(&mut numbers, &cloud).unwrap();
    let Coordinates::Space(places) = &cloud.coordinates else {
        return;
    };
    let line = |[x, y, z]: &[f64; 3]| format!("{x:?} {y:?} {z:?}\n");
    let text: String = places.iter().map(line).collect();
    let header = |format: &str| {
        let properties = "property double x\nproperty double y\nproperty double z\n";
        format!("ply\nformat {format} 1.0\nelement vertex {COUNT}\n{properties}end_header\n")
    };
    let ascii = header("ascii") + &text;
    let binary = [header("binary_little_endian").as_bytes(), &numbers].concat();
    let mut group = criterion.benchmark_group("points");
    group.sample_size(10);
    group.throughput(Throughput::Elements(COUNT.into()));
    group.bench_function("raw", |bencher| {
        bencher.iter(|| raw::parse(black_box(&numbers), Dimension::Space, false).unwrap());
    });
    group.bench_function("xyz", |bencher| {
        bencher.iter(|| xy::parse::<3>(black_box(text.as_bytes())).unwrap());
    });
    for (name, file) in [("ply ascii", ascii.as_bytes()), ("ply binary", &binary)] {
        group.bench_function(name, |bencher| {
            bencher.iter(|| ply::parse(black_box(file), false).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, formats, points);
criterion_main!(benches);
