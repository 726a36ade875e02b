//! Combinations of load cases: names, factors, and the models they make.

use crate::code;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::document::Document;
use crate::fault::Fault;
use crate::source::Source;
use crate::suggest::nearest;
use groundbeam::Model;

/// More combinations than this a file may not have.
pub(crate) const MOST: usize = 1000;

/// A combination as it is written: its name, and the factors of cases.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Recipe {
    pub name: String,
    pub factors: Vec<(String, f64)>,
}

/// One of the combinations of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Combination {
    /// Its name, which no other combination of the file has.
    pub name: String,
    /// The cases it names, each with its factor; any other case has the factor 0.
    pub factors: Vec<(String, f64)>,
    /// The file's model under its loads alone: those of factor 0 are left out.
    pub model: Model,
    /// Which of the document's loads these are.
    pub loads: Vec<usize>,
}

/// A load case all by itself.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCase {
    /// Its name.
    pub name: String,
    /// The file's model under the loads of this case alone.
    pub model: Model,
}

impl Document {
    /// Whether the file asks for combinations.
    pub fn has_combinations(&self) -> bool {
        !self.recipes.is_empty()
    }

    /// The file's combinations, each with its own model; none if it asks for none.
    ///
    /// ```
    /// let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n
    ///     [[load]]\npoint = 4\nat = 0.5\ncase = 'G'\n
    ///     [[load]]\npoint = 2\nat = 0.1\ncase = 'Q'\n
    ///     [[combination]]\nname = 'ULS'\nfactors = { G = 1.25, Q = 1.5 }\n
    ///     [[combination]]\nname = 'empty'\nfactors = { G = 1 }\n";
    /// let document = groundbeam_file::parse(text)?;
    /// let [uls, empty] = &document.combinations()[..] else { panic!() };
    /// assert_eq!(uls.model.loads[1], groundbeam::Load::point(3.0, 0.1));
    /// assert_eq!((&*empty.name, empty.model.loads.len()), ("empty", 1));
    /// # Ok::<(), groundbeam_file::Diagnostics>(())
    /// ```
    pub fn combinations(&self) -> Vec<Combination> {
        let combined = |recipe: &Recipe| {
            let factor = |case: &Option<String>| match case {
                None => 1.0,
                Some(case) => {
                    let named = recipe.factors.iter().find(|(name, _)| name == case);
                    named.map_or(0.0, |(_, factor)| *factor)
                }
            };
            let (model, loads) = self.under(factor);
            Combination { name: recipe.name.clone(), factors: recipe.factors.clone(), model, loads }
        };
        self.recipes.iter().map(combined).collect()
    }

    /// The combination of a name.
    ///
    /// # Errors
    ///
    /// A name that no combination has, or a file that has none; the place counts from the start of `name`, so that
    /// [`Diagnostics::render`] shows it with `name` as the text.
    pub fn combination(&self, name: &str) -> Result<Combination, Diagnostics> {
        let wanted = name.trim();
        let mut all = self.combinations();
        if let Some(i) = all.iter().position(|combination| combination.name == wanted) {
            return Ok(all.swap_remove(i));
        }
        let names: Vec<&str> = all.iter().map(|combination| combination.name.as_str()).collect();
        let hint = match nearest(wanted, names.iter().copied()) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None if names.is_empty() => "the file has no [[combination]]".to_owned(),
            None => format!("the combinations of the file: {}", names.join(", ")),
        };
        let message = format!("no combination is called `{wanted}`");
        let fault = Fault::new(code::UNKNOWN_WORD, 0..name.len(), message, "", hint);
        Err(Diagnostic::new(&Source::new(name), fault).into())
    }

    /// Every load case of the file by itself, in the order in which the loads name them.
    pub fn load_cases(&self) -> Vec<LoadCase> {
        let mut names: Vec<&String> = Vec::new();
        for case in self.cases.iter().flatten() {
            if !names.contains(&case) {
                names.push(case);
            }
        }
        let alone = |name: &String| {
            let (model, _) = self.under(|case| f64::from(case.as_ref() == Some(name)));
            LoadCase { name: name.clone(), model }
        };
        names.into_iter().map(alone).collect()
    }

    /// The model with a factor to each load, and the loads whose factor is not 0.
    fn under(&self, factor: impl Fn(&Option<String>) -> f64) -> (Model, Vec<usize>) {
        let mut loads = Vec::new();
        let mut scaled = Vec::new();
        for (i, (load, case)) in self.model.loads.iter().zip(&self.cases).enumerate() {
            let factor = factor(case);
            if factor != 0.0 {
                loads.push(i);
                scaled.push(load.scaled(factor));
            }
        }
        (Model { loads: scaled, ..self.model.clone() }, loads)
    }
}
