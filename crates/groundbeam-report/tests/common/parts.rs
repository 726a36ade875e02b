//! The parts of an SVG picture as text: its words and groups as they are, and the shapes of a group counted by kind and
//! colour, with their extent and length.

use std::fmt::Write;

/// Shapes of one kind and colour.
struct Shapes {
    kind: String,
    count: usize,
    points: usize,
    /// Smallest and largest x and y.
    extent: [[f64; 2]; 2],
    length: f64,
}

/// The parts of a picture, one per line. Each element is on a line of its own.
pub fn parts(picture: &str) -> String {
    let (mut made, mut shapes) = (String::new(), Vec::new());
    for line in picture.lines() {
        let element = line.trim_start_matches('<').trim_end_matches("/>");
        let tag = element.split([' ', '>']).next().unwrap();
        if ["line", "path", "rect", "circle"].contains(&tag) {
            add(&mut shapes, tag, element);
            continue;
        }
        if ["g", "/g", "/svg"].contains(&tag) {
            shapes.drain(..).for_each(|shapes| write(&mut made, &shapes));
        }
        writeln!(made, "{line}").unwrap();
    }
    made
}

fn write(made: &mut String, Shapes { kind, count, points, extent, length }: &Shapes) {
    let [[left, right], [top, bottom]] =
        extent.map(|ends| ends.map(|x| (100.0 * x).round() / 100.0));
    writeln!(
        made,
        "{count} × {kind}: {points} points, x {left} … {right}, y {top} … {bottom}, {length:.1} long"
    )
    .unwrap();
}

/// Attributes that place a shape; the others say how it looks.
const PLACES: [&str; 12] =
    ["d", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "width", "height"];

fn add(shapes: &mut Vec<Shapes>, tag: &str, element: &str) {
    let mut kind = tag.to_owned();
    let mut places = Vec::new();
    for attribute in element[tag.len()..].split("\" ") {
        let (name, value) = attribute.trim_start().split_once("=\"").unwrap();
        let value = value.trim_end_matches('"');
        if PLACES.contains(&name) {
            places.push((name, value));
        } else {
            write!(kind, " {name}=\"{value}\"").unwrap();
        }
    }
    if shapes.iter().all(|shapes| shapes.kind != kind) {
        let extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        shapes.push(Shapes { kind: kind.clone(), count: 0, points: 0, extent, length: 0.0 });
    }
    let own = shapes.iter_mut().find(|shapes| shapes.kind == kind).unwrap();
    own.count += 1;
    for line in lines(tag, &places) {
        own.points += line.len();
        for point in &line {
            for ([low, high], x) in own.extent.iter_mut().zip(point) {
                (*low, *high) = (low.min(*x), high.max(*x));
            }
        }
        let apart = |pair: &[[f64; 2]]| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        own.length += line.windows(2).map(apart).sum::<f64>();
    }
}

/// The corners of a shape: of each of its lines, or of the box around it.
fn lines(tag: &str, places: &[(&str, &str)]) -> Vec<Vec<[f64; 2]>> {
    let text = |name: &str| places.iter().find(|(own, _)| *own == name).map(|(_, value)| *value);
    let number = |name: &str| text(name).map_or(0.0, |value| value.parse::<f64>().unwrap());
    match tag {
        "path" => text("d").unwrap().split('M').skip(1).map(corners).collect(),
        "line" => vec![vec![[number("x1"), number("y1")], [number("x2"), number("y2")]]],
        "rect" => {
            let [x, y] = ["x", "y"].map(number);
            vec![vec![[x, y], [x + number("width"), y + number("height")]]]
        }
        _ => {
            let [x, y, r] = ["cx", "cy", "r"].map(number);
            vec![vec![[x - r, y - r], [x + r, y + r]]]
        }
    }
}

/// The corners of one line of a path. Of an arc these are its ends.
fn corners(line: &str) -> Vec<[f64; 2]> {
    let steps = line.trim_end_matches('Z').split(['L', 'A']);
    steps
        .map(|step| {
            let numbers: Vec<f64> = step.split(' ').map(|n| n.parse().unwrap()).collect();
            *numbers.last_chunk().unwrap()
        })
        .collect()
}
