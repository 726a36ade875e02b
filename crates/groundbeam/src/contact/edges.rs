//! Phase B of the contact iteration: finds the contact edges by Newton's method.
//!
//! Each step solves the beam bonded to the ground on a trial contact set. The next set follows from [edge
//! Newton](super::edge_step) near the solution, otherwise from the obstacle problem. A line search shortens steps that
//! do not converge. See *Stopping* in `docs/methods.md`.

use crate::contact::bonded::{Bonded, GivenRotation, Springs};
use crate::contact::descent::shorten;
use crate::contact::edge_error::EdgeError;
use crate::contact::edge_step;
use crate::contact::intervals::{Interval, longest_difference, positions, snapped};
use crate::contact::obstacle;
use crate::contact::springs::zone_is_rounding_error;
use crate::contact::state::edges_not_converged;
use crate::contact::state::{ContactState, Unconverged};
use crate::contact::stopping::{
    BLIND, CONVERGED_MOVE, JITTER, LEAST_PART, NEAR, NOT_SHORTENED, ROUNDING_GAP, ROUNDING_MOVE,
    SAME, SOFTEN, SOFTEST_SPRING, STALE_STEPS, STIFFEN, StepLimit, WEIGHTLESS,
};
use crate::contact::undecided::differ_by_rounding;
use crate::contact::zone_forces::zone_forces;
use crate::mesh::mesh::required_positions;
use crate::numeric::step::Step;
use crate::numeric::tolerance::GAP;
use std::rc::Rc;

/// A trial contact set from which the iteration starts.
pub(crate) struct Start {
    pub contact: Vec<Interval>,
    /// The deflection whose contact set is `contact`, if known.
    pub now: Option<ContactState>,
    /// Whether the first step may find the next contact set by Newton's method for the positions of the contact
    /// edges. Otherwise, the first step solves the obstacle problem.
    pub near: bool,
}

impl Start {
    /// Creates an initial guess for the iteration from a trial contact set, without a deflection.
    pub fn on(contact: Vec<Interval>) -> Self {
        Start { contact, now: None, near: false }
    }

    /// Creates an initial guess for the iteration from a deflection and its contact set.
    pub fn of(found: ContactState) -> Self {
        let contact = positions(&found.mesh, &found.zones, &[]);
        Start { contact, now: Some(found), near: false }
    }
}

/// Computes the relative energy gap of a deflection with its contact set.
pub(crate) type Judge<'a> = &'a mut dyn FnMut(&ContactState) -> f64;

/// Finds the contact edges by Newton's method. The iteration starts from the contact set in `start`. `judge`
/// computes the relative energy gap of a solution.
pub(crate) fn edges(
    bonded: &mut Bonded,
    start: Start,
    limit: StepLimit,
    judge: Judge,
) -> Result<ContactState, Unconverged> {
    let places = required_positions(bonded.model, &[]);
    let mut search = Search {
        bonded,
        judge,
        places,
        history: Vec::new(),
        visited: Vec::new(),
        now: start.now.map(Rc::new),
        before: f64::INFINITY,
        last: f64::INFINITY,
        moved: if start.near { 0.0 } else { f64::INFINITY },
        least: f64::INFINITY,
        stale: 0,
        epsilon: SOFTEST_SPRING,
        needs_springs: false,
    };
    let mut contact = search.placed(start.contact);
    while limit.allows(search.history.len(), search.cells()) {
        let trial = match search.bond(&contact)? {
            Bond::OnOnePoint(found) => return Ok(search.with_history(*found)),
            Bond::Trial(trial) => trial,
        };
        let asked = search.next_contact(&contact, &trial);
        if let Some(answer) = search.answer(&contact, &trial, &asked) {
            return Ok(search.with_history(answer));
        }
        contact = search.step(contact, trial, asked);
    }
    Err(search.stalled())
}

/// The state of the iteration between two steps.
struct Search<'a, 'm> {
    bonded: &'a mut Bonded<'m>,
    judge: Judge<'a>,
    /// The positions of the nodes required by the model.
    places: Vec<f64>,
    history: Vec<Step>,
    /// The contact sets of all steps since the line search last shortened a step.
    visited: Vec<Visited>,
    /// The present deflection, from which the next step of the contact iteration starts.
    now: Option<Rc<ContactState>>,
    /// Length of the longest interval on which the contact changed in the step before the last, relative to the beam
    /// length.
    before: f64,
    /// The same length in the last step; infinite after a shortened step.
    moved: f64,
    /// The smallest of these lengths so far.
    least: f64,
    /// Length of the longest interval on which the contact changed in the last step, relative to the length of the
    /// beam. A shortened step resets `moved`, but not this value.
    last: f64,
    /// Number of consecutive steps without progress.
    stale: usize,
    /// Stiffness of the stabilising springs in the next solve that needs them, relative to the stiffness of the
    /// ground.
    epsilon: f64,
    /// Whether the last line search was limited by rounding error. The next trial then has stabilising springs.
    needs_springs: bool,
}

/// A trial contact set, and the solution of the beam that is bonded to the ground on this set.
struct Visited {
    contact: Vec<Interval>,
    found: Rc<ContactState>,
}

/// The result of one step, in which the beam is solved as bonded to the ground on the trial contact set.
enum Bond {
    /// A solution in which the beam is balanced on one point and may rotate about it until another point comes into
    /// contact.
    OnOnePoint(Box<ContactState>),
    Trial(Trial),
}

/// The solution of the beam that is bonded to the ground on a trial contact set.
struct Trial {
    found: Rc<ContactState>,
    /// The stabilising springs; `None` unless the bonded beam is a mechanism.
    springs: Option<Springs>,
}

impl Search<'_, '_> {
    fn length(&self) -> f64 {
        self.bonded.model.beam.length
    }

    /// Number of cells of the mesh of the present deflection; 0 if no deflection is known.
    fn cells(&self) -> usize {
        self.now.as_ref().map_or(0, |now| now.mesh.cells.len())
    }

    fn placed(&self, contact: Vec<Interval>) -> Vec<Interval> {
        let l = self.length();
        contact.into_iter().map(|ends| ends.map(|x| snapped(x, &self.places, l))).collect()
    }

    /// Solves the obstacle problem of the ground under the beam with the given deflection `found`, and returns the
    /// contact set.
    fn scan(&self, found: &ContactState) -> Vec<Interval> {
        positions(&found.mesh, &obstacle::contact(&found.deflection()), &self.places)
    }

    /// Whether `contact` is the contact set of a deflection, up to rounding error.
    fn confirms(&self, contact: &[Interval], found: &ContactState) -> bool {
        longest_difference(contact, &self.scan(found)) <= ROUNDING_MOVE * self.length()
    }

    fn holds(&mut self, found: &ContactState) -> bool {
        (self.judge)(found) <= GAP
    }

    fn with_history(self, found: ContactState) -> ContactState {
        ContactState { history: self.history, ..found }
    }

    fn stalled(&self) -> Unconverged {
        edges_not_converged(self.history.len(), self.moved)
    }

    /// Solves the beam bonded to the ground on a trial contact set. If this beam is a mechanism, springs that
    /// are unstressed at the previous deflection stabilise it.
    fn bond(&mut self, contact: &[Interval]) -> Result<Bond, Unconverged> {
        if !self.needs_springs
            && let Ok(found) = self.bonded.solve_on(contact)
        {
            return Ok(Bond::Trial(Trial { found: Rc::new(found), springs: None }));
        }
        let Some(now) = self.now.clone() else { return Err(self.stalled()) };
        if let Some(found) = self.balanced(contact, &now) {
            return Ok(Bond::OnOnePoint(Box::new(found)));
        }
        let stabilised = self.bonded.solve_stabilised(contact, &now, &mut self.epsilon);
        let (found, springs) = stabilised.ok_or_else(|| self.stalled())?;
        Ok(Bond::Trial(Trial { found: Rc::new(found), springs: Some(springs) }))
    }

    /// Solves a beam that touches the ground at one point and has the rotation of `like` there. Returns `None` if the
    /// solution does not satisfy the contact conditions.
    fn balanced(&mut self, contact: &[Interval], like: &ContactState) -> Option<ContactState> {
        let found = self.bonded.solve_held(contact, &[GivenRotation::as_in(like)]).ok()?;
        let holds = self.confirms(contact, &found) && (self.judge)(&found) <= ROUNDING_GAP;
        holds.then_some(found)
    }

    /// Computes the next trial contact set by a Newton step of the edges, or from the obstacle problem if the last move
    /// was large or no edge moves.
    fn next_contact(&mut self, contact: &[Interval], trial: &Trial) -> Vec<Interval> {
        let found = &trial.found;
        let l = self.length();
        let is_near = self.moved < NEAR && self.moved <= self.least && trial.springs.is_none();
        let by_edges = is_near
            .then(|| edge_step::next_intervals(&found.deflection(), &found.zones))
            .flatten()
            .map(|next| self.placed(next));
        let by_edges =
            by_edges.filter(|next| longest_difference(contact, next) > ROUNDING_MOVE * l);
        let next = by_edges.unwrap_or_else(|| self.scan(found));
        self.before = self.moved;
        self.moved = longest_difference(contact, &next) / l;
        // A move is progress if it is at most half of the preceding move. Moves in the range of rounding error
        // fluctuate, so they must be at most half of the smallest move.
        let goal = if self.moved > JITTER { self.last } else { self.least };
        let is_progress = self.moved.is_finite() && self.moved <= 0.5 * goal;
        self.stale = if is_progress { 0 } else { self.stale + 1 };
        self.last = self.moved;
        self.history.push(Step { zones: next.len(), step: 1.0, decrement: self.moved });
        next
    }

    /// Returns the solution if the trial contact has converged, if only rounding error moves it, or if the iteration
    /// returns to an earlier contact.
    fn answer(
        &mut self,
        contact: &[Interval],
        trial: &Trial,
        asked: &[Interval],
    ) -> Option<ContactState> {
        let found = &trial.found;
        if let Some(springs) = &trial.springs {
            return self.is_balanced(contact, found, springs).then(|| {
                let edge_error = EdgeError::of(&[contact, asked], self.length());
                ContactState { edge_error, ..found.as_ref().clone() }
            });
        }
        self.visited.push(Visited { contact: contact.to_vec(), found: Rc::clone(found) });
        self.settled(contact, found, asked).or_else(|| self.returned(asked))
    }

    /// Whether the stabilising springs of a mechanism carry no force.
    fn is_balanced(
        &mut self,
        contact: &[Interval],
        found: &ContactState,
        springs: &Springs,
    ) -> bool {
        let is_unchanged = self.moved <= ROUNDING_MOVE;
        let at_rest = is_unchanged && !self.needs_springs && springs.at_rest;
        at_rest && self.holds(found)
            || (is_unchanged || self.jitters(contact, found)) && (self.judge)(found) <= ROUNDING_GAP
    }

    /// Returns the solution if the trial contact has converged or if only rounding error moves it.
    fn settled(
        &mut self,
        contact: &[Interval],
        found: &ContactState,
        asked: &[Interval],
    ) -> Option<ContactState> {
        let (moved, l) = (self.moved, self.length());
        let lengths = contact.iter().map(|[from, to]| to - from).filter(|length| *length > 0.0);
        let shortest = lengths.fold(l, f64::min) / l;
        let has_converged = moved <= CONVERGED_MOVE * shortest
            || moved <= ROUNDING_MOVE && moved >= 0.25 * self.before;
        if !has_converged && !self.jitters(contact, found) {
            return None;
        }
        let fewer = self.without_weightless(contact, found);
        if let Some(answer) = fewer.or_else(|| self.on_a_corner(contact, found)) {
            return Some(answer);
        }
        if !self.holds(found) && !has_converged {
            return None;
        }
        let trials = if has_converged { 1 } else { STALE_STEPS };
        let last = &self.visited[self.visited.len().saturating_sub(trials)..];
        let trials: Vec<&[Interval]> =
            last.iter().map(|one| &one.contact[..]).chain([asked]).collect();
        Some(ContactState { edge_error: EdgeError::of(&trials, l), ..found.clone() })
    }

    /// If the iteration returns to an earlier contact, returns the solution with the fewest zones in this cycle. The
    /// contacts of a cycle differ by rounding error.
    fn returned(&mut self, asked: &[Interval]) -> Option<ContactState> {
        let l = self.length();
        if self.moved <= SAME {
            return None;
        }
        let is_same = |one: &Visited| longest_difference(&one.contact, asked) <= SAME * l;
        let first = self.visited.iter().position(is_same)?;
        let mut cycle: Vec<Visited> = self.visited.drain(first..).collect();
        let trials: Vec<&[Interval]> = cycle.iter().map(|one| &one.contact[..]).collect();
        let edge_error = EdgeError::of(&trials, l);
        cycle.sort_by_key(|one| one.contact.len());
        let one = cycle.into_iter().find(|one| self.holds(&one.found))?;
        Some(ContactState { edge_error, ..Rc::unwrap_or_clone(one.found) })
    }

    /// Whether the contact edges change only because of rounding error.
    fn jitters(&self, contact: &[Interval], found: &ContactState) -> bool {
        let asked = || obstacle::contact(&found.deflection());
        self.stale >= STALE_STEPS
            && self.moved.is_finite()
            && (self.moved <= JITTER || differ_by_rounding(found, contact, &asked(), &self.places))
    }

    /// Solves the beam without the zones whose contact force is rounding error. On Winkler ground, a zone in which the
    /// obstacle is rounding error stays in contact.
    fn without_weightless(
        &mut self,
        contact: &[Interval],
        found: &ContactState,
    ) -> Option<ContactState> {
        // A single zone carries the whole force.
        if contact.len() < 2 {
            return None;
        }
        let forces = zone_forces(&found.deflection(), contact, &found.zones);
        let all: f64 = forces.iter().map(|force| force.abs()).sum();
        let each = contact.iter().copied().zip(forces);
        let w = found.deflection();
        let on_winkler_ground = |[from, to]: Interval| {
            w.mesh.cells[w.mesh.cell_at(0.5 * (from + to))].shear_layer == 0.0
        };
        let (strong, weightless): (Vec<_>, Vec<_>) =
            each.partition(|(zone, force)| match zone_is_rounding_error(&w, *zone) {
                true => on_winkler_ground(*zone),
                false => *force > WEIGHTLESS * all,
            });
        if weightless.is_empty() {
            return None;
        }
        let in_tension = weightless.iter().all(|(_, force)| *force < 0.0);
        let strong: Vec<Interval> = strong.into_iter().map(|(zone, _)| zone).collect();
        let mut edge_error = EdgeError::of(&[contact, &strong], self.length());
        edge_error.moved = edge_error.moved.max(self.moved * self.length());
        let rest = self.bonded.solve_on(&strong).ok()?;
        // Zones in tension are left out. If the obstacle problem puts them in contact again, their tension is rounding
        // error.
        let own = self.scan(&rest);
        let same =
            |zones: &[Interval]| longest_difference(zones, &own) <= ROUNDING_MOVE * self.length();
        let is_own = same(&strong) || in_tension && same(contact);
        (is_own && self.holds(&rest)).then_some(ContactState { edge_error, ..rest })
    }

    /// If the length of the only contact zone may be rounding error, solves the beam as balanced on a single point.
    /// This point is one of the ends of the zone.
    fn on_a_corner(&mut self, contact: &[Interval], found: &ContactState) -> Option<ContactState> {
        let &[[from, to]] = contact else { return None };
        let is_short = from < to && to - from <= SAME * self.length();
        is_short.then(|| [from, to].into_iter().find_map(|at| self.balanced(&[[at; 2]], found)))?
    }

    /// Returns the next trial contact set: `asked` after a full step, otherwise that of the deflection after the
    /// shortened step.
    fn step(
        &mut self,
        contact: Vec<Interval>,
        trial: Trial,
        asked: Vec<Interval>,
    ) -> Vec<Interval> {
        let Trial { found, springs } = trial;
        let is_whole = springs.is_none() && (self.moved <= 0.5 * self.least || self.moved <= BLIND);
        self.least = self.least.min(self.moved);
        self.needs_springs = false;
        let from = match &self.now {
            Some(from) if !is_whole => Rc::clone(from),
            _ => {
                self.now = Some(found);
                return asked;
            }
        };
        let spring_work = springs.map_or(0.0, |springs| springs.work);
        let shortened = shorten(self.bonded.model, &from, &found, spring_work);
        if let Some(step) = self.history.last_mut() {
            step.step = shortened.part;
        }
        if springs.is_some() {
            let change = if shortened.part < NOT_SHORTENED { STIFFEN } else { SOFTEN };
            self.epsilon = (self.epsilon * change).max(SOFTEST_SPRING);
        }
        if shortened.part < LEAST_PART {
            // With the contact set of the obstacle problem, the energy decreases in the next step.
            let own = self.scan(&from);
            self.needs_springs =
                longest_difference(&contact, &own) <= ROUNDING_MOVE * self.length();
            self.moved = f64::INFINITY;
            return own;
        }
        let Some(between) = shortened.between else {
            self.now = Some(found);
            return asked;
        };
        self.visited.clear();
        self.moved = f64::INFINITY;
        let next = positions(&between.mesh, &between.zones, &self.places);
        self.now = Some(Rc::new(between));
        next
    }
}
