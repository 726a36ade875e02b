//! Colours that people with any kind of colour vision tell apart (Okabe and Ito), and sizes of words.

use super::canvas::Style;

pub(super) const INK: &str = "#1f2328";
pub(super) const FAINT_INK: &str = "#646c75";
pub(super) const RULE: &str = "#d5d9de";
pub(super) const BEAM: &str = "#3d444d";
pub(super) const GROUND: &str = "#efe6d8";
pub(super) const GROUND_LINE: &str = "#8a7453";
pub(super) const GAP: &str = "#b9dff5";
pub(super) const LOAD: &str = "#b34700";
pub(super) const PRESSURE: &str = "#0072b2";
pub(super) const MOMENT: &str = "#d55e00";
pub(super) const SHEAR: &str = "#00805e";
pub(super) const SUPPORT: &str = "#1f2328";

pub(super) const TITLE: Style = Style { size: 17.0, bold: true, colour: INK, rim: false };
pub(super) const PANEL_TITLE: Style = Style { size: 12.5, bold: true, colour: INK, rim: false };
pub(super) const NOTE: Style = Style { size: 11.0, bold: false, colour: FAINT_INK, rim: false };
pub(super) const TICK: Style = Style { size: 10.5, bold: false, colour: FAINT_INK, rim: false };
pub(super) const LABEL: Style = Style { size: 11.5, bold: false, colour: INK, rim: false };
/// In diagrams, where labels may have to cross lines.
pub(super) const RIMMED: Style = Style { rim: true, ..LABEL };
/// The colour of concentrated forces, to be told from the pressure they stand beside.
pub(super) const FORCE: &str = "#00395c";
