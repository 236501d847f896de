#!/usr/bin/env python3
"""How long a course takes, how much memory, and whether it comes out the same twice.

    figures.py watch COMMAND...               runs it; wall and processor seconds and the peak memory of its whole tree
    figures.py compare COURSE OUT [OUT...]    what grades.csv of each OUT says beside COURSE/expected.csv

Memory is the sum of PSS (shared pages counted once) where /proc lets us read it, which for the sandbox's users takes root; else of RSS.
"""
import collections
import csv
import os
import subprocess
import sys
import time

PERIOD = 0.25
TICK = os.sysconf("SC_CLK_TCK")
PAGE = os.sysconf("SC_PAGE_SIZE")


def stat(pid):
    """The fields of /proc/PID/stat after the name, which may hold anything; None when it is gone."""
    try:
        with open(f"/proc/{pid}/stat", "rb") as file:
            return file.read().rpartition(b")")[2].split()
    except OSError:
        return None


def tree(root):
    """The numbers and fields of root and of all that came of it."""
    seen = {int(name): stat(name) for name in os.listdir("/proc") if name.isdigit()}
    children = collections.defaultdict(list)
    for pid, fields in seen.items():
        if fields:
            children[int(fields[1])].append(pid)
    members, waiting = {}, [root]
    while waiting:
        pid = waiting.pop()
        if seen.get(pid):
            members[pid] = seen[pid]
            waiting += children[pid]
    return members


def memory(pid, fields):
    try:
        with open(f"/proc/{pid}/smaps_rollup") as file:
            return next(int(line.split()[1]) << 10 for line in file if line.startswith("Pss:"))
    except (OSError, StopIteration):
        return int(fields[21]) * PAGE


def watch(command):
    start = time.monotonic()
    process = subprocess.Popen(command)
    peak, ticks = 0, {}
    while process.poll() is None:
        members = tree(process.pid)
        peak = max(peak, sum(memory(pid, fields) for pid, fields in members.items()))
        # Each process by itself: nobody is charged with those that die inside the sandbox. The last moments of each are missed.
        ticks.update({(pid, fields[19]): int(fields[11]) + int(fields[12]) for pid, fields in members.items()})
        time.sleep(PERIOD)
    print(f"wall {time.monotonic() - start:.1f} s, processor {sum(ticks.values()) / TICK:.1f} s, peak {peak / 2**20:.0f} MiB")
    return process.returncode


def rows(file):
    with open(file, newline="", encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def judge(kind, wanted, row):
    """Whether row is what was wanted; for what was graded, whether each wanted mistake is named and no other."""
    if kind == "broken":
        return (row["reason"].split(":")[0] or "graded") in wanted.split("|")
    named, sets = set(row["mistakes"].split()), [set(part.split("|")) for part in wanted.split()]
    return row["outcome"] == "graded" and all(named & part for part in sets) and not named - set().union({"unknown"} if sets else set(), *sets)


def compare(course, outs):
    expected = rows(os.path.join(course, "expected.csv"))
    tables = [{row["submission"]: row for row in rows(os.path.join(out, "grades.csv"))} for out in outs]
    first = tables[0]
    lost = [e["name"] for e in expected if any(t.get(e["name"], {}).get("outcome", "missing") == "missing" for t in tables)]
    right = collections.Counter()
    for entry in expected:
        row = first.get(entry["name"])
        if row and judge(entry["kind"], entry["wanted"], row):
            right[entry["kind"]] += 1
        elif row:
            print(f"{entry['name']}: wanted {entry['wanted'] or 'nothing'}, is {row['points']} {row['mistakes']} {row['reason'][:60]}")
    changing = [n for n in first for t in tables if (t.get(n, {}).get("points"), t.get(n, {}).get("mistakes")) != (first[n]["points"], first[n]["mistakes"])]
    kinds = collections.Counter(entry["kind"] for entry in expected)
    print(f"{len(expected)} submissions, {len(lost)} lost {lost}, {sum(r['outcome'] == 'graded' for r in first.values())} graded")
    print("as wanted: " + ", ".join(f"{kind} {right[kind]} of {kinds[kind]}" for kind in kinds))
    full = sum(float(first[e["name"]]["points"] or 0) == 100 for e in expected if e["kind"] == "correct" and e["name"] in first)
    print(f"correct with full points: {full} of {kinds['correct']}")
    if len(tables) > 1:
        print(f"not the same points and mistakes in all {len(tables)} runs: {len(changing)} {sorted(set(changing))}")
    return 1 if lost or changing else 0


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["watch", *command] if command:
            sys.exit(watch(command))
        case ["compare", course, *outs] if outs:
            sys.exit(compare(course, outs))
        case _:
            sys.exit(__doc__)
