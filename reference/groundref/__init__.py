"""Multiprecision reference solutions for a beam on ground that can only push back.

Read the modules in this order: `model` (what is given), `coarse` (which parts touch, roughly),
`pieces` (closed forms on one stretch), `analytic` (the stretches joined, the edges by Newton),
`verify` (signs, balances, energy), `topology` (the loop over all of these), `record` (the output).
"""
