//! Tables of figures 8 to 11: what refinement leaves, beside what the paper printed, and what it took.
//!
//! Goldens hold no times. What the paper's minutes were spent on, tests of candidates, is counted instead.

use sink_refine::{Outcome3, Reason3, Round};

use super::solids::Runs;
use crate::figures::table::{Table, grouped};

/// What the paper printed of an example.
pub(super) struct Printed {
    /// Before refinement.
    pub(super) init: PrintedRow,
    /// Refined by sinks.
    pub(super) sink: PrintedRow,
    /// Refined by circumcentres.
    pub(super) circ: PrintedRow,
    /// Minutes by sinks and by circumcentres.
    pub(super) minutes: [u32; 2],
}

/// Tetrahedra, those of low quality, and least, mean and largest r/l; `-` where nothing is printed.
pub(super) struct PrintedRow(
    pub(super) &'static str,
    pub(super) &'static str,
    pub(super) [&'static str; 3],
);

/// All tables of an example; why low quality is left only where some is.
pub(super) fn report(title: &str, paper: &Printed, runs: &Runs) -> String {
    let tables = [
        Some(quality(title, paper, runs)),
        Some(work(paper, runs)),
        left(runs),
    ];
    let texts = tables.iter().flatten().map(Table::to_string);
    texts.collect::<Vec<_>>().join("\n")
}

fn quality(title: &str, paper: &Printed, runs: &Runs) -> Table {
    let header = ["", "tetrahedra", "of low quality", "min r/l", "mean", "max"];
    Table::new(title, header)
        .row(mesh("init", runs.sinks.rounds.first()))
        .row(printed(&paper.init))
        .row(mesh("sink", runs.sinks.rounds.last()))
        .row(printed(&paper.sink))
        .row(mesh("circ", runs.circumcenters.rounds.last()))
        .row(printed(&paper.circ))
        .row(mesh("economical", runs.economical.rounds.last()))
}

/// Size and quality of a mesh: name, elements, those of low quality, and least, mean and largest r/l.
pub(super) fn mesh(name: &str, mesh: Option<&Round>) -> [String; 6] {
    let mesh = mesh.copied().unwrap_or_default();
    [
        String::from(name),
        grouped(mesh.elements),
        grouped(mesh.low),
        format!("{:.3}", mesh.min_ratio),
        format!("{:.3}", mesh.mean_ratio),
        format!("{:.3}", mesh.max_ratio),
    ]
}

fn printed(PrintedRow(tetrahedra, low, [min, mean, max]): &PrintedRow) -> [&'static str; 6] {
    ["  paper", tetrahedra, low, min, mean, max]
}

fn work(paper: &Printed, runs: &Runs) -> Table {
    let title = "Work: different candidates in the first round; in all rounds, candidates tested and rejected at the boundary";
    let header = [
        "",
        "first",
        "rounds",
        "tested",
        "rejected",
        "inserted",
        "removed",
        "paper, minutes",
    ];
    let [sink, circ] = paper.minutes;
    let ratio = |of: fn(&Outcome3) -> usize| times(of(&runs.circumcenters), of(&runs.sinks));
    Table::new(title, header)
        .row(effort("sink", &runs.sinks, &sink.to_string()))
        .row(effort("circ", &runs.circumcenters, &circ.to_string()))
        .row([
            String::from("circ / sink"),
            ratio(first),
            ratio(rounds),
            ratio(|run| run.counters.tested),
            ratio(|run| run.counters.encroaching),
            ratio(|run| run.counters.inserted),
            String::from("-"),
            times(circ as usize, sink as usize),
        ])
        .row(effort("economical", &runs.economical, "-"))
}

fn effort(name: &str, run: &Outcome3, minutes: &str) -> [String; 8] {
    let counters = run.counters;
    // The economical method knows neither rounds nor all candidates before it begins.
    let [first, rounds] = match first(run) {
        0 => [(); 2].map(|()| String::from("-")),
        first => [first, rounds(run)].map(grouped),
    };
    [
        String::from(name),
        first,
        rounds,
        grouped(counters.tested),
        grouped(counters.encroaching),
        grouped(counters.inserted),
        grouped(counters.removed),
        String::from(minutes),
    ]
}

/// Different candidates of all tetrahedra that are of low quality at first.
fn first(run: &Outcome3) -> usize {
    run.rounds.first().map_or(0, |round| round.candidates)
}

/// Rounds that inserted something: the records end with a search that found nothing, and the mesh that comes out.
fn rounds(run: &Outcome3) -> usize {
    run.rounds.iter().filter(|round| round.inserted > 0).count()
}

fn times(a: usize, b: usize) -> String {
    if b == 0 {
        String::from("-")
    } else {
        format!("{:.2}", a as f64 / b as f64)
    }
}

/// Why tetrahedra of low quality are left; `None` when there are none.
fn left(runs: &Runs) -> Option<Table> {
    let all = [&runs.sinks, &runs.circumcenters, &runs.economical];
    if all.iter().all(|run| run.low.is_empty()) {
        return None;
    }
    let header = [
        "",
        "its boundary triangle",
        "boundary test",
        "its flow leaves",
        "nothing, another candidate fits",
    ];
    let [sinks, circumcenters, economical] = all;
    let table = Table::new(
        "Tetrahedra of low quality that are left, by what forbids better ones",
        header,
    )
    .row(reasons("sink", sinks))
    .row(reasons("circ", circumcenters))
    .row(reasons("economical", economical));
    Some(table)
}

fn reasons(name: &str, run: &Outcome3) -> [String; 5] {
    let mut counts = [0; 4];
    for low in &run.low {
        let column = match low.reason {
            Reason3::BoundaryTriangle(_) => 0,
            Reason3::Encroaches(_) => 1,
            Reason3::Outside => 2,
            Reason3::NotReached => 3,
        };
        counts[column] += 1;
    }
    let [triangle, test, outside, not_reached] = counts.map(grouped);
    [String::from(name), triangle, test, outside, not_reached]
}
