//! The grids on which contact is looked for, one after the other.

use super::grid::{Grid, Ground};
use crate::model::Model;

/// Elements per 1/wave number on the coarsest grid that shows every wave of the beam.
const COARSEST: f64 = 1.5;
/// By how much a grid of a beam that is too soft for it is coarser than the next, and the fewest elements it has.
const STEP: f64 = 4.0;
const FEWEST: f64 = 20.0;
/// The part of the wanted grid's elements that one may have which tells where contact ends to a part of a
/// node, and how much finer than √(h/wave) it is at most.
const SHARE: f64 = 0.3;
const SHARPEST: f64 = 6.0;
/// How much finer it must be to be worth its solves.
const SHARP: f64 = 4.0;
/// How much finer than a rough grid the next is at most.
const FEW: f64 = 3.5;

/// Grids from one on which every wave of the beam is a few elements long to the wanted one; each finer
/// one is as much finer as Newton's method, which squares errors, can make good in a step or two. Where the
/// wanted one itself is too coarse for the beam, those before it are of stiffer beams.
pub(crate) fn grids(model: &Model, elements: usize, ground: Ground, grids: &mut Vec<Grid>) {
    grids.clear();
    let fine = Grid::new(model, elements, ground);
    let waves = model.beam.length * fine.wave_number();
    let coarser = coarser(elements as f64, waves);
    let coarse = |elements: &f64| Grid::stiffened(model, *elements as usize, ground);
    grids.extend(coarser.iter().rev().map(coarse));
    grids.push(fine);
    for i in 1..grids.len() {
        grids[i - 1].rough = is_rough(&grids[i - 1], &grids[i], waves);
    }
}

/// How many elements each has, from fine to coarse.
fn coarser(wanted: f64, waves: f64) -> Vec<f64> {
    let coarsest = (waves * COARSEST).ceil().max(8.0);
    let mut coarser = Vec::new();
    let mut last = wanted;
    loop {
        // h → √(h/wave). Contact then ends within a node or two of where that grid says; a few times finer, at
        // that very node, and one solve is enough.
        let mut next = (last * waves).sqrt();
        let sharper = (SHARE * last / next).min(SHARPEST);
        if coarser.is_empty() && sharper > SHARP {
            next *= sharper;
        }
        if next >= 0.7 * last || next < coarsest {
            break;
        }
        coarser.push(next);
        last = next;
    }
    if last > 2.0 * coarsest {
        coarser.push(coarsest);
    }
    if coarser.is_empty() {
        while last >= STEP * FEWEST {
            last /= STEP;
            coarser.push(last);
        }
    }
    coarser
}

/// Whether a node of a grid that shows all waves is but a few of the next.
fn is_rough(grid: &Grid, next: &Grid, waves: f64) -> bool {
    let [elements, finer] = [grid, next].map(|grid| grid.last() as f64);
    elements >= waves * COARSEST && finer < FEW * elements
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_fall_off_fast_down_to_a_few_elements_a_wave() {
        for (elements, waves) in [(1e6, 100.0), (1e4, 100.0), (100.0, 3.0), (100.0, 1e4)] {
            let coarser = coarser(elements, waves);
            let steps = [elements].into_iter().chain(coarser.iter().copied()).zip(&coarser);
            for (finer, elements) in steps {
                assert!(*elements <= 0.7 * finer, "{elements} {finer}");
            }
            let coarsest = coarser.last().copied().unwrap_or(elements);
            let few = 2.0 * COARSEST * waves;
            assert!(coarsest <= few.max(STEP * FEWEST), "{coarsest} of {waves}");
        }
    }
}
