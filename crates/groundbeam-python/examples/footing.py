"""The strip footing of the README, the same model as in ``crates/groundbeam/examples/footing.rs``."""

import groundbeam as gb

# The footing is 12 m long and has EI = 1.28e9 N m^2. The ground has k = 40 MN/m^2 and mu = 9 MN.
# Numbers are in N and m.
model = (
    gb.Model(gb.Beam.uniform(12.0, 1.28e9), gb.Foundation.pasternak(40e6, 9e6))
    .with_load(gb.Load.point(900e3, 1.5))
    .with_load(gb.Load.uniform(10e3, 0.0, 12.0))
)
try:
    found = model.solve()
    (start, end), lifted = found.contact[0], found.lift_off[0]
    print(f"the beam is in contact from {start:.3f} m to {end:.3f} m")
    print(f"the left end presses with {found.end_forces.left / 1e3:.1f} kN")
    print(f"the right end is {lifted.largest_gap * 1e3:.2f} mm above the ground")
    assert found.certificate.relative_gap < 1e-12
except gb.NoEquilibrium as why:
    print(f"it tips: {why}")
