//! Lists the names of parameters and outputs, and parses these names.

use super::{Domain, LoadNumber, Output, Parameter, Property, SupportNumber};
use crate::solution::field::Field;
use crate::solution::fields::Side;

impl Parameter {
    /// Syntax of the names of parameters, such as `k`, `mu_factor`, `EI[0]` and `load[1].at`.
    pub const NAMES: &str = "k, mu, EI, GA, axial_force, k_factor, mu_factor, EI_factor, GA_factor, load_factor; of segments k[0], \
                             k_factor[0] and so on, of what is outside them k[]; of loads load[0], load[0].at, \
                             load[0].from, load[0].to, load[0].start, load[0].end; support[0].settlement, \
                             support[0].spring, support[0].rotational_spring, hinge[0], gap[0]";

    /// Returns the parameter with the given name, or `None` for an unknown name.
    ///
    /// ```
    /// use groundbeam::derivatives::{Domain, Parameter, Property};
    ///
    /// let softer = Parameter::named("k_factor[2]");
    /// assert_eq!(softer, Some(Parameter::Factor(Property::Spring, Domain::Segment(2))));
    /// assert_eq!(Parameter::named("load[0].size"), None);
    /// ```
    pub fn named(name: &str) -> Option<Self> {
        let (word, number, part) = parts(name)?;
        let domain = match number {
            None => Domain::Whole,
            Some("") => Domain::OutsideSegments,
            Some(digits) => Domain::Segment(digits.parse().ok()?),
        };
        let property = |word: &str| find(&PROPERTIES, word).filter(|_| part.is_empty());
        if let Some(property) = property(word) {
            return Some(Parameter::Value(property, domain));
        }
        if let Some(property) = word.strip_suffix("_factor").and_then(property) {
            return Some(Parameter::Factor(property, domain));
        }
        Some(match (word, domain, part) {
            ("axial_force", Domain::Whole, "") => Parameter::AxialForce,
            ("load_factor", Domain::Whole, "") => Parameter::LoadFactor,
            ("load", Domain::Segment(i), part) => Parameter::Load(i, find(&OF_LOADS, part)?),
            ("support", Domain::Segment(i), part) => {
                Parameter::Support(i, find(&OF_SUPPORTS, part)?)
            }
            ("hinge", Domain::Segment(i), "") => Parameter::HingeSpring(i),
            ("gap", Domain::Segment(i), "") => Parameter::Gap(i),
            _ => return None,
        })
    }
}

const PROPERTIES: [(&str, Property); 4] = [
    ("k", Property::Spring),
    ("mu", Property::Shear),
    ("EI", Property::BendingStiffness),
    ("GA", Property::ShearStiffness),
];

const OF_LOADS: [(&str, LoadNumber); 6] = [
    ("", LoadNumber::Size),
    ("at", LoadNumber::At),
    ("from", LoadNumber::From),
    ("to", LoadNumber::To),
    ("start", LoadNumber::Start),
    ("end", LoadNumber::End),
];

const OF_SUPPORTS: [(&str, SupportNumber); 3] = [
    ("settlement", SupportNumber::Settlement),
    ("spring", SupportNumber::Spring),
    ("rotational_spring", SupportNumber::RotationalSpring),
];

fn find<T: Copy>(table: &[(&str, T)], name: &str) -> Option<T> {
    table.iter().find(|(own, _)| *own == name).map(|(_, found)| *found)
}

impl Output {
    /// Names of all outputs except fields at a position.
    pub const NAMES: &str = "largest moment, smallest gap and so on, edge[0].left, edge[0].right, end_force.left, \
                             end_force.right, support[0].force, support[0].moment, potential_energy";

    /// Returns the output with the given name, or `None` for an unknown name. Fields at a position have no name.
    ///
    /// ```
    /// use groundbeam::{Field, derivatives::Output, solution::Side};
    ///
    /// assert_eq!(Output::named("largest moment"), Some(Output::Largest(Field::Moment)));
    /// assert_eq!(Output::named("edge[1].left"), Some(Output::Edge(1, Side::Left)));
    /// ```
    pub fn named(name: &str) -> Option<Self> {
        if let Some((which, name)) = name.split_once(' ') {
            let field = Field::named(name)?;
            return match which {
                "largest" => Some(Output::Largest(field)),
                "smallest" => Some(Output::Smallest(field)),
                _ => None,
            };
        }
        let (word, number, part) = parts(name)?;
        let count = number.map(str::parse::<usize>);
        let side = match part {
            "left" => Some(Side::Left),
            "right" => Some(Side::Right),
            _ => None,
        };
        match (word, count, part) {
            ("edge", Some(Ok(i)), _) => Some(Output::Edge(i, side?)),
            ("end_force", None, _) => Some(Output::EndForce(side?)),
            ("support", Some(Ok(i)), "force") => Some(Output::SupportForce(i)),
            ("support", Some(Ok(i)), "moment") => Some(Output::SupportMoment(i)),
            ("potential_energy", None, "") => Some(Output::PotentialEnergy),
            _ => None,
        }
    }
}

/// Splits a name of the form `word[number].part`. The number and the part are optional.
fn parts(name: &str) -> Option<(&str, Option<&str>, &str)> {
    let Some((word, rest)) = name.split_once('[') else {
        let (word, part) = name.split_once('.').unwrap_or((name, ""));
        return Some((word, None, part));
    };
    let (number, rest) = rest.split_once(']')?;
    let part =
        if rest.is_empty() { "" } else { rest.strip_prefix('.').filter(|p| !p.is_empty())? };
    Some((word, Some(number), part))
}
