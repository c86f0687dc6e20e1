"""z3: real coordinates, a Boolean for each yaw, all pairs apart by a disjunction.

Distances are circles, which are made polygons: inner ones (16 sides) where a solution is sought, so that what is found
is one; outer ones (64 sides) for contradictions, so that they are proofs.
"""

import math

import z3
from quarter import DIRECTIONS, FRONT, axes, run


def q(value):
    return z3.RealVal(f"{value:.6f}")


class Encoding:
    def __init__(self, problem, outer):
        self.p, self.outer = problem, outer
        self.x = {i: z3.Real(f"x.{i}") for i in problem.size}
        self.z = {i: z3.Real(f"z.{i}") for i in problem.size}
        self.yaw = {i: {y: z3.Bool(f"{i}.{y}") for y in ys} for i, ys in problem.yaws.items()}
        self.half = {}
        for i, (w, _, d) in problem.size.items():
            side = z3.Or([v for y, v in self.yaw[i].items() if y % 180])
            self.half[i] = z3.If(side, q(d / 2), q(w / 2)), z3.If(side, q(w / 2), q(d / 2))

    def given(self):
        x0, z0, x1, z1 = (q(v) for v in self.p.room)
        names = list(self.p.size)
        for i in names:
            hx, hz = self.half[i]
            yield z3.PbEq([(v, 1) for v in self.yaw[i].values()], 1)
            yield z3.And(self.x[i] - hx >= x0, self.x[i] + hx <= x1, self.z[i] - hz >= z0, self.z[i] + hz <= z1)
        for k, a in enumerate(names):
            for b in names[:k]:
                if self.p.overlap_upright(a, b):
                    hx, hz = self.half[a][0] + self.half[b][0], self.half[a][1] + self.half[b][1]
                    dx, dz = self.x[a] - self.x[b], self.z[a] - self.z[b]
                    yield z3.Or(dx >= hx, -dx >= hx, dz >= hz, -dz >= hz)

    def by_yaw(self, name, of):
        return z3.And([z3.Implies(v, of(y)) for y, v in self.yaw[name].items()])

    def formula(self, c):
        kind, a, b = c["kind"], c["a"], c.get("b")
        centre = {"x": self.x, "z": self.z}
        if kind == "order":
            return centre[c["axis"]][a] + q(c["by"]) <= centre[c["axis"]][b]
        if kind == "bound":
            v = centre[c["axis"]][a]
            return v <= q(c["value"]) if c["op"] == "<=" else v >= q(c["value"])
        if kind == "inline":
            off = centre[c["axis"]][a] - centre[c["axis"]][b]
            return z3.And(off <= q(c["value"]), -off <= q(c["value"]))
        if kind == "inside":
            x0, z0, x1, z1 = (q(v) for v in self.p.rects[c["region"]])
            hx, hz = self.half[a]
            return z3.And(self.x[a] - hx >= x0, self.x[a] + hx <= x1, self.z[a] - hz >= z0, self.z[a] + hz <= z1)
        if kind == "against_wall":
            x0, z0, x1, z1 = self.p.rects[c["region"]]
            back = self.p.size[a][2] / 2 + 0.05
            at = {0: self.z[a] - q(z0 + back) <= 0, 90: self.x[a] - q(x0 + back) <= 0, 180: self.z[a] >= q(z1 - back), 270: self.x[a] >= q(x1 - back)}
            return self.by_yaw(a, lambda y: at[y])
        dx, dz = self.x[a] - self.x[b], self.z[a] - self.z[b]
        if kind == "distance":
            return self.circle(dx, dz, self.p.flat(c), c["op"])
        if kind == "aligned":
            return z3.Or(z3.And(dx <= q(0.05), -dx <= q(0.05)), z3.And(dz <= q(0.05), -dz <= q(0.05)))
        if kind in DIRECTIONS:
            w, _, d = self.p.size[b]
            half, across = (w / 2, d / 2) if kind in ("left_of", "right_of") else (d / 2, w / 2)
            def beyond(yaw):
                u, v = axes(kind, yaw)
                du, dv = u[0] * dx + u[1] * dz - q(half), v[0] * dx + v[1] * dz
                return z3.And(du >= 0, du >= dv - q(across), du >= -dv - q(across))
            return self.by_yaw(b, beyond)
        if kind == "facing":
            def looks(yaw):
                f = FRONT[yaw]
                along, aside = -(f[0] * dx + f[1] * dz), f[1] * dx - f[0] * dz
                slope = q(math.tan(math.radians(30)) + (1e-6 if self.outer else -1e-6))
                return z3.And(along >= 0, aside <= slope * along, -aside <= slope * along)
            return self.by_yaw(a, looks)
        # on: the middle of a over b; the height is given.
        hx, hz = self.half[b]
        return z3.And(dx <= hx, -dx <= hx, dz <= hz, -dz <= hz)

    def circle(self, dx, dz, radius, op):
        if radius is None:
            return z3.BoolVal(True)
        if radius < 0:
            return z3.BoolVal(False)
        sides = 64 if self.outer else 16
        if (op == "<=") != self.outer:
            radius *= math.cos(math.pi / sides)
        ways = [(math.cos(2 * math.pi * k / sides), math.sin(2 * math.pi * k / sides)) for k in range(sides)]
        reach = [q(u) * dx + q(v) * dz for u, v in ways]
        return z3.And([r <= q(radius) for r in reach]) if op == "<=" else z3.Or([r >= q(radius) for r in reach])


def solve(problem, limit, core):
    encoding = Encoding(problem, outer=core)
    solver = z3.Solver()
    solver.set("timeout", int(limit * 1000))
    solver.add(list(encoding.given()))
    if core:
        solver.set("core.minimize", True)
        for c in problem.stated:
            solver.assert_and_track(encoding.formula(c), c["id"])
    else:
        solver.add([encoding.formula(c) for c in problem.stated])
    answer = solver.check()
    if answer == z3.unsat:
        return ("refuted", [str(c) for c in solver.unsat_core()]) if core else ("none found", None)
    if answer != z3.sat:
        return "timeout", None
    model = solver.model()
    def value(term):
        return float(model.eval(term, model_completion=True).as_fraction())
    found = {}
    for i, yaws in encoding.yaw.items():
        yaw = next(y for y, v in yaws.items() if z3.is_true(model.eval(v, model_completion=True)))
        found[i] = value(encoding.x[i]), value(encoding.z[i]), yaw
    return "solved", found


run(f"z3 {z3.get_version_string()}", solve)
