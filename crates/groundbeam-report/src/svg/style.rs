//! Styles of the text and of the distributed loads in the pictures.

use super::canvas::Style;
use super::paint::{Colour, Fill, Paint, Stroke};

pub(super) const TITLE: Style = Style::new(17.0, true, Colour::Ink);
pub(super) const PANEL_TITLE: Style = Style::new(12.5, true, Colour::Ink);
pub(super) const NOTE: Style = Style::new(11.0, false, Colour::FaintInk);
pub(super) const TICK: Style = Style::new(10.5, false, Colour::FaintInk);
pub(super) const LABEL: Style = Style::new(11.5, false, Colour::Ink);
/// Style of text in diagrams, with a rim because the text may cross lines.
pub(super) const RIMMED: Style = Style { rim: true, ..LABEL };
/// Fill and outline of the area of a distributed load.
pub(super) const DISTRIBUTED: Paint =
    Fill::new(Colour::Load).with_opacity(0.12).and(Stroke::new(Colour::Load, 0.9));
