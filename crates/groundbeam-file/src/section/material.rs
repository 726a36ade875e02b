//! Reads `material = "…"`, which gives E and, on request, the unit weight and the thermal expansion.

use crate::code;
use crate::fault::Fault;
use crate::materials::{self, Material};
use crate::profile::Along;
use crate::quantity::ELASTIC_MODULUS;
use crate::reader::Reader;
use crate::suggest;
use crate::table::Section;
use crate::units::Seen;
use groundbeam::model::Profile;

/// Returns E of the material that `table` names; without a material, returns the given E.
pub(super) fn modulus(reader: &mut Reader, table: &Section, given: Option<Along>) -> Option<Along> {
    let Some(value) = table.value("material") else { return given };
    let value = value.span();
    if let Some(given) = &given {
        let hint = "the material gives E: keep either `E` or `material`";
        reader.exclusive(("material", &value), ("E", &given.span), hint);
    }
    reader.quantities.push(Seen::of_built_in("material", &ELASTIC_MODULUS, value.clone()));
    Some(match named(reader, table) {
        Some(known) => Along { profile: Profile::constant(known.elastic_modulus), span: value },
        None => Along::unreadable(value),
    })
}

/// Finds the material that `table` names, and reports an unknown name.
fn named(reader: &mut Reader, table: &Section) -> Option<&'static Material> {
    let (written, span) = reader.text(table, "material")?;
    let name = written.trim();
    let found = materials::find(name);
    if found.is_none() {
        let all: Vec<&str> = materials::materials().iter().map(|m| &*m.name).collect();
        let families = "materials: C12/15 to C90/105, S235 to S460, R200 to R350LHT, \
                        timber C14 to C50, GL20h to GL32c; for others give `E`";
        let hint = match materials::holding(name).as_slice() {
            [] => suggest::nearest(name, all)
                .map_or(families.to_owned(), |meant| format!("did you mean `{meant}`?")),
            several => format!("did you mean `{}`?", several.join("` or `")),
        };
        let message = format!("the material `{written}` is not known");
        reader.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
    }
    found
}

/// Returns the material that `table` names; `None` if the name is missing or unknown.
pub(super) fn of(table: &Section) -> Option<&'static Material> {
    materials::find(table.value("material")?.get_ref().as_str()?.trim())
}
