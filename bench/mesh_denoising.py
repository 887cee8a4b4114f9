#!/usr/bin/env python3
"""Noise on an icosphere, smoothed by the vertex rules of schemes and by Taubin's filter. Makes the table of
docs/mesh-fits.md. Needs numpy and the program:

    python3 bench/mesh_denoising.py build/release/subcert

Each vertex of the sphere of radius 1 (2562 of them) is moved along its normal by independent noise of deviation 0.02.
Noise left: root mean square of the difference of the smoothed noisy and the smoothed clean mesh, along the normal; bias:
that of the smoothed clean mesh from the sphere; total: that of the smoothed noisy mesh from the sphere. Taubin: steps
of 0.33 and -0.34 towards the mean of the neighbours [Tau95]; `steps` counts both."""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy


def icosphere(levels):
    g = (1 + 5**0.5) / 2
    points = [numpy.array(p, float) for p in
              ((0, 1, g), (0, -1, g), (0, 1, -g), (0, -1, -g), (1, g, 0), (-1, g, 0), (1, -g, 0), (-1, -g, 0),
               (g, 0, 1), (-g, 0, 1), (g, 0, -1), (-g, 0, -1))]
    edge = 2.0
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b)
             if all(abs(numpy.linalg.norm(points[p] - points[q]) - edge) < 1e-9 for p, q in ((a, b), (b, c), (a, c)))]
    faces = [(a, b, c) if numpy.linalg.det([points[a], points[b], points[c]]) > 0 else (a, c, b) for a, b, c in faces]
    for _ in range(levels):
        middle = {}

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(points[a] + points[b])
            return middle[key]

        faces = [f for a, b, c in faces for x, y, z in [(between(a, b), between(b, c), between(c, a))]
                 for f in ((a, x, z), (b, y, x), (c, z, y), (x, y, z))]
        points = [p / numpy.linalg.norm(p) for p in points]
    return numpy.array(points), faces


def smoothed(program, scheme, steps, points, faces):
    with tempfile.TemporaryDirectory() as folder:
        data, out = Path(folder) / "in.obj", Path(folder) / "out.obj"
        data.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
                        + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))
        subprocess.run([program, "smooth", data, "--scheme", scheme, "--steps", str(steps), "--out", out, "--quiet"],
                       check=True)
        return numpy.array([line.split()[1:] for line in out.read_text().splitlines() if line.startswith("v ")], float)


def taubin(steps, points, faces):
    corners = numpy.array(faces)
    starts, ends = corners.ravel(), numpy.roll(corners, -1, axis=1).ravel()
    count = numpy.bincount(starts, minlength=len(points))[:, None]
    for step in range(steps):
        sums = numpy.zeros_like(points)
        numpy.add.at(sums, starts, points[ends])
        points = points + (0.33 if step % 2 == 0 else -0.34) * (sums / count - points)
    return points


def main():
    program = sys.argv[1]
    clean, faces = icosphere(4)
    noise = 0.02 * numpy.random.default_rng(1).standard_normal(len(clean))
    noisy = clean * (1 + noise[:, None])
    rms = lambda values: float(numpy.sqrt(numpy.mean(values**2)))
    print("| rule | steps | noise left | bias | total |\n|---|---|---|---|---|")
    print(f"| none | 0 | {rms(noise):.5f} | 0 | {rms(noise):.5f} |")
    schemes = ["loop", "triangular:L=17/10,d=1", "triangular:L=17/10,d=1,power=1", "triangular:L=17/10,d=1,power=2"]
    rows = [(f"`{s}`", n, lambda p, s=s, n=n: smoothed(program, s, n, p, faces)) for s in schemes for n in (1, 3, 10)]
    rows += [("Taubin", n, lambda p, n=n: taubin(n, p, faces)) for n in (2, 10, 40)]
    for name, steps, rule in rows:
        of_clean, of_noisy = rule(clean), rule(noisy)
        left = rms(numpy.sum((of_noisy - of_clean) * clean, axis=1))
        bias = rms(numpy.linalg.norm(of_clean, axis=1) - 1)
        total = rms(numpy.linalg.norm(of_noisy, axis=1) - 1)
        print(f"| {name} | {steps} | {left:.5f} | {bias:.5f} | {total:.5f} |")


if __name__ == "__main__":
    main()
