//! Builds a mesh of dual numbers (values with derivatives) from a model and the derivatives of the model data.
//!
//! The data of cells and nodes are linear in the data of the model. So a mesh of the derivatives of the model contains
//! their derivatives.

use crate::ground::link;
use crate::mesh::free_field::{self, GroundLoad, Line, ground_loads};
use crate::mesh::mesh::{Mesh, Node, cells_of};
use crate::model::{GroundOutside, Model};
use crate::numeric::dual::Dual;
use std::ops::Range;

/// Model, and the derivatives of its data with respect to at most N parameters.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rates<'a> {
    pub model: &'a Model,
    /// One model for each parameter. Its positions are those of `model`, and its data are the derivatives of the data
    /// of `model` with respect to the parameter.
    pub by: &'a [&'a Model],
    /// Range of the beam \[m\] outside which no parameter changes the stiffness of beam or ground, the gap or the
    /// distributed loads.
    pub reach: [f64; 2],
}

impl Rates<'_> {
    fn dual<const N: usize>(&self, number: impl Fn(&Model) -> f64) -> Dual<N> {
        Dual {
            value: number(self.model),
            by: std::array::from_fn(|i| self.by.get(i).map_or(0.0, |model| number(model))),
        }
    }

    /// Returns the ground outside one end of the beam. `at_end` contains k and μ at this end.
    pub fn beyond<const N: usize>(
        &self,
        right: bool,
        at_end: [Dual<N>; 2],
    ) -> GroundOutside<Dual<N>> {
        let own = |i: usize| {
            [
                self.dual(|model| model.foundation.segments[i].subgrade.start()),
                self.dual(|model| model.foundation.segments[i].shear_layer.start()),
            ]
        };
        self.model.foundation.beyond_with(right, self.model.beam.length, at_end, own)
    }

    /// The loads on the ground.
    pub fn ground_loads<const N: usize>(&self) -> Vec<GroundLoad<Dual<N>>> {
        let own = ground_loads(self.model);
        let by: Vec<Vec<GroundLoad>> = self.by.iter().map(|model| ground_loads(model)).collect();
        let load = |(i, load): (usize, &GroundLoad)| GroundLoad {
            ends: load.ends,
            sizes: std::array::from_fn(|end| Dual {
                value: load.sizes[end],
                by: std::array::from_fn(|n| by.get(n).map_or(0.0, |by| by[i].sizes[end])),
            }),
        };
        own.iter().enumerate().map(load).collect()
    }
}

impl Mesh {
    /// Returns the mesh in dual numbers whose derivatives are all zero.
    pub fn still<const N: usize>(&self) -> Mesh<Dual<N>> {
        Mesh {
            nodes: self.nodes.iter().map(|node| node.lifted([None; N])).collect(),
            cells: self.cells.iter().map(|cell| cell.lifted([None; N])).collect(),
            axial_force: self.axial_force.into(),
            outside: self.outside.map(Dual::from),
        }
    }

    /// Sets all derivatives of the mesh `into` from `rates`, and returns the cells whose derivatives may then be
    /// nonzero. Before the call, only the cells in `varied` may have nonzero derivatives.
    pub fn vary<const N: usize>(
        &self,
        rates: &Rates,
        varied: Range<usize>,
        into: &mut Mesh<Dual<N>>,
    ) -> Range<usize> {
        let x: Vec<f64> = self.nodes.iter().map(|node| node.x).collect();
        // The cells of `reach` and one more cell on each side are replaced, because the ends of `reach` may have
        // rounding errors.
        let from = x.partition_point(|x| *x <= rates.reach[0]).saturating_sub(2);
        let to = (x.partition_point(|x| *x < rates.reach[1]) + 1).min(self.cells.len()).max(from);
        let of = |model: &&Model| {
            let nodes = x.iter().map(|&x| Node { x, ..Node::default() }).collect();
            let cells = cells_of(model, &x[from..=to]);
            let mut mesh = Mesh { nodes, cells, axial_force: 0.0, outside: [0.0; 2] };
            mesh.place_loads_and_supports(model);
            mesh
        };
        let by: Vec<Mesh> = rates.by.iter().map(of).collect();
        for i in varied.chain(from..to) {
            into.cells[i] = self.cells[i].lifted(std::array::from_fn(|n| {
                by.get(n).and_then(|mesh| mesh.cells.get(i.checked_sub(from)?))
            }));
        }
        for (i, (node, into)) in self.nodes.iter().zip(&mut into.nodes).enumerate() {
            *into = node.lifted(std::array::from_fn(|n| by.get(n).map(|mesh| &mesh.nodes[i])));
        }
        let cells = &mut into.cells;
        let at_ends = [cells[0].ground_at(-1.0), cells[cells.len() - 1].ground_at(1.0)];
        let beyond = [false, true].map(|right| rates.beyond(right, at_ends[usize::from(right)]));
        into.axial_force = rates.dual(|model| model.beam.axial_force);
        into.outside = beyond.each_ref().map(link::outside);
        if !rates.model.has_ground_loads() {
            return if into.axial_force == self.axial_force { from..to } else { 0..cells.len() };
        }
        let (loads, length) = (rates.ground_loads(), rates.model.beam.length);
        free_field::settle(&Line { length, beyond: beyond.each_ref(), loads: &loads }, cells);
        0..cells.len()
    }
}

impl Node {
    fn lifted<const N: usize>(&self, by: [Option<&Node>; N]) -> Node<Dual<N>> {
        let dual = |number: &dyn Fn(&Node) -> f64| Dual {
            value: number(self),
            by: by.map(|node| node.map_or(0.0, number)),
        };
        Node {
            x: self.x,
            force: dual(&|node| node.force),
            moment: dual(&|node| node.moment),
            pinned: self.pinned,
            settlement: dual(&|node| node.settlement),
            clamped: self.clamped,
            spring: dual(&|node| node.spring),
            rotational_spring: dual(&|node| node.rotational_spring),
            hinge: self.hinge.map(|_| dual(&|node| node.hinge.unwrap_or(0.0))),
            kinked: self.kinked,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};

    #[test]
    fn cells_have_the_derivatives_of_the_models_numbers() {
        let model = Model::new(Beam::uniform(4.0, 3.0), Foundation::pasternak(2.0, 8.0))
            .with_load(Load::distributed_force(1.0, 3.0, 5.0, 7.0));
        let mut by_k = model.clone().with_loads_scaled(0.0);
        by_k.beam.bending_stiffness = 0.0;
        by_k.foundation = Foundation::pasternak(1.0, 0.0);
        let mut by_load = by_k.clone();
        by_load.foundation = Foundation::pasternak(0.0, 0.0);
        by_load.loads[0] = Load::distributed_force(1.0, 3.0, 0.0, 1.0);
        let mesh = Mesh::build(&model, &[2.0], |_| 1);
        let rates = Rates { model: &model, by: &[&by_k, &by_load], reach: [0.0, 4.0] };
        let mut lifted: Mesh<Dual<2>> = mesh.still();
        assert_eq!(mesh.vary(&rates, 0..0, &mut lifted), 0..4);
        assert_eq!(lifted.cells[1].subgrade, Dual { value: 2.0, by: [1.0, 0.0] });
        assert_eq!(lifted.cells[1].load[1], Dual { value: 6.0, by: [0.0, 0.5] });
        // The derivative of √(kμ) with respect to k is μ/(2√(kμ)).
        assert_eq!(lifted.outside[0], Dual { value: 4.0, by: [1.0, 0.0] });
    }
}
