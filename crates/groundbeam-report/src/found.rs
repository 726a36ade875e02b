//! What mechanics says of a file, in every form it is wanted in.

use crate::calculation::{self, Report, Source};
use crate::combinations::{Combinations, Overall};
use crate::context::Context;
use crate::trains::Passages;
use crate::{csv, json, png, svg, text};
use groundbeam::{Existence, Field, Model, Solution, Stopped};

/// What came out of a file: of one model, of all its combinations, or of all positions of its trains.
#[derive(Debug, Clone, Copy)]
pub enum Found<'a> {
    /// An equilibrium.
    Equilibrium(&'a Solution),
    /// There is none.
    NoEquilibrium(&'a Model, &'a Existence),
    /// The method did not reach its tolerance.
    NotConverged(&'a Model, &'a Stopped),
    /// The combinations of load cases.
    Combinations(&'a Combinations<'a>),
    /// Trains that pass.
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
        calculation::report(*self, context, source)
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
    ///
    /// # Errors
    ///
    /// As [`png::picture`].
    pub fn png(&self, context: &Context) -> Result<Vec<u8>, png::Error> {
        match self {
            Found::Equilibrium(solution) => png::picture(solution, context),
            Found::NoEquilibrium(..) | Found::NotConverged(..) => Ok(Vec::new()),
            Found::Combinations(all) => png::combinations(all, context),
            Found::Trains(passages) => png::trains(passages, context),
        }
    }
}
