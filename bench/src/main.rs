//! How fast groundbeam is.

mod models;
mod quad;
mod reference;

use groundbeam::*;
use std::time::Instant;

fn main() {
    let which = std::env::args().nth(1).unwrap_or_default();
    match which.as_str() {
        "mesh" => {
            let model = models::long_beam(0.0);
            for n in [1000, 10_000, 100_000] {
                let options =
                    Options { method: Method::ActiveSet, elements: n, pressure: Pressure::Dirac, ..Options::default() };
                let t = Instant::now();
                match solve_with(&model, &options) {
                    Ok(Outcome::Equilibrium(s)) => println!("{n} {:?} its {} zones {}", t.elapsed(), s.iterations(), s.contact().len()),
                    Ok(_) => println!("none"),
                    Err(e) => println!("{n} {:?} {e}", t.elapsed()),
                }
            }
        }
        "exact" => {
            let model = models::long_beam(0.0);
            for _ in 0..3 {
                let t = Instant::now();
                let r = solve(&model);
                println!("long {:?} {}", t.elapsed(), match r { Ok(Outcome::Equilibrium(s)) => s.iterations(), _ => 0 });
            }
            for (name, models) in [("footings", models::footings(2000)), ("C", models::random_beams(1000))] {
                let mut zones = [0; 20];
                let mut its = 0; let mut bad = 0;
                let t = Instant::now();
                for m in &models {
                    match solve(m) { Ok(Outcome::Equilibrium(s)) => { zones[s.contact().len().min(19)] += 1; its += s.iterations(); }, _ => bad += 1 }
                }
                println!("{name} {:?} each, its {}, bad {bad}, zones {zones:?}", t.elapsed() / models.len() as u32, its as f64 / models.len() as f64);
            }
        }
        "feet" => {
            let models = models::footings(2000);
            let mut full = 0; let mut its = 0;
            for m in &models { if let Ok(Outcome::Equilibrium(s)) = solve(m) { full += usize::from(s.lift_off().is_empty()); its += s.iterations(); } }
            println!("full contact {full}, its {}", its as f64 / models.len() as f64);
            for _ in 0..5 {
                let t = Instant::now();
                for m in &models { std::hint::black_box(solve(m).is_ok()); }
                println!("footings {:?} each", t.elapsed() / models.len() as u32);
            }
        }
        "C" => {
            let models = models::random_beams(1000);
            let mut times: Vec<f64> = models.iter().map(|m| { let t = Instant::now(); std::hint::black_box(solve(m).is_ok()); t.elapsed().as_secs_f64() * 1e6 }).collect();
            let mut order: Vec<usize> = (0..1000).collect();
            order.sort_by(|a, b| times[*b].total_cmp(&times[*a]));
            println!("slowest {:?}", order[..5].iter().map(|i| (*i, times[*i], match solve(&models[*i]) { Ok(Outcome::Equilibrium(s)) => (s.iterations(), s.elements()), _ => (0, 0) })).collect::<Vec<_>>());
            times.sort_by(f64::total_cmp);
            println!("C median {} p90 {} max {} mean {}", times[500], times[900], times[999], times.iter().sum::<f64>() / 1000.0);
        }
        "rail1" => { for _ in 0..8 { std::hint::black_box(solve(&models::rail(3200.0, 1)).is_ok()); } }
        "rail" => {
            for l in [1250.0, 2500.0, 5000.0, 10000.0] {
                let m = models::rail(l, 1);
                let t = Instant::now();
                match solve(&m) {
                    Ok(Outcome::Equilibrium(s)) => println!("{l} loads {} zones {} its {} {:?} gap {:e}", m.loads.len(), s.contact().len(), s.iterations(), (t.elapsed(), s.elements()), s.certificate().relative_gap),
                    Ok(_) => println!("none"),
                    Err(e) => println!("{l} {e} {:?}", t.elapsed()),
                }
            }
        }
        "nodal" => {
            let ns: Vec<usize> = std::env::args().skip(3).map(|n| n.parse().unwrap()).collect();
            let p: f64 = std::env::args().nth(2).unwrap().parse().unwrap();
            let model = models::long_beam(p);
            let mut solver = NodalSolver::new();
            let (mut glued, mut found) = (NodalSolution::default(), NodalSolution::default());
            for n in ns {
                let reps = (2_000_000 / n).clamp(3, 500);
                let time = |f: &mut dyn FnMut()| { let mut best = f64::MAX; for _ in 0..reps { let t = Instant::now(); f(); best = best.min(t.elapsed().as_secs_f64()); } best };
                let tg = time(&mut || solver.bonded_into(&model, n, &mut glued).unwrap());
                let mut err = None;
                let tc = time(&mut || if let Err(e) = solver.solve_into(&model, n, &mut found) { err = Some(e) });
                if let Some(e) = err { println!("{n}: {e}"); continue; }
                println!("{n}: glued {:.2} ns/node contact {:.2} ratio {:.2} zones {} {:?} {:?}", tg / n as f64 * 1e9, tc / n as f64 * 1e9, tc / tg, found.contact.len(), found.work, found.check);
                let t = Instant::now();
                let compare = |s: &NodalSolution| {
                    let r = reference::solve(&model, &s.rows(), &s.contact);
                    let err = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / b.iter().fold(0.0_f64, |m, b| m.max(b.abs()));
                    println!("   errw {:.1e} errp {:.1e} smallest {:.1e} deepest {:.1e}", err(&s.deflection, &r.deflection), err(&s.force, &r.force), r.smallest_force, r.deepest);
                };
                if std::env::var("NOREF").is_ok() { continue; }
                compare(&glued); compare(&found);
                if n <= 1000 { for z in &found.contact { println!("   {z:?} {:.4}..{:.4} forces {:.3e} {:.3e}", found.position(z[0]), found.position(z[1]), found.force[z[0]], found.force[z[1]]); } for (x, i, c, h) in found.rows() { println!("   row {x} {i} {c} {h}"); } }
                println!("   reference {:?}", t.elapsed());
            }
        }
        _ => {}
    }
}
