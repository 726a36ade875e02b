//! Writes the log of a proof: its inputs and its inequalities, with one JSON object in each line.
//!
//! An independent program can recompute the inequalities. Lengths and forces are scaled by powers of two. A ball is
//! written as the list of its midpoint, a correction of the midpoint, and its radius. `docs/verify.md` describes the
//! lines.

use crate::beside::Row;
use crate::coefficient::Coefficient;
use crate::contact_set::{EdgeShift, Round, Shown};
use crate::frame::{Frame, Node, Span};
use crate::model::Acts;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::polynomial::Polynomial;
use crate::scalar::Scalar;
use crate::size::Size;

/// The lines of the log of one proof.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Log {
    text: String,
}

/// A line of the log that is being written.
struct Line<'a> {
    text: &'a mut String,
}

impl Line<'_> {
    /// Adds a key and its value in JSON to the line.
    fn with(self, key: &str, json: impl AsRef<str>) -> Self {
        self.text.push_str(&format!(",\"{key}\":{}", json.as_ref()));
        self
    }

    fn end(self) {
        self.text.push_str("}\n");
    }
}

impl Log {
    /// An empty log.
    pub fn new() -> Self {
        Log::default()
    }

    /// The lines.
    pub fn text(&self) -> &str {
        &self.text
    }

    fn line(&mut self, name: &str, section: &str) -> Line<'_> {
        self.text.push_str(&format!("{{\"name\":\"{name}\",\"section\":\"{section}\""));
        Line { text: &mut self.text }
    }

    /// Writes the problem, the claimed solution and its corrections, the error energy, the error bounds on each piece,
    /// and the contact set.
    pub(crate) fn record<S: Scalar>(
        &mut self,
        pointwise: &Pointwise<S>,
        bounds: &[PieceBounds],
        shown: &Shown,
    ) {
        let (fields, balanced) = (pointwise.fields, pointwise.balanced);
        let frame = fields.frame;
        self.line("problem", "3")
            .with("P", optional(frame.axial_force().map(ball)))
            .with("sigma", optional(frame.compression.as_ref().map(|c| double(c.margin))))
            .with("outside", list(frame.outside.map(ball)))
            .with("pushed", list(frame.pushed.map(ball)))
            .with("cuts", list(balanced.cuts.iter().map(usize::to_string)))
            .with("carrier", double(balanced.carrier))
            .with("units", list([frame.units.force, frame.units.length].map(|n| n.to_string())))
            .end();
        for (side, row) in frame.rows.iter().enumerate() {
            self.row(side, row);
        }
        for (i, node) in frame.nodes.iter().enumerate() {
            self.node(i, node);
        }
        for (i, span) in frame.spans.iter().enumerate() {
            self.piece(i, span);
        }
        for (i, value) in fields.deflection.values.iter().enumerate() {
            self.line("admissible at a node", "3, deflection")
                .with("node", i.to_string())
                .with("w", ball(*value))
                .with("touches", fields.surface.touches[i].to_string())
                .end();
        }
        for (i, closing) in fields.deflection.pieces.iter().enumerate() {
            self.line("closing", "(3)")
                .with("piece", i.to_string())
                .with("slopes", list(closing.slope.map(ball)))
                .with("bounds", list(closing.bounds.map(size)))
                .end();
        }
        for (i, pressure) in fields.pressures.iter().enumerate() {
            self.line("pull", "3, signs of p")
                .with("piece", i.to_string())
                .with("depth", size(pressure.depth))
                .with("width", size(pressure.width))
                .end();
        }
        for i in 0..frame.spans.len() {
            self.line("ground", "(4)")
                .with("piece", i.to_string())
                .with("root_g", size(fields.surface.pieces[i].flexibility))
                .with("raised", size(fields.clearance.raised[i]))
                .end();
        }
        self.line("clearance", "(10)")
            .with("lifted", size(fields.clearance.lifted))
            .with("risen", size(fields.clearance.risen))
            .end();
        self.line("energy", "(11)").with("E", size(pointwise.energy)).end();
        for (i, piece) in bounds.iter().enumerate() {
            self.bounds(i, piece);
        }
        self.contact(shown);
    }

    /// Writes the supports with the error bounds of force and moment, and whether the states of all one-way
    /// supports are proven.
    pub(crate) fn supports<S: Scalar>(
        &mut self,
        frame: &Frame<S>,
        errors: &[[Size; 2]],
        decided: bool,
    ) {
        for (i, (held, errors)) in frame.supports.iter().zip(errors).enumerate() {
            self.line("support", "6")
                .with("support", i.to_string())
                .with("node", optional(held.node.map(|node| node.to_string())))
                .with("x", ball(held.x))
                .with("acts", acts(held.acts))
                .with("springs", optional(held.springs.map(|both| list(both.map(ball)))))
                .with("settlement", ball(held.settlement))
                .with("claimed", list(held.claimed.map(ball)))
                .with("errors", list(errors.map(size)))
                .end();
        }
        self.line("supports", "6").with("decided", decided.to_string()).end();
    }

    /// Writes whether the solution is unique.
    pub(crate) fn unique(&mut self, is_unique: bool) {
        self.line("unique", "7").with("shown", is_unique.to_string()).end();
    }

    /// Writes the ground outside one end of the beam, from the beam outward.
    fn row<S: Scalar>(&mut self, side: usize, row: &Row<S>) {
        let stretches = row.stretches.iter().map(|stretch| {
            list([
                optional(stretch.length.map(ball)),
                list(stretch.ground.map(ball)),
                list(stretch.spread.map(ball)),
                ball(stretch.force),
            ])
        });
        self.line("ground beside the beam", "3, ground")
            .with("side", side.to_string())
            .with("stretches", list(stretches))
            .with("held", row.held.to_string())
            .end();
    }

    fn node<S: Scalar>(&mut self, i: usize, node: &Node<S>) {
        let weights = &node.weights;
        let weights = [weights.rigid, weights.spring, weights.clamp, weights.turning];
        self.line("node", "3, positions")
            .with("node", i.to_string())
            .with("x", ball(node.x))
            .with("F", ball(node.force))
            .with("M0", ball(node.moment))
            .with("Q", ball(node.ground_force))
            .with("rigid", optional(node.rigid.map(ball)))
            .with("clamped", node.clamped.to_string())
            .with("acts", acts(node.acts))
            .with("spring", optional(node.spring.map(|spring| list(spring.map(ball)))))
            .with("turning", optional(node.turning.map(ball)))
            .with("hinge", optional(node.hinge.map(ball)))
            .with("reaction", list(node.reaction.map(ball)))
            .with("weights", list(weights.map(double)))
            .end();
    }

    fn piece<S: Scalar>(&mut self, i: usize, span: &Span<S>) {
        self.line("piece", "1")
            .with("piece", i.to_string())
            .with("middle", ball(span.middle))
            .with("half", ball(span.half))
            .with("touches", span.touches.to_string())
            .with("w", polynomial(&span.deflection))
            .with("phi", optional(span.rotation.as_deref().map(polynomial)))
            .with("EI", coefficient(&span.bending))
            .with("S", optional(span.stiffness.as_ref().map(coefficient)))
            .with("k", coefficient(&span.spring))
            .with("mu", coefficient(&span.shear))
            .with("f", polynomial(&span.force))
            .with("g", polynomial(&span.moment))
            .with("kappa0", polynomial(&span.curvature))
            .with("g0", polynomial(&span.gap))
            .with("q", optional(span.ground_load.as_ref().map(polynomial)))
            .with("open", optional(span.stored.map(|ends| list(ends.map(ball)))))
            .with("u", optional(span.settlement.as_deref().map(polynomial)))
            .end();
    }

    fn bounds(&mut self, i: usize, bounds: &PieceBounds) {
        self.line("bounds", "4")
            .with("piece", i.to_string())
            .with("w", size(bounds.deflection))
            .with("slope", size(bounds.slope))
            .with("rotation", size(bounds.rotation))
            .with("m", size(bounds.balanced_moment))
            .with("M", size(bounds.moment))
            .with("V", size(bounds.shear_force))
            .with("u", size(bounds.settlement))
            .with("p", size(bounds.pressure))
            .end();
    }

    /// Writes one iteration of the proof of the contact set: the error bounds on each piece and those of the contact
    /// edges.
    fn round(&mut self, round: &Round) {
        let bounds = |b: &PieceBounds| list([b.slope, b.shear_force, b.pressure].map(size));
        self.line("round", "5")
            .with("shown", round.shown.to_string())
            .with("bounds", list(round.bounds.iter().map(bounds)))
            .with("edges", list(round.edges.iter().map(edge)))
            .end();
    }

    fn contact(&mut self, shown: &Shown) {
        for round in &shown.rounds {
            self.round(round);
        }
        for shift in &shown.edges {
            self.line("edge", "5").with("edge", edge(shift)).end();
        }
        for zone in &shown.zones {
            self.line("zone", "5")
                .with("piece", zone.piece.to_string())
                .with("side", zone.side.to_string())
                .with("length", size(zone.theta))
                .end();
        }
        for (node, tolerance) in shown.tolerances.iter().enumerate() {
            self.line("tolerance of a force", "5")
                .with("node", node.to_string())
                .with("error", size(*tolerance))
                .end();
        }
        let shown = [shown.failed[0].is_none(), shown.failed[1].is_none()];
        self.line("contact set", "5")
            .with("shown", list(shown.map(|shown| shown.to_string())))
            .end();
    }
}

/// Returns the code of the directions of a support: 0 if it acts in both directions, 1 if it only pushes up, −1 if
/// it only pulls down.
fn acts(acts: Acts) -> String {
    let sign = match acts {
        Acts::Both => 0,
        Acts::Up => 1,
        Acts::Down => -1,
    };
    sign.to_string()
}

/// Lists the node and the side of a contact edge, and the outward and inward error bounds of its position.
fn edge(edge: &EdgeShift) -> String {
    let lengths = [edge.outside, edge.inside].map(size);
    list([edge.node, edge.side].map(|n| n.to_string()).into_iter().chain(lengths))
}

/// Writes a constant coefficient as a ball, and a varying coefficient as a list of balls, one for each coefficient of
/// its polynomial.
fn coefficient<S: Scalar>(coefficient: &Coefficient<S>) -> String {
    match coefficient.along() {
        Some(along) => polynomial(along),
        None => ball(coefficient.least()),
    }
}

fn double(x: f64) -> String {
    if x.is_finite() { format!("{x:?}") } else { "null".to_owned() }
}

fn size(x: Size) -> String {
    double(x.value())
}

fn ball<S: Scalar>(x: S) -> String {
    list(x.parts().map(double))
}

fn polynomial<S: Scalar, const N: usize>(p: &Polynomial<S, N>) -> String {
    list(p.coefficients().iter().map(|c| ball(*c)))
}

fn list(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    format!("[{}]", items.join(","))
}

fn optional(json: Option<String>) -> String {
    json.unwrap_or_else(|| "null".to_owned())
}
