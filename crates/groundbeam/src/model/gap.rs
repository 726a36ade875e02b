//! Initial clearance g₀(x) between beam and ground.

/// One corner of the piecewise linear profile of the initial clearance.
///
/// Between two corners the clearance is linear. Beyond the outermost corners it is constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapPoint {
    /// Position x \[m\]. Corners are listed from left to right.
    pub at: f64,
    /// Clearance g₀ \[m\], positive where there is a gap before loading.
    pub value: f64,
}
