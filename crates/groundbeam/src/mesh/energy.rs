//! Bilinear forms of the energy, for deflections that are polynomials in each cell of a mesh.

use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::mesh::ground_runs::ground_runs;
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::open_link;
use crate::mesh::varying;
use crate::numeric::polynomial::inner;
use crate::numeric::polynomial::{TERMS, derivative, jet, product, rescale, value};
use crate::numeric::real::Real;

/// Deflection and rotation of the beam. Each is a polynomial with [`TERMS`] coefficients in every cell.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Motion<'a, R = f64> {
    pub deflection: &'a [R],
    /// Coefficients of the rotation of the cross-sections. Empty if the beam has no shear deformation, so that the
    /// rotation is w'.
    pub rotation: &'a [R],
}

impl<R: Real> Motion<'_, R> {
    fn deflection(&self, cell: usize) -> &[R] {
        &self.deflection[cell * TERMS..(cell + 1) * TERMS]
    }

    /// Coefficients of the rotation in a cell; `None` if the beam has no shear deformation.
    fn rotation(&self, cell: usize) -> Option<&[R]> {
        self.rotation.get(cell * TERMS..(cell + 1) * TERMS)
    }

    /// w and φ at s in a cell.
    fn at(&self, mesh: &Mesh<R>, cell: usize, s: f64) -> [R; 2] {
        let [w, d, ..] = jet(self.deflection(cell), s);
        let slope = d * 2.0 / mesh.cells[cell].length();
        [w, self.rotation(cell).map_or(slope, |rotation| value(rotation, s))]
    }
}

/// Computes the bilinear form ∫(EI φ'ψ' + S (w' − φ)(z' − ψ) + P w'z') of the beam energy plus the terms of all
/// springs. Deflection and rotation are w and φ in `a`, z and ψ in `b`. P is the axial force.
pub(crate) fn beam_form<R: Real>(mesh: &Mesh<R>, a: Motion<R>, b: Motion<R>) -> R {
    let mut sum = R::ZERO;
    for (i, cell) in mesh.cells.iter().enumerate() {
        let [f, g] = [a.deflection(i), b.deflection(i)];
        let h = cell.length();
        sum += match (cell.beam_shear, a.rotation(i), b.rotation(i)) {
            (Some(shear), Some(p), Some(q)) => {
                turning(cell, p, q) * (2.0 / h) + shearing(&shear, h, [f, p], [g, q]) * (0.5 * h)
            }
            _ => bending(cell, f, g) * 8.0 / (h * h * h),
        };
        if mesh.axial_force != 0.0 {
            sum += energy_form(h, (R::ZERO, mesh.axial_force), [-1.0, 1.0], f, g);
        }
    }
    for (i, node) in mesh.nodes.iter().enumerate() {
        if node.spring != 0.0 || node.rotational_spring != 0.0 {
            let (cell, s) = if i == 0 { (0, -1.0) } else { (i - 1, 1.0) };
            let ([w, d], [z, e]) = (a.at(mesh, cell, s), b.at(mesh, cell, s));
            sum += node.spring * w * z + node.rotational_spring * d * e;
        }
        if let Some(spring) = node.hinge.filter(|spring| *spring != 0.0) {
            let turned = |c: Motion<R>| c.at(mesh, i, -1.0)[1] - c.at(mesh, i - 1, 1.0)[1];
            sum += spring * turned(a) * turned(b);
        }
    }
    sum
}

/// Computes the work F(w) of the loads in the deflection w.
pub(crate) fn work_of_loads<R: Real>(mesh: &Mesh<R>, motion: Motion<R>) -> R {
    let mut work = R::ZERO;
    for (i, cell) in mesh.cells.iter().enumerate() {
        let c = motion.deflection(i);
        let line = |[left, right]: [R; 2]| [(left + right) * 0.5, (right - left) * 0.5];
        work += inner(&line(cell.load), c, 0) * (0.5 * cell.length());
        let turned = match motion.rotation(i) {
            Some(rotation) => inner(&line(cell.moment_load), rotation, 0) * (0.5 * cell.length()),
            None => inner(&line(cell.moment_load), &derivative(c), 0),
        };
        work += turned;
    }
    for (i, node) in mesh.nodes.iter().enumerate() {
        let (cell, s) = if i == 0 { (0, -1.0) } else { (i - 1, 1.0) };
        let [w, turned] = motion.at(mesh, cell, s);
        work += node.force * w + node.moment * turned;
    }
    work
}

/// Computes the work of the ground reactions to the settlement `psi` in the displacement `delta`. The ground is bonded
/// to the beam on `zones` and out of contact elsewhere.
pub(crate) fn ground_work<R: Real>(
    mesh: &Mesh<R>,
    zones: &[MeshZone],
    psi: &[R],
    delta: &[R],
) -> R {
    let of = |c: &'_ [R], point: BeamPoint| {
        value(&c[point.cell * TERMS..(point.cell + 1) * TERMS], point.s)
    };
    let mut work = R::ZERO;
    for run in ground_runs(mesh) {
        let mut left: Option<BeamPoint> = None;
        let own = zones.iter().filter(|z| run.cells.contains(&z.from.cell));
        let mut any = false;
        let mut across = |from: Option<BeamPoint>, to: Option<BeamPoint>| {
            if let Some(link) = open_link(mesh, &run, from, to) {
                let [a, b] = [from, to].map(|point| point.map_or(R::ZERO, |point| of(psi, point)));
                let [da, db] =
                    [from, to].map(|point| point.map_or(R::ZERO, |point| of(delta, point)));
                work += link.force_left(a, b) * da + link.force_right(a, b) * db;
            }
        };
        let mut touching = R::ZERO;
        for zone in own {
            any = true;
            if run.pasternak {
                across(left, Some(zone.from));
            }
            for cell in zone.from.cell..=zone.to.cell {
                let start = if cell == zone.from.cell { zone.from.s } else { -1.0 };
                let end = if cell == zone.to.cell { zone.to.s } else { 1.0 };
                if end > start {
                    let c = &mesh.cells[cell];
                    let slice = cell * TERMS..(cell + 1) * TERMS;
                    let [psi, delta] = [&psi[slice.clone()], &delta[slice]];
                    let part = [start, end];
                    touching += if c.ground_varies() {
                        varying::energy_form(c, part, psi, delta)
                    } else {
                        energy_form(c.length(), (c.subgrade, c.shear_layer), part, psi, delta)
                    };
                }
            }
            left = Some(zone.to);
        }
        if run.pasternak && any {
            across(left, None);
        }
        work += touching;
    }
    work
}

/// Computes ∫ (κ f g + N f' g') dx between the local coordinates `from` and `to` of a cell of length h. κ and N are
/// constants, and f and g are polynomials.
pub(crate) fn energy_form<R: Real>(
    h: f64,
    (kappa, tension): (R, R),
    [from, to]: [f64; 2],
    f: &[R],
    g: &[R],
) -> R {
    let (middle, quarter) = (0.5 * (from + to), 0.5 * (to - from));
    let half = 0.5 * h * quarter;
    let form = |f: &[R], g: &[R]| kappa * half * inner(f, g, 0) + tension / half * inner(f, g, 1);
    if [from, to] == [-1.0, 1.0] {
        return form(f, g);
    }
    form(&rescale(f, middle, quarter), &rescale(g, middle, quarter))
}

/// Computes the bending integral ∫ EI f″ g″ ds over \[−1, 1\], with derivatives with respect to s.
fn bending<R: Real>(cell: &Cell<R>, f: &[R], g: &[R]) -> R {
    if cell.beam_varies() { varying::bending(cell, f, g) } else { cell.stiffness * inner(f, g, 2) }
}

/// Computes the bending integral ∫ EI φ'ψ' ds over \[−1, 1\] for the rotations φ and ψ, with derivatives with respect
/// to s.
fn turning<R: Real>(cell: &Cell<R>, f: &[R], g: &[R]) -> R {
    inner(&product(&cell.stiffness_along(), &derivative(f)), &derivative(g), 0)
}

/// Computes the shear integral ∫ S γ₁γ₂ ds over \[−1, 1\] in a cell of length h. `a` and `b` are pairs of a deflection
/// w and a rotation φ with the shear strain γ = dw/dx − φ.
fn shearing<R: Real>(shear: &[R], h: f64, a: [&[R]; 2], b: [&[R]; 2]) -> R {
    let strain = |[w, rotation]: [&[R]; 2]| {
        let mut strain = derivative(w).at_least(rotation.len());
        for (c, turned) in strain.iter_mut().zip(rotation) {
            *c = *c * (2.0 / h) - *turned;
        }
        strain
    };
    inner(&product(shear, &strain(a)), &strain(b), 0)
}
