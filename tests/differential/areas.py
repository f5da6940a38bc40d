#!/usr/bin/env python3
"""H and K at faces (17): areas and mixed areas by sympy, exactly, and by Shapely in doubles.

The mixed area is taken by polarisation, area(F + S) - area(F) - area(S) over 2, with the areas of whole
polygons; the curvatures are its quotients.
"""

import shapely
import sympy

from common import Comparison, Mesh, double, fraction


def rational(x):
    return sympy.Rational(int(x.p), int(x.q))


def area(polygon):
    """The signed area, by the boundary integral of sympy."""
    corners = [sympy.Point(rational(x), rational(y), evaluate=False) for x, y in polygon]
    total = sympy.Integer(0)
    for a, b in zip(corners, corners[1:] + corners[:1]):
        total += sympy.Matrix([[a.x, a.y], [b.x, b.y]]).det()
    return total / 2


def shapely_area(polygon):
    ring = shapely.LinearRing([(double(x), double(y)) for x, y in polygon])
    size = shapely.Polygon(ring).area
    return size if ring.is_ccw else -size


def main():
    compare = Comparison(__doc__)
    for family in ["saddle", "enneper", "bonnet", "circular-net", "hex-cmc", "rotational-cmc", "hex-minimal"]:
        compare.run("make", family, "-o", family)
        folder = compare.folder / family
        if not (folder / "gauss.iso.json").exists():
            continue
        m, s = (Mesh.read(folder / name) for name in ("surface.iso.json", "gauss.iso.json"))
        report = compare.run(
            "curvature", f"{family}/surface.iso.json", "--at", "faces", "--integrated",
            "--gauss", f"{family}/gauss.iso.json", codes=(0, 1, 3),
        )
        for entry in report["values"]:
            if "area" not in entry:
                continue
            face = m.faces[entry["face"]]
            flat = [[mesh.points[v][:2] for v in face] for mesh in (m, s)]
            both = [[a + b for a, b in zip(p, q)] for p, q in zip(*flat)]
            exact = [area(p) for p in (*flat, both)]
            mixed = (exact[2] - exact[0] - exact[1]) / 2
            ours = {name: rational(fraction(entry[name])) for name in ("area", "mixed_area", "image_area")}
            compare.same("sympy: area(F)", ours["area"], exact[0])
            compare.same("sympy: area(F, S)", ours["mixed_area"], mixed)
            compare.same("sympy: area(S)", ours["image_area"], exact[1])
            compare.same("sympy: H", rational(fraction(entry["H"])), mixed / exact[0])
            compare.same("sympy: K", rational(fraction(entry["K"])), exact[1] / exact[0])
            if shapely.Polygon([(double(x), double(y)) for x, y in flat[0]]).is_valid:
                compare.same("Shapely: area(F)", float(ours["area"]), shapely_area(flat[0]), 1e-9)
    compare.finish()


main()
