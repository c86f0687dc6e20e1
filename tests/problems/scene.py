"""A problem as a program: one statement for each constraint, with its id as the requirement it answers."""

import kinds
from hidden import bounds

n = kinds.number


def vector(*values):
    return f"vec3({', '.join(n(v) for v in values)})"


def program(facts):
    counted = [c for c in facts["constraints"] if not c.get("given")]
    hard = sum(1 for c in counted if not c.get("weight"))
    out = [f"// {facts['id']}: {len(facts['objects'])} objects, {hard} constraints, {len(counted) - hard} preferences"]
    for region in facts["regions"]:
        name, corners = region["id"], region["polygon"]
        x0, z0, x1, z1 = bounds(corners)
        out.append(f"region {name};")
        out.append(f"{name}.pos <- {vector((x0 + x1) / 2, region['floor'], (z0 + z1) / 2)};")
        out.append(f"{name}.scale <- {vector(x1 - x0, region['height'], z1 - z0)};")
        if len(corners) != 4:
            out.append(f"{name}.vertices <- polygon({', '.join(vector(x, 0, z) for x, z in corners)});")
    declared = set()
    for thing in facts["objects"]:
        name = thing.get("array", thing["id"])
        if name not in declared:
            declared.add(name)
            count = sum(1 for t in facts["objects"] if t.get("array") == name)
            out.append(f"object {name}[{count}];" if count else f"object {name};")
            out.append(f"{name}.dimensions <- {vector(*thing['size'])};")
    for constraint in facts["constraints"]:
        formula = kinds.sentence(constraint)
        if constraint.get("given"):
            out.append(f"assert {formula};")
        elif constraint.get("weight"):
            out.append(f'@req("{constraint["id"]}") prefer {formula} weight {n(constraint["weight"])};')
        else:
            out.append(f'@req("{constraint["id"]}") assert {formula};')
    return "\n".join(out) + "\n"
