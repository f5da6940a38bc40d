#!/usr/bin/env python3
"""Dimensions of the spaces of parallel and v-parallel meshes: ranks of python-flint.

Unknown are all coordinates, 3 N of them; the equations are those of the definition, e x e' = 0 for the edges,
and for v-parallel meshes, with N unknown heights, that the corners of a face lie in a plane. The example
`parallel_meshes` solves for factors of edges instead, modulo primes.
"""

import itertools
import random
import subprocess

from flint import fmpq, fmpq_mat, fmpz_mat

from common import ROOT, Comparison, Mesh, grid_faces


def parallel_dimension(mesh):
    n = len(mesh.points)
    edges = {frozenset(e) for face in mesh.faces for e in zip(face, face[1:] + face[:1])}
    rows = []
    for a, b in map(sorted, edges):
        e = [q - p for p, q in zip(mesh.points[a], mesh.points[b])]
        for i, j in ((0, 1), (1, 2), (2, 0)):
            row = [fmpq(0)] * (3 * n)
            row[3 * b + j], row[3 * a + j] = e[i], -e[i]
            row[3 * b + i], row[3 * a + i] = -e[j], e[j]
            rows.append(row)
    return 3 * n - fmpq_mat(rows).rank()


def v_parallel_dimension(mesh):
    n = len(mesh.points)
    rows = []
    for face in mesh.faces:
        for four in itertools.combinations(face, 4):
            flat = [[*mesh.points[v][:2], fmpq(1)] for v in four]
            row = [fmpq(0)] * n
            for i, v in enumerate(four):
                row[v] = (-1) ** i * fmpq_mat(flat[:i] + flat[i + 1 :]).det()
            rows.append(row)
    return n - (fmpq_mat(rows).rank() if rows else 0)


def main():
    compare = Comparison(__doc__)
    dice = random.Random(compare.options.seed)
    meshes = {}
    for n in (1, 2, 3, 4):
        f, g = ([fmpq(dice.randint(-99, 99), 7) for _ in range(n + 1)] for _ in range(2))
        net = [[fmpq(3 * i), fmpq(2 * j), f[i] + g[j]] for i in range(n + 1) for j in range(n + 1)]
        meshes[f"net-{n}"] = Mesh(net, grid_faces(n))
        skew = [[x + fmpq(dice.randint(-9, 9), 10), y, z + dice.randint(-9, 9)] for x, y, z in net]
        meshes[f"skew-{n}"] = Mesh(skew, grid_faces(n))
    for family in ["enneper", "bonnet", "hex-minimal", "triangle-graph"]:
        compare.run("make", family, "--n", "3x4", "-o", family)
        meshes[family] = Mesh.read(compare.folder / family / "surface.iso.json")
    for name, mesh in meshes.items():
        mesh.write(compare.folder / f"{name}.iso.json")
    example = compare.options.isogeo.parent / "examples/parallel_meshes"
    files = [compare.folder / f"{name}.iso.json" for name in meshes]
    lines = subprocess.run([example, *files], check=True, capture_output=True, text=True).stdout.splitlines()
    for line, mesh in zip(lines, meshes.values(), strict=True):
        parallel, v_parallel = (int(word) for word in line.split()[-2:])
        compare.same("parallel meshes: dimensions", parallel, parallel_dimension(mesh))
        compare.same("v-parallel meshes: dimensions", v_parallel, v_parallel_dimension(mesh))
    compare.finish()


main()
