//! Reads `[[hinge]]`.

use crate::keys::{ALSO_AT, Table, quantity};
use crate::quantity::{POSITION, ROTATIONAL_SPRING};
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::Hinge;
use groundbeam::model::Part;

pub(super) static TABLE: Table = Table {
    name: "[[hinge]]",
    keys: &[
        quantity("at", &POSITION, "The position on the beam.").needed().also(ALSO_AT),
        quantity(
            "rotational_spring",
            &ROTATIONAL_SPRING,
            "The rotational spring of the hinge; default: 0, a free hinge.",
        )
        .also(&["k_r", "kr", "rotation", "rotational"]),
    ],
};

pub(super) fn read(reader: &mut Reader, root: &Section) -> Vec<Hinge> {
    let mut hinges = Vec::new();
    for table in reader.parts(root, "hinge", Part::Hinge) {
        let at = reader.required(&table, "at").value;
        let spring = reader.quantity(&table, "rotational_spring");
        hinges.push(Hinge { at, rotational_spring: spring.map_or(0.0, |spring| spring.value) });
    }
    hinges
}
