"""Whether triangles are a polygon cut up, however it was cut.

tobj keeps polygons, Glint cuts them into triangles and leaves out those without area. The cut is right where the
triangles' edges, each with its direction, add up to the polygon's outline, edges of both directions cancelling: then
they cover the same surface in the same winding. Corners are told apart by what the dumps print of them.
"""

from collections import defaultdict


def edges_of(outline):
    """The outline's edges, counted: +1 forwards, -1 backwards; none that lead nowhere."""
    counts = defaultdict(int)
    for a, b in zip(outline, outline[1:] + outline[:1]):
        if a < b:
            counts[a, b] += 1
        elif b < a:
            counts[b, a] -= 1
    return counts


def left_over(outline, triangles):
    """The outline's edges that are missing among the triangles', and those that they have besides."""
    counts = edges_of(outline)
    for triangle in triangles:
        for edge, count in edges_of(triangle).items():
            counts[edge] -= count
    return [edge for edge, count in counts.items() if count != 0]


def are_in_a_row(places):
    """As Glint's own rule for triangles without area has it: in double precision, all cross products are zero."""
    a = places[0]
    deltas = [[x - y for x, y in zip(place, a)] for place in places[1:]]
    for u in deltas:
        for v in deltas:
            if u[1] * v[2] != u[2] * v[1] or u[2] * v[0] != u[0] * v[2] or u[0] * v[1] != u[1] * v[0]:
                return False
    return True


def encloses_nothing(edges, place_of):
    """Whether the edges are those of triangles without area: each connected part lies on a line."""
    neighbours = defaultdict(set)
    for a, b in edges:
        neighbours[a].add(b)
        neighbours[b].add(a)
    while neighbours:
        part, ahead = set(), [next(iter(neighbours))]
        while ahead:
            corner = ahead.pop()
            part.add(corner)
            ahead.extend(neighbours.pop(corner, ()))
        if not are_in_a_row([place_of(corner) for corner in sorted(part)]):
            return False
    return True


def first_difference(polygons, triangles, place_of):
    """The number of the first polygon, from 0, that the triangles are not cut from; None where there is none.

    Both are in the file's order, so that a polygon of n corners takes the next n - 2 triangles, or fewer where some had
    no area: which ones are missing, the triangles that follow show.
    """
    missing = sum(len(outline) - 2 for outline in polygons) - len(triangles)
    reached = {0}  # how many triangles all polygons so far can have taken
    for number, outline in enumerate(polygons):
        after = set()
        for begin in reached:
            for taken in range(max(0, len(outline) - 2 - missing), len(outline) - 1):
                edges = left_over(outline, triangles[begin:begin + taken])
                if begin + taken <= len(triangles) and encloses_nothing(edges, place_of):
                    after.add(begin + taken)
        if not after:
            return number
        reached = after
    return None if len(triangles) in reached else len(polygons)
