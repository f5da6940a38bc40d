#!/usr/bin/env python3
"""H and K at vertices (22) of triangle meshes with their lift: operators of libigl, areas of Shapely.

With the cotangent matrix L of the top view, D(v, s) is (L f)(v) / 2 and D(s) the quarter of the sum of the
weights times the squared lengths; D(v) is the area of the polygon of gradients, which igl.grad gives.
"""

import random

import igl
import numpy as np
import shapely

from common import Comparison, Mesh, double, fraction

WITHIN = 1e-8


def main():
    compare = Comparison(__doc__)
    dice = random.Random(compare.options.seed)
    for n in (30, 100, 300):
        places = {(dice.randint(0, 4000), dice.randint(0, 4000)) for _ in range(n)}
        samples = [(x, y, dice.randint(-1000, 1000)) for x, y in sorted(places)]
        (compare.folder / "samples.txt").write_text("".join("%d %d %d\n" % p for p in samples))
        compare.run("triangulate", "samples.txt", "-o", "mesh.iso.json")
        mesh = Mesh.read(compare.folder / "mesh.iso.json")
        for m in (mesh, moved(mesh, dice)):
            m.write(compare.folder / "mesh.iso.json")
            report = compare.run("curvature", "mesh.iso.json", "--at", "vertices", "--integrated", codes=(0, 1, 3))
            v = np.array([[double(c) for c in p] for p in m.points])
            f = np.array(m.faces, dtype=np.int64)
            flat = v * [1, 1, 0]
            laplacian = igl.cotmatrix(flat, f)
            weights = laplacian.tocoo()
            squares = np.sum((flat[weights.row] - flat[weights.col]) ** 2, axis=1) * weights.data
            image_measure = np.bincount(weights.row, squares, len(v)) / 4
            mixed_measure = laplacian @ v[:, 2] / 2
            gradients = (igl.grad(flat, f) @ v[:, 2]).reshape(3, len(f)).T
            stars = m.stars()
            for entry in report["values"]:
                if "measure" not in entry:
                    continue
                vertex = entry["vertex"]
                ours = {name: float_of(entry[name]) for name in
                        ("measure", "mixed_measure", "image_measure", "H", "K")}
                compare.same("libigl: D(v, s)", ours["mixed_measure"], mixed_measure[vertex], WITHIN)
                compare.same("libigl: D(s)", ours["image_measure"], image_measure[vertex], WITHIN)
                h = mixed_measure[vertex] / image_measure[vertex]
                compare.same("libigl: H", ours["H"], h, WITHIN)
                polygon = gradients[stars[vertex]][:, :2]
                measure = signed(polygon)
                compare.same("libigl, Shapely: D(v)", ours["measure"], measure, WITHIN)
                compare.same("libigl, Shapely: K", ours["K"], measure / image_measure[vertex], WITHIN)
    compare.finish()


def moved(mesh, dice):
    """Vertices go far enough that edges are no longer Delaunay, and angles obtuse; no triangle is turned over,
    since libigl takes areas and cotangents without signs."""
    m = Mesh([list(p) for p in mesh.points], mesh.faces)
    for v, point in enumerate(m.points):
        before = list(point)
        point[:2] = [c + dice.randint(-300, 300) for c in point[:2]]
        if any(turn(*(m.points[w] for w in face)) <= 0 for face in m.faces if v in face):
            point[:] = before
    return m


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def signed(polygon):
    """The signed area of a polygon that may cross itself: by triangles of Shapely from its first corner."""
    total = 0.0
    for a, b in zip(polygon[1:], polygon[2:]):
        ring = shapely.LinearRing([polygon[0], a, b])
        size = shapely.Polygon(ring).area
        total += size if ring.is_ccw else -size
    return total


def float_of(text):
    return double(fraction(text))


main()
