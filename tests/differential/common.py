"""What the scripts share: the program, meshes, and how differences are counted. No geometry."""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

from flint import fmpq

sys.set_int_max_str_digits(0)
ROOT = pathlib.Path(__file__).resolve().parents[2]


def fraction(text):
    """The fraction `p/q` or `p`."""
    p, _, q = text.partition("/")
    return fmpq(int(p), int(q or 1))


class Mesh:
    """Points in fractions and faces, as they stand in an .iso.json file."""

    def __init__(self, points, faces, data=None):
        self.points, self.faces, self.data = points, faces, data or {}

    @staticmethod
    def read(path):
        document = json.loads(pathlib.Path(path).read_text())
        points = [[fraction(c) for c in p] for p in document["vertices"]]
        return Mesh(points, document["faces"], document.get("data"))

    def write(self, path):
        vertices = [[str(c) for c in p] for p in self.points]
        document = {"format": "isogeo-mesh", "version": 1, "field": "QQ"}
        pathlib.Path(path).write_text(json.dumps({**document, "vertices": vertices, "faces": self.faces}))

    def stars(self):
        """Interior vertices with their faces, counter-clockwise for faces that run so."""
        after = {}  # vertex -> {incoming corner: (outgoing corner, face)}
        for f, face in enumerate(self.faces):
            n = len(face)
            for i, v in enumerate(face):
                after.setdefault(v, {})[face[(i + 1) % n]] = (face[i - 1], f)
        stars = {}
        for v, step in sorted(after.items()):
            at = start = next(iter(step))
            around = []
            while at in step:
                at, f = step[at]
                around.append(f)
                if at == start:
                    break
            if at == start and len(around) == len(step):
                stars[v] = around
        return stars


class Comparison:
    """Counts what was compared, and keeps the first differences."""

    def __init__(self, description):
        parser = argparse.ArgumentParser(description=description)
        parser.add_argument("--isogeo", type=pathlib.Path, default=ROOT / "target/release/isogeo", help="the program")
        parser.add_argument("--seed", type=int, default=1, help="of the random meshes")
        parser.add_argument("--disturb", action="store_true", help="change one number: must be found")
        self.options = parser.parse_args()
        self.options.isogeo = self.options.isogeo.resolve()
        self.compared, self.differences = {}, []
        self.temporary = tempfile.TemporaryDirectory(prefix="isogeo-differential-")
        self.folder = pathlib.Path(self.temporary.name)

    def run(self, *arguments, codes=(0,)):
        """The report of the program on some arguments."""
        command = [str(self.options.isogeo), *map(str, arguments), "--format", "json"]
        done = subprocess.run(command, capture_output=True, text=True, cwd=self.folder)
        if done.returncode not in codes:
            sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        return json.loads(done.stdout)

    def same(self, what, ours, theirs, relative=None):
        """Counts a comparison: exact, or within a relative error of rounded numbers."""
        self.compared[what] = self.compared.get(what, 0) + 1
        if self.options.disturb and not isinstance(ours, (set, list, tuple, str)):
            ours, self.options.disturb = ours + 1, False
        elif self.options.disturb and isinstance(ours, (set, list)):
            ours, self.options.disturb = list(ours) + ["disturbed"], False
            theirs = list(theirs)
        if relative is None:
            equal = ours == theirs
        else:
            equal = abs(float(ours) - float(theirs)) <= relative * max(1.0, abs(float(theirs)))
        if not equal:
            self.differences.append((what, ours, theirs))

    def finish(self):
        """Prints the counts, and exits with 1 if there is a difference."""
        for what, count in self.compared.items():
            print(f"  {what}: {count} compared")
        for what, ours, theirs in self.differences[:5]:
            print(f"  DIFFERENCE, {what}: {str(ours)[:200]} here, {str(theirs)[:200]} there")
        print(f"  {len(self.differences)} differences")
        sys.exit(bool(self.differences) or not self.compared)


def double(x):
    """The nearest double of a fraction."""
    return int(x.p) / int(x.q)


def grid_faces(n):
    """The quads over (n+1) x (n+1) vertices."""
    at = lambda i, j: i * (n + 1) + j
    return [[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)] for i in range(n) for j in range(n)]
