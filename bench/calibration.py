import time, numpy as np, groundbeam as gb
from groundbeam._solution import Solution
from scipy.optimize import least_squares
X = np.linspace(0.0, 12.0, 13)
def model(k, mu, EI=1.28e9):
    return gb.Model(gb.Beam(12.0, EI), gb.Foundation(k, mu), loads=[gb.Load.point(900e3, 1.5), gb.Load.distributed(10e3, 0.0, 12.0)])
def segmented(ks, mu=9e6):
    n=len(ks); l=12.0
    seg=[{"from": l*i/n, "to": l*(i+1)/n, "k": float(k), "mu": mu} for i,k in enumerate(ks)]
    return gb.Model(gb.Beam(l, 1.28e9), gb.Foundation(40e6, mu, segments=seg), loads=[gb.Load.point(900e3, 1.5), gb.Load.point(700e3, 7.0), gb.Load.distributed(10e3, 0.0, 12.0)])
def case(name, true, guess, unknown, at=X):
    exact = true.solve()
    rng = np.random.default_rng(1)
    noise = 3e-5
    y = exact.deflection(at) + rng.normal(0, noise, len(at))
    start = np.array([guess._inner.number(n, None) for n in unknown])
    def solve(theta):
        s = Solution(guess._inner.solve_with([(n, float(v)) for n, v in zip(unknown, np.exp(theta))], None))
        return (s.deflection(at) - y)/noise
    best = {}
    for rep in range(15):
        t=time.perf_counter(); c = gb.calibrate(guess, {"deflection": (at, y)}, unknown, noise=noise); best.setdefault('own',[]).append(time.perf_counter()-t)
        for method in ("lm","trf"):
            t=time.perf_counter(); r = least_squares(solve, np.log(start), method=method); best.setdefault(method,[]).append(time.perf_counter()-t)
            best[method+'_nfev']=r.nfev; best[method+'_cost']=r.cost
    own = sum(float((v/noise)@(v/noise))/2 for v in c.residuals.values())
    print(name, "calibrate %.2f ms (%d solves, cost %.6f)" % (1e3*min(best['own']), c.steps, own), *["%s %.2f ms (nfev %d, cost %.6f) ratio %.2f" % (m, 1e3*min(best[m]), best[m+'_nfev'], best[m+'_cost'], min(best[m])/min(best['own'])) for m in ("lm","trf")], flush=True)
case("k, mu", model(40e6, 9e6), model(10e6, 30e6), ["k","mu"])
case("k, mu, EI", model(40e6, 9e6, 1.28e9), model(20e6, 15e6, 1e9), ["k","mu","EI"])
n=6; rng=np.random.default_rng(2)
case("k of 6 segments", segmented(40e6*np.exp(rng.normal(0,.3,n))), segmented([30e6]*n), [f"k[{i}]" for i in range(n)], np.linspace(0,12,25))
raise SystemExit
case("k of 20 segments", segmented(40e6*np.exp(rng.normal(0,.3,n))), segmented([30e6]*n), [f"k[{i}]" for i in range(n)], np.linspace(0,12,61))
