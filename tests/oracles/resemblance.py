#!/usr/bin/env python3
"""Constraint resemblance a second time, written from the published definition and from what docs/evaluation.md says of likeness.

Reads cases as JSON from standard input, one a line, and prints for each of them, and each threshold, precision, recall and F1 of
objects and of constraints. The pairing is found by another method than the Hungarian one: augmenting paths of greatest gain
(Bellman-Ford on the residual graph), so that a mistake in one of both does not hide in the other.
"""

import json
import sys
from collections import Counter


def trigrams(text):
    words, word = [], ""
    for c in text + " ":
        if c.isalpha():
            word += c.lower()
        elif word:
            words.append(" " + word + " ")
            word = ""
    return Counter(w[i : i + 3] for w in words for i in range(len(w) - 2))


def likeness(a, b):
    a, b = trigrams(a), trigrams(b)
    total = sum(a.values()) + sum(b.values())
    return 2 * sum((a & b).values()) / total if total else 0.0


def harmonic(a, b):
    return 2 * a * b / (a + b) if a + b > 0 else 0.0


def assignment(weights):
    """The pairs of greatest total weight: rows are added one by one, each time along the path that gains most."""
    rows, columns = len(weights), len(weights[0]) if weights else 0
    row_of = [None] * columns
    for _ in range(min(rows, columns)):
        used = {r for r in row_of if r is not None}
        gain = [float("-inf")] * columns
        came = [None] * columns
        for c in range(columns):
            for r in range(rows):
                if r not in used and weights[r][c] > gain[c]:
                    gain[c], came[c] = weights[r][c], ("row", r)
        for _ in range(columns):
            changed = False
            for c in range(columns):
                r = row_of[c]
                if r is None or gain[c] == float("-inf"):
                    continue
                for d in range(columns):
                    new = gain[c] - weights[r][c] + weights[r][d]
                    if d != c and new > gain[d]:
                        gain[d], came[d], changed = new, ("column", c), True
            if not changed:
                break
        free = [c for c in range(columns) if row_of[c] is None]
        c = max(free, key=lambda c: gain[c])
        while True:
            kind, index = came[c]
            if kind == "row":
                row_of[c] = index
                break
            row_of[c] = row_of[index]
            c = index
    return [(r, c) for c, r in enumerate(row_of) if r is not None]


def quality(found, vain, missed):
    precision = found / (found + vain) if found + vain else 0.0
    recall = found / (found + missed) if found + missed else 0.0
    return [precision, recall, harmonic(precision, recall)]


def objects(truth, made, tau):
    def confidence(t, m):
        return harmonic(likeness(t["name"], m["name"]), likeness(t["description"], m["description"]))

    exact = [[confidence(t, m) for m in made] for t in truth]
    whole = [[round(x * 10**9) for x in row] for row in exact]
    found = sum(exact[r][c] >= tau for r, c in assignment(whole) if whole[r][c] > 0)
    return quality(found, len(made) - found, len(truth) - found)


def words(text):
    return " " + " ".join("".join(c.lower() if c.isalpha() else " " for c in text).split()) + " "


def layout(truth, made, tau):
    def goes(t, m):
        return any(words(n) in words(m) for n in t["names"]) and likeness(t["sentence"], m) >= tau

    table = [[goes(t, m) for m in made] for t in truth]
    hit = sum(any(row) for row in table)
    vain = sum(not any(row[m] for row in table) for m in range(len(made)))
    return quality(hit, vain, len(truth) - hit)


def main():
    for line in sys.stdin:
        case = json.loads(line)
        answers = []
        for tau in case["taus"]:
            answers.append(
                {
                    "objects": objects(case["objects"]["truth"], case["objects"]["made"], tau),
                    "layout": layout(case["layout"]["truth"], case["layout"]["made"], tau),
                }
            )
        print(json.dumps(answers))


if __name__ == "__main__":
    main()
