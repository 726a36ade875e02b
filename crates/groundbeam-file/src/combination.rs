//! Builds the model of each combination of load cases, from the names of load cases and the factors in the file.

use crate::band::Band;
use crate::code;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::document::Document;
use crate::fault::Fault;
use crate::moving::MovingTrain;
use crate::source::Source;
use crate::{case_names, sets, suggest};
use groundbeam::{Load, Model, design::LimitStates};

/// Maximum number of combinations in a file. Each combination counts once for each pair of factors on k and μ.
pub(crate) const MOST: usize = 1000;

/// Combination as written in the file: its name, and the factors on the loads of the load cases.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Recipe {
    pub name: String,
    pub factors: Vec<(String, f64)>,
    /// Limit states of the combination; empty if neither the file nor the set of combinations in `set` names any.
    pub limit_states: LimitStates,
    /// The set of a code of practice from which the combination is generated; `None` if the file gives its factors.
    pub set: Option<&'static str>,
    /// Whether `set` belongs to the Eurocodes.
    pub eurocode: bool,
}

impl Recipe {
    /// Returns the factor on the loads of a load case. The factor is 1 for loads without a case, and 0 for a case
    /// that the combination does not name.
    pub fn factor(&self, case: Option<&str>) -> f64 {
        case.map_or(1.0, |case| {
            let named = self.factors.iter().find(|(name, _)| name == case);
            named.map_or(0.0, |(_, factor)| *factor)
        })
    }
}

/// Combination of load cases, with the model under the factored loads.
#[derive(Debug, Clone, PartialEq)]
pub struct Combination {
    /// Name of the combination, unique in the file.
    pub name: String,
    /// Load cases that the combination names, each with its factor. Other load cases have the factor 0.
    pub factors: Vec<(String, f64)>,
    /// Limit states of the combination; empty if the file names no limit states or has no combinations of loads.
    pub limit_states: LimitStates,
    /// Whether all loads act as the file gives them, because the file has no combinations of loads.
    pub as_written: bool,
    /// Whether the combination comes from a set of the Eurocodes. Reports then cite the clauses that require the checks.
    pub eurocode: bool,
    /// Model of the file under the factored loads. Loads with the factor 0 are omitted.
    pub model: Model,
    /// Indices, in the load list of the document, of the loads whose factor is not 0.
    pub loads: Vec<usize>,
    /// Factors on k and μ, if the file has a [`Band`](crate::Band). The ground of `model` already includes these
    /// factors.
    pub ground: Option<[f64; 2]>,
}

impl From<Model> for Combination {
    /// Returns the combination without a name, in which all loads of the model act.
    fn from(model: Model) -> Self {
        let loads = (0..model.loads.len()).collect();
        let limit_states = LimitStates::NONE;
        let (name, factors) = (String::new(), Vec::new());
        let (as_written, eurocode, ground) = (true, false, None);
        Combination { name, factors, limit_states, as_written, eurocode, model, loads, ground }
    }
}

/// Single load case, with the model under its loads only.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCase {
    /// Name of the load case.
    pub name: String,
    /// Model of the file under the loads of this load case only.
    pub model: Model,
}

/// Returns the name of a combination on ground with these factors on k and μ.
fn on(name: &str, band: &Band, ground: [f64; 2]) -> String {
    let place = band.name(ground);
    match name {
        "" => place,
        name => format!("{name}; {place}"),
    }
}

impl Combination {
    /// Returns the factor on a train, or `None` if the combination omits its load case. Without a load case or
    /// combinations, the factor is 1.
    pub fn factor_of(&self, train: &MovingTrain) -> Option<f64> {
        let Some(case) = train.case.as_ref().filter(|_| !self.as_written) else {
            return Some(1.0);
        };
        let named = self.factors.iter().find(|(name, _)| name == case);
        named.map(|(_, factor)| *factor).filter(|factor| *factor != 0.0)
    }

    /// Returns this combination with additional loads.
    pub fn with_loads(mut self, loads: Vec<Load>) -> Self {
        self.model.loads.extend(loads);
        self
    }

    /// Returns this combination with k and μ multiplied by the factors in `ground`.
    fn on(mut self, band: &Band, ground: [f64; 2]) -> Self {
        let [spring, shear] = ground;
        self.model.foundation = self.model.foundation.scaled(spring, shear);
        self.ground = Some(ground);
        self.name = on(&self.name, band, ground);
        self
    }
}

/// Returns a hint that lists the names most similar to `wanted`.
fn nearest(wanted: &str, names: &[&str]) -> String {
    let near = suggest::nearest_three(wanted, names);
    let near: Vec<String> = near.iter().map(|name| format!("`{name}`")).collect();
    match (near.len(), names.len()) {
        (near_count, all) if near_count < all => {
            format!("the most similar of {all} names: {}", near.join(", "))
        }
        _ => format!("there is {}", near.join(", ")),
    }
}

fn unknown(name: &str, message: String, hint: String) -> Diagnostics {
    let fault = Fault::new(code::UNKNOWN_WORD, 0..name.len(), message, "", hint);
    Diagnostic::new(&Source::new(name), fault).into()
}

impl Document {
    /// Whether the file has combinations of load cases or a [`Band`], and therefore several results.
    pub fn has_combinations(&self) -> bool {
        !self.recipes.is_empty() || self.band.is_some()
    }

    /// Returns the combinations of the file, each with its own model. The list is empty if the file has neither
    /// combinations nor a [`Band`].
    ///
    /// With a [`Band`], each combination occurs once per pair of factors on k and μ. In a file without combinations,
    /// all loads together count as one combination.
    ///
    /// ```
    /// let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n
    ///     [[load]]\npoint = 4\nat = 0.5\ncase = 'G'\n
    ///     [[load]]\npoint = 2\nat = 0.1\ncase = 'Q'\n
    ///     [[combination]]\nname = 'ULS'\nfactors = { G = 1.25, Q = 1.5 }\n
    ///     [[combination]]\nname = 'empty'\nfactors = { G = 1 }\n";
    /// let document = groundbeam_file::parse(text)?;
    /// let [uls, empty] = &document.combinations()[..] else { panic!() };
    /// assert_eq!(uls.model.loads[1], groundbeam::Load::point_force(0.1, 3.0));
    /// assert_eq!((&*empty.name, empty.model.loads.len()), ("empty", 1));
    /// # Ok::<(), groundbeam_file::Diagnostics>(())
    /// ```
    pub fn combinations(&self) -> Vec<Combination> {
        let combined = |recipe: &Recipe| {
            let (model, loads) = self.under(|case| recipe.factor(case.as_deref()));
            let (name, factors) = (recipe.name.clone(), recipe.factors.clone());
            let Recipe { limit_states, eurocode, .. } = *recipe;
            let (as_written, ground) = (false, None);
            Combination { name, factors, limit_states, as_written, eurocode, model, loads, ground }
        };
        let Some(band) = &self.band else { return self.recipes.iter().map(combined).collect() };
        let alone = self.recipes.is_empty().then(|| self.as_written());
        let all = alone.into_iter().chain(self.recipes.iter().map(combined));
        let on_each = |combination: Combination| {
            let on = move |ground| combination.clone().on(band, ground);
            band.grounds().into_iter().map(on)
        };
        all.flat_map(on_each).collect()
    }

    /// Returns the names of the combinations, in the order of [`Document::combinations`].
    pub fn combination_names(&self) -> Vec<String> {
        let written = self.recipes.iter().map(|recipe| &*recipe.name);
        let Some(band) = &self.band else { return written.map(str::to_owned).collect() };
        let alone = self.recipes.is_empty().then_some("");
        let on_each = |name| band.grounds().into_iter().map(move |ground| on(name, band, ground));
        alone.into_iter().chain(written).flat_map(on_each).collect()
    }

    /// Returns all combinations of the file. For a file without combinations, returns a single combination without a
    /// name, in which all loads act.
    pub fn wanted(&self) -> Vec<Combination> {
        match self.has_combinations() {
            true => self.combinations(),
            false => vec![self.as_written()],
        }
    }

    /// Returns the combination without a name, in which all loads act as the file gives them.
    pub fn as_written(&self) -> Combination {
        Combination::from(self.model.clone())
    }

    /// Returns the title of the results of one combination, such as `Footing: ULS 1`.
    pub fn title_of(&self, combination: &Combination) -> String {
        match &self.title {
            Some(title) => format!("{title}: {}", combination.name),
            None => combination.name.clone(),
        }
    }

    /// Returns the combination with this name.
    ///
    /// # Errors
    ///
    /// Returns an error if no combination has this name. Its byte positions refer to `name`.
    pub fn combination(&self, name: &str) -> Result<Combination, Diagnostics> {
        let wanted = name.trim();
        let mut all = self.combinations();
        if let Some(i) = all.iter().position(|combination| combination.name == wanted) {
            return Ok(all.swap_remove(i));
        }
        let names = self.combination_names();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let hint = match names[..] {
            [] => "the file has no [[combination]]".to_owned(),
            _ => nearest(wanted, &names),
        };
        Err(unknown(name, format!("no combination has the name `{wanted}`"), hint))
    }

    /// Returns the names of the sets of combinations that the file uses, each once.
    pub fn set_names(&self) -> Vec<&'static str> {
        let mut names: Vec<&str> = self.recipes.iter().filter_map(|recipe| recipe.set).collect();
        // A file names each set of combinations at most once, so the combinations of one set are consecutive.
        names.dedup();
        names
    }

    /// Returns the combinations of the set with this name.
    ///
    /// # Errors
    ///
    /// Returns an error if the file does not use this set. Its byte positions refer to `name`.
    pub fn combinations_of_set(&self, name: &str) -> Result<Vec<Combination>, Diagnostics> {
        let wanted = name.trim();
        let asked = sets::find(wanted).map(|(_, set)| &*set.name);
        let names = self.set_names();
        if let Some(asked) = asked.filter(|asked| names.contains(asked)) {
            let recipes = self.recipes.iter().filter(|recipe| recipe.set == Some(asked));
            let recipes = recipes.cloned().collect();
            return Ok(Document { recipes, ..self.clone() }.combinations());
        }
        let hint = match names[..] {
            [] => "the file has no set of combinations; add a [[combination]] with `set = \"EN 1990 6.10\"`"
                .to_owned(),
            _ => nearest(wanted, &names),
        };
        Err(unknown(
            name,
            format!("the file does not use the set of combinations `{wanted}`"),
            hint,
        ))
    }

    /// Returns each load case alone, in the order of the loads. The list is empty if the file has no combinations of
    /// loads.
    pub fn load_cases(&self) -> Vec<LoadCase> {
        if self.recipes.is_empty() {
            return Vec::new();
        }
        let alone = |name: &str| {
            let (model, _) = self.under(|case| f64::from(case.as_deref() == Some(name)));
            LoadCase { name: name.to_owned(), model }
        };
        case_names::names(&self.cases).into_iter().map(alone).collect()
    }

    /// Returns the model with each load multiplied by its factor, and the indices of the loads whose factor is not 0.
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
