"""Case B beside other programs; writes the last part of bench/RESULTS.md.

    pip install -r bench/requirements.txt
    cargo build --release -p groundbeam-bench && python bench/rivals.py

Each program gets the same nodes and nodal forces. `stiffness` is what a user writes from the paper:
unknowns (w, h·w', u), Hessian EI/h³. `natural` has element deformations as further unknowns, tied by
equalities: the form in which groundbeam works, found to be much better for interior-point methods.
"""

import importlib.metadata
import multiprocessing
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import numpy as np
import scipy.linalg
import scipy.sparse as sp

HERE = pathlib.Path(__file__).parent
EI, K, MU = 1.0, 1.0, 0.1
LIMIT = 60  # seconds for one program on one mesh


def read(n, program):
    """Positions, nodal forces and moments, w and p in twice the digits, bonded w; our own seconds."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "problem")
        said = subprocess.run([program, "problem", str(n), file], capture_output=True, text=True, check=True)
        nodes, bonded_time, contact = said.stdout.split()
        arrays = np.fromfile(file).reshape(6, int(nodes))
    return arrays, float(bonded_time), float(contact)


def ground(h):
    """Coupling and leak of open ground of length h."""
    z = np.sqrt(K / MU) * h
    s = np.sqrt(K * MU)
    return s / np.sinh(z), s * np.tanh(z / 2)


def under_nodes(leak, beyond):
    """Springs of open ground under its nodes; what lies beyond it is one at each end."""
    u = np.zeros(len(leak) + 1)
    u[:-1] += leak
    u[1:] += leak
    u[[0, -1]] += beyond
    return u


def assembled(h, blocks, size, stride):
    """Sum of element matrices whose unknowns begin at stride·i."""
    m = blocks.shape[1]
    at = stride * np.arange(len(h))[:, None] + np.arange(m)
    rows = np.repeat(at, m, axis=1).ravel()
    columns = np.tile(at, (1, m)).ravel()
    return sp.csc_matrix((blocks.ravel(), (rows, columns)), shape=(size, size))


def beam_blocks(h, scale):
    """Hermite elements for (w, scale·w') at both ends."""
    r = h / scale
    one = np.ones_like(h)
    k = np.array([[12 * one, 6 * r, -12 * one, 6 * r], [6 * r, 4 * r * r, -6 * r, 2 * r * r],
                  [-12 * one, -6 * r, 12 * one, -6 * r], [6 * r, 2 * r * r, -6 * r, 4 * r * r]])
    return np.moveaxis(k * (EI / h**3), 2, 0)


def ground_matrix(h):
    c, leak = ground(h)
    blocks = np.moveaxis(np.array([[c + leak, -c], [-c, c + leak]]), 2, 0)
    a = assembled(h, blocks, len(h) + 1, 1).tolil()
    a[0, 0] += np.sqrt(K * MU)
    a[-1, -1] += np.sqrt(K * MU)
    return a.tocsc()


def stiffness(x, force, moment):
    """min ½zᵗPz + qᵗz, G z ≥ 0 with z = (w, h·w', …, u)."""
    h, n = np.diff(x), len(x)
    scale = np.median(h)
    k = assembled(h, beam_blocks(h, scale), 2 * n, 2)
    p = sp.block_diag([k, ground_matrix(h)], format="csc")
    q = np.zeros(3 * n)
    q[0:2 * n:2], q[1:2 * n:2] = -force, -moment / scale
    w = sp.csc_matrix((np.ones(n), (np.arange(n), 2 * np.arange(n))), shape=(n, 2 * n))
    g = sp.hstack([-w, sp.identity(n)], format="csc")
    return p, q, None, None, g, slice(0, 2 * n, 2)


def natural(x, force, moment):
    """Unknowns per node (w, w', u), then per element (d₁, h·d₂, rise of u); equalities tie them."""
    h, n = np.diff(x), len(x)
    m = n - 1
    c, leak = ground(h)
    one = np.ones(m)
    e = np.moveaxis(np.array([[12 * one, -6 * one, 0 * one], [-6 * one, 4 * one, 0 * one], [0 * one, 0 * one, c * h**3 / EI]]) * (EI / h**3), 2, 0)
    elements = assembled(h, e, 3 * m, 3)
    u = under_nodes(leak, np.sqrt(K * MU))
    nodes = sp.diags(np.kron(u, [0, 0, 1]))
    p = sp.block_diag([nodes, elements], format="csc")
    q = np.zeros(3 * n + 3 * m)
    q[0:3 * n:3], q[1:3 * n:3] = -force, -moment
    i = np.arange(m)
    entries = []
    for row, terms in enumerate([[(3, 1), (0, -1), (1, -h), ("d0", -1)], [(4, h), (1, -h), ("d1", -1)], [(5, 1), (2, -1), ("d2", -1)]]):
        for place, value in terms:
            column = 3 * n + 3 * i + int(place[1]) if isinstance(place, str) else 3 * i + place
            entries.append((3 * i + row, column, np.broadcast_to(value, m)))
    rows, columns, values = (np.concatenate(part) for part in zip(*entries))
    a = sp.csc_matrix((values.astype(float), (rows, columns)), shape=(3 * m, 3 * n + 3 * m))
    g = sp.csc_matrix((np.tile([1.0, -1.0], n), (np.repeat(np.arange(n), 2), (3 * np.arange(n)[:, None] + [2, 0]).ravel())),
                      shape=(n, 3 * n + 3 * m))
    return p, q, a, np.zeros(3 * m), g, slice(0, 3 * n, 3)


# Smallest stopping tolerance that the interior-point methods reach, for each formulation of the problem.
TOLERANCE = {natural: 1e-12, stiffness: 1e-9}


def by_piqp(form, *data):
    import piqp
    p, q, a, b, g, w = form(*data)
    solver = piqp.SparseSolver()
    solver.settings.eps_abs = solver.settings.eps_rel = TOLERANCE[form]
    solver.settings.max_iter = 400
    if hasattr(solver.settings, "num_threads"):
        solver.settings.num_threads = 1
    began = time.perf_counter()
    solver.setup(sp.triu(p, format="csc"), q, a, b, g, np.zeros(g.shape[0]), None)
    status = solver.solve()
    r = solver.result
    return time.perf_counter() - began, r.x[w], r.z_l, f"{str(status).split('.')[-1]}, {r.info.iter} it"


def by_clarabel(form, *data):
    import clarabel
    p, q, a, b, g, w = form(*data)
    n = g.shape[0]
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = TOLERANCE[form]
    if hasattr(settings, "max_threads"):
        settings.max_threads = 1
    cones, rows, right = [clarabel.NonnegativeConeT(n)], -g, np.zeros(n)
    if a is not None:
        cones, rows, right = [clarabel.ZeroConeT(len(b))] + cones, sp.vstack([a, -g], format="csc"), np.concatenate([b, right])
    began = time.perf_counter()
    r = clarabel.DefaultSolver(sp.triu(p, format="csc"), q, sp.csc_matrix(rows), right, cones, settings).solve()
    return time.perf_counter() - began, np.array(r.x)[w], np.array(r.z)[-n:], f"{r.status}, {r.iterations} it"


def by_osqp(form, *data):
    import osqp
    p, q, a, b, g, w = form(*data)
    n = g.shape[0]
    rows, low, high = g, np.zeros(n), np.full(n, np.inf)
    if a is not None:
        rows, low, high = sp.vstack([a, g], format="csc"), np.concatenate([b, low]), np.concatenate([b, high])
    solver = osqp.OSQP()
    began = time.perf_counter()
    solver.setup(sp.triu(p, format="csc"), q, sp.csc_matrix(rows), low, high, verbose=False, eps_abs=1e-9, eps_rel=1e-9,
                 max_iter=1_000_000, polishing=True)
    r = solver.solve(raise_error=False)
    return time.perf_counter() - began, r.x[w], -r.y[-n:], f"{r.info.status}, {r.info.iter} it"


def by_lapack_stiffness(x, force, moment):
    """The bonded beam, dpbsv."""
    h, n = np.diff(x), len(x)
    scale = np.median(h)
    k = assembled(h, beam_blocks(h, scale), 2 * n, 2).tocoo()
    a = ground_matrix(h).tocoo()
    band = np.zeros((4, 2 * n))
    for rows, columns, values in [(k.row, k.col, k.data), (2 * a.row, 2 * a.col, a.data)]:
        upper = columns >= rows
        np.add.at(band, (3 + rows[upper] - columns[upper], columns[upper]), values[upper])
    q = np.zeros(2 * n)
    q[::2], q[1::2] = force, moment / scale
    began = time.perf_counter()
    z = scipy.linalg.solveh_banded(band, q)
    return time.perf_counter() - began, z[::2], None, "bonded only"


def by_lapack_natural(x, force, moment):
    """The bonded beam with deformations and multipliers, dgbsv: (w, w', d₁, h·d₂, λ₁, λ₂) node by node."""
    h, n = np.diff(x), len(x)
    c, leak = ground(h)
    u = under_nodes(leak, np.sqrt(K * MU))
    size, low = 6 * n - 4, 6
    band = np.zeros((2 * low + 1, size))

    def put(rows, columns, values):
        np.add.at(band, (low + rows - columns, columns), np.broadcast_to(values, rows.shape))

    i = 6 * np.arange(n)
    put(i, i, u)
    j = i[:-1]
    e = EI / h**3
    # The shear layer is a spring of stiffness c between the ends of an element of length h. Their deflections differ by
    # h·w' + d₁: w' is the slope at the left end, d₁ the distance of the right end from the tangent there.
    for a, b, value in [(1, 1, c * h * h), (1, 2, c * h), (2, 1, c * h), (2, 2, 12 * e + c), (2, 3, -6 * e), (3, 2, -6 * e), (3, 3, 4 * e)]:
        put(j + a, j + b, value)
    for row, terms in [(4, [(6, 1.0), (0, -1.0), (1, -h), (2, -1.0)]), (5, [(7, h), (1, -h), (3, -1.0)])]:
        for column, value in terms:
            put(j + row, j + column, value)
            put(j + column, j + row, value)
    q = np.zeros(size)
    q[0::6][:n], q[1::6][:n] = force, moment
    began = time.perf_counter()
    z = scipy.linalg.solve_banded((low, low), band, q)
    return time.perf_counter() - began, z[0::6][:n], None, "bonded only"


def by_opensees(x, force, moment):
    """Penalty contact: ENT springs of 1e8 between beam nodes and ground nodes."""
    import openseespy.opensees as ops
    h, n = np.diff(x), len(x)
    c, leak = ground(h)
    u = under_nodes(leak, np.sqrt(K * MU))
    penalty = 1e8
    began = time.perf_counter()
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    ops.uniaxialMaterial("ENT", 1, penalty)
    for i, at in enumerate(x):
        ops.node(i + 1, at, 0.0)
        ops.fix(i + 1, 1, 0, 0)
        ops.node(n + i + 1, at, 0.0)
        ops.fix(n + i + 1, 1, 0, 1)
        ops.node(2 * n + i + 1, at, 0.0)
        ops.fix(2 * n + i + 1, 1, 1, 1)
        # The y axis points upward. The contact spring acts if its beam node moves downward relative to its ground
        # node.
        ops.element("zeroLength", 4 * n + i, n + i + 1, i + 1, "-mat", 1, "-dir", 2)
        ops.uniaxialMaterial("Elastic", 10 + i, u[i])
        ops.element("zeroLength", 5 * n + i, 2 * n + i + 1, n + i + 1, "-mat", 10 + i, "-dir", 2)
    for i in range(n - 1):
        ops.element("elasticBeamColumn", i + 1, i + 1, i + 2, 1.0, 1.0, EI, 1)
        ops.uniaxialMaterial("Elastic", 10 + n + i, c[i])
        ops.element("zeroLength", 6 * n + i, n + i + 1, n + i + 2, "-mat", 10 + n + i, "-dir", 2)
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    for i in range(n):
        ops.load(i + 1, 0.0, -force[i], -moment[i])
    ops.system("BandGeneral")
    ops.numberer("RCM")
    ops.constraints("Plain")
    ops.test("NormDispIncr", 1e-10, 200, 0)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    status = ops.analyze(1)
    seconds = time.perf_counter() - began
    w = -np.array([ops.nodeDisp(i + 1, 2) for i in range(n)])
    s = -np.array([ops.nodeDisp(n + i + 1, 2) for i in range(n)])
    return seconds, w, penalty * np.maximum(w - s, 0.0), f"penalty 1e8, {'fails' if status else 'ok'}"


def by_pynite(x, force, moment):
    """One-way springs to the fixed earth: no shear layer can be said, so what is timed is another problem."""
    from Pynite import FEModel3D
    h, n = np.diff(x), len(x)
    _, leak = ground(h)
    u = under_nodes(leak, 0.0)
    began = time.perf_counter()
    model = FEModel3D()
    model.add_material("m", 1.0, 0.5, 0.3, 0.0)
    model.add_section("s", 1.0, EI, EI, 1.0)
    for i, at in enumerate(x):
        model.add_node(f"N{i}", at, 0.0, 0.0)
        model.def_support(f"N{i}", i == 0, False, True, True, True, False)
        model.def_support_spring(f"N{i}", "DY", u[i], "-")
        model.add_node_load(f"N{i}", "FY", -force[i])
        model.add_node_load(f"N{i}", "MZ", -moment[i])
    for i in range(n - 1):
        model.add_member(f"M{i}", f"N{i}", f"N{i + 1}", "m", "s")
    model.analyze(check_stability=False)
    return time.perf_counter() - began, None, None, "springs without shear layer: another problem"


PROGRAMS = [
    ("PIQP", "natural", lambda *d: by_piqp(natural, *d), 100_000),
    ("PIQP", "stiffness", lambda *d: by_piqp(stiffness, *d), 10_000),
    ("Clarabel", "natural", lambda *d: by_clarabel(natural, *d), 100_000),
    ("Clarabel", "stiffness", lambda *d: by_clarabel(stiffness, *d), 10_000),
    ("OSQP", "natural", lambda *d: by_osqp(natural, *d), 1_000),
    ("OSQP", "stiffness", lambda *d: by_osqp(stiffness, *d), 1_000),
    ("LAPACK dpbsv", "stiffness", by_lapack_stiffness, 1_000_000),
    ("LAPACK dgbsv", "natural", by_lapack_natural, 100_000),
    ("OpenSees", "stiffness", by_opensees, 1_000),
    ("Pynite", "stiffness", by_pynite, 100),
]


def run(pipe, job, data, again):
    quiet = os.open(os.devnull, os.O_WRONLY)
    os.dup2(quiet, 1)
    os.dup2(quiet, 2)
    try:
        best = min((job(*data) for _ in range(again)), key=lambda result: result[0])
        pipe.send(best)
    except Exception as error:  # what a program says is a result too
        pipe.send(f"{type(error).__name__}: {error}"[:120].replace("\n", " "))


def limited(job, data, again):
    """A program in a process of its own, for LIMIT seconds."""
    ours, theirs = multiprocessing.Pipe(False)
    process = multiprocessing.Process(target=run, args=(theirs, job, data, again))
    process.start()
    said = ours.recv() if ours.poll(LIMIT) else f"no answer in {LIMIT} s"
    process.kill()
    process.join()
    return said


def error(found, right):
    return f"{np.max(np.abs(found - right)) / np.max(np.abs(right)):.0e}"


def main():
    meta = subprocess.run(["cargo", "metadata", "--format-version", "1", "--no-deps"], cwd=HERE, capture_output=True, text=True, check=True).stdout
    target = re.search(r'"target_directory":"([^"]*)"', meta).group(1)
    program = str(pathlib.Path(target, "release", "groundbeam-bench"))
    sizes = [int(float(n)) for n in sys.argv[1:]] or [100, 1_000, 10_000, 100_000]
    names = ["numpy", "scipy", "piqp", "clarabel", "osqp", "openseespy", "PyNiteFEA"]
    versions = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in names)
    lines = ["", "## Beside other programs", "",
             f"Case B, P = 0, one thread, least of several runs; {time.strftime('%Y-%m-%d %H:%M UTC', time.gmtime())}.",
             f"Versions: {versions}.",
             "The ratio of a program's time to ours comes first: contact to contact, or bonded to bonded.",
             "Tolerances: 1e-12 in the natural form, 1e-9 in the stiffness form; OSQP 1e-9, polished.", "",
             "| n | program | form | time / ours | ms | errw | errp | says |", "|---|---|---|---|---|---|---|---|"]
    for n in sizes:
        (x, force, moment, w, p, bonded), bonded_time, contact = read(n, program)
        lines.append(f"| {n} | **groundbeam** | contact | **1** | {1e3 * contact:.3g} | | | bonded {1e3 * bonded_time:.3g} ms |")
        for name, form, job, most in PROGRAMS:
            if n > most:
                continue
            said = limited(job, (x, force, moment), 3 if n <= 10_000 else 1)
            if isinstance(said, str):
                lines.append(f"| {n} | {name} | {form} | | | | | {said} |")
            else:
                seconds, found, pressed, remark = said
                ours, right = (bonded_time, bonded) if remark == "bonded only" else (contact, w)
                errw = error(found, right) if found is not None else ""
                errp = error(pressed, p) if pressed is not None else ""
                lines.append(f"| {n} | {name} | {form} | **{seconds / ours:.3g}** | {1e3 * seconds:.3g} | {errw} | {errp} | {remark} |")
            print(lines[-1], flush=True)
    results = HERE / "RESULTS.md"
    before = results.read_text() if results.exists() else "# Results\n"
    results.write_text(before.split("\n## Beside other programs")[0].rstrip("\n") + "\n" + "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
