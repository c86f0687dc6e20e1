"""OR-tools' CP-SAT with one worker, on a lattice: sizes are rounded up to it and rooms inward, so that what is found is a
solution; that there is none is proved for the lattice alone."""

import math

import ortools
from ortools.sat.python import cp_model
from quarter import DIRECTIONS, FRONT, axes, run

UNIT = 0.005  # metres
UP, DOWN = (lambda v: math.ceil(v / UNIT - 1e-6)), (lambda v: math.floor(v / UNIT + 1e-6))


class Encoding:
    """Coordinates are of corners in units; `centre` is twice that of the middle, so that it is whole, too."""

    def __init__(self, problem, core):
        self.p, self.model, self.core, self.ids = problem, cp_model.CpModel(), core, {}
        m, (x0, z0, x1, z1) = self.model, problem.room
        self.low, self.yaw, self.extent, self.centre = {}, {}, {}, {}
        rooms = (UP(x0), DOWN(x1)), (UP(z0), DOWN(z1))
        levels = {}
        for i, (w, _, d) in problem.size.items():
            w, d = UP(w), UP(d)
            self.yaw[i] = {y: m.new_bool_var(f"{i}.{y}") for y in problem.yaws[i]}
            m.add_exactly_one(self.yaw[i].values())
            side = sum(v for y, v in self.yaw[i].items() if y % 180)
            self.extent[i] = w + (d - w) * side, d + (w - d) * side
            self.low[i] = tuple(m.new_int_var(lo, hi, f"{i}.{k}") for k, (lo, hi) in enumerate(rooms))
            boxes = []
            for k, (lo, hi) in enumerate(rooms):
                size, end = m.new_int_var(min(w, d), max(w, d), ""), m.new_int_var(lo, hi, "")
                m.add(size == self.extent[i][k])
                boxes.append(m.new_interval_var(self.low[i][k], size, end, ""))
            self.centre[i] = tuple(2 * lo + e for lo, e in zip(self.low[i], self.extent[i]))
            levels.setdefault(problem.bottom[i], []).append((i, boxes))
        for level in levels.values():
            m.add_no_overlap_2d([b[0] for _, b in level], [b[1] for _, b in level])
        names = [(level, i) for level, things in levels.items() for i, _ in things]
        for k, (one, a) in enumerate(names):
            for other, b in names[:k]:
                if one != other and problem.overlap_upright(a, b):
                    self.any_of([self.low[a][j] + self.extent[a][j] <= self.low[b][j] for j in (0, 1)] + [self.low[b][j] + self.extent[b][j] <= self.low[a][j] for j in (0, 1)])

    def any_of(self, choices, when=()):
        picks = [self.model.new_bool_var("") for _ in choices]
        clause = self.model.add_bool_or(picks)
        if when:
            clause.only_enforce_if(*when)
        for pick, choice in zip(picks, choices):
            self.model.add(choice).only_enforce_if(pick)

    def state(self, c):
        m, kind, a, b = self.model, c["kind"], c["a"], c.get("b")
        when = []
        if self.core:
            literal = m.new_bool_var(c["id"])
            self.ids[literal.index] = c["id"]
            m.add_assumption(literal)
            when = [literal]
        def add(condition, *more):
            if condition is True:
                return
            added = m.add(condition)
            if when or more:
                added.only_enforce_if(*when, *more)
        k = "xz".find(c.get("axis", "?"))
        if kind == "order":
            return add(self.centre[a][k] + UP(2 * c["by"]) <= self.centre[b][k])
        if kind == "bound":
            v = self.centre[a][k]
            return add(v <= DOWN(2 * c["value"]) if c["op"] == "<=" else v >= UP(2 * c["value"]))
        if kind == "inside":
            x0, z0, x1, z1 = self.p.rects[c["region"]]
            for j, lo, hi in ((0, x0, x1), (1, z0, z1)):
                add(self.low[a][j] >= UP(lo))
                add(self.low[a][j] + self.extent[a][j] <= DOWN(hi))
            return None
        if kind == "against_wall":
            x0, z0, x1, z1 = self.p.rects[c["region"]]
            for y, v in self.yaw[a].items():
                j = 0 if y % 180 else 1
                if y in (0, 90):
                    add(self.low[a][j] <= DOWN((z0, x0)[y == 90] + 0.05), v)
                else:
                    add(self.low[a][j] + self.extent[a][j] >= UP((z1, x1)[y == 270] - 0.05), v)
            return None
        off = [p - q for p, q in zip(self.centre[a], self.centre[b])]
        if kind == "inline":
            add(off[k] <= DOWN(2 * c["value"]))
            return add(-off[k] <= DOWN(2 * c["value"]))
        if kind == "distance":
            return self.distance(c, off, add)
        if kind == "aligned":
            t = DOWN(2 * 0.05)
            pick = m.new_bool_var("")
            for j, literal in ((0, pick), (1, pick.negated())):
                add(off[j] <= t, literal)
                add(-off[j] <= t, literal)
            return None
        if kind in DIRECTIONS:
            w, _, d = self.p.size[b]
            half, across = (w, d) if kind in ("left_of", "right_of") else (d, w)
            for y, v in self.yaw[b].items():
                u, t = axes(kind, y)
                du, dv = u[0] * off[0] + u[1] * off[1] - UP(half), t[0] * off[0] + t[1] * off[1]
                add(du >= 0, v)
                add(du >= dv - DOWN(across), v)
                add(du >= -dv - DOWN(across), v)
            return None
        if kind == "facing":
            slope = math.floor(math.tan(math.radians(30)) * 1000)
            for y, v in self.yaw[a].items():
                f = FRONT[y]
                along, aside = -(f[0] * off[0] + f[1] * off[1]), f[1] * off[0] - f[0] * off[1]
                add(along >= 0, v)
                add(1000 * aside <= slope * along, v)
                add(-1000 * aside <= slope * along, v)
            return None
        for j in (0, 1):
            # On: a unit less than half of b, for what b was rounded up.
            add(off[j] <= self.extent[b][j] - 2)
            add(-off[j] <= self.extent[b][j] - 2)
        return None

    def distance(self, c, off, add):
        radius = self.p.flat(c)
        if radius is None:
            return
        m, big = self.model, 4 * max(DOWN(v) for v in self.p.room)
        squares = []
        for v in off:
            plain, square = m.new_int_var(-big, big, ""), m.new_int_var(0, big * big, "")
            m.add(plain == v)
            m.add_multiplication_equality(square, [plain, plain])
            squares.append(square)
        bound = 2 * radius / UNIT
        add(sum(squares) <= math.floor(bound * abs(bound)) if c["op"] == "<=" else sum(squares) >= math.ceil(bound * bound))


def solve(problem, limit, core):
    encoding = Encoding(problem, core)
    for c in problem.stated:
        encoding.state(c)
    solver = cp_model.CpSolver()
    solver.parameters.num_workers, solver.parameters.max_time_in_seconds = 1, limit
    answer = solver.solve(encoding.model)
    if answer == cp_model.INFEASIBLE:
        return ("refuted", minimal(problem, encoding, solver)) if core else ("none found", None)
    if answer not in (cp_model.FEASIBLE, cp_model.OPTIMAL):
        return "timeout", None
    found = {}
    for i, (w, _, d) in problem.size.items():
        yaw = next(y for y, v in encoding.yaw[i].items() if solver.value(v))
        found[i] = *(solver.value(v) / 2 * UNIT for v in encoding.centre[i]), yaw
    return "solved", found


def minimal(problem, encoding, solver):
    """CP-SAT's core, then one statement after the other left out of it as long as the rest still contradicts."""
    kept = [encoding.ids[k] for k in solver.sufficient_assumptions_for_infeasibility()]
    for tried in list(kept):
        rest = Encoding(problem, True)
        for c in problem.stated:
            if c["id"] in kept and c["id"] != tried:
                rest.state(c)
        again = cp_model.CpSolver()
        again.parameters.num_workers, again.parameters.max_time_in_seconds = 1, 5
        if again.solve(rest.model) == cp_model.INFEASIBLE:
            kept.remove(tried)
    return kept


run(f"CP-SAT {ortools.__version__}", solve)
