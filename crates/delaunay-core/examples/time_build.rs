//! Times the bulk build on a file of points and prints one line of JSON.
//!
//! ```text
//! cargo run --release -p delaunay-core --example time_build -- FILE.2d.f64 [RUNS] [THREADS] [small-pages]
//! ```
//!
//! The file holds raw little-endian doubles, `x y x y …`. The clock covers the call alone, from the slice of
//! points to the finished mesh; reading the file and freeing the mesh are not counted.

use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Delaunay2};
use glam::DVec2;
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let path = arguments.first().ok_or("which file of points?")?;
    let number = |i: usize| arguments.get(i).map_or(Ok(1), |word| word.parse());
    let (runs, threads): (usize, usize) = (number(1)?, number(2)?);
    let options = BuildOptions {
        huge_pages: !arguments.contains(&"small-pages".to_owned()),
        ..BuildOptions::on_threads(threads)
    };
    let numbers = read_doubles(path)?;
    let points: Vec<DVec2> = numbers.chunks_exact(2).map(DVec2::from_slice).collect();
    drop(numbers);
    let mut seconds = Vec::new();
    let mut triangles = 0;
    for _ in 0..runs.max(1) {
        let start = Instant::now();
        let delaunay = Delaunay2::build_on(&points, options, &mut silent)?;
        seconds.push(start.elapsed().as_secs_f64());
        triangles = delaunay.faces().count();
    }
    seconds.sort_by(f64::total_cmp);
    let (least, median) = (seconds[0], seconds[seconds.len() / 2]);
    let (count, memory) = (points.len(), peak_memory());
    #[allow(clippy::print_stdout)]
    {
        println!(
            "{{\"peer\":\"delaunay-core\",\"version\":\"{}\",\"n\":{count},\"runs\":{runs},\"threads\":{threads},\
             \"secs_min\":{least:.6},\"secs_med\":{median:.6},\"simplices\":{triangles},\"rss_kb\":{memory}}}",
            env!("CARGO_PKG_VERSION"),
        );
    }
    Ok(())
}

fn read_doubles(path: &str) -> std::io::Result<Vec<f64>> {
    let bytes = std::fs::read(path)?;
    let words = bytes.as_chunks::<8>().0;
    Ok(words.iter().map(|&word| f64::from_le_bytes(word)).collect())
}

/// The greatest memory in use so far, in kB, where the system tells; else 0.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let number = line.and_then(|line| line.split_whitespace().next());
    number.map_or(0, |number| number.parse().unwrap_or(0))
}
