//! Benchmarks: `cargo run --release -p groundbeam-bench -- all` writes `bench/RESULTS.md`.

mod batch;
mod clock;
mod gradients;
mod mesh;
mod models;
mod proof;
mod quad;
mod reference;
mod study;
mod table;

const USAGE: &str = "\
groundbeam-bench mesh     case B on meshes of 10³ … 10⁶ elements, in comparison with the bonded beam
groundbeam-bench batch    1000 random beams on meshes; footings and case C by the exact method, on one thread and on two
groundbeam-bench study    random footings drawn, solved, certified and written, in comparison with the solver alone
groundbeam-bench rail     rails of 1 to 10 km by the exact method
groundbeam-bench proof    the proof of a result in comparison with the solve
groundbeam-bench gradients  gradients in comparison with the solve
groundbeam-bench all      all benchmarks, written to bench/RESULTS.md; the section of bench/rivals.py is kept";

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize| arguments.get(i).and_then(|text| text.parse::<f64>().ok());
    let print = |parts: &[String]| println!("{}", parts.concat());
    match arguments.first().map(String::as_str) {
        Some("mesh") => print(&[mesh::table(number(1).unwrap_or(1e6) as usize)]),
        Some("batch") => print(&[batch::meshes(), batch::exact()]),
        Some("study") => print(&[study::table(number(1).unwrap_or(100_000.0) as u64)]),
        Some("rail") => print(&[batch::rails()]),
        Some("proof") => print(&[proof::table()]),
        Some("gradients") => print(&[gradients::table()]),
        Some("peak") => mesh::peak(number(1).unwrap_or(0.0), number(2).unwrap_or(1e3) as usize),
        Some("problem") => {
            let file = arguments.get(2).map(std::path::PathBuf::from).unwrap_or_default();
            mesh::problem(number(1).unwrap_or(1e3) as usize, &file);
        }
        Some("all") => {
            let parts = [
                mesh::table(1_000_000),
                batch::meshes(),
                batch::exact(),
                batch::rails(),
                proof::table(),
                gradients::table(),
                study::table(100_000),
            ];
            write(&parts.concat());
        }
        _ => println!("{USAGE}"),
    }
}

/// Heading of the section of `bench/RESULTS.md` about other programs.
const RIVALS: &str = "\n## Beside other programs";

fn write(ours: &str) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/RESULTS.md");
    let before = std::fs::read_to_string(path).unwrap_or_default();
    let rivals = before.find(RIVALS).map_or("", |at| &before[at..]);
    let head = "# Results\n\nMade by `cargo run --release -p groundbeam-bench -- all`, and the last part by \
                `python bench/rivals.py`.\nRatios come first: they hold on other machines.\n\n";
    let text = format!("{head}{}{ours}{rivals}", table::setting());
    std::fs::write(path, text).expect("bench/RESULTS.md can be written");
}
