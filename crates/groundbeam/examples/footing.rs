//! A strip footing with a heavy column near its left end: where does it lift off?

use groundbeam::{Beam, Foundation, Load, Model, Outcome, solve};

fn main() -> Result<(), groundbeam::Error> {
    // The footing is 12 m long and has EI = 1.28 GN·m². The ground has k = 40 MN/m² and mu = 9 MN.
    // All numbers are in N and m.
    let model = Model::new(Beam::uniform(12.0, 1.28e9), Foundation::pasternak(40e6, 9e6))
        .with_load(Load::point_force(1.5, 900e3))
        .with_load(Load::uniform_force(0.0, 12.0, 10e3));
    match solve(&model)? {
        Outcome::Equilibrium(found) => {
            let (touches, lifted) = (found.contact()[0], found.lift_off()[0].largest_gap);
            println!("the beam is in contact from {:.3} m to {:.3} m", touches.from, touches.to);
            println!("the left end presses with {:.1} kN", found.end_forces().left / 1e3);
            println!("the right end is {:.2} mm above the ground", lifted.value * 1e3);
            assert!(found.certificate().relative_gap() < 1e-12);
        }
        Outcome::NoEquilibrium(why) => println!("it tips: {:?}", why.verdict),
    }
    Ok(())
}
