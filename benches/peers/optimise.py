#!/usr/bin/env python3
"""Constrained mesh optimisation without isogeo: a researcher's own script, and ready-made planarisers.

    pip install -r benches/peers/requirements.txt       # or some of it: what is missing is left out
    python benches/peers/optimise.py                    # a table; --json FILE writes a line for each row
    python benches/peers/optimise.py --isogeo target/release/isogeo
    python benches/peers/optimise.py --write DIR        # the inputs as OBJ, 17 digits, and nothing else

*The script.* Gauss-Newton with steps of minimum norm, dx = -J^T (J J^T)^{-1} r, on all coordinates, from
the input until every residual is at most 1e-10. J is analytic; J J^T is factored by CHOLMOD (two orderings),
PARDISO or SuperLU, and analysed once (by SuperLU in each step). Residuals, each over its own scale:

    planar      6 volumes of the quad, over the cube of its mean diagonal
    i-circular  planar, and the in-circle determinant of the top view, which is Im(e0 e2 conj(e1 e3)) for
                its edges, over |e0 e1 e2 e3|
    i-conical   planar, and the same for the four edges, in cyclic order, from each inner vertex

*Noisy net.* (m+1)^2 vertices of the i-minimal Enneper net x + iy = zeta^(2/3), z = 0.2 Re zeta^2, with zeta
in [1,2] + i[0.2,1.2]; Re zeta is constant along a row. Each coordinate is moved by 0.02 (mean top-view edge)
(2u - 1), where u = (splitmix64(seed * 0x9E3779B97F4A7C15 + i) >> 11) / 2^53 for vertex i, with seeds 11, 12,
13 for x, y, z; splitmix64(s) is what that generator returns in state s.

*Patch.* z = 0.3 sin(1.7x + 0.3) cos(1.3y - 0.2) + 0.2xy on [-1,1]^2, 32 x 32 quads without noise, also given
to libigl (100 iterations), compas_shapeop (planes of weight 1, closeness of 0.01, 100 iterations) and mpfp
(defaults, corners fixed).

Seconds are those of whole solves, points and faces being in memory: best and median of the runs. isogeo
reports its own seconds; what it wrote is measured here like the others. `residual` is the largest of the
goal at the end, `distance` the largest of a vertex from the best plane of its quad over the mean diagonal,
`nonconvex` the number of quads whose top view is not convex. Movement is in mean top-view edges of the
input: root mean square over the vertices, and largest.

CHOLMOD is as fast as the BLAS that it is linked with: on Debian, install libopenblas0-pthread. On a busy
machine all are faster with OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1.
"""

import argparse
import importlib
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from functools import partial

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg

GOALS = "planar", "i-circular", "i-conical"
TOLERANCE = 1e-10
MOST_STEPS = 30
PATIENCE = 30  # seconds, after which a method is not run again


class Grid:
    """Quads over rows of points."""

    def __init__(self, name, points):
        rows = points.reshape(int(len(points) ** 0.5 + 0.5), -1, 3)
        i = np.arange(len(points)).reshape(rows.shape[:2])
        quads = i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]
        stars = i[1:-1, 1:-1], i[2:, 1:-1], i[1:-1, 2:], i[:-2, 1:-1], i[1:-1, :-2]
        self.name, self.points = name, points
        self.quads = np.stack(quads, axis=-1).reshape(-1, 4)
        self.stars = np.stack(stars, axis=-1).reshape(-1, 5)
        self.corners = [int(v) for v in i[[0, 0, -1, -1], [0, -1, 0, -1]]]
        edges = np.concatenate([np.diff(rows, axis=k).reshape(-1, 3) for k in (0, 1)])
        self.edge = norm(edges[:, :2]).mean()

    def write(self, path):
        with open(path, "w") as file:
            file.writelines("v {:.17g} {:.17g} {:.17g}\n".format(*point) for point in self.points)
            file.writelines("f {} {} {} {}\n".format(*quad) for quad in self.quads + 1)


def noisy_net(m):
    step = np.arange(m + 1) / m
    zeta = (1 + step[:, None] + 1j * (0.2 + step)).ravel()
    top = zeta ** (2 / 3)
    points = np.stack([top.real, top.imag, 0.2 * (zeta**2).real], axis=1)
    noise = np.stack([2 * uniform(seed, len(points)) - 1 for seed in (11, 12, 13)], axis=1)
    return Grid(f"noisy-{m}", points + 0.02 * Grid("", points).edge * noise)


def patch(m):
    axis = np.linspace(-1, 1, m + 1)
    x, y = np.repeat(axis, m + 1), np.tile(axis, m + 1)
    z = 0.3 * np.sin(1.7 * x + 0.3) * np.cos(1.3 * y - 0.2) + 0.2 * x * y
    return Grid(f"patch-{m}", np.stack([x, y, z], axis=1))


def uniform(seed, count):
    """u(seed, i) in [0, 1) for i below count."""
    golden = 0x9E3779B97F4A7C15
    z = np.arange(count, dtype=np.uint64) + np.uint64((seed + 1) * golden % 2**64)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return ((z ^ (z >> np.uint64(31))) >> np.uint64(11)) * 2.0**-53


# Residuals: one value for each element, and the gradient by the coordinates of its vertices.


def planar(points, quads):
    corner = points[quads]
    u, v, w = (corner[:, k] - corner[:, 0] for k in (1, 2, 3))
    du, dv, dw = np.cross(v, w), np.cross(w, u), np.cross(u, v)
    scale = (0.5 * (norm(v) + norm(u - w))) ** -3
    gradient = np.stack([-du - dv - dw, du, dv, dw], axis=1) * scale[:, None, None]
    return (u * du).sum(axis=1) * scale, gradient.reshape(len(quads), -1)


def balance(edges):
    """Im(e0 e2 conj(e1 e3)) over |e0 e1 e2 e3|; d/dx + i d/dy by the four edges."""
    a, b, c, d = edges.T
    even, odd = a * c, np.conj(b * d)
    gradient = [np.conj(c * odd), -even * np.conj(d), np.conj(a * odd), -even * np.conj(b)]
    scale = 1 / np.abs(even * odd)
    return (even * odd).imag * scale, 1j * np.stack(gradient, axis=1) * scale[:, None]


def circular(points, quads):
    corner = (points[:, 0] + 1j * points[:, 1])[quads]
    r, g = balance(np.roll(corner, -1, axis=1) - corner)
    return r, (np.roll(g, 1, axis=1) - g).view(float)


def conical(points, stars):
    star = (points[:, 0] + 1j * points[:, 1])[stars]
    r, g = balance(star[:, 1:] - star[:, :1])
    return r, np.hstack([-g.sum(axis=1, keepdims=True), g]).view(float)


def norm(vectors):
    return np.sqrt((vectors * vectors).sum(axis=-1))


class System:
    """The residuals of a goal and their Jacobian, whose pattern is made once."""

    def __init__(self, grid, goal):
        self.parts = [(planar, grid.quads, 3)]
        self.parts += [(circular, grid.quads, 2)] if goal == "i-circular" else []
        self.parts += [(conical, grid.stars, 2)] if goal == "i-conical" else []
        columns = [(3 * at[:, :, None] + np.arange(k)).reshape(len(at), -1) for _, at, k in self.parts]
        widths = np.concatenate([np.full(len(c), c.shape[1]) for c in columns])
        self.indices = np.concatenate([c.ravel() for c in columns]).astype(np.int32)
        self.starts = np.concatenate([[0], np.cumsum(widths)]).astype(np.int32)
        self.shape = len(widths), grid.points.size

    def __call__(self, points):
        r, gradients = zip(*(residual(points, at) for residual, at, _ in self.parts))
        data = np.concatenate([g.ravel() for g in gradients])
        return np.concatenate(r), sparse.csr_matrix((data, self.indices, self.starts), self.shape)


def gauss_newton(solver):
    """The script with a solver; lengths are in edges on the way, so that scale does not matter."""

    def run(grid, goal):
        system, solve, points = System(grid, goal), solver(), grid.points / grid.edge
        for step in range(MOST_STEPS + 1):
            r, j = system(points)
            if np.abs(r).max() <= TOLERANCE:
                break
            points = points - (j.T @ solve(j, r)).reshape(-1, 3)
        return points * grid.edge, {"steps": step}

    return run


# Solvers of (J J^T) y = r: a function that is called in each step and analyses in the first.


def superlu():
    options = dict(permc_spec="MMD_AT_PLUS_A", options=dict(SymmetricMode=True, DiagPivotThresh=0))
    return lambda j, r: sparse.linalg.splu((j @ j.T).tocsc(), **options).solve(r)


def cholmod(module, ordering):
    factor = None

    def solve(j, r):
        nonlocal factor
        j = j.tocsc()
        factor = factor or module.analyze_AAt(j, mode="supernodal", ordering_method=ordering)
        factor.cholesky_AAt_inplace(j)
        return factor(r)

    return solve


def pardiso(solver):
    solver.set_phase(13)

    def solve(j, r):
        upper = sparse.triu(j @ j.T, format="csr")
        upper.sort_indices()
        y = solver._call_pardiso(upper, r)
        solver.set_phase(23)
        return y

    return solve


# Ready-made planarisers.


def libigl(module):
    return lambda grid, _: (module.planarize_quad_mesh(grid.points, grid.quads, 100, 1e-9), {"steps": 100})


def shapeop(module):
    def run(grid, _):
        solver = module.Solver()
        solver.points = grid.points
        solver.add_closeness_constraints(range(len(grid.points)), 0.01)
        for quad in grid.quads.tolist():
            solver.add_plane_constraint(quad, 1.0)
        solver.init()
        solver.solve(100)
        return np.array(solver.points), {"steps": 100}

    return run


def mpfp(module):
    settings = module.MakePlanarSettings()
    settings.verbose = False

    def run(grid, _):
        faces = grid.quads.tolist()
        return np.array(module.make_planar_faces(list(grid.points), faces, grid.corners, settings)), {}

    return run


def isogeo(binary):
    """Seconds are its own, or else those of the process; what it reports in a number or a word is kept."""

    def run(grid, goal):
        with tempfile.TemporaryDirectory() as folder:
            start, end = (os.path.join(folder, name) for name in ("start.obj", "end.obj"))
            grid.write(start)
            command = [binary, "optimize", start, "--to", goal, "-o", end, "--format", "json"]
            result = subprocess.run(command, capture_output=True, text=True)
            if not os.path.exists(end):
                raise RuntimeError(result.stderr.strip()[:200])
            with open(end) as file:
                points = [line.split()[1:4] for line in file if line.startswith("v ")]
        said = {k: v for k, v in json.loads(result.stdout).items() if isinstance(v, (int, float, str))}
        more = {k: said[k] for k in ("seconds", "steps") if k in said}
        return np.array(points, dtype=float), more | {"reported": said}

    return run


def methods(binary):
    """Names, functions, and whether they only planarise; what is not installed is left out."""

    def module(name):
        try:
            return importlib.import_module(name)
        except ImportError as error:
            print(f"left out: {name}: {error}", file=sys.stderr)

    if found := module("sksparse.cholmod"):
        for ordering in ("amd", "nesdis"):
            yield f"CHOLMOD {ordering}", gauss_newton(partial(cholmod, found, ordering)), False
    if found := module("pypardiso"):
        solver = found.PyPardisoSolver(mtype=2)  # symmetric positive definite
        yield "PARDISO", gauss_newton(partial(pardiso, solver)), False
    yield "SuperLU", gauss_newton(superlu), False
    for name, make in ("igl", libigl), ("compas_shapeop.shapeop", shapeop), ("mpfp", mpfp):
        if found := module(name):
            yield make.__name__, make(found), True
    if binary:
        yield "isogeo", isogeo(binary), False


def state(grid, goal, points):
    """What is left and how far the points have moved."""
    corner = points[grid.quads]
    from_centre = corner - corner.mean(axis=1, keepdims=True)
    normal = np.linalg.svd(from_centre)[2][:, 2]
    distance = np.abs(np.einsum("fvk,fk->fv", from_centre, normal))
    edge = np.roll(corner, -1, axis=1) - corner
    turn = np.sign(np.cross(edge, np.roll(edge, -1, axis=1))[:, :, 2])
    moved = norm(points - grid.points) / grid.edge
    return {
        "residual": np.abs(System(grid, goal)(points)[0]).max(),
        "distance": distance.max() / norm(corner[:, 2:] - corner[:, :2]).mean(),
        "nonconvex": int((np.abs(turn.sum(axis=1)) < 4).sum()),
        "movement_rms": np.sqrt((moved**2).mean()),
        "movement_max": moved.max(),
    }


def measure(name, run, grid, goal, runs):
    seconds = []
    while len(seconds) < runs and sum(seconds) < PATIENCE:
        begin = time.perf_counter()
        points, more = run(grid, goal)
        elapsed = time.perf_counter() - begin
        seconds.append(more.pop("seconds", elapsed))
    row = {"input": grid.name, "faces": len(grid.quads), "goal": goal, "method": name, "runs": len(seconds)}
    row |= {"seconds": min(seconds), "seconds_median": statistics.median(seconds), "steps": "-"}
    return row | more | state(grid, goal, points)


COLUMNS = {  # of the table: heading, width, kind of number
    "input": ("input", "10", ""),
    "faces": ("faces", ">6", ""),
    "goal": ("goal", "10", ""),
    "method": ("method", "14", ""),
    "seconds": ("best s", ">8", ".3f"),
    "seconds_median": ("median s", ">8", ".3f"),
    "steps": ("steps", ">5", ""),
    "residual": ("residual", ">8", ".0e"),
    "distance": ("distance", ">8", ".0e"),
    "nonconvex": ("nonconvex", ">9", ""),
    "movement_rms": ("rms", ">6", ".3f"),
    "movement_max": ("max", ">6", ".3f"),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--sizes", default="50,100,200", help="m of the noisy nets (default: %(default)s)")
    parser.add_argument("--runs", type=int, default=5, help="runs of each method (default: %(default)s)")
    parser.add_argument("--json", help="write a line of JSON for each row to this file")
    parser.add_argument("--write", metavar="DIR", help="write the inputs as OBJ and stop")
    parser.add_argument("--isogeo", metavar="PATH", help="also run this binary")
    options = parser.parse_args()

    nets = [noisy_net(int(m)) for m in options.sizes.split(",") if m]
    cases = [(net, goal) for net in nets for goal in GOALS] + [(patch(32), "planar")]
    if options.write:
        os.makedirs(options.write, exist_ok=True)
        for grid in dict.fromkeys(grid for grid, _ in cases):
            grid.write(os.path.join(options.write, grid.name + ".obj"))
        return

    peers = list(methods(options.isogeo))
    lines = open(options.json or os.devnull, "w")
    print(*(format(head, width) for head, width, _ in COLUMNS.values()))
    for grid, goal in cases:
        for name, run, planarises_only in peers:
            if planarises_only and not grid.name.startswith("patch"):
                continue
            try:
                row = measure(name, run, grid, goal, options.runs)
            except Exception as error:  # a peer that fails does not end the table
                print(f"{name} fails on {grid.name}, {goal}: {error}", file=sys.stderr)
                continue
            cells = (format(format(row[key], kind), width) for key, (_, width, kind) in COLUMNS.items())
            print(*cells, flush=True)
            print(json.dumps(row), file=lines, flush=True)


if __name__ == "__main__":
    main()
