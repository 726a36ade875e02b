//! Debug.
use groundbeam::{Outcome, solve};
use groundbeam_verification::reference::Answer;
fn main() {
    for answer in Answer::all() {
        if !["hard-006", "supports-004"].contains(&answer.name.as_str()) {
            continue;
        }
        if let Ok(Outcome::Equilibrium(s)) = solve(&answer.parsed()) {
            let d = answer.distance(&s);
            println!(
                "{} {d:?} gap {:.1e} viol {:.1e} pen {:.1e}\n  contact {:?}\n  {}",
                answer.name,
                s.certificate().relative_gap,
                s.certificate().violation(),
                s.certificate().deepest_penetration,
                s.contact(),
                s.history()
                    .iter()
                    .map(|h| format!("{}:{:.1e}:{:.2}", h.zones, h.decrement, h.step))
                    .collect::<Vec<_>>()
                    .join(" ")
            );
        }
    }
}
