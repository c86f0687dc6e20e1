"""Reads JUnit XML with a parser that is not ours, and counts what it found.

usage: junit.py FILE      exit 0 sound, 1 findings, 2 cannot judge

Prints a line for each suite: name: tests failures errors skipped.
"""
import sys

from junitparser import Error, Failure, JUnitXml, Skipped


def main(path):
    sound = True
    for suite in JUnitXml.fromfile(path):
        cases = list(suite)
        results = [result for case in cases for result in case.result]
        of = lambda kind: sum(isinstance(result, kind) for result in results)
        counted = (len(cases), of(Failure), of(Error), of(Skipped))
        stated = (suite.tests, suite.failures, suite.errors, suite.skipped)
        if counted != stated:
            print(f"{suite.name}: states {stated}, has {counted}", file=sys.stderr)
            sound = False
        for case in cases:
            if not case.name or not case.classname:
                print(f"{suite.name}: a case without a name", file=sys.stderr)
                sound = False
        print(f"{suite.name}: {' '.join(map(str, counted))}")
    return 0 if sound else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1]))
    except (OSError, SyntaxError) as error:
        print(error, file=sys.stderr)
        sys.exit(2)
