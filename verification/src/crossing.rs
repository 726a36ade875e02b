//! Draws an animated picture of a load that crosses a footing, whose ends lift off the ground.

use groundbeam::{Beam, Field, Foundation, Load, Model, Outcome, Solution, solution::Side, solve};
use std::fmt::Write;

/// Length of the beam \[m\].
const LENGTH: f64 = 12.0;
/// Length of the ground that is shown outside each end of the beam \[m\].
const BEYOND: f64 = 2.0;
/// Number of steps in which the load crosses the beam.
const PLACES: usize = 48;
/// Number of equal parts into which the beam is divided. The fields are computed at the ends of each part.
const POINTS: usize = 40;
/// Number of equal parts into which the ground shown beyond each end of the beam is divided.
const OUTSIDE: usize = 8;
/// Width of the picture in pixels.
const WIDTH: f64 = 800.0;
/// Height of the picture in pixels.
const HEIGHT: f64 = 330.0;
/// Vertical position of the undeformed beam in pixels.
const BEAM_AT: f64 = 110.0;
/// Vertical position of the zero line of the pressure diagram in pixels.
const PRESSURE_AT: f64 = 215.0;
/// Length in pixels that represents the largest deflection of the beam.
const DEEPEST: f64 = 70.0;
/// Length in pixels that represents the largest contact pressure, and the largest force under an end of the beam.
const DIAGRAM: f64 = 80.0;

fn model(at: f64) -> Model {
    Model::new(Beam::uniform(LENGTH, 1.28e9), Foundation::pasternak(40e6, 9e6))
        .with_load(Load::point_force(at, 900e3))
        .with_load(Load::uniform_force(0.0, LENGTH, 10e3))
}

/// Returns the picture as an animated SVG file.
///
/// # Errors
///
/// The model cannot be solved for one of the positions of the load.
pub fn picture() -> Result<String, groundbeam::Error> {
    let mut solutions = Vec::new();
    for i in 0..=PLACES {
        // The load keeps a distance of 2 % of the beam length from both ends of the beam.
        let at = LENGTH * (0.02 + 0.96 * i as f64 / PLACES as f64);
        if let Outcome::Equilibrium(solution) = solve(&model(at))? {
            solutions.push((at, solution));
        }
    }
    let there: Vec<Frame> =
        solutions.iter().map(|(at, solution)| Frame::of(*at, solution)).collect();
    let most = |of: fn(&Frame) -> f64| there.iter().map(of).fold(0.0, f64::max);
    let scale = Scale {
        deflection: DEEPEST / most(Frame::deepest),
        pressure: DIAGRAM / most(Frame::largest_pressure),
        force: DIAGRAM / most(|frame| frame.ends[0].max(frame.ends[1])),
    };
    // The load moves to the other end and back.
    let order = (0..there.len()).chain((1..there.len() - 1).rev()).chain([0]);
    let frames: Vec<&Frame> = order.map(|i| &there[i]).collect();
    Ok(page(&frames, &scale))
}

/// The picture for one position of the load.
struct Frame {
    at: f64,
    /// Position x, deflection w and contact pressure.
    beam: Vec<[f64; 3]>,
    /// Position x and settlement u of points of the ground surface, including points beyond the ends of the beam.
    ground: Vec<[f64; 2]>,
    ends: [f64; 2],
}

struct Scale {
    deflection: f64,
    pressure: f64,
    force: f64,
}

impl Frame {
    fn of(at: f64, solution: &Solution) -> Self {
        let even = |i: usize| LENGTH * i as f64 / POINTS as f64;
        let beam = (0..=POINTS).map(|i| {
            let fields = solution.at(even(i), Side::Right);
            [even(i), fields.deflection, fields.get(Field::Pressure)]
        });
        let outside = |i: usize| BEYOND * i as f64 / OUTSIDE as f64;
        let left = (1..=OUTSIDE).rev().map(|i| -outside(i));
        let right = (1..=OUTSIDE).map(|i| LENGTH + outside(i));
        let ground = left.chain((0..=POINTS).map(even)).chain(right);
        let ends = solution.end_forces();
        Frame {
            at,
            beam: beam.collect(),
            ground: ground.map(|x| [x, solution.settlement(x)]).collect(),
            ends: [ends.left, ends.right],
        }
    }

    fn deepest(&self) -> f64 {
        self.beam.iter().fold(0.0, |most, point| most.max(point[1]))
    }

    fn largest_pressure(&self) -> f64 {
        self.beam.iter().fold(0.0, |most, point| most.max(point[2]))
    }
}

fn across(x: f64) -> f64 {
    WIDTH * (x + BEYOND) / (LENGTH + 2.0 * BEYOND)
}

fn path(points: impl Iterator<Item = [f64; 2]>, closed: bool) -> String {
    let mut path = String::new();
    for (i, [x, y]) in points.enumerate() {
        // Writing to a string cannot fail.
        let _ = write!(path, "{}{x:.0} {y:.1}", if i == 0 { 'M' } else { 'L' });
    }
    if closed { path + "Z" } else { path }
}

fn page(frames: &[&Frame], scale: &Scale) -> String {
    let down = |w: f64| BEAM_AT + scale.deflection * w;
    let beam = |f: &Frame| path(f.beam.iter().map(|p| [across(p[0]), down(p[1])]), false);
    let ground = |f: &Frame| {
        let corners = [[WIDTH, PRESSURE_AT - 25.0], [0.0, PRESSURE_AT - 25.0]];
        path(f.ground.iter().map(|p| [across(p[0]), down(p[1])]).chain(corners), true)
    };
    // `gap` is the path around the area between beam and ground. The area is zero in contact.
    let gap = |f: &Frame| {
        let under = f.ground[OUTSIDE..=OUTSIDE + POINTS].iter().rev().map(|p| [p[0], p[1]]);
        let around = f.beam.iter().map(|p| [p[0], p[1]]).chain(under);
        path(around.map(|[x, w]| [across(x), down(w)]), true)
    };
    let pressure = |f: &Frame| {
        let ends = [[LENGTH, 0.0], [0.0, 0.0]];
        let around = f.beam.iter().map(|p| [p[0], p[2]]).chain(ends);
        path(around.map(|[x, p]| [across(x), PRESSURE_AT + scale.pressure * p]), true)
    };
    let each = |of: &dyn Fn(&Frame) -> String| {
        frames.iter().map(|frame| of(frame)).collect::<Vec<_>>().join(";")
    };
    let moving = |attribute: &str, values: &str| {
        format!(
            r#"<animate attributeName="{attribute}" dur="12s" repeatCount="indefinite" values="{values}"/>"#
        )
    };
    let shape = |look: &str, of: &dyn Fn(&Frame) -> String| {
        let first = frames.first().map(|frame| of(frame)).unwrap_or_default();
        format!("<path d=\"{first}\" {look}>{}</path>\n", moving("d", &each(of)))
    };
    let mut body = shape(r##"fill="#efe6d8" stroke="#8a7453" stroke-width="1.4""##, &ground);
    body += &shape(r##"fill="#b9dff5""##, &gap);
    body += &shape(r##"fill="none" stroke="#3d444d" stroke-width="7""##, &beam);
    body += &shape(
        r##"fill="#0072b2" fill-opacity="0.2" stroke="#0072b2" stroke-width="1.6""##,
        &pressure,
    );
    for (end, x) in [0.0, LENGTH].into_iter().enumerate() {
        let height = |f: &Frame| format!("{:.1}", scale.force * f.ends[end]);
        let left = across(x) - 3.0;
        let first = frames.first().map(|frame| height(frame)).unwrap_or_default();
        let _ = writeln!(
            body,
            r##"<rect x="{left:.0}" y="{PRESSURE_AT}" width="6" height="{first}" fill="#00395c">{}</rect>"##,
            moving("height", &each(&height))
        );
    }
    let place = |f: &Frame| {
        let near = (f.at / LENGTH * POINTS as f64).round() as usize;
        format!("{:.0} {:.1}", across(f.at), down(f.beam[near.min(POINTS)][1]) - 4.0)
    };
    let (first, places) = (frames.first().map(|f| place(f)).unwrap_or_default(), each(&place));
    let _ = writeln!(
        body,
        r##"<g transform="translate({first})"><path d="M0 -58L0 -8M0 0L-5 -11L5 -11Z" fill="#b34700" stroke="#b34700" stroke-width="2.4"/><animateTransform attributeName="transform" type="translate" dur="12s" repeatCount="indefinite" values="{places}"/></g>"##
    );
    let words = [
        (
            24.0,
            "#1f2328",
            "A 900 kN load crosses a 12 m footing that weighs 10 kN/m; deflections are not to scale",
        ),
        (
            HEIGHT - 14.0,
            "#0072b2",
            "Contact pressure; the bars are the forces under the beam's ends. Pale blue: lifted off",
        ),
    ];
    for (y, colour, words) in words {
        let _ =
            writeln!(body, r#"<text x="16" y="{y}" fill="{colour}" font-size="14">{words}</text>"#);
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" \
         font-family=\"Inter, 'Helvetica Neue', Arial, sans-serif\" stroke-linejoin=\"round\">\n\
         <title>A load crosses a footing</title>\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#ffffff\"/>\n{body}</svg>\n"
    )
}
