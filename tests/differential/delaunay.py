#!/usr/bin/env python3
"""Delaunay meshes: the triangles of `triangulate` and those of scipy, equal up to cocircular ties.

Where the sets of triangles differ, every triangle of either set must have a further point exactly on its
circumcircle and none inside, by determinants of python-flint. Random points, points with ties (a lattice),
and both together.
"""

import random

import numpy as np
from flint import fmpz_mat
from scipy.spatial import Delaunay

from common import Comparison, Mesh


def in_circle(a, b, c, d):
    rows = [[p[0] - d[0], p[1] - d[1], (p[0] - d[0]) ** 2 + (p[1] - d[1]) ** 2] for p in (a, b, c)]
    return int(fmpz_mat(rows).det())


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def ccw(triangle, places):
    a, b, c = triangle
    return (a, b, c) if turn(*(places[i] for i in triangle)) > 0 else (a, c, b)


def is_tie(triangle, places):
    """Whether another point lies on the circumcircle, and none inside."""
    signs = [in_circle(*(places[i] for i in triangle), p) for i, p in enumerate(places) if i not in triangle]
    return max(signs, default=-1) == 0


def main():
    compare = Comparison(__doc__)
    dice = random.Random(compare.options.seed)
    lattice = [(x, y) for x in range(8) for y in range(8)]
    scattered = lambda n, size: list({(dice.randrange(size), dice.randrange(size)) for _ in range(n)})
    cases = [lattice, [(8 * x, 8 * y) for x, y in lattice] + [(4, 4), (12, 4), (33, 37)]]
    cases += [scattered(n, size) for n in (20, 100, 300) for size in (15, 10**4, 10**6)]
    for places in cases:
        places = sorted(set(places))
        dice.shuffle(places)
        (compare.folder / "samples.txt").write_text("".join("%d %d 0\n" % p for p in places))
        compare.run("triangulate", "samples.txt", "-o", "mesh.iso.json")
        mesh = Mesh.read(compare.folder / "mesh.iso.json")
        ours = {frozenset(face) for face in mesh.faces}
        # Triangles without area are no part of a triangulation.
        theirs = {frozenset(map(int, t)) for t in Delaunay(np.array(places, float)).simplices
                  if turn(*(places[i] for i in t)) != 0}
        area = lambda triangles: sum(abs(turn(*(places[i] for i in t))) for t in triangles)
        compare.same("area of the convex hull", area(ours), area(theirs))
        compare.same("number of triangles", len(ours), len(theirs))
        for triangle in ours & theirs:
            compare.same("triangles of both", 0, 0)
        for triangle in ours ^ theirs:
            compare.same("triangles of one, in a tie", int(is_tie(ccw(tuple(triangle), places), places)), 1)
    compare.finish()


main()
