//! Compression.
use groundbeam::*;
use groundbeam_verification::upheaval::Meshed;

#[test]
fn scratch() {
    for l in [1.0, 2.0, 5.0, 20.0, 100.0] {
        let mut m = Model::new(Beam::uniform(l, 1.0), Foundation::winkler(1.0))
            .with_load(Load::uniform(1.0, 0.0, l));
        m.beam.axial_force = -10.0;
        for _ in 0..2 {
            let mesh = Meshed::new(&m, 400);
            println!("{l} {:?} {:?}", exists(&m).unwrap().verdict, mesh.critical_compression(0.01));
            m.loads.push(Load::point(3.0, 0.4 * l));
        }
    }
}
