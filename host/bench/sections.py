# SPDX-License-Identifier: BSD-3-Clause
"""How the sections of a scene's cage are turned: against their neighbours and against their slides' radii, in degrees."""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests/external"))
from gltf_file import CAGE, SLIDE, GltfFile, local_matrix  # noqa: E402


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scaled(a, factor):
    return tuple(x * factor for x in a)


def unit(a):
    return scaled(a, 1 / math.sqrt(dot(a, a)))


def quarter(degrees):
    """The angle to the nearest of four directions at right angles: 0 to 45."""
    rest = degrees % 90
    return min(rest, 90 - rest)


def angle_in_plane(a, b, normal):
    """From a to b about the normal, degrees."""
    return math.degrees(math.atan2(dot(cross(a, b), normal), dot(a, b)))


def twist(normal_k, axis_k, normal_h, axis_h):
    """Between two neighbouring sections, as docs/algorithms/measures.md defines it. Unit vectors."""
    if abs(dot(normal_k, normal_h)) > math.cos(math.pi / 4):
        way_out = normal_h if dot(normal_k, normal_h) > 0 else scaled(normal_h, -1)
        turn, cosine = cross(normal_k, way_out), dot(normal_k, way_out)
        # Rodrigues' rotation of normal_k to way_out, for the smaller of their angles.
        part = dot(turn, axis_k) / (1 + cosine)
        turned = tuple(cosine * a + c + t * part for a, c, t in zip(axis_k, cross(turn, axis_k), turn))
        return quarter(angle_in_plane(turned, axis_h, way_out))

    def off(normal, axis, other):
        seen = minus(other, scaled(normal, dot(other, normal)))
        return quarter(angle_in_plane(axis, seen, normal))

    return max(off(normal_k, axis_k, normal_h), off(normal_h, axis_h, normal_k))


def neighbours(triangles, sections):
    """Pairs of sections that bound the same part: triangles hang together but across the edges of sections."""
    def is_section_edge(a, b):
        return sections[a] >= 0 and sections[a] == sections[b]

    leader = list(range(len(triangles)))

    def find(i):
        while leader[i] != i:
            leader[i] = leader[leader[i]]
            i = leader[i]
        return i

    seen = {}
    for i, corners in enumerate(triangles):
        for a, b in zip(corners, corners[1:] + corners[:1]):
            if is_section_edge(a, b):
                continue
            other = seen.setdefault(frozenset((a, b)), i)
            leader[find(i)] = find(other)
    parts = {}
    for i, corners in enumerate(triangles):
        parts.setdefault(find(i), set()).update(sections[v] for v in corners if sections[v] >= 0)
    return {(k, h) for part in parts.values() for k in part for h in part if k < h}


def turns(scene):
    """{mean_twist, worst_twist, mean_off_radii, worst_off_radii} of the one cage of a scene file, whose sections have to be
    rectangles (refine.iterations = 0, enclose.mode = off). A section counts against its slide's radii by how far that is
    from round, w_k of (5b) without lambda; `worst` is of those with w_k above 0.02 (radii 1 to 1.33)."""
    file = GltfFile(scene)
    number, node, cage = file.own_nodes(CAGE)[0]
    points, _ = file.cage_positions(node)
    slides = []
    for row, (_, slide_node, _) in enumerate(file.own_nodes(SLIDE)):
        matrix = local_matrix(slide_node)
        u, v = (tuple(matrix[i][axis] for i in range(3)) for axis in (0, 1))
        corners = [points[i] for i, section in enumerate(cage["sections"]) if section == row]
        slides.append((u, v, unit(cross(u, v)), unit(minus(corners[1], corners[0]))))
    angles = [twist(slides[k][2], slides[k][3], slides[h][2], slides[h][3])
              for k, h in sorted(neighbours(file.cage_triangles(node), cage["sections"]))]
    off = []
    for u, v, normal, axis in slides:
        long, short = math.sqrt(dot(u, u)), math.sqrt(dot(v, v))
        weight = (long - short) ** 2 / (long ** 2 + short ** 2)
        off.append((weight, quarter(angle_in_plane(unit(u), axis, normal))))
    total = sum(weight for weight, _ in off)
    return {"mean_twist": sum(angles) / len(angles), "worst_twist": max(angles),
            "mean_off_radii": sum(weight * angle for weight, angle in off) / total,
            "worst_off_radii": max((angle for weight, angle in off if weight > 0.02), default=0.0)}
