"""Multiprecision reference solutions for beams on tensionless ground.

Read the modules in this order: `model` (the input), `coarse` (an estimate of the contact set), `pieces`
(closed-form solutions on one stretch), `analytic` (all stretches together, edges by Newton's method), `verify`
(signs, balances, energy), `topology` (the loop over all of these), `record` (the output).
"""
