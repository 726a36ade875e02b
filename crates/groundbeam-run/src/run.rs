//! Solves the combinations of a model file, with its trains and options, and returns a list of answers.

use crate::answer::{Answer, Found, Ground, Label, Placed};
use crate::answers::{Alone, Answers, Asked};
use crate::growing::Growing;
use crate::host::{Failed, Host};
use crate::single::answered;
use crate::trains::{ERROR, Reach, Sweep, Swept, checked};
use groundbeam::{Error, Field, Options, Solution, check_memory, exists};
use groundbeam_file::{Combination, Document, LoadCase, MovingTrain};
use std::sync::Arc;

/// The models of a file that are solved together.
#[derive(Debug, Clone)]
pub struct Run {
    pub(crate) asked: Asked,
    pub(crate) combinations: Vec<Arc<Combination>>,
    trains: Vec<Arc<MovingTrain>>,
    /// A train at a single position.
    placed: Option<Placed>,
    load_cases: Vec<LoadCase>,
    pub(crate) width: Option<f64>,
    options: Options,
    growing: Option<Growing>,
    error: f64,
    /// Whether the three rules of `ways` for combinations and trains apply.
    placed_loads: bool,
}

impl Run {
    /// A run of all models of a file.
    pub fn of(document: &Document) -> Self {
        match (document.trains.is_empty(), document.has_combinations()) {
            (false, _) => Run::new(document, Asked::Trains, document.wanted()),
            (true, true) => Run::of_combinations(document),
            (true, false) => Run::new(document, Asked::One, document.wanted()),
        }
    }

    /// A run of all load combinations of a file. The trains of the file are omitted.
    pub fn of_combinations(document: &Document) -> Self {
        let run = Run::new(document, Asked::Combinations, document.combinations());
        Run { load_cases: document.load_cases(), ..run }
    }

    /// A run of some load combinations of a file, with the trains of the file at all their positions.
    pub fn of_some(document: &Document, combinations: Vec<Combination>) -> Self {
        let trains = !document.trains.is_empty();
        let asked = if trains { Asked::Trains } else { Asked::Combinations };
        let run = Run::new(document, asked, combinations);
        let load_cases = if trains { Vec::new() } else { document.load_cases() };
        Run { load_cases, ..run }
    }

    /// A run of one load combination of a file, with the trains of the file at all their positions.
    pub fn of_one(document: &Document, combination: Combination) -> Self {
        let asked = if document.trains.is_empty() { Asked::One } else { Asked::Trains };
        Run::new(document, asked, vec![combination])
    }

    /// A run of one load combination of a file. The trains of the file are omitted.
    pub fn without_trains(document: &Document, combination: Combination) -> Self {
        Run::new(document, Asked::One, vec![combination])
    }

    /// A run of one combination of a file, with one train at one position of its first axle \[m\].
    pub fn at_position(
        document: &Document,
        combination: Combination,
        train: &MovingTrain,
        first_axle: f64,
    ) -> Self {
        let train = train.multiplied(combination.factor_of(train).unwrap_or(0.0));
        let placed = Some(Placed { train: Arc::new(train), first_axle });
        Run { placed, ..Run::new(document, Asked::One, vec![combination]) }
    }

    fn new(document: &Document, asked: Asked, combinations: Vec<Combination>) -> Self {
        let trains = document.trains.iter().cloned().map(Arc::new);
        Run {
            trains: if asked == Asked::Trains { trains.collect() } else { Vec::new() },
            width: document.width,
            placed_loads: true,
            ..Run::on(asked, combinations)
        }
    }

    /// A run of one train over one model. All loads of the train act as given.
    pub fn train(model: Combination, train: MovingTrain) -> Self {
        Run { trains: vec![Arc::new(train)], ..Run::on(Asked::Trains, vec![model]) }
    }

    fn on(asked: Asked, combinations: Vec<Combination>) -> Self {
        Run {
            asked,
            combinations: combinations.into_iter().map(Arc::new).collect(),
            trains: Vec::new(),
            placed: None,
            load_cases: Vec::new(),
            width: None,
            options: Options::default(),
            growing: None,
            error: ERROR,
            placed_loads: false,
        }
    }

    /// Returns this run with other options.
    pub fn with_options(self, options: Options) -> Self {
        Run { options, ..self }
    }

    /// Returns this run with a request for load factors; `None` for no load factors.
    pub fn with_growing(self, growing: Option<Growing>) -> Self {
        Run { growing, ..self }
    }

    /// Returns this run with another error tolerance for the envelopes of trains, relative to the largest absolute
    /// value of each field.
    pub fn with_error(self, error: f64) -> Self {
        Run { error, ..self }
    }

    /// The kind of request.
    pub fn asked(&self) -> Asked {
        self.asked
    }

    /// The combinations.
    pub fn combinations(&self) -> &[Arc<Combination>] {
        &self.combinations
    }

    /// Number of calls of [`Host::done`]: one for each combination, or for each train under each combination.
    pub fn pieces(&self) -> usize {
        match self.asked {
            Asked::Trains => self.ways().len(),
            _ => self.combinations.len(),
        }
    }

    /// Solves all models.
    ///
    /// # Errors
    ///
    /// Returns the first error of a model, or the reason why the host stopped the work.
    pub fn solve<H: Host>(&self, host: &H) -> Result<Answers, Failed<H::Stop>> {
        let mut answers = self.nothing();
        if self.asked == Asked::Trains {
            for (combination, train) in self.ways() {
                let sweep = Sweep::new(combination, train, self.error);
                let (list, swept) = sweep.run(&self.options, host)?;
                let (from, to) = (answers.list.len(), answers.list.len() + list.len());
                answers.list.extend(list);
                answers.swept.push(Swept { answers: from..to, ..swept });
            }
            return Ok(answers);
        }
        if self.combinations.len() > 1 {
            check_memory(self.combinations.iter().map(|one| &one.model), &self.options)?;
        }
        // Each model is solved independently and stored at its index, so the result does not depend on the
        // number of threads.
        let list = host.map(self.combinations.len(), |i| self.one(&self.combinations[i], host));
        let list = list.map_err(Failed::Stopped)?;
        answers.alone = self.alone()?;
        answers.list = list.into_iter().collect::<Result<Vec<Answer>, Error>>()?;
        Ok(answers)
    }

    /// Decides for each model whether an equilibrium exists, without solving the model.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`groundbeam::exists`].
    pub fn check(&self) -> Result<Answers, Error> {
        let mut answers = self.nothing();
        for (combination, train) in self.ways() {
            answers.swept.push(Swept {
                none: checked(&combination.model, &train.train, train.range)?,
                combination,
                train,
                answers: 0..0,
                sections: Vec::new(),
                reach: Reach { asked: self.error, reached: [f64::NAN; Field::ALL.len()] },
            });
        }
        if self.asked != Asked::Trains {
            let checked = self.combinations.iter().map(|combination| {
                let label = Label::of(combination, self.options.method);
                let found = Found::checked(exists(&combination.model)?);
                Ok(Answer { label, found, ground: None, factors: None, seconds: f64::NAN })
            });
            answers.list = checked.collect::<Result<Vec<Answer>, Error>>()?;
            answers.alone = self.alone()?;
        }
        Ok(answers)
    }

    /// An empty list of answers.
    pub(crate) fn nothing(&self) -> Answers {
        let first = self.combinations.first();
        let ground = first.and_then(|first| Ground::before(&first.model, self.width));
        let (list, alone, swept) = (Vec::new(), Vec::new(), Vec::new());
        Answers { asked: self.asked, list, alone, ground, swept }
    }

    /// Returns all pairs of a combination and a train that must be solved. If `placed_loads` is true, three rules
    /// apply:
    ///
    /// * The load factor of the combination multiplies the loads of the train.
    /// * Each arrangement of the loads of infinite length gives one pair (*Loads without end* in docs/moving-loads.md).
    /// * Each named combination is also paired with a train that has no loads.
    fn ways(&self) -> Vec<(Arc<Combination>, Arc<MovingTrain>)> {
        let mut ways = Vec::new();
        for combination in &self.combinations {
            for train in &self.trains {
                let Some(factor) = combination.factor_of(train) else { continue };
                if !self.placed_loads {
                    ways.push((combination.clone(), train.clone()));
                    continue;
                }
                let train = train.multiplied(factor);
                for (train, loads) in train.placements(combination.model.beam.length) {
                    let combination = match loads.is_empty() {
                        true => combination.clone(),
                        false => Arc::new(Combination::clone(combination).with_loads(loads)),
                    };
                    ways.push((combination, Arc::new(train)));
                }
            }
            if self.placed_loads && !combination.name.is_empty() && !self.trains.is_empty() {
                ways.push((combination.clone(), Arc::new(MovingTrain::absent())));
            }
        }
        ways
    }

    fn one(&self, combination: &Arc<Combination>, host: &impl Host) -> Result<Answer, Error> {
        let label =
            Label { train: self.placed.clone(), ..Label::of(combination, self.options.method) };
        let answer = answered(label, self.width, &self.options, None, host)?;
        let growing = self.growing.as_ref();
        let factors = growing.map(|growing| {
            let on_soil = answer.solution().filter(|solution| solution.soil().is_some());
            let model = on_soil.map_or(answer.model(), Solution::model);
            growing.factors(model, &self.options)
        });
        host.done();
        Ok(Answer { factors: factors.transpose()?, ..answer })
    }

    fn alone(&self) -> Result<Vec<Alone>, Error> {
        let each = self
            .load_cases
            .iter()
            .map(|case| Ok(Alone { case: case.clone(), existence: exists(&case.model)? }));
        each.collect()
    }
}
