//! Times the bulk build on a file of points and prints one line of JSON.
//!
//! ```text
//! cargo run --release -p delaunay-core --example time_build -- FILE.3d.f64 [RUNS] [THREADS] [small-pages]
//! ```
//!
//! The file holds raw little-endian doubles, `x y x y …` or, with `.3d.` in its name, `x y z x y z …`. The clock
//! covers the call alone, from the slice of points to the finished mesh; reading the file and freeing the
//! mesh are not counted. `cpu_min` is the time of all threads together.

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
    let times = if path.contains(".3d.") {
        let points: Vec<DVec3> = numbers.chunks_exact(3).map(DVec3::from_slice).collect();
        let build = || Delaunay3::build_on(&points, options, &mut silent);
        time(runs, points.len(), build, |built| built.tets().count())
    } else {
        let points: Vec<DVec2> = numbers.chunks_exact(2).map(DVec2::from_slice).collect();
        let build = || Delaunay2::build_on(&points, options, &mut silent);
        time(runs, points.len(), build, |built| built.faces().count())
    };
    print_line(&times?, threads);
    Ok(())
}

/// What the builds took, in seconds, one entry for each.
struct Times {
    points: usize,
    simplices: usize,
    wall: Vec<f64>,
    busy: Vec<f64>,
}

/// Times `runs` builds; what is built is counted and freed off the clock.
fn time<T>(
    runs: usize,
    points: usize,
    build: impl Fn() -> Result<T, BuildError>,
    count: impl Fn(&T) -> usize,
) -> Result<Times, BuildError> {
    let mut times = Times {
        points,
        simplices: 0,
        wall: Vec::new(),
        busy: Vec::new(),
    };
    for _ in 0..runs.max(1) {
        let (start, busy) = (Instant::now(), processor_seconds());
        let built = build()?;
        times.wall.push(start.elapsed().as_secs_f64());
        times.busy.push(processor_seconds() - busy);
        times.simplices = count(&built);
    }
    times.wall.sort_by(f64::total_cmp);
    times.busy.sort_by(f64::total_cmp);
    Ok(times)
}

#[allow(clippy::print_stdout)]
fn print_line(times: &Times, threads: usize) {
    let (count, runs, simplices) = (times.points, times.wall.len(), times.simplices);
    let (least, median, busy) = (times.wall[0], times.wall[runs / 2], times.busy[0]);
    let (version, memory) = (env!("CARGO_PKG_VERSION"), peak_memory());
    println!(
        "{{\"peer\":\"delaunay-core\",\"version\":\"{version}\",\"n\":{count},\"runs\":{runs},\
         \"threads\":{threads},\"secs_min\":{least:.6},\"secs_med\":{median:.6},\"cpu_min\":{busy:.6},\
         \"simplices\":{simplices},\"rss_kb\":{memory}}}"
    );
}

fn read_doubles(path: &str) -> std::io::Result<Vec<f64>> {
    let bytes = std::fs::read(path)?;
    let words = bytes.as_chunks::<8>().0;
    Ok(words.iter().map(|&word| f64::from_le_bytes(word)).collect())
}

/// Time that processors have spent on this process, in seconds, where the system tells; else 0.
fn processor_seconds() -> f64 {
    let Ok(threads) = std::fs::read_dir("/proc/self/task") else {
        return 0.0;
    };
    let nanoseconds = threads.flatten().map(|thread| {
        let text = std::fs::read_to_string(thread.path().join("schedstat")).unwrap_or_default();
        let word = text.split_whitespace().next();
        word.map_or(0.0, |word| word.parse().unwrap_or(0.0))
    });
    nanoseconds.sum::<f64>() * 1e-9
}

/// The greatest memory in use so far, in kB, where the system tells; else 0.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let number = line.and_then(|line| line.split_whitespace().next());
    number.map_or(0, |number| number.parse().unwrap_or(0))
}
