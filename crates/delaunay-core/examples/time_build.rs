//! Times the bulk build on a file of points and prints one line of JSON.
//!
//! ```text
//! cargo run --release -p delaunay-core --example time_build -- FILE.3d.f64 [RUNS] [THREADS] [small-pages]
//! ```
//!
//! The file holds raw little-endian doubles, `x y x y …` or, with `.3d.` in its name, `x y z x y z …`. The clock covers the call alone, from the slice of
//! points to the finished mesh; reading the file and freeing the mesh are not counted.

use delaunay_core::progress::silent;
use delaunay_core::{BuildError, BuildOptions, Delaunay2, Delaunay3};
use glam::{DVec2, DVec3};
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
    let dimension = if path.contains(".3d.") { 3 } else { 2 };
    let count = numbers.len() / dimension;
    let mut simplices = 0;
    let mut seconds = if dimension == 3 {
        let points: Vec<DVec3> = numbers.chunks_exact(3).map(DVec3::from_slice).collect();
        drop(numbers);
        time(
            runs,
            || Delaunay3::build_on(&points, options, &mut silent),
            |built| {
                simplices = built.tets().count();
            },
        )?
    } else {
        let points: Vec<DVec2> = numbers.chunks_exact(2).map(DVec2::from_slice).collect();
        drop(numbers);
        time(
            runs,
            || Delaunay2::build_on(&points, options, &mut silent),
            |built| {
                simplices = built.faces().count();
            },
        )?
    };
    seconds.sort_by(f64::total_cmp);
    let (least, median) = (seconds[0], seconds[seconds.len() / 2]);
    let memory = peak_memory();
    #[allow(clippy::print_stdout)]
    {
        println!(
            "{{\"peer\":\"delaunay-core\",\"version\":\"{}\",\"n\":{count},\"runs\":{runs},\"threads\":{threads},\
             \"secs_min\":{least:.6},\"secs_med\":{median:.6},\"simplices\":{simplices},\"rss_kb\":{memory}}}",
            env!("CARGO_PKG_VERSION"),
        );
    }
    Ok(())
}

/// The seconds that each of `runs` builds takes; what is built is looked at and freed off the clock.
fn time<T>(
    runs: usize,
    build: impl Fn() -> Result<T, BuildError>,
    mut look: impl FnMut(&T),
) -> Result<Vec<f64>, BuildError> {
    let timed = (0..runs.max(1)).map(|_| {
        let start = Instant::now();
        let built = build()?;
        let seconds = start.elapsed().as_secs_f64();
        look(&built);
        Ok(seconds)
    });
    timed.collect()
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
