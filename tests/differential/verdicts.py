#!/usr/bin/env python3
"""Verdicts of `check`: the faces and vertices that fail, by determinants of python-flint and of sympy.

planar, i-circular, i-conical, inscribed, a-net and Euclidean circular are decided from their definitions:
ranks of lifted points. Meshes: random grids, translational nets, exact families, and copies of them with
one coordinate moved by a millionth.
"""

import itertools
import random

import sympy
from flint import fmpq, fmpq_mat

from common import ROOT, Comparison, Mesh, grid_faces


def rank(rows):
    return fmpq_mat(rows).rank()


def is_planar(points):
    return rank([[*p, 1] for p in points]) <= 3


def is_concyclic(places):
    """Whether points of the plane lie on one circle, by all determinants of four."""
    rows = [[x * x + y * y, x, y, 1] for x, y in places]
    return all(fmpq_mat(list(four)).det() == 0 for four in itertools.combinations(rows, 4))


def is_circular_in_space(points):
    rows = [[sum((c * c for c in p), fmpq(0)), *p, 1] for p in points]
    return is_planar(points) and rank(rows) <= 3


def gradient(points):
    """The gradient of the plane through the first three corners that span one."""
    for a, b, c in itertools.combinations(points, 3):
        m = fmpq_mat([[a[0], a[1], 1], [b[0], b[1], 1], [c[0], c[1], 1]])
        if m.det() != 0:
            s = m.solve(fmpq_mat([[a[2]], [b[2]], [c[2]]]))
            return s[0, 0], s[1, 0]


def failures(mesh):
    """The elements that fail each property."""
    corners = [[mesh.points[v] for v in face] for face in mesh.faces]
    stars = mesh.stars()
    planar = [is_planar(c) for c in corners]
    gradients = [gradient(c) for c in corners]
    faces = range(len(corners))
    return {
        "planar": [f for f in faces if not planar[f]],
        "i-circular": [
            f for f in faces if not (planar[f] and is_concyclic([p[:2] for p in corners[f]]))
        ],
        "circular": [f for f in faces if not is_circular_in_space(corners[f])],
        "i-conical": [
            v
            for v, around in stars.items()
            if not (all(planar[f] for f in around) and is_concyclic([gradients[f] for f in around]))
        ],
        "inscribed": [v for v, (x, y, z) in enumerate(mesh.points) if 2 * z != x * x + y * y],
        "a-net": [
            v
            for v, around in stars.items()
            if not is_planar(
                [mesh.points[v]] + [mesh.points[w] for w in neighbours(mesh, v, around)]
            )
        ],
    }


def neighbours(mesh, v, around):
    return {w for f in around for w in next_to(mesh.faces[f], v)}


def next_to(face, v):
    i = face.index(v)
    return face[i - 1], face[(i + 1) % len(face)]


def meshes(compare):
    dice = random.Random(compare.options.seed)
    n = 6
    number = lambda: fmpq(dice.randint(-(10**6), 10**6), dice.randint(1, 10**3))
    base = [[fmpq(10 * i), fmpq(10 * j)] for i in range(n + 1) for j in range(n + 1)]
    moved = [[x + fmpq(dice.randint(-9, 9), 7), y + fmpq(dice.randint(-9, 9), 7)] for x, y in base]
    yield Mesh([[*p, number()] for p in moved], grid_faces(n))
    f, g = [number() for _ in range(n + 1)], [number() for _ in range(n + 1)]
    net = [[*base[i * (n + 1) + j], f[i] + g[j]] for i in range(n + 1) for j in range(n + 1)]
    yield Mesh(net, grid_faces(n))
    yield Mesh([[x, y, (x * x + y * y) / 2] for x, y in moved], grid_faces(n))
    yield Mesh.read(ROOT / "meshes/shell.iso.json")
    for family in ["enneper", "circular-net", "conical-net", "hex-minimal", "helicoid", "bonnet"]:
        compare.run("make", family, "-o", family)
        yield Mesh.read(compare.folder / family / "surface.iso.json")


def main():
    compare = Comparison(__doc__)
    compare.dice = random.Random(compare.options.seed)
    for mesh in meshes(compare):
        spoilt = Mesh([list(p) for p in mesh.points], mesh.faces)
        spoilt.points[compare.dice.randrange(len(spoilt.points))][compare.dice.randrange(3)] += fmpq(1, 10**6)
        for m in (mesh, spoilt):
            m.write(compare.folder / "mesh.iso.json")
            theirs = failures(m)
            report = compare.run("check", "mesh.iso.json")
            for entry in report["properties"]:
                name = entry["property"]
                if name in theirs:
                    undefined = {e.get("face", e.get("vertex")) for e in entry["undefined_at"]}
                    ours = sorted(e.get("face", e.get("vertex")) for e in entry["failures"])
                    compare.same(f"{name}: meshes, all elements that fail", ours, sorted(set(theirs[name]) - undefined))
    # The determinants themselves by another library.
    dice = compare.dice
    for _ in range(20):
        quad = [[dice.randint(-99, 99) for _ in range(3)] for _ in range(4)]
        rows = [[*p, 1] for p in quad]
        ours = Mesh([[fmpq(c) for c in p] for p in quad], [[0, 1, 2, 3]])
        ours.write(compare.folder / "mesh.iso.json")
        report = compare.run("check", "mesh.iso.json", "--is", "planar", codes=(0, 1, 3))
        failed = len(report["properties"][0]["failures"])
        compare.same("sympy: planarity of single quads", failed, int(sympy.Matrix(rows).det() != 0))
    compare.finish()


main()
