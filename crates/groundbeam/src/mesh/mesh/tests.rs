//! Tests of the mesh: positions of its nodes, and cells of varying data.

#![cfg(test)]

use super::*;
use crate::model::{Beam, Foundation, Profile};
use crate::numeric::polynomial::value;

#[test]
fn nodes_lie_at_all_required_positions() {
    let model = Model::new(
        Beam::uniform(10.0, 1.0).with_segment(2.0, 4.0, 5.0),
        Foundation::winkler(1.0).with_segment(-5.0, 3.0, 7.0, 2.0),
    )
    .with_load(Load::point_force(4.0, 1.0))
    .with_load(Load::distributed_force(1.0, 9.0, 0.0, 8.0));
    let mesh = Mesh::build(&model, &[], |_| 1);
    let x: Vec<f64> = mesh.nodes.iter().map(|n| n.x).collect();
    assert_eq!(x, [0.0, 1.0, 2.0, 3.0, 4.0, 9.0, 10.0]);
    assert_eq!(mesh.cells[3].stiffness, 5.0);
    assert_eq!((mesh.cells[2].subgrade, mesh.cells[3].subgrade), (7.0, 1.0));
    assert_eq!(mesh.cells[4].load, [3.0, 8.0]);
    assert_eq!(mesh.nodes[4].force, 1.0);
    assert_eq!(mesh.outside, [f64::sqrt(14.0), 0.0]);
}

#[test]
fn cells_are_shorter_where_the_stiffness_is_small() {
    let thousandfold = Profile::linear(1.0, 1000.0);
    let ground = Foundation::winkler(1.0).with_varying_segment(
        -1.0,
        6.0,
        Profile::linear(1.0, 8.0),
        Profile::linear(3.0, 10.0),
    );
    let beam = Beam::uniform(6.0, 1.0).with_varying_segment(0.0, 5.0, thousandfold);
    let mesh = Mesh::graded(&Model::new(beam, ground), &[], |_, _| ());
    assert!(mesh.cells.iter().all(Cell::is_smooth));
    assert!((30..80).contains(&mesh.cells.len()), "{}", mesh.cells.len());
    let ends = |i: usize| mesh.cells[i].shear_layer_ends();
    assert!((1..mesh.cells.len()).all(|i| ends(i - 1)[1] == ends(i)[0]));
    assert!((mesh.outside[0] - f64::sqrt(8.0)).abs() < 1e-15);
    assert!((mesh.outside[1] - f64::sqrt(80.0)).abs() < 1e-14);
    let part = mesh.cells[3].part([-0.5, 1.0]);
    let course = thousandfold.at(part.global(0.3) / 5.0);
    assert!((value(&part.stiffness_along(), 0.3) / course - 1.0).abs() < 1e-14);
    assert_eq!(part.shear_layer_ends()[1], ends(3)[1]);
}

#[test]
fn positions_that_differ_by_rounding_share_a_node() {
    let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::winkler(1.0))
        .with_load(Load::point_force(0.3, 1.0))
        .with_load(Load::point_force(0.1 + 0.2, 1.0));
    let mesh = Mesh::build(&model, &[], |_| 1);
    assert_eq!(mesh.nodes.len(), 3);
    assert_eq!(mesh.nodes[1].force, 2.0);
}
