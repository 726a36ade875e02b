//! Writes a model as a model file, from which [`parse`](crate::parse) reads the same numbers bit for bit.

use crate::section::load::{LoadKind, kind_of};
use crate::section::soil::method_name;
use crate::units::UnitSystem;
use groundbeam::soil::{LayeredSoil, Soil, SoilModel};
use groundbeam::{
    Load, Model, SupportKind,
    model::{Acts, Extent, GroundEnd, Profile},
};
use std::fmt::Write;

/// Returns the model as a model file, in SI units or without units. Reading it gives the same numbers bit for bit.
///
/// Ground from soil data is written as soil data, or as k and μ if a [`Band`](crate::Band) factor multiplies it.
/// Non-finite numbers cannot be read again.
///
/// ```
/// use groundbeam::{Beam, Foundation, Load, Model};
/// use groundbeam_file::{UnitSystem, parse, write_toml};
///
/// let model = Model::new(Beam::uniform(12.0, 1.2e9), Foundation::pasternak(4e7, 9e6))
///     .with_load(Load::point_force(1.0, 6e5));
/// let text = write_toml(&model, Some("Strip footing"), UnitSystem::Si);
/// assert!(text.contains("\n[[load]]\npoint = \"600000.0 N\"\nat = \"1.0 m\"\n"));
/// assert_eq!(parse(&text).unwrap().model, model);
/// ```
pub fn write_toml(model: &Model, title: Option<&str>, units: UnitSystem) -> String {
    let mut out = Writer { text: String::new(), units };
    if let Some(title) = title {
        out.line("title", &quoted(title));
    }
    out.beam(model);
    out.foundation(model);
    // The reader reads loads on the ground after all other loads, so they are written in this order.
    for on_ground in [false, true] {
        for load in model.loads.iter().filter(|load| load.is_on_ground() == on_ground) {
            out.load(load);
        }
    }
    out.held_and_joined(model);
    out.gap(model);
    out.text.trim_start().to_owned()
}

struct Writer {
    text: String,
    units: UnitSystem,
}

impl Writer {
    fn heading(&mut self, heading: &str) {
        self.text.push('\n');
        self.text.push_str(heading);
        self.text.push('\n');
    }

    fn line(&mut self, key: &str, value: &str) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "{key} = {value}");
    }

    /// Returns the text of a number. `{:?}` gives the shortest text that reads back as the same bits, and
    /// always a TOML float.
    fn number(&self, value: f64, unit: &str) -> String {
        match self.units {
            UnitSystem::Si => format!("\"{value:?} {unit}\""),
            UnitSystem::Plain => format!("{value:?}"),
        }
    }

    fn quantity(&mut self, key: &str, value: f64, unit: &str) {
        let number = self.number(value, unit);
        self.line(key, &number);
    }

    /// Writes a quantity unless it equals the default 0. The value −0 is written.
    fn unless_left_out(&mut self, key: &str, value: f64, unit: &str) {
        if value.to_bits() != 0 {
            self.quantity(key, value, unit);
        }
    }

    fn beam(&mut self, model: &Model) {
        let beam = &model.beam;
        self.heading("[beam]");
        self.quantity("length", beam.length, "m");
        self.quantity("EI", beam.bending_stiffness, "N m^2");
        if let Some(stiffness) = beam.shear_stiffness {
            self.quantity("shear_stiffness", stiffness, "N");
        }
        self.quantity("axial_force", beam.axial_force, "N");
        for segment in &beam.segments {
            self.heading("[[beam.segment]]");
            self.stretch(segment.from, segment.to);
            self.profile("EI", &segment.bending_stiffness, "N m^2");
            if let Some(stiffness) = &segment.shear_stiffness {
                self.profile("shear_stiffness", stiffness, "N");
            }
        }
    }

    fn foundation(&mut self, model: &Model) {
        let ground = &model.foundation;
        self.heading("[foundation]");
        if let Some(soil) = ground.soil.as_ref().filter(|soil| soil.factors == [1.0; 2]) {
            self.soil(soil);
            return;
        }
        self.quantity("k", ground.subgrade, "N/m^2");
        self.quantity("mu", ground.shear_layer, "N");
        for (key, end) in ["left", "right"].into_iter().zip(ground.ends) {
            let (at, kind) = match end {
                GroundEnd::Endless => continue,
                GroundEnd::Free { at } => (at, "free"),
                GroundEnd::Held { at } => (at, "held"),
            };
            let at = self.number(at, "m");
            self.line(key, &format!("{{ ends = {at}, as = \"{kind}\" }}"));
        }
        for segment in &ground.segments {
            self.heading("[[foundation.segment]]");
            self.stretch(segment.from, segment.to);
            self.profile("k", &segment.subgrade, "N/m^2");
            self.profile("mu", &segment.shear_layer, "N");
        }
    }

    fn soil(&mut self, SoilModel { soil, width, .. }: &SoilModel) {
        self.quantity("width", *width, "m");
        self.heading("[foundation.soil]");
        self.line("method", &quoted(method_name(soil)));
        match soil {
            Soil::Vlasov(layers, gamma) => {
                self.line("gamma", &format!("{gamma:?}"));
                self.layers(layers);
            }
            Soil::ModifiedVlasov(layers) => self.layers(layers),
            Soil::Vesic(soil)
            | Soil::Biot(soil)
            | Soil::MeyerhofBaike(soil)
            | Soil::Selvadurai(soil) => self.elastic(soil.modulus, soil.poisson),
            Soil::TerzaghiClay(plate) | Soil::TerzaghiSand(plate) => {
                self.quantity("plate_modulus", plate.modulus, "N/m^3");
                self.quantity("plate_width", plate.width, "m");
            }
        }
    }

    fn elastic(&mut self, modulus: f64, poisson: f64) {
        self.quantity("E", modulus, "Pa");
        self.line("nu", &format!("{poisson:?}"));
    }

    fn layers(&mut self, soil: &LayeredSoil) {
        for layer in &soil.layers {
            self.heading("[[foundation.soil.layer]]");
            self.elastic(layer.modulus, layer.poisson);
            self.quantity("thickness", layer.thickness, "m");
        }
    }

    fn load(&mut self, load: &Load) {
        self.heading(if load.is_on_ground() { "[[ground_load]]" } else { "[[load]]" });
        let LoadKind { key, unit, .. } = kind_of(load);
        let key = key.name;
        match load.extent() {
            Extent::Point { at, size } => {
                self.quantity(key, size, unit);
                self.quantity("at", at, "m");
            }
            Extent::Distributed { from, to, start, end } => {
                self.intensity(key, start, end, unit);
                self.stretch(from, to);
            }
        }
    }

    fn held_and_joined(&mut self, model: &Model) {
        for support in &model.supports {
            self.heading("[[support]]");
            self.quantity("at", support.at, "m");
            match support.kind {
                SupportKind::Pinned => self.line("type", "\"pinned\""),
                SupportKind::Fixed => self.line("type", "\"fixed\""),
                SupportKind::Spring { spring, rotational_spring } => {
                    self.quantity("spring", spring, "N/m");
                    self.quantity("rotational_spring", rotational_spring, "N m/rad");
                }
            }
            self.unless_left_out("settlement", support.settlement, "m");
            match support.acts {
                Acts::Both => {}
                Acts::Up => self.line("acts", "\"up\""),
                Acts::Down => self.line("acts", "\"down\""),
            }
        }
        for hinge in &model.hinges {
            self.heading("[[hinge]]");
            self.quantity("at", hinge.at, "m");
            self.unless_left_out("rotational_spring", hinge.rotational_spring, "N m/rad");
        }
    }

    fn gap(&mut self, model: &Model) {
        for corner in &model.gap {
            self.heading("[[gap]]");
            self.quantity("at", corner.at, "m");
            self.quantity("value", corner.value, "m");
        }
    }

    fn stretch(&mut self, from: f64, to: f64) {
        self.quantity("from", from, "m");
        self.quantity("to", to, "m");
    }

    /// Writes one value for a constant profile, or the list of Bernstein coefficients of a varying profile.
    fn profile(&mut self, key: &str, profile: &Profile, unit: &str) {
        let numbers = profile.control_values().iter().map(|value| self.number(*value, unit));
        let numbers: Vec<String> = numbers.collect();
        let value = match &numbers[..] {
            [constant] => constant.clone(),
            several => format!("[{}]", several.join(", ")),
        };
        self.line(key, &value);
    }

    fn intensity(&mut self, key: &str, start: f64, end: f64, unit: &str) {
        let value = if start.to_bits() == end.to_bits() {
            self.number(start, unit)
        } else {
            format!("[{}, {}]", self.number(start, unit), self.number(end, unit))
        };
        self.line(key, &value);
    }
}

/// Returns the text as a TOML basic string.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{:04x}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
