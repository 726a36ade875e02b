//! Computes which nodes are in contact with the ground from the deflections of all nodes.
//!
//! The contact set solves the [obstacle problem](crate::contact::obstacle) at the nodes. Only nodes on which bonded
//! ground would press can be in contact. Consecutive nodes of this kind form an *arc*. A scan from left to right joins
//! arcs to contact zones. The force at the end of a zone is monotone in the position of this end, so bisection finds
//! the end.

use super::grid::Grid;
use crate::ground::link::TwoPort;

/// Contact zone, given by its first and its last node.
pub(crate) type Zone = [usize; 2];

/// Obstacle problem at the nodes for ψ = w − g₀ − u₀, with the deflection w, the initial gap g₀ and the free-field
/// settlement u₀.
pub(crate) struct Hull<'a> {
    pub grid: &'a Grid,
    pub deflection: &'a [f64],
    /// Initial guess of the contact zones. The search for each end of a zone starts from this guess.
    pub near: &'a [Zone],
}

/// Number of nodes tested in one block.
const BLOCK: usize = 32;

/// Contact zones in the part of the beam that is already scanned.
type Stack = Vec<Zone>;

impl Hull<'_> {
    /// Computes the contact zones and writes them to `zones`. `arcs` is scratch memory.
    pub fn zones(&self, arcs: &mut Vec<Zone>, zones: &mut Stack) {
        self.arcs(arcs);
        zones.clear();
        for arc in arcs.iter() {
            let mut new = *arc;
            loop {
                let Some(last) = zones.last_mut() else {
                    new[0] = self.first_that_presses(new, None);
                    break;
                };
                // The loop moves the end of the last zone and the start of the new zone in turn, until neither of
                // them moves.
                loop {
                    let before = new[0];
                    last[1] = self.last_that_presses(*last, Some(new[0]));
                    new[0] = self.first_that_presses([new[0], arc[1]], Some(last[1]));
                    if before == new[0] {
                        break;
                    }
                }
                if !self.ends_in_tension(zones, Some(new[0])) {
                    break;
                }
                zones.pop();
                new[0] = arc[0];
            }
            zones.push(new);
        }
        while let Some(last) = zones.last_mut() {
            last[1] = self.last_that_presses(*last, None);
            if !self.ends_in_tension(zones, None) {
                break;
            }
            zones.pop();
        }
    }

    pub fn psi(&self, node: usize) -> f64 {
        let w = self.deflection[node];
        if self.grid.flat { w } else { w - self.grid.gap(node) }
    }

    /// Computes the arcs, which are the rows of nodes on which bonded ground would press. Each end node of the beam
    /// always belongs to an arc.
    fn arcs(&self, arcs: &mut Vec<Zone>) {
        arcs.clear();
        let last = self.grid.last();
        let mut start = Some(0);
        let note = |start: &mut Option<usize>, arcs: &mut Vec<Zone>, node: usize| match start.take()
        {
            Some(first) => arcs.push([first, node - 1]),
            None => *start = Some(node),
        };
        for run in &self.grid.runs {
            let bonded = run.first > 0 && self.bonded_force(run.first) > 0.0;
            if run.first > 0 && bonded != start.is_some() {
                note(&mut start, arcs, run.first);
            }
            let (c, shunt) = (run.link.series, run.link.shunt_left + run.link.shunt_right);
            let [g, to] = run.gap;
            let dg = (to - g) / run.count as f64;
            let w = &self.deflection[run.first..=run.end()];
            let mut presses = [false; BLOCK];
            let mut at = 1;
            while at < run.count {
                let end = (at + BLOCK).min(run.count);
                let mut pressing = 0;
                for ((i, w), presses) in w[at - 1..=end].windows(3).enumerate().zip(&mut presses) {
                    // The gap is linear along this row of equal elements, so the deflection w and ψ = w − gap have
                    // equal second differences.
                    let psi = w[1] - (g + dg * (at + i) as f64);
                    *presses = shunt * psi + c * ((w[1] - w[0]) - (w[2] - w[1])) > 0.0;
                    pressing += usize::from(*presses);
                }
                // No row of pressed nodes begins or ends in the block if its nodes are pressed exactly as the node
                // before the block.
                let alike = if start.is_some() { end - at } else { 0 };
                if pressing != alike {
                    for (i, presses) in presses[..end - at].iter().enumerate() {
                        if *presses != start.is_some() {
                            note(&mut start, arcs, run.first + at + i);
                        }
                    }
                }
                at = end;
            }
        }
        match start {
            Some(first) => arcs.push([first, last]),
            None => arcs.push([last, last]),
        }
    }

    /// Force of the ground on a node, if the ground is bonded to this node and to both of its neighbours.
    fn bonded_force(&self, node: usize) -> f64 {
        self.push_from_left(node) + self.push_from_right(node)
    }

    /// Force on a node from the ground to the left of it, if the ground is bonded to this node and to its
    /// left neighbour.
    fn push_from_left(&self, node: usize) -> f64 {
        if node == 0 {
            return self.grid.outside[0] * self.psi(0);
        }
        let link = &self.grid.runs[self.grid.run_at(node - 1)].link;
        link.force_right(self.psi(node - 1), self.psi(node))
    }

    fn push_from_right(&self, node: usize) -> f64 {
        if node == self.grid.last() {
            return self.grid.outside[1] * self.psi(node);
        }
        let link = &self.grid.runs[self.grid.run_at(node)].link;
        link.force_left(self.psi(node), self.psi(node + 1))
    }

    /// Force on a node from the ground to its right, which is out of contact up to the first node `next` of the next
    /// zone, or up to the far end of the ground.
    fn open_right(&self, node: usize, next: Option<usize>) -> f64 {
        let psi = next.map_or(0.0, |next| self.psi(next));
        Opening::default().rightwards(self.grid, node, next).force_left(self.psi(node), psi)
    }

    fn open_left(&self, node: usize, before: Option<usize>) -> f64 {
        let psi = before.map_or(0.0, |before| self.psi(before));
        Opening::default().leftwards(self.grid, node, before).force_right(psi, self.psi(node))
    }

    /// Returns the last node of the contact zone from `from` to `to` on which the ground presses if it is out of
    /// contact between this node and the first node `next` of the next zone.
    fn last_that_presses(&self, [from, to]: Zone, next: Option<usize>) -> usize {
        let (mut opening, psi_next) = (Opening::default(), next.map_or(0.0, |next| self.psi(next)));
        let presses = |back: usize| {
            let node = to - back;
            let open = opening.rightwards(self.grid, node, next);
            self.push_from_left(node) + open.force_left(self.psi(node), psi_next) >= 0.0
        };
        let near = self.near.partition_point(|zone| zone[1] < from);
        let guess = self.near.get(near).map_or(to, |zone| zone[1].min(to));
        to - first_holding(to - from, to - guess, presses)
    }

    fn first_that_presses(&self, [from, to]: Zone, before: Option<usize>) -> usize {
        let (mut opening, psi_before) =
            (Opening::default(), before.map_or(0.0, |before| self.psi(before)));
        let presses = |on: usize| {
            let node = from + on;
            let open = opening.leftwards(self.grid, node, before);
            self.push_from_right(node) + open.force_right(psi_before, self.psi(node)) >= 0.0
        };
        let near = self.near.partition_point(|zone| zone[0] <= to);
        let guess = near.checked_sub(1).map_or(from, |i| self.near[i][0].max(from));
        from + first_holding(to - from, guess - from, presses)
    }

    /// Whether the last zone is a single node on which the ground does not press. The ground on both sides of this
    /// node is out of contact.
    fn ends_in_tension(&self, zones: &[Zone], next: Option<usize>) -> bool {
        let Some(&[from, to]) = zones.last() else { return false };
        let before = zones.len().checked_sub(2).map(|i| zones[i][1]);
        from == to && self.open_left(from, before) + self.open_right(from, next) <= 0.0
    }

    /// Calls `each` for every contribution to the ground forces at the nodes in contact, with the node and the
    /// contribution.
    pub fn forces(&self, zones: &[Zone], mut each: impl FnMut(usize, f64)) {
        for (i, &[from, to]) in zones.iter().enumerate() {
            let before = i.checked_sub(1).map(|i| zones[i][1]);
            let next = zones.get(i + 1).map(|zone| zone[0]);
            each(from, self.open_left(from, before));
            each(to, self.open_right(to, next));
            for (run, a, b) in self.grid.parts(from, to) {
                let link = &self.grid.runs[run].link;
                let mut psi = self.psi(a);
                for node in a..b {
                    let after = self.psi(node + 1);
                    each(node, link.force_left(psi, after));
                    each(node + 1, link.force_right(psi, after));
                    psi = after;
                }
            }
        }
    }
}

/// Ground out of contact on one side of a node that is tried as the end of a contact zone. `rest`, the ground beyond
/// the row `run`, is stored for the next trial.
#[derive(Default)]
struct Opening {
    run: usize,
    rest: Option<Rest>,
}

/// Two-port of the ground from the end of a row of elements to the neighbouring contact zone, or of all ground beyond
/// the row. `None` if this zone reaches into the row.
type Rest = Option<TwoPort>;

impl Opening {
    /// Equivalent springs of the ground out of contact from a node to the first node of the next contact zone.
    /// Without a next zone, the ground outside the beam is included.
    fn rightwards(&mut self, grid: &Grid, node: usize, next: Option<usize>) -> TwoPort {
        if next.is_none() && node == grid.last() {
            return grid.right_of(node);
        }
        let run = grid.run_at(node);
        let (own, end) = (&grid.runs[run], next.unwrap_or(grid.last()));
        let rest = match self.rest {
            Some(rest) if self.run == run => rest,
            _ => match next {
                None => Some(grid.right_of(own.end())),
                Some(next) => grid.link(own.end().min(next), next),
            },
        };
        (self.run, self.rest) = (run, Some(rest));
        let near = own.open(node, own.end().min(end));
        rest.map_or(near, |rest| near.then(rest))
    }

    /// Equivalent springs of the ground out of contact from the last node of the previous contact zone to a node.
    /// Without a previous zone, the ground outside the beam is included.
    fn leftwards(&mut self, grid: &Grid, node: usize, before: Option<usize>) -> TwoPort {
        if node == 0 {
            return grid.left_of(node);
        }
        let run = grid.run_at(node - 1);
        let (own, start) = (&grid.runs[run], before.unwrap_or(0));
        let rest = match self.rest {
            Some(rest) if self.run == run => rest,
            _ => match before {
                None => Some(grid.left_of(own.first)),
                Some(before) => grid.link(before, own.first.max(before)),
            },
        };
        (self.run, self.rest) = (run, Some(rest));
        let near = own.open(own.first.max(start), node);
        rest.map_or(near, |rest| rest.then(near))
    }
}

/// Returns the smallest number that satisfies a monotone condition, or `most` if no smaller number satisfies the
/// condition. The search doubles its steps from a guess and then bisects.
fn first_holding(most: usize, guess: usize, mut holds: impl FnMut(usize) -> bool) -> usize {
    let (mut fails, mut found) = (None, most);
    let mut step = 1;
    if guess < most && !holds(guess) {
        // Upwards.
        fails = Some(guess);
        let mut at = guess + step;
        while at < most {
            if holds(at) {
                found = at;
                break;
            }
            fails = Some(at);
            step *= 2;
            at += step;
        }
    } else {
        found = guess;
        while found > 0 {
            let at = found.saturating_sub(step);
            if !holds(at) {
                fails = Some(at);
                break;
            }
            found = at;
            step *= 2;
        }
    }
    while let Some(low) = fails.filter(|low| found - low > 1) {
        let middle = low + (found - low) / 2;
        if holds(middle) {
            found = middle;
        } else {
            fails = Some(middle);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_search_succeeds_from_any_guess() {
        for most in 0..40 {
            for first in 0..=most {
                for guess in 0..=most {
                    assert_eq!(first_holding(most, guess, |i| i >= first), first);
                }
            }
        }
    }
}
