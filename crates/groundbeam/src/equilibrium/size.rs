//! Number of elements and memory of a solve, estimated from the model and the options.
//!
//! [`Options::memory_limit`] limits the memory. A limit on series elements bounds the computing time. See *Limits of
//! size* in `docs/methods.md`.

use crate::element;
use crate::element::element::LONGEST_SERIES;
use crate::element::operator::{Operator, ZoneKind, wave_number};
use crate::error::{Error, TooLarge};
use crate::mesh::mesh::Mesh;
use crate::model::problem::Bytes;
use crate::model::{Model, Part, Problem};
use crate::nodal::beam::LONGEST_ELEMENT;
use crate::nodal::grid::{fewest_in, is_even};
use crate::options::{Method, Options};

/// Maximum number of elements whose deflection is a power series because the stiffness varies or the beam has
/// shear deformation.
const MOST_SERIES: usize = 30_000;

/// Upper bound of the memory per element of the exact method \[bytes\]. The largest value measured in
/// `verification/tests/memory.rs` and `bench/` is 10,800.
const EXACT: usize = 12_000;
/// Upper bound of the memory per mesh cell of the other methods \[bytes\]. The largest measured value is 3500.
const MESH: usize = 4_200;
/// Upper bound of the memory per node of a solution at nodes alone \[bytes\]. The largest measured value is 53.
const NODE: usize = 100;

/// Upper bounds of the numbers of elements of a model.
#[derive(Debug, Clone, Copy, Default)]
struct Count {
    /// Number of cells of the model. A cell lies between neighbouring loads, supports or ends of segments.
    cells: usize,
    /// Number of elements of the exact method.
    elements: usize,
    /// Minimum number of elements into which a mesh divides a beam that is out of contact.
    fewest: usize,
    /// Number of elements whose deflection is a power series.
    series: usize,
    /// Whether all cells are uniform, so that a mesh can divide each cell into equal elements.
    is_even: bool,
}

impl Count {
    fn of(model: &Model) -> Self {
        let axial = model.beam.axial_force;
        let mut count = Count { is_even: true, ..Count::default() };
        count.cells = Mesh::each_graded(model, |cell, settles| {
            // The number of elements becomes infinite if compression reduces the shear stiffness to zero. The
            // estimate therefore ignores compression in cells with shear deformation.
            let tension = if cell.beam_shear.is_some() { axial.max(0.0) } else { axial };
            let needed = |touch: ZoneKind| {
                element::count(&Operator::of(cell, tension, touch), cell.length())
            };
            let needed =
                needed(ZoneKind::Contact).max(needed(ZoneKind::Open)).saturating_add(settles - 1);
            count.elements = count.elements.saturating_add(needed);
            count.fewest = count.fewest.saturating_add(fewest_in(cell, axial, settles));
            if cell.beam_shear.is_some() || cell.beam_varies() || cell.ground_varies() {
                count.series = count.series.saturating_add(needed);
            }
            count.is_even &= is_even(cell);
        });
        count
    }

    fn memory(&self, options: &Options) -> u64 {
        let each = if options.method == Method::Exact { EXACT } else { MESH };
        self.elements_of(options).saturating_mul(each) as u64
    }

    /// Estimated memory of a solve if the whole beam is out of contact \[bytes\]. Only the method `active-set` needs
    /// less memory out of contact than in contact.
    fn least_memory(&self, options: &Options) -> u64 {
        if options.method != Method::ActiveSet || !self.is_even {
            return self.memory(options);
        }
        let nodes = self.elements_of(options).saturating_mul(NODE);
        let pieces = self.cells.saturating_add(self.fewest).saturating_mul(MESH);
        nodes.saturating_add(pieces) as u64
    }

    fn elements_of(&self, options: &Options) -> usize {
        match options.method {
            Method::Exact => self.elements,
            _ => options.elements.saturating_add(self.cells).saturating_add(self.fewest),
        }
    }
}

/// Returns upper bounds of the numbers in [`Count`] without dividing the model into cells, which takes time. Returns
/// `None` for shear deformation, varying segments or loads on the ground.
fn few(model: &Model) -> Option<Count> {
    let Model { beam, foundation, loads, supports, hinges, gap } = model;
    if beam.shears() || model.varying_part().is_some() || model.has_ground_loads() {
        return None;
    }
    let softest = beam.segments.iter().map(|segment| segment.bending_stiffness.smallest());
    let softest = softest.fold(beam.bending_stiffness, f64::min);
    let (spring, shear) = foundation.largest();
    let waves = wave_number(softest, beam.axial_force.abs() + shear, spring) * beam.length;
    let ends = 2 * (beam.segments.len() + foundation.segments.len() + loads.len());
    let cells = 1 + ends + supports.len() + hinges.len() + gap.len();
    // Rounding up adds at most one element in each cell.
    let elements = cells.saturating_add((waves / LONGEST_SERIES).ceil() as usize);
    let open_waves = (beam.axial_force.abs() / softest).sqrt() * beam.length;
    let fewest = cells.saturating_add((open_waves / LONGEST_ELEMENT).ceil() as usize);
    Some(Count { cells, elements, fewest, series: 0, is_even: true })
}

/// Returns an upper estimate of the memory of a solve of a valid model \[bytes\]. The method `active-set` needs less if
/// nodes lift off.
///
/// ```
/// use groundbeam::{Beam, Foundation, Method, Model, Options, memory_estimate};
///
/// let model = Model::new(Beam::uniform(10.0, 1.0), Foundation::winkler(1.0));
/// let of = |elements: usize| {
///     memory_estimate(&model, &Options { method: Method::ActiveSet, elements, ..Options::default() })
/// };
/// assert!(of(1_000_000) > 900 * of(1_000));
/// ```
pub fn memory_estimate(model: &Model, options: &Options) -> u64 {
    Count::of(model).memory(options)
}

/// A stored solution is assumed to take 1/`KEPT` of the memory of its solve. The fraction measured in 100
/// combinations of 10⁴ loads is 0.18.
const KEPT: u64 = 5;

/// Refuses models whose stored solutions and largest solve exceed the memory limit together.
///
/// # Errors
///
/// Returns [`Error::TooLarge`] if the memory limit is exceeded.
pub fn check_memory<'m>(
    models: impl Iterator<Item = &'m Model> + Clone,
    options: &Options,
) -> Result<(), Error> {
    let check = |count: fn(&Model) -> Count| {
        let (mut elements, mut largest, mut kept) = (0_usize, 0, 0_u64);
        for model in models.clone() {
            let count = count(model);
            elements = elements.saturating_add(count.elements_of(options));
            largest = count.memory(options).max(largest);
            kept = kept.saturating_add(count.memory(options) / KEPT);
        }
        let needed = largest.saturating_add(kept);
        within(options.method.name(), elements, needed, options.memory_limit)
    };
    check(|model| few(model).unwrap_or_else(|| Count::of(model))).or_else(|_| check(Count::of))
}

/// Refuses a model with too many elements. For the method `active-set`, [`check_cells`] must be called too,
/// because the nodes that lift off are not known before the solve.
pub(crate) fn check(model: &Model, options: &Options) -> Result<(), Error> {
    if few(model).is_some_and(|count| count.least_memory(options) <= options.memory_limit) {
        return Ok(());
    }
    let count = Count::of(model);
    if options.method == Method::Exact && count.series > MOST_SERIES {
        let part = model.varying_part().unwrap_or(Part::Beam);
        return Err(Error::Unsupported(Problem::too_fine(part, count.series)));
    }
    let elements = count.elements_of(options);
    within(options.method.name(), elements, count.least_memory(options), options.memory_limit)
}

/// Refuses a mesh on which too many cells are in contact.
pub(crate) fn check_cells(cells: usize, options: &Options) -> Result<(), Error> {
    let needed = cells.saturating_mul(MESH) as u64;
    within(options.method.name(), cells, needed, options.memory_limit)
}

/// Refuses a solution at the nodes of a mesh with too many nodes.
pub(crate) fn check_nodes(model: &Model, elements: usize, limit: u64) -> Result<(), Error> {
    let count = few(model).unwrap_or_else(|| Count::of(model));
    let nodes = elements.saturating_add(count.fewest);
    let each = if count.is_even { NODE } else { MESH };
    within("nodal", nodes, nodes.saturating_mul(each) as u64, limit)
}

fn within(method: &str, elements: usize, needed: u64, limit: u64) -> Result<(), Error> {
    if needed <= limit {
        return Ok(());
    }
    let problem = Problem::too_large(method, elements, [Bytes(needed), Bytes(limit)]);
    Err(Error::TooLarge(Box::new(TooLarge { problem, elements, needed, limit })))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation};
    use crate::{solve, solve_with};

    /// Returns a model of a beam that is 10¹⁵ characteristic lengths long, under a point force at its middle.
    fn endless() -> Model {
        Model::new(Beam::uniform(1e15, 1.0), Foundation::winkler(4.0))
            .with_load(crate::Load::point_force(5e14, 1.0))
    }

    #[test]
    fn a_model_beyond_the_limit_is_refused_with_the_estimate() {
        let Err(Error::TooLarge(refused)) = solve(&endless()) else { panic!() };
        assert!(refused.needed > refused.limit && refused.limit == Options::default().memory_limit);
        let needed = Bytes(refused.needed).to_string();
        assert!(refused.problem.message.contains(&needed), "{}", refused.problem);
    }

    #[test]
    fn every_method_has_the_limit() {
        let short = Model { beam: Beam::uniform(10.0, 1.0), ..endless() };
        let short = Model { loads: vec![crate::Load::uniform_force(0.0, 10.0, 1.0)], ..short };
        for method in Method::ALL {
            let elements = if method == Method::Exact { 1 } else { usize::MAX };
            let model = if method == Method::Exact { endless() } else { short.clone() };
            let options = Options { method, elements, ..Options::default() };
            assert!(matches!(solve_with(&model, &options), Err(Error::TooLarge(_))), "{method:?}");
        }
        let none = Options { memory_limit: 0, ..Options::default() };
        assert!(matches!(solve_with(&short, &none), Err(Error::TooLarge(_))));
    }

    /// The moment lifts the beam off along four fifths of its length. Without the moment the whole beam is in
    /// contact.
    #[test]
    fn a_mesh_needs_memory_for_elements_in_contact_alone() {
        let elements = 10_000;
        let bonded = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(crate::Load::point_force(0.5, 1.0));
        let lifted = bonded.clone().with_load(crate::Load::point_moment(0.5, 0.49));
        let memory_limit = (elements * NODE + 3_000 * MESH) as u64;
        let method = Method::ActiveSet;
        let options = Options { method, elements, memory_limit, ..Options::default() };
        assert!(solve_with(&lifted, &options).is_ok());
        assert!(matches!(solve_with(&bonded, &options), Err(Error::TooLarge(_))));
    }

    #[test]
    fn the_quick_count_is_an_upper_bound() {
        let beam = Beam::uniform(100.0, 3.0).with_segment(20.0, 40.0, 0.5).with_axial_force(7.0);
        let ground = Foundation::pasternak(2.0, 1.0).with_segment(30.0, 60.0, 9.0, 5.0);
        let loads = (0..50).map(|i| crate::Load::point_force(2.0 * f64::from(i), 1.0));
        let model = Model { loads: loads.collect(), ..Model::new(beam, ground) };
        let (quick, count) = (few(&model).unwrap_or_default(), Count::of(&model));
        assert!(count.elements > 100 && quick.elements >= count.elements, "{quick:?} {count:?}");
        assert!(quick.fewest >= count.fewest, "{quick:?} {count:?}");
        assert!(quick.cells >= count.cells);
    }

    #[test]
    fn bytes_are_written_in_two_digits() {
        let written = [999, 4_000_000_000, 12_345_678, u64::MAX].map(|n| Bytes(n).to_string());
        assert_eq!(written, ["999 bytes", "4 GB", "12 MB", "18447 PB"]);
    }
}
