//! Reads `[foundation.soil]`: soil data in place of `k` and `mu`.

use crate::code;
use crate::fault::Fault;
use crate::keys::{ALSO_E, ALSO_NU, Table, Words, quantity, tables, word};
use crate::quantity::{LENGTH, RATIO, SOIL_MODULUS, SUBGRADE_MODULUS, WIDTH};
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::soil::{Elastic, LayeredSoil, PlateTest, Soil, SoilLayer, SoilModel};

/// A method that computes k and μ from soil data: its name, its keys, the function that reads its data, and
/// the function that recognises its soils.
struct Method {
    name: &'static str,
    keys: &'static [&'static str],
    make: fn(&mut Reader, &Section) -> Soil,
    is_of: fn(&Soil) -> bool,
}

/// Returns the name that a model file uses for the method of a soil.
pub(crate) fn method_name(soil: &Soil) -> &'static str {
    METHODS.iter().find(|method| (method.is_of)(soil)).map_or("", |method| method.name)
}

const ELASTIC: &[&str] = &["method", "E", "nu"];
const PLATE: &[&str] = &["method", "plate_modulus", "plate_width"];

/// Keys that probably mean the oedometric modulus (no lateral strain), which is not accepted in place of
/// `E`.
const OEDOMETRIC: &[&str] = &["e_s", "es", "e_oed", "eoed", "e_stat", "m_s"];
const OF_OEDOMETRIC: &str = "write `E`, the modulus with free lateral strain; from an oedometric modulus E_s it is \
                             E = E_s (1 + nu) (1 − 2 nu)/(1 − nu)";

static LAYER: Table = Table {
    name: "[[foundation.soil.layer]]",
    keys: &[
        quantity("E", &SOIL_MODULUS, "The elastic modulus.")
            .needed()
            .also(ALSO_E)
            .unlike(OEDOMETRIC, OF_OEDOMETRIC),
        quantity("nu", &RATIO, "Poisson's ratio, below 0.5.").needed().also(ALSO_NU),
        quantity("thickness", &LENGTH, "The thickness of the layer.").needed(),
    ],
};

static NAMES: Words = Words {
    all: || METHODS.iter().map(|method| method.name).collect(),
    also: &[],
    message: "`{}` is not a method that computes k and mu from soil data",
    hint: "methods: {}",
};

/// Keys of all methods.
pub(super) static TABLE: Table = Table {
    name: "[foundation.soil]",
    keys: &[
        word("method", &NAMES, "The method that computes k and mu.").needed(),
        tables(
            "layer",
            &LAYER,
            "The layers above rock, the uppermost first, for `vlasov` and `modified-vlasov`.",
        ),
        quantity("gamma", &RATIO, "The parameter of the decay with depth, for `vlasov`."),
        quantity(
            "E",
            &SOIL_MODULUS,
            "The elastic modulus, for `vesic`, `biot`, `meyerhof-baike` and `selvadurai`.",
        )
        .also(ALSO_E)
        .unlike(OEDOMETRIC, OF_OEDOMETRIC),
        quantity(
            "nu",
            &RATIO,
            "Poisson's ratio, for `vesic`, `biot`, `meyerhof-baike` and `selvadurai`.",
        )
        .also(ALSO_NU),
        quantity(
            "plate_modulus",
            &SUBGRADE_MODULUS,
            "The subgrade modulus from a plate load test, for `terzaghi-clay` and `terzaghi-sand`.",
        ),
        quantity(
            "plate_width",
            &WIDTH,
            "The width of the plate, for `terzaghi-clay` and `terzaghi-sand`.",
        ),
    ],
};

const METHODS: [Method; 8] = [
    Method {
        name: "modified-vlasov",
        keys: &["method", "layer"],
        make: |reader, table| Soil::ModifiedVlasov(layers(reader, table)),
        is_of: |soil| matches!(soil, Soil::ModifiedVlasov(_)),
    },
    Method {
        name: "vlasov",
        keys: &["method", "layer", "gamma"],
        make: |reader, table| Soil::Vlasov(layers(reader, table), positive(reader, table, "gamma")),
        is_of: |soil| matches!(soil, Soil::Vlasov(..)),
    },
    Method {
        name: "vesic",
        keys: ELASTIC,
        make: |r, t| Soil::Vesic(elastic(r, t)),
        is_of: |soil| matches!(soil, Soil::Vesic(_)),
    },
    Method {
        name: "biot",
        keys: ELASTIC,
        make: |r, t| Soil::Biot(elastic(r, t)),
        is_of: |soil| matches!(soil, Soil::Biot(_)),
    },
    Method {
        name: "meyerhof-baike",
        keys: ELASTIC,
        make: |r, t| Soil::MeyerhofBaike(elastic(r, t)),
        is_of: |soil| matches!(soil, Soil::MeyerhofBaike(_)),
    },
    Method {
        name: "selvadurai",
        keys: ELASTIC,
        make: |r, t| Soil::Selvadurai(elastic(r, t)),
        is_of: |soil| matches!(soil, Soil::Selvadurai(_)),
    },
    Method {
        name: "terzaghi-clay",
        keys: PLATE,
        make: |r, t| Soil::TerzaghiClay(plate(r, t)),
        is_of: |soil| matches!(soil, Soil::TerzaghiClay(_)),
    },
    Method {
        name: "terzaghi-sand",
        keys: PLATE,
        make: |r, t| Soil::TerzaghiSand(plate(r, t)),
        is_of: |soil| matches!(soil, Soil::TerzaghiSand(_)),
    },
];

/// Reads the soil model under a beam with the bearing width `width`.
pub(super) fn read(reader: &mut Reader, table: &Section, width: f64) -> Option<SoilModel> {
    let method = method(reader, table)?;
    reader.refuse_all_but(table, method.keys);
    Some(SoilModel::new((method.make)(reader, table), width))
}

fn method(reader: &mut Reader, table: &Section) -> Option<&'static Method> {
    let word = reader.word(table, "method")?;
    METHODS.iter().find(|method| method.name == word)
}

fn layers(reader: &mut Reader, table: &Section) -> LayeredSoil {
    let tables = reader.tables(table, "layer");
    if tables.is_empty() && table.value("layer").is_none() {
        let example =
            "[[foundation.soil.layer]] with `E`, `nu` and `thickness`, the uppermost first";
        reader.missing(table, &["layer"], "layer", example);
    }
    let layers = tables.iter().map(|layer| {
        let Elastic { modulus, poisson } = elastic(reader, layer);
        SoilLayer { modulus, poisson, thickness: positive(reader, layer, "thickness") }
    });
    LayeredSoil { layers: layers.collect() }
}

fn elastic(reader: &mut Reader, table: &Section) -> Elastic {
    let modulus = positive(reader, table, "E");
    let poisson = reader.required(table, "nu");
    if poisson.value < 0.0 || poisson.value >= 0.5 {
        let message = "Poisson's ratio of a soil must lie between 0 and 0.5";
        let hint = "Poisson's ratio is about 0.2 to 0.35 for sand and 0.4 to 0.45 for wet clay; 0.5 is not allowed";
        reader.report(Fault::new(code::POISSON, poisson.span, message, "", hint));
        return Elastic { modulus, poisson: f64::NAN };
    }
    Elastic { modulus, poisson: poisson.value }
}

fn plate(reader: &mut Reader, table: &Section) -> PlateTest {
    let modulus = positive(reader, table, "plate_modulus");
    PlateTest { modulus, width: positive(reader, table, "plate_width") }
}

fn positive(reader: &mut Reader, table: &Section, key: &'static str) -> f64 {
    let field = reader.required(table, key);
    reader.positive(key, field).value
}
