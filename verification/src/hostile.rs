//! Draws hostile models and files with extreme numbers, positions that differ by rounding errors, and random changes of text.

use groundbeam::{
    Beam, Error, Field, Foundation, Hinge, Load, Method, Model, Options, Outcome, Solution,
    Support, exists,
    load_factors::{LoadFactors, load_factors_with},
    memory_estimate,
    model::{Acts, GroundEnd, Profile},
    solve_with,
};
use groundbeam_file::UnitSystem;
use groundbeam_report::{Context, json, text};
use groundbeam_testing::repository;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Memory limit for hostile models. The solver refuses every model that needs more memory, so that no solve takes
/// minutes.
const MEMORY: u64 = 3_000_000;

/// Applies every function of the library to a model. No function may panic.
pub fn exercise(model: &Model) {
    let context = Context::new(UnitSystem::Plain.into());
    memory_estimate(model, &Options::default());
    if let Ok(existence) = exists_within(model) {
        json::existence(model, &existence, &context);
        text::existence(model, &existence, &context, true);
    }
    for (method, elements) in [(Method::Exact, 1), (Method::ActiveSet, 20), (Method::Psor, 10)] {
        let options = Options {
            method,
            elements,
            most_sweeps: 100,
            memory_limit: MEMORY,
            ..Options::default()
        };
        match solve_with(model, &options) {
            Ok(Outcome::Equilibrium(solution)) => show(&solution, &context),
            Ok(Outcome::NoEquilibrium(existence)) => {
                json::existence(model, &existence, &context);
            }
            Err(error) => drop(error.to_string()),
        }
    }
    if memory_estimate(model, &Options::default()) < MEMORY {
        let options = Options { memory_limit: MEMORY, ..Options::default() };
        let found: Result<LoadFactors, Error> =
            load_factors_with(model, &options, |load| load % 2 == 0);
        drop(found);
    }
}

/// Decides whether the model has an equilibrium. A model in compression is solved for this, with the memory limit
/// [`MEMORY`].
fn exists_within(model: &Model) -> Result<groundbeam::Existence, Error> {
    let large = memory_estimate(model, &Options::default()) > MEMORY;
    if model.beam.axial_force < 0.0 && large && model.problems().is_empty() {
        let options = Options { memory_limit: MEMORY, ..Options::default() };
        return match solve_with(model, &options)? {
            Outcome::Equilibrium(solution) => Ok(*solution.existence()),
            Outcome::NoEquilibrium(existence) => Ok(existence),
        };
    }
    exists(model)
}

fn show(solution: &Solution, context: &Context) {
    json::solved(solution, &json::default_stations(solution), context);
    text::solved(solution, context, false);
    for field in Field::ALL {
        solution.range(field);
    }
    solution.lift_off();
}

/// A source of random numbers and choices.
struct Dice(ChaCha8Rng);

impl Dice {
    fn of(number: u64, stream: u64) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(number);
        rng.set_stream(stream);
        Dice(rng)
    }

    fn up_to(&mut self, most: usize) -> usize {
        self.0.random_range(0..=most)
    }

    fn happens(&mut self, one_in: u32) -> bool {
        self.0.random_ratio(1, one_in)
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        *all.choose(&mut self.0).expect("not empty")
    }

    /// Returns a positive number, which is extreme with a probability of one third.
    fn size(&mut self) -> f64 {
        match self.up_to(5) {
            0 => 1.0,
            1 => self.one_of(&[1e-60, 1e-30, 1e-16, 1e-8, 1e8, 1e16, 1e30, 1e60]),
            2 => 10_f64.powf(self.0.random_range(-20.0..20.0)),
            _ => 10_f64.powf(self.0.random_range(-3.0..3.0)),
        }
    }

    fn signed(&mut self) -> f64 {
        let sign = if self.happens(3) { -1.0 } else { 1.0 };
        if self.happens(12) { sign * 0.0 } else { sign * self.size() }
    }

    /// Returns a position on a beam: an end, a simple fraction of the beam length, an earlier position, a random
    /// position, or a position very close to one of these.
    fn place(&mut self, places: &mut Vec<f64>) -> f64 {
        let length = places[1];
        let at = match self.up_to(3) {
            0 | 1 => *places.choose(&mut self.0).expect("not empty"),
            2 => length * self.one_of(&[0.1, 0.25, 0.5, 0.75]),
            _ => length * self.0.random_range(0.0..1.0),
        };
        let step = match self.up_to(5) {
            0 => 1.0 + f64::EPSILON * self.0.random_range(-20.0..20.0),
            1 => 1.0 + self.0.random_range(-1e-9..1e-9),
            _ => 1.0,
        };
        let beside = match self.up_to(8) {
            0 => length * f64::EPSILON * self.0.random_range(-20.0..20.0),
            1 => length * self.size() * 1e-12,
            _ => 0.0,
        };
        let at = (at * step + beside).clamp(0.0, length);
        places.push(at);
        at
    }

    fn stretch(&mut self, places: &mut Vec<f64>) -> [f64; 2] {
        let [a, b] = [0, 1].map(|_| self.place(places));
        [a.min(b), a.max(b)]
    }

    fn profile(&mut self, most: usize) -> Profile {
        let values: Vec<f64> = (0..1 + self.up_to(most - 1)).map(|_| self.size()).collect();
        Profile::by_control_values(&values).expect("not too many")
    }
}

/// Returns the random model with the given number. A number always gives the same model. The model may be invalid,
/// and often has no equilibrium.
pub fn model(number: u64) -> Model {
    let dice = &mut Dice::of(number, 1);
    let length = dice.size();
    let places = &mut vec![0.0, length];
    // If `tame` is true, EI and μ are drawn as multiples of k l⁴ and k l², where k is the subgrade modulus and l the
    // beam length. Extreme stiffness ratios are then rare.
    let tame = dice.happens(2);
    let k = dice.size();
    let stiffness = if tame {
        k * length.powi(4) * 10_f64.powf(dice.0.random_range(-8.0..3.0))
    } else {
        dice.size()
    };
    let shear = if tame {
        k * length * length * 10_f64.powf(dice.0.random_range(-6.0..2.0))
    } else {
        dice.size()
    };
    let shear = if dice.happens(3) { 0.0 } else { shear };
    let force = if tame { stiffness / (length * length) } else { 1.0 };
    let mut beam = Beam::uniform(length, stiffness);
    if dice.happens(3) {
        beam.axial_force = force * dice.signed();
    }
    if dice.happens(5) {
        beam.shear_stiffness = Some(force * dice.size());
    }
    let mut ground = Foundation::pasternak(k, shear);
    segments(&mut beam, &mut ground, places, dice);
    ends(&mut ground, length, dice);
    let mut model = Model::new(beam, ground);
    if dice.happens(2) {
        model = model.with_load(Load::uniform_force(0.0, length, force / length));
    }
    for _ in 0..dice.up_to(5) {
        let load = load(length, places, dice);
        model = model.with_load(load.scaled(force));
    }
    if dice.happens(3) {
        joints(&mut model, places, dice);
    }
    if dice.happens(3) {
        let mut corners: Vec<f64> = (0..1 + dice.up_to(4)).map(|_| dice.place(places)).collect();
        corners.sort_by(f64::total_cmp);
        corners.dedup();
        for at in corners {
            model = model.with_gap(at, dice.signed());
        }
    }
    model
}

/// Adds segments of beam and ground between sorted positions.
fn segments(beam: &mut Beam, ground: &mut Foundation, places: &mut Vec<f64>, dice: &mut Dice) {
    let mut joints = |dice: &mut Dice| {
        let mut joints: Vec<f64> = (0..dice.up_to(4)).map(|_| dice.place(places)).collect();
        joints.sort_by(f64::total_cmp);
        joints.dedup();
        joints
    };
    let of = |value: f64, profile: Profile| profile.scaled(value / profile.start());
    if dice.happens(4) {
        for ends in joints(dice).windows(2) {
            let most = if dice.happens(2) { 5 } else { 1 };
            let profile = of(beam.bending_stiffness, dice.profile(most));
            *beam = beam.clone().with_varying_segment(ends[0], ends[1], profile);
        }
    }
    if dice.happens(4) {
        for ends in joints(dice).windows(2) {
            let most = if dice.happens(2) { 3 } else { 1 };
            let spring = of(ground.subgrade, dice.profile(most));
            let layered = ground.shear_layer > 0.0 && !dice.happens(4);
            let shear = if layered {
                of(ground.shear_layer, dice.profile(most))
            } else {
                Profile::constant(0.0)
            };
            *ground = ground.clone().with_varying_segment(ends[0], ends[1], spring, shear);
        }
    }
}

/// Draws for each side of the beam whether the ground ends, and at which distance from the end of the beam.
fn ends(ground: &mut Foundation, length: f64, dice: &mut Dice) {
    for right in [false, true] {
        if dice.happens(6) {
            let beyond = dice.one_of(&[0.0, f64::EPSILON * length, 0.1 * length, length]);
            let at = if right { length + beyond } else { -beyond };
            ground.ends[usize::from(right)] =
                if dice.happens(2) { GroundEnd::Free { at } } else { GroundEnd::Held { at } };
        }
    }
}

fn load(length: f64, places: &mut Vec<f64>, dice: &mut Dice) -> Load {
    let at = dice.place(places);
    let [from, to] = dice.stretch(places);
    let (start, end) = (dice.signed() / length, dice.signed() / length);
    match dice.up_to(12) {
        0..=3 => Load::point_force(at, dice.signed()),
        4 | 5 => Load::point_moment(at, dice.signed() * length),
        6..=8 => Load::distributed_force(from, to, start, end),
        9 => Load::distributed_moment(from, to, start * length, end * length),
        10 => Load::distributed_curvature(from, to, start, end),
        11 => Load::ground_force(at + dice.one_of(&[0.0, 0.0, length, -length]), dice.size()),
        _ => Load::distributed_ground_force(from, to, dice.size() / length, dice.size() / length),
    }
}

/// Adds supports and hinges.
fn joints(model: &mut Model, places: &mut Vec<f64>, dice: &mut Dice) {
    let unit = model.beam.bending_stiffness / model.beam.length;
    for _ in 0..dice.up_to(3) {
        let at = dice.place(places);
        let support = match dice.up_to(3) {
            0 => Support::fixed(at),
            1 => Support::spring(at, unit * dice.size(), unit * dice.size()),
            2 => Support::spring(at, unit * dice.size(), 0.0),
            _ => Support::pinned(at),
        };
        let settlement = if dice.happens(4) { dice.signed() } else { 0.0 };
        let acts = dice.one_of(&[Acts::Both, Acts::Both, Acts::Up, Acts::Down]);
        model.supports.push(support.settled(settlement).acting(acts));
    }
    for _ in 0..dice.up_to(3) {
        let at = dice.place(places);
        let spring = if dice.happens(2) { 0.0 } else { unit * dice.size() };
        model.hinges.push(Hinge { at, rotational_spring: spring });
    }
}

/// Words that replace a part of a text in [`mutated`].
const WORDS: [&str; 24] = [
    "0",
    "-1",
    "1e16",
    "1e-30",
    "1e300",
    "nan",
    "inf",
    "-0.0",
    "\"1 m\"",
    "\"1e16 m\"",
    "\"3 kN\"",
    "\"\"",
    "\"",
    "[",
    "]",
    "[1, 2]",
    "{}",
    "=",
    "\n",
    "[[load]]",
    "[[hinge]]",
    "true",
    "µ",
    "9999999999999999999999",
];

/// Returns a text with a few changes, in which parts are removed, repeated, moved or replaced.
pub fn mutated(text: &str, number: u64) -> String {
    let dice = &mut Dice::of(number, 2);
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..=dice.up_to(3) {
        if lines.is_empty() {
            break;
        }
        let i = dice.up_to(lines.len() - 1);
        match dice.up_to(5) {
            0 => drop(lines.remove(i)),
            1 => lines.insert(i, lines[dice.up_to(lines.len() - 1)].clone()),
            2 => {
                let j = dice.up_to(lines.len() - 1);
                lines.swap(i, j);
            }
            3 => {
                let own: Vec<char> = lines[i].chars().collect();
                let from = dice.up_to(own.len());
                let to = (from + dice.up_to(3)).min(own.len());
                let word = dice.one_of(&WORDS);
                let [head, tail] = [&own[..from], &own[to..]].map(|c| c.iter().collect::<String>());
                lines[i] = head + word + &tail;
            }
            _ => {
                // The value of a key.
                if let Some((key, _)) = lines[i].split_once('=') {
                    let number = match dice.up_to(2) {
                        0 => dice.one_of(&WORDS).to_owned(),
                        1 => format!("{:e}", dice.signed()),
                        _ => format!(
                            "\"{:e} {}\"",
                            dice.signed(),
                            dice.one_of(&["m", "kN", "MN/m^2", "kN m"])
                        ),
                    };
                    lines[i] = format!("{key}= {number}");
                }
            }
        }
    }
    lines.join("\n")
}

/// Returns the texts of the model files of the repository, including faulty files, sorted by name.
pub fn texts() -> Vec<String> {
    let cases = repository().join("cases");
    let mut paths = Vec::new();
    for folder in
        [".", "combinations", "errors", "footings", "ground", "kikuchi-1980", "limits", "textbook"]
    {
        let entries = std::fs::read_dir(cases.join(folder)).into_iter().flatten().flatten();
        paths.extend(entries.map(|entry| entry.path()));
    }
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    // Files that are not UTF-8 are skipped.
    paths.iter().filter_map(|path| std::fs::read_to_string(path).ok()).collect()
}

/// Returns the message of a panic in `exercise`; `None` if there is no panic.
pub fn panics(exercise: impl FnOnce()) -> Option<String> {
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(exercise)).err()?;
    let said = panic.downcast_ref::<String>().map(String::as_str);
    Some(said.or(panic.downcast_ref::<&str>().copied()).unwrap_or("a panic").to_owned())
}

/// Reads a text, solves the model and writes the result. For an invalid text the function writes the diagnostics.
pub fn exercise_text(written: &str) {
    match groundbeam_file::parse(written) {
        Ok(document) => {
            for combination in document.wanted().iter().take(3) {
                exercise(&combination.model);
            }
            groundbeam_file::write_toml(&document.model, None, document.units);
        }
        Err(found) => drop(found.render("model.toml", written, false)),
    }
}
