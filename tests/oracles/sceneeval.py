#!/usr/bin/env python3
"""Scores boxes by SceneEval's own geometry code, to compare with ours.

usage: sceneeval.py CHECKOUT < cases.jsonl

CHECKOUT is a copy of its repository (github.com/3dlg-hcvc/SceneEval); only its folder `spatial` is used, with the thresholds of
its configuration. It needs numpy. Each line has boxes in the frame of a layout and the names of relations; for each line the scores
are printed, in the same order. What its code asks of a library of meshes (rays, nearest points) is answered here for boxes
and floors. Its random points are replaced by many even ones, so that scores are those it tends to.
"""

import functools
import json
import sys
import types

import numpy as np

# Points in each box: of pairs of objects, and where there are walls, too.
POINTS, FEWER = 600_000, 150_000
# From the frame of a layout (x right, y up, z front; left-handed) to SceneEval's (front -y, z up): a thing's own right is -x.
MAP = np.array([[-1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
WALL = 0.08


def even(count):
    """Points that fill the cube from -1 to 1 evenly (an additive recurrence), and its corners."""
    g = 1.2207440846057596
    steps = (np.arange(1, count + 1)[:, None] * np.array([1 / g, 1 / g**2, 1 / g**3]) + 0.5) % 1
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    return np.vstack([steps * 2 - 1, corners])


def shell(n=40):
    """A grid on the surface of the cube from -1 to 1."""
    line = np.linspace(-1, 1, n)
    u, v = (grid.ravel() for grid in np.meshgrid(line, line))
    faces = []
    for axis in range(3):
        for side in (-1.0, 1.0):
            face = np.full((n * n, 3), side)
            face[:, (axis + 1) % 3], face[:, (axis + 2) % 3] = u, v
            faces.append(face)
    return np.vstack(faces)


EVEN, FEW, SHELL = even(POINTS), even(FEWER), shell()


class Mesh:
    """What is asked of a box as a mesh."""

    def __init__(self, box):
        self.box = box
        self.ray = self.nearest = self.bounding_box_oriented = self

    def local(self, points):
        return (np.asarray(points) - self.box.centroid) @ self.box.coord_axes

    def world(self, points):
        return points @ self.box.coord_axes.T + self.box.centroid

    def sample_volume(self, _count):
        return self.world(SHELL * self.box.half_size)

    def on_surface(self, points):
        """Nearest points; of the distances the least, which is all that is asked for."""
        local, half = self.local(points), self.box.half_size
        near = np.clip(local, -half, half)
        inside = np.all(near == local, axis=1)
        axis = np.argmin(half - np.abs(local), axis=1)
        rows = np.nonzero(inside)[0]
        near[rows, axis[rows]] = np.where(local[rows, axis[rows]] >= 0, 1, -1) * half[axis[rows]]
        return self.world(near), [np.linalg.norm(near - local, axis=1).min()], None

    def intersects_location(self, origins, ways, multiple_hits=False):
        local, way = self.local(origins), np.asarray(ways) @ self.box.coord_axes
        with np.errstate(divide="ignore", invalid="ignore"):
            a, b = (-self.box.half_size - local) / way, (self.box.half_size - local) / way
        enters, leaves = np.nanmax(np.minimum(a, b), axis=1), np.nanmin(np.maximum(a, b), axis=1)
        hit = (leaves >= enters) & (leaves >= 0)
        at = np.where(enters >= 0, enters, leaves)[hit, None]
        return np.asarray(origins)[hit] + at * np.asarray(ways)[hit], np.nonzero(hit)[0], None


class Floor:
    """What is asked of a floor, or of a ceiling, as a mesh: an outline at a height."""

    def __init__(self, outline, height):
        self.outline, self.height = outline, height
        self.ray = self.nearest = self

    def copy(self):
        return Floor(self.outline, self.height)

    def apply_translation(self, by):
        self.height += by[2]

    def over(self, points):
        x, y = points[:, 0], points[:, 1]
        inside = np.zeros(len(points), bool)
        for a, b in zip(self.outline, np.roll(self.outline, -1, axis=0)):
            with np.errstate(divide="ignore", invalid="ignore"):
                cross = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])
            inside ^= ((a[1] > y) != (b[1] > y)) & (x < cross)
        return inside

    def intersects_location(self, origins, _ways, multiple_hits=False):
        origins = np.asarray(origins)
        hit = self.over(origins) & (origins[:, 2] >= self.height)
        return origins[hit], np.nonzero(hit)[0], None

    def on_surface(self, points):
        off = np.full(len(points), np.inf)
        for a, b in zip(self.outline, np.roll(self.outline, -1, axis=0)):
            along = np.clip((points[:, :2] - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
            off = np.minimum(off, np.linalg.norm(points[:, :2] - a - along[:, None] * (b - a), axis=1))
        off[self.over(points)] = 0
        return None, [np.hypot(off, points[:, 2] - self.height).min()], None


def stand_ins():
    """Modules that the code imports for the names in its annotations."""
    for name in ("trimesh", "omegaconf", "matplotlib", "matplotlib.pyplot"):
        sys.modules[name] = types.ModuleType(name)
    sys.modules["omegaconf"].DictConfig = type("DictConfig", (dict,), {})
    sys.modules["matplotlib"].pyplot = sys.modules["matplotlib.pyplot"]
    sys.modules["matplotlib.pyplot"].Axes = object
    trimesh = sys.modules["trimesh"]
    trimesh.Trimesh = object
    trimesh.primitives = types.SimpleNamespace(Box=object)
    trimesh.util = types.SimpleNamespace(concatenate=lambda floors: floors[0])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    stand_ins()
    sys.path.insert(0, sys.argv[1])
    from spatial.arch_relation import ArchitecturalRelationEvaluator
    from spatial.bounding_box import BoundingBox, BoundingBoxConfig
    from spatial.config import ArchitecturalRelationConfig, SpatialRelationConfig
    from spatial.spatial_relation import SpatialRelationEvaluator

    # As metrics.yaml has it; the other defaults are the same in both.
    between = SpatialRelationEvaluator(SpatialRelationConfig(on_top={"no_contain": False, "within_area_margin": 1e-9}))
    places = ArchitecturalRelationEvaluator(ArchitecturalRelationConfig())

    def framed(centre, half, columns, points=FEW):
        made = BoundingBox(MAP @ centre, np.array(half), np.column_stack(columns), cfg=BoundingBoxConfig())
        # One version of the code asks the box for what its configuration has.
        made.epsilon, made.sample_points_per_unit_volume = made.cfg.epsilon, made.cfg.sample_points_per_unit_volume
        made.sample_points = functools.cache(lambda: points * made.half_size @ made.coord_axes.T + made.centroid)
        return made

    def box(told, points):
        (x, y, z), (w, h, d) = told["pos"], told["scale"]
        turn = np.radians(told["yaw"])
        right, front = np.array([np.cos(turn), 0, -np.sin(turn)]), np.array([np.sin(turn), 0, np.cos(turn)])
        columns = [MAP @ -right, MAP @ -front, np.array([0, 0, 1.0])]
        return framed(np.array([x, y + h / 2, z]), [w / 2, d / 2, h / 2], columns, points)

    def room(told):
        outline = np.array([(MAP @ [x, 0, z])[:2] for x, z in told["outline"]])
        low, high = outline.min(axis=0), outline.max(axis=0)
        height, middle = told["height"], np.append(outline.mean(axis=0), 0)
        floor = Floor(outline, 0.0)
        bounds = framed(MAP.T @ np.append((low + high) / 2, 0), np.append((high - low) / 2, 0), np.eye(3))
        walls = []
        for a, b in zip(outline, np.roll(outline, -1, axis=0)):
            along = np.append(b - a, 0)
            right = along / np.linalg.norm(along)
            back = np.cross([0, 0, 1.0], right)
            foot = np.append((a + b) / 2, height / 2)
            # Of the two sides the one that the floor is on is the front.
            if floor.over(np.array([foot - back * 0.01]))[0] == floor.over(np.array([foot + back * 0.01]))[0]:
                raise ValueError(f"no side of a wall is inside: {middle}")
            if floor.over(np.array([foot + back * 0.01]))[0]:
                right, back = -right, -back
            half = [np.linalg.norm(along) / 2, WALL / 2, height / 2]
            walls.append(framed(MAP.T @ (foot + back * WALL / 2), half, [right, back, np.array([0, 0, 1.0])]))
        return floor, bounds, walls

    def pair(relation, target, reference):
        told = {
            "target_bbox": target, "reference_bbox": reference,
            "target_t_obj": Mesh(target), "reference_t_obj": Mesh(reference),
        }
        sides = {"left": "left", "right": "right", "front": "front", "behind": "back", "above": "top", "below": "bottom"}
        names = {
            "on-top": between.on_top, "next": between.next_to, "near": between.near, "across": between.across_from,
            "facing": between.face_to, "inside": between.inside_of, "middle": between.middle_of,
        }
        if relation in sides:
            return between.side_of(**told, side=sides[relation])
        if relation.endswith("-side"):
            return between.long_short_side_of(**told, side=relation.removesuffix("-side"))
        return names[relation](**told)

    def place(relation, thing, floor, bounds, walls, openings):
        meshes = [Mesh(wall) for wall in walls]
        told = {
            "obj_bbox": thing, "obj_t_obj": Mesh(thing), "floor_t_objs": [floor], "floor_bboxes": [bounds],
            "wall_t_objs": meshes, "wall_bboxes": walls, "door_t_objs": openings, "window_t_objs": [],
        }
        names = {
            "opening-next": places.next_to, "opening-near": places.near, "opening-across": places.across_from,
            "opening-far": places.far, "near-wall": places.near, "corner": places.corner_of_room,
            "in-middle": places.middle_of_room, "on-wall": places.on_wall, "against-wall": places.against_wall,
            "on-ceiling": places.hang_from_ceiling, "in-room": places.inside_room,
        }
        told["architectural_element_type"] = "door" if relation.startswith("opening") else "wall"
        return names[relation](**told)

    for line in sys.stdin:
        case = json.loads(line)
        boxes = [box(told, FEW if "room" in case else EVEN) for told in case["boxes"]]
        if "room" in case:
            floor, bounds, walls = room(case["room"])
            openings = [Mesh(opening) for opening in boxes[1:]]
            scores = [place(name, boxes[0], floor, bounds, walls, openings) for name in case["relations"]]
        elif case["relations"] == ["surround"]:
            scores = [between.surround(boxes[1:], boxes[0])]
        else:
            scores = [pair(name, boxes[1], boxes[0]) for name in case["relations"]]
        print(json.dumps([max(0.0, float(score)) for score in scores]), flush=True)


if __name__ == "__main__":
    main()
