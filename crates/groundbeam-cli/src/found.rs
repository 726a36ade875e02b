//! What mechanics says of a file, in every form it is wanted in.

use crate::Status;
use groundbeam::{Existence, Field, Model, NotConverged, Solution};
use groundbeam_report::calculation::{self, Contents, Report, Source};
use groundbeam_report::{Combinations, Context, Overall, Passages, csv, json, png, svg, text};

/// What came out of a file: of one model, of all its combinations, or of all positions of its trains.
pub enum Found<'a> {
    Equilibrium(&'a Solution),
    NoEquilibrium(&'a Model, &'a Existence),
    NotConverged(&'a Model, &'a NotConverged),
    Combinations(&'a Combinations<'a>),
    Trains(&'a Passages<'a>),
}

impl Found<'_> {
    /// What is to be said of all of it at once.
    pub fn overall(&self) -> Overall {
        match self {
            Found::Equilibrium(_) => Overall::Solved,
            Found::NoEquilibrium(..) => Overall::NoEquilibrium,
            Found::NotConverged(..) => Overall::NotConverged,
            Found::Combinations(all) => all.overall(),
            Found::Trains(passages) => passages.overall(),
        }
    }

    pub fn status(&self) -> Status {
        match self.overall() {
            Overall::Solved => Status::Done,
            Overall::NoEquilibrium => Status::NoEquilibrium,
            Overall::NotConverged => Status::NotConverged,
        }
    }

    /// Whether there are fields to draw and to list.
    pub fn has_fields(&self) -> bool {
        match self {
            Found::Equilibrium(_) => true,
            Found::NoEquilibrium(..) | Found::NotConverged(..) => false,
            Found::Combinations(all) => all.solved().next().is_some(),
            Found::Trains(passages) => passages.range(Field::Deflection).is_some(),
        }
    }

    /// The result document.
    pub fn json(&self, stations: Option<&[f64]>, context: &Context) -> String {
        match self {
            Found::Equilibrium(solution) => match stations {
                Some(stations) => json::solved(solution, stations, context),
                None => json::solved(solution, &json::default_stations(solution), context),
            },
            Found::NoEquilibrium(model, existence) => {
                json::no_equilibrium(model, existence, context)
            }
            Found::NotConverged(_, reached) => json::not_converged(reached, context),
            Found::Combinations(all) => json::combinations(all, stations, context),
            Found::Trains(passages) => json::trains(passages, stations, context),
        }
    }

    /// The report for a terminal.
    pub fn text(&self, context: &Context, colour: bool) -> String {
        match self {
            Found::Equilibrium(solution) => text::solved(solution, context, colour),
            Found::NoEquilibrium(model, existence) => {
                text::existence(model, existence, context, colour)
            }
            Found::NotConverged(_, reached) => {
                text::not_converged(reached, colour) + &text::load_factors(context, colour)
            }
            Found::Combinations(all) => text::combinations(all, context, colour),
            Found::Trains(passages) => text::trains(passages, context, colour),
        }
    }

    /// The calculation report.
    pub fn calculation(&self, context: &Context, source: &Source) -> Report {
        let contents = match *self {
            Found::Equilibrium(solution) => Contents::Solved(solution),
            Found::NoEquilibrium(model, existence) => Contents::NoEquilibrium(model, existence),
            Found::NotConverged(model, reached) => Contents::NotConverged(model, reached),
            Found::Combinations(all) => Contents::Combinations(all),
            Found::Trains(passages) => Contents::Trains(passages),
        };
        calculation::report(contents, context, source)
    }

    /// The table of fields; empty where there are none.
    pub fn csv(&self, stations: Option<&[f64]>, context: &Context) -> String {
        let or = |default: Vec<f64>| stations.map_or(default, <[f64]>::to_vec);
        match self {
            Found::Equilibrium(solution) => {
                csv::table(solution, &or(json::default_stations(solution)), context.units)
            }
            Found::NoEquilibrium(..) | Found::NotConverged(..) => String::new(),
            Found::Combinations(all) => {
                csv::envelope(all, &or(json::envelope_stations(all)), context.units)
            }
            Found::Trains(passages) => {
                csv::trains(passages, &or(passages.default_stations()), context.units)
            }
        }
    }

    /// The picture; empty where there is none.
    pub fn svg(&self, context: &Context) -> String {
        match self {
            Found::Equilibrium(solution) => svg::picture(solution, context),
            Found::NoEquilibrium(..) | Found::NotConverged(..) => String::new(),
            Found::Combinations(all) => svg::combinations(all, context),
            Found::Trains(passages) => svg::trains(passages, context),
        }
    }

    /// The picture in pixels; empty where there is none.
    pub fn png(&self, context: &Context) -> Result<Vec<u8>, png::Error> {
        match self {
            Found::Equilibrium(solution) => png::picture(solution, context),
            Found::NoEquilibrium(..) | Found::NotConverged(..) => Ok(Vec::new()),
            Found::Combinations(all) => png::combinations(all, context),
            Found::Trains(passages) => png::trains(passages, context),
        }
    }
}
