"""A manifest for `scenelang batch` of many good lines and a twentieth of poisoned ones, spread among them.

    python3 tests/scale/manifest.py -n 1000 -o jobs.jsonl
"""

import argparse
import json
import pathlib
import random

ROOM = """region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3({width}, 2.6, {depth});
object desk; desk.category <- "desk"; object chair; chair.category <- "chair";
object box[{boxes}]; box.dimensions <- vec3(rand(0.2, 0.5), 0.4, 0.3); box.color <- oneOf("red", "green", "blue");
assert againstWall(desk, room) and near(chair, desk, 0.5) and gap(box[0], desk) >= 0.5;
"""
REQUESTS = [
    "a bedroom with a double bed, two nightstands and a wardrobe",
    "a study with a desk by the window and a bookshelf",
    "a small kitchen with a fridge and a table for four",
    "a living room with a sofa, a coffee table and a television",
]
NEVER = 'region room; room.scale <- vec3(4, 2.6, 4); object a; assert a.pos.x > {x}; assert a.pos.x < {x} - 0.5;'
# More than there is room for, and nothing that proves it at once.
LONG = """region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(4, 2.6, 4);
object more[40]; more.dimensions <- vec3(0.6, 0.5, 0.62);
assert forall m in more: onFloor(m, room);
"""
# By turns. Texts of 10 MB are few, since a manifest may have 64 MB.
KINDS = ["syntax", "contradiction", "text", "name", "time", "syntax", "contradiction", "json", "name", "syntax"]
BROKEN = ["object", "object a; assert a.pos.x >", "assert b.pos.x > 1;", "object a; a.color <- 3;", "not a program at all"]


def good(number):
    """A line that has a scene."""
    if number % 20 == 4:
        return {"name": f"room-{number}", "seed": number, "request": REQUESTS[number // 20 % len(REQUESTS)]}
    sizes = {"width": 4 + number % 3, "depth": 3.5 + number % 4 / 2, "boxes": 1 + number % 6}
    return {"name": f"room-{number}", "seed": number, "source": ROOM.format(**sizes)}


def bad(number):
    """A line that has none; by turns, each for another reason."""
    kind = KINDS[number % len(KINDS)]
    name = f"{kind}-{number}"
    if kind == "syntax":
        return {"name": name, "source": BROKEN[number % 7 % len(BROKEN)]}
    if kind == "contradiction":
        return {"name": name, "source": NEVER.format(x=number / 10)}
    if kind == "text":
        return {"name": name, "source": "x" * (10 << 20)}
    if kind == "json":
        return "not JSON"
    if kind == "name":
        return {"name": "../" * (1 + number) + "outside", "source": "object a;"}
    return {"name": name, "source": LONG, "effort": 1000}


def text_of(line):
    """As it stands in the manifest."""
    return line if isinstance(line, str) else json.dumps(line)


def lines(count):
    """All lines: a twentieth of them is bad."""
    order = list(range(count))
    random.Random(7).shuffle(order)
    poisoned = {line: turn for turn, line in enumerate(sorted(order[: count // 20]))}
    for line in range(count):
        yield bad(poisoned[line]) if line in poisoned else good(line)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("-n", type=int, default=1000, help="lines")
    arguments.add_argument("-o", type=pathlib.Path, required=True, help="the manifest")
    args = arguments.parse_args()
    with args.o.open("w") as file:
        for line in lines(args.n):
            file.write(text_of(line) + "\n")


if __name__ == "__main__":
    main()
