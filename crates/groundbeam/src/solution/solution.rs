//! What is found: deflections, moments, the ground's surface, contact, forces. Evaluated anywhere.

use crate::Step;
use crate::certificate::Certificate;
use crate::existence::existence::Existence;
use crate::ground::link;
use crate::mesh::cell::Cell;
use crate::mesh::free_field;
use crate::model::{Beyond, Model};
use crate::numeric::polynomial::{Coefficients, jet, value};
use crate::options::Method;

/// A stretch of contact between beam and ground; of a single point, both ends are equal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactRegion {
    /// Left end \[m\].
    pub from: f64,
    /// Right end \[m\].
    pub to: f64,
}

/// The concentrated contact forces p₀ and p_l of (2.6), not negative, pushing the beam up \[N\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndForces {
    /// p₀, at x = 0.
    pub left: f64,
    /// p_l, at x = l.
    pub right: f64,
}

/// A concentrated contact force inside the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConcentratedForce {
    /// Position \[m\].
    pub at: f64,
    /// Force, pushing the beam up \[N\].
    pub force: f64,
}

/// What a support does to the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reaction {
    /// Position \[m\].
    pub at: f64,
    /// Force, positive where it pushes the beam up \[N\].
    pub force: f64,
    /// Moment, positive where it turns the right side down \[N·m\].
    pub moment: f64,
}

/// From which side a value is taken where a field jumps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Just left of the position.
    Left,
    /// Just right of the position.
    Right,
}

/// All fields at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fields {
    /// w, down positive \[m\].
    pub deflection: f64,
    /// w' \[rad\].
    pub slope: f64,
    /// φ, the rotation of the sections: w' where the beam does not shear \[rad\].
    pub rotation: f64,
    /// M = −EI (φ' − κ₀), sagging positive, κ₀ the imposed curvature; φ' = w″ where the beam does not shear \[N·m\].
    pub moment: f64,
    /// V = M' \[N\].
    pub shear_force: f64,
    /// u, the ground's surface, down positive \[m\].
    pub settlement: f64,
    /// u + g₀ − w, not negative \[m\].
    pub gap: f64,
    /// p, not negative, pushing the beam up \[N/m\].
    pub pressure: f64,
}

/// One of the fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// w.
    Deflection,
    /// w'.
    Slope,
    /// M.
    Moment,
    /// V.
    ShearForce,
    /// u.
    Settlement,
    /// u + g₀ − w.
    Gap,
    /// p.
    Pressure,
}

impl Field {
    /// All of them, in the order results list them.
    pub const ALL: [Field; 7] = [
        Field::Deflection,
        Field::Slope,
        Field::Moment,
        Field::ShearForce,
        Field::Settlement,
        Field::Gap,
        Field::Pressure,
    ];

    /// Its place in [`Field::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// The name that results use: `deflection`, `shear_force`, …
    pub fn name(self) -> &'static str {
        match self {
            Field::Deflection => "deflection",
            Field::Slope => "slope",
            Field::Moment => "moment",
            Field::ShearForce => "shear_force",
            Field::Settlement => "settlement",
            Field::Gap => "gap",
            Field::Pressure => "pressure",
        }
    }
}

impl Fields {
    /// The value of one field.
    pub fn get(&self, field: Field) -> f64 {
        match field {
            Field::Deflection => self.deflection,
            Field::Slope => self.slope,
            Field::Moment => self.moment,
            Field::ShearForce => self.shear_force,
            Field::Settlement => self.settlement,
            Field::Gap => self.gap,
            Field::Pressure => self.pressure,
        }
    }
}

/// Where a field is largest or smallest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// Position \[m\]; of several the leftmost.
    pub x: f64,
    /// Value of the field there.
    pub value: f64,
}

/// The smallest and the largest value of a field on the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The smallest value.
    pub min: Extreme,
    /// The largest value.
    pub max: Extreme,
}

/// A part of the beam on which every field is one closed form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stretch {
    /// Its ends \[m\].
    pub x: [f64; 2],
    /// Half its length \[m\]: not the difference of its ends, which are rounded.
    pub half: f64,
    /// The cell it lies in, cut to its ends: coefficients of ground, beam and loads.
    pub cell: Cell,
    /// Coefficients of w(s).
    pub deflection: Coefficients,
    /// Coefficients of φ(s); none where the beam does not shear.
    pub rotation: Coefficients,
    /// Coefficients of M(s).
    pub moment: Coefficients,
    /// Coefficients of p(s).
    pub pressure: Coefficients,
    /// Off contact, u at both ends.
    pub open: Option<[f64; 2]>,
    /// Off contact where the ground varies: coefficients of u(s).
    pub settlement: Coefficients,
}

impl Stretch {
    /// b·h of the open ground.
    fn decay(&self) -> f64 {
        (self.cell.spring / self.cell.shear).sqrt() * 2.0 * self.half
    }

    fn gap_at(&self, s: f64) -> f64 {
        let [left, right] = self.cell.gap;
        0.5 * (left + right) + 0.5 * (right - left) * s
    }

    /// u and u'.
    pub(crate) fn settlement(&self, s: f64, w: f64, slope: f64) -> [f64; 2] {
        match self.open {
            None => [w - self.gap_at(s), slope - self.cell.gap_slope],
            Some(ends) => {
                let ([u, du], [own, sinks]) = (self.pressed(s, ends), self.cell.settled_at(s));
                [u + own, du + sinks]
            }
        }
    }

    /// What the beam's pressure elsewhere adds to u and u' of open ground.
    pub(crate) fn pressed(&self, s: f64, [left, right]: [f64; 2]) -> [f64; 2] {
        if [left, right] == [0.0; 2] {
            return [0.0; 2];
        }
        if !self.settlement.is_empty() {
            let [u, du, ..] = jet(&self.settlement, s);
            return [u, du / self.half];
        }
        let t = 0.5 * (1.0 + s);
        let bh = self.decay();
        let b = bh / (2.0 * self.half);
        let slope = link::slope_between(left, right, bh, t);
        [link::between(left, right, bh, t), b * slope]
    }

    pub(crate) fn fields(&self, s: f64) -> Fields {
        let per_length = 1.0 / self.half;
        let [w, dw, ..] = jet(&self.deflection, s);
        let slope = dw * per_length;
        let [moment, dm, ..] = jet(&self.moment, s);
        let [settlement, _] = self.settlement(s, w, slope);
        let gap = match self.open {
            None => 0.0,
            Some(_) => settlement + self.gap_at(s) - w,
        };
        Fields {
            deflection: w,
            slope,
            rotation: if self.rotation.is_empty() { slope } else { value(&self.rotation, s) },
            moment,
            shear_force: dm * per_length,
            settlement,
            gap,
            pressure: value(&self.pressure, s),
        }
    }

    pub(crate) fn local(&self, x: f64) -> f64 {
        let [from, to] = self.x;
        let s = if x - from <= to - x {
            (x - from) / self.half - 1.0
        } else {
            1.0 - (to - x) / self.half
        };
        s.clamp(-1.0, 1.0)
    }

    pub(crate) fn global(&self, s: f64) -> f64 {
        let [from, to] = self.x;
        if s <= 0.0 { from + self.half * (1.0 + s) } else { to - self.half * (1.0 - s) }
    }
}

/// An equilibrium, with its certificate.
///
/// There is one way to make one: [`solve`](crate::solve()), which certifies it.
#[derive(Debug, Clone)]
pub struct Solution {
    pub(crate) model: Model,
    pub(crate) method: Method,
    pub(crate) existence: Existence,
    pub(crate) stretches: Vec<Stretch>,
    pub(crate) contact: Vec<ContactRegion>,
    pub(crate) end_forces: EndForces,
    pub(crate) concentrated: Vec<ConcentratedForce>,
    pub(crate) reactions: Vec<Reaction>,
    pub(crate) certificate: Certificate,
    pub(crate) history: Vec<Step>,
    pub(crate) elements: usize,
}

impl Solution {
    /// A place for a solution.
    pub(crate) fn without_fields(model: Model) -> Self {
        Solution {
            model,
            method: Method::default(),
            existence: Existence::default(),
            stretches: Vec::new(),
            contact: Vec::new(),
            end_forces: EndForces { left: 0.0, right: 0.0 },
            concentrated: Vec::new(),
            reactions: Vec::new(),
            certificate: Certificate::default(),
            history: Vec::new(),
            elements: 0,
        }
    }

    /// The model that was solved.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The method that found it.
    pub fn method(&self) -> Method {
        self.method
    }

    /// What is known of existence and uniqueness.
    pub fn existence(&self) -> &Existence {
        &self.existence
    }

    /// The contact zones as pairs of positions \[m\].
    pub(crate) fn contact_positions(&self) -> Vec<[f64; 2]> {
        self.contact.iter().map(|zone| [zone.from, zone.to]).collect()
    }

    /// Where beam and ground touch, from left to right. A beam that touches nowhere has none.
    pub fn contact(&self) -> &[ContactRegion] {
        &self.contact
    }

    /// The concentrated contact forces under the beam's ends.
    pub fn end_forces(&self) -> EndForces {
        self.end_forces
    }

    /// Concentrated contact forces elsewhere: where μ jumps, where the ground has a corner, at a single
    /// point of contact; with pressures as nodal forces (5.5), all of those.
    pub fn concentrated_forces(&self) -> &[ConcentratedForce] {
        &self.concentrated
    }

    /// What the supports do, in the order of the model's supports.
    pub fn reactions(&self) -> &[Reaction] {
        &self.reactions
    }

    /// The proof.
    pub fn certificate(&self) -> &Certificate {
        &self.certificate
    }

    /// Every step of the iteration that led here.
    pub fn history(&self) -> &[Step] {
        &self.history
    }

    /// Steps of the iteration.
    pub fn iterations(&self) -> usize {
        self.history.len()
    }

    /// Elements of the mesh, or closed-form pieces of the exact method.
    pub fn elements(&self) -> usize {
        self.elements
    }

    fn stretch_at(&self, x: f64, side: Side) -> &Stretch {
        let i = match side {
            Side::Right => self.stretches.partition_point(|s| s.x[1] <= x),
            Side::Left => self.stretches.partition_point(|s| s.x[1] < x),
        };
        &self.stretches[i.min(self.stretches.len() - 1)]
    }

    /// All fields at a position of the beam, 0 ≤ x ≤ l \[m\]; where a field jumps, from the given side.
    pub fn at(&self, x: f64, side: Side) -> Fields {
        let x = x.clamp(0.0, self.model.beam.length);
        let stretch = self.stretch_at(x, side);
        stretch.fields(stretch.local(x))
    }

    /// One field at a position of the beam; where it jumps, from the right (at x = l from the left).
    pub fn value(&self, field: Field, x: f64) -> f64 {
        self.at(x, Side::Right).get(field)
    }

    /// u at any position on the whole line, also beyond the beam \[m\]; 0 where there is no shear layer.
    pub fn settlement(&self, x: f64) -> f64 {
        let l = self.model.beam.length;
        let right = x > l;
        if !right && x >= 0.0 {
            return self.value(Field::Settlement, x);
        }
        let (end, distance) =
            if right { (self.at(l, Side::Left), x - l) } else { (self.at(0.0, Side::Right), -x) };
        let beyond = self.beyond(right);
        if !self.model.has_ground_loads() {
            return link::beside(&beyond, end.settlement, distance);
        }
        let cells: Vec<Cell> = self.stretches.iter().map(|stretch| stretch.cell).collect();
        let own = |distance: f64| free_field::at(&self.model, &beyond, right, &cells, distance);
        link::beside(&beyond, end.settlement - own(0.0), distance) + own(distance)
    }

    /// The ground beyond an end of the beam.
    pub(crate) fn beyond(&self, right: bool) -> Beyond {
        let at_end = if right {
            self.stretches[self.stretches.len() - 1].cell.ground_at(1.0)
        } else {
            self.stretches[0].cell.ground_at(-1.0)
        };
        self.model.foundation.beyond(right, self.model.beam.length, at_end)
    }

    /// Positions at which the fields are worth listing: `even` equal steps, every load, support, joint and
    /// edge of contact, and the extremes of every field.
    pub fn stations(&self, even: usize) -> Vec<f64> {
        let l = self.model.beam.length;
        let mut x: Vec<f64> = (0..=even).map(|i| l * (i as f64 / even.max(1) as f64)).collect();
        x.extend(crate::mesh::mesh::Mesh::build(&self.model, &[], |_| 1).nodes.iter().map(|n| n.x));
        x.extend(self.contact.iter().flat_map(|c| [c.from, c.to]));
        for field in Field::ALL {
            let range = self.range(field);
            x.extend([range.min.x, range.max.x]);
        }
        x.sort_by(f64::total_cmp);
        x.dedup();
        x
    }
}
