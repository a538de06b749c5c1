# SPDX-License-Identifier: CC0-1.0
"""python3 run.py [--all] ADAPTER.py FILE.json...: runs vectors against the functions of ADAPTER by their group's name.

Arguments come in the order of the group, those of one number as a float, others as a list; a function returns its
results as a list of floats and lists. Format: docs/vectors.md.
"""
import collections
import importlib.util
import json
import math
import sys


def load(path):
    spec = importlib.util.spec_from_file_location("adapter", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def difference(got, want, sign):
    """The largest difference of got times sign from want; infinite where only one is a NaN."""
    if len(got) != len(want):
        return math.inf
    largest = 0.0
    for g, w in zip(got, want):
        g *= sign
        both = math.isnan(g) and math.isnan(w)
        d = 0.0 if both or g == w else abs(g - w)
        largest = max(largest, math.inf if math.isnan(d) else d)
    return largest


def holds(compare, got, want, bound):
    if compare == "nan":
        return any(math.isnan(x) for x in got)
    if compare == "unit":
        return abs(math.sqrt(sum(x * x for x in got)) - 1) <= bound
    d = difference(got, want, 1)
    if compare == "exact":
        return d == 0
    return (min(d, difference(got, want, -1)) if compare == "sign" else d) <= bound


def run_case(group, function, case, counts):
    arguments = []
    for a in group["in"]:
        values = [float(x) for x in case["in"][a["name"]]]
        arguments.append(values[0] if a["count"] == "1" else values)
    results, failed = function(*arguments), 0
    for i, (o, result) in enumerate(zip(group["out"], results)):
        got = list(result) if isinstance(result, (list, tuple)) else [result]
        want = [float(x) for x in case["out"][o["name"]]]
        sizes = case["size"]
        bound = group["tolerance"] * sizes[i if i < len(sizes) else 0]
        if holds(case.get("check", o["compare"]), got, want, bound):
            counts[case["class"]] += 1
            continue
        failed += 1
        print(f"FAILED {group['name']} {case['name']} {o['name']}, bound {bound}:\n  got  {got}\n  want {want}")
    return failed


def main(arguments):
    every = arguments[:1] == ["--all"]
    adapter, *files = arguments[every:]
    functions, counts, failed, skipped = load(adapter), collections.Counter(), 0, 0
    for path in files:
        with open(path, encoding="utf-8") as file:
            for group in json.load(file)["groups"]:
                function = getattr(functions, group["name"], None)
                if function is None:
                    skipped += len(group["cases"])
                    continue
                failed += sum(run_case(group, function, case, counts) for case in group["cases"])
    passed = ", ".join(f"{n} {kind}" for kind, n in counts.items())
    print(f"passed: {passed or 'none'}; {failed} failed; {skipped} cases without a function")
    return 1 if failed or not passed or (every and skipped) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
