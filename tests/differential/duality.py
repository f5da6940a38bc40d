#!/usr/bin/env python3
"""Metric duals, offsets and the map (12) to Euclidean space: by linear systems of python-flint, exactly.

The dual of a face is found from its plane, which solves a linear system; a vertex of the image under (12)
solves that of the oriented planes n x + h = 0 of the vertices of a face, n = (2a, 2b, 1 - a2 - b2)/(1 + a2 + b2)
and h = 2c/(1 + a2 + b2), all of which must go through it.
"""

from flint import fmpq, fmpq_mat

from common import ROOT, Comparison, Mesh


def solve(rows, right):
    """The solution of a linear system of full rank; `None` where an equation fails or it is not unique."""
    reduced, rank = fmpq_mat([[*row, r] for row, r in zip(rows, right)]).rref()
    n = len(rows[0])
    if rank != n or any(reduced[i, i] != 1 for i in range(n)):
        return None
    return [reduced[i, n] for i in range(n)]


def cyclic(face):
    i = face.index(min(face))
    return face[i:] + face[:i]


def dual(compare, name):
    compare.run("dual", name, "-o", "dual.iso.json")
    m, d = Mesh.read(compare.folder / name), Mesh.read(compare.folder / "dual.iso.json")
    for face, point in zip(m.faces, d.points):
        corners = [m.points[v] for v in face]
        p, q, t = solve([[x, y, 1] for x, y, _ in corners], [z for _, _, z in corners])
        compare.same("poles of face planes", point, [p, q, -t])
    stars = [cyclic(around) for around in m.stars().values()]
    turned = [cyclic(around[::-1]) for around in m.stars().values()]
    faces = [cyclic(f) for f in d.faces]
    compare.same("faces of the dual", faces if faces != turned else stars, stars)


def offset(compare, name, gauss, distance):
    compare.run("offset", name, "--gauss", gauss, "-d", distance, "-o", "offset.iso.json")
    m, s, o = (Mesh.read(compare.folder / n) for n in (name, gauss, "offset.iso.json"))
    d = fmpq(*map(int, distance.split("/")))
    for p, q, r in zip(m.points, s.points, o.points):
        compare.same("vertices of offsets", r, [a + d * b for a, b in zip(p, q)])


def euclidean(compare, name):
    compare.run("transfer", name, "--to", "euclidean", "-o", "euclidean.iso.json", codes=(0, 3))
    m, e = Mesh.read(compare.folder / name), Mesh.read(compare.folder / "euclidean.iso.json")
    planes = []
    for a, b, c in m.points:
        n = 1 + a * a + b * b
        planes.append(([2 * a / n, 2 * b / n, (2 - n) / n], 2 * c / n))
    for face, point in zip(m.faces, e.points):
        found = solve([planes[v][0] for v in face], [-planes[v][1] for v in face])
        compare.same("vertices under (12)", point, found)


def main():
    compare = Comparison(__doc__)
    shell = Mesh.read(ROOT / "meshes/shell.iso.json")
    shell.write(compare.folder / "shell.iso.json")
    dual(compare, "shell.iso.json")
    euclidean(compare, "shell.iso.json")
    for family in ["enneper", "circular-net", "conical-net", "bonnet"]:
        compare.run("make", family, "-o", family)
        dual(compare, f"{family}/surface.iso.json")
        offset(compare, f"{family}/surface.iso.json", f"{family}/gauss.iso.json", "-5/7")
    euclidean(compare, "circular-net/surface.iso.json")
    compare.finish()


main()
