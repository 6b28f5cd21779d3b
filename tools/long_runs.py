#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run the long form of the tests that have one, and write what they print to a page.

A test says how it runs long: a comment line `// Long: CASTRAY_RAYS=10000000 [arguments]`. Its figures are the
lines that it prints beside those of GoogleTest.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import time

HEAD = """# Long runs
Written by `make long`: the tests that have a long form, with the environment that asks for it, and what they found.
"""


def long_form(source):
    """(environment, arguments) of a test's long form."""
    words = re.search(r"^// Long: (.*)$", source.read_text(), re.M).group(1).split()
    settings = [word for word in words if re.match(r"[A-Z_]+=", word)]
    return settings, [word for word in words if word not in settings]


def figures(text):
    """The lines of a test's output that are its own."""
    return [line.strip() for line in text.splitlines() if line.strip() and not re.match(r"\[[ =\-A-Z]+\]|Running main|Note: |\s*\d+ FAILED", line)]


def run(source):
    """(name, command, ok, seconds, output) of one test."""
    name = str(source).removeprefix("tb/").removesuffix("_test.cpp")
    settings, arguments = long_form(source)
    start = time.monotonic()
    done = subprocess.run([f"build/unit/{name}_test", *arguments], env=os.environ | dict(s.split("=", 1) for s in settings),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, stdin=subprocess.DEVNULL)
    log = pathlib.Path("build/log") / f"long-{name.replace('/', '-')}.log"
    log.parent.mkdir(parents=True, exist_ok=True)
    log.write_text(done.stdout)
    return name, " ".join(settings + [f"build/unit/{name}_test"] + arguments), done.returncode == 0, time.monotonic() - start, done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tests", nargs="+", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--page", type=pathlib.Path)
    args = parser.parse_args()
    results = []
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for job in concurrent.futures.as_completed([pool.submit(run, test) for test in args.tests]):
            name, command, ok, seconds, output = job.result()
            results.append(job.result())
            print(f"  {len(results)} of {len(args.tests)}  {'ok' if ok else 'FAIL'}  {seconds:6.0f} s  {name}", flush=True)
            print("\n".join(f"      {line}" for line in (figures(output) if ok else output.splitlines()[-60:])), flush=True)
    failed = sum(not ok for _, _, ok, _, _ in results)
    if args.page:
        page = HEAD
        for name, command, ok, seconds, output in sorted(results):
            page += f"\n## {name}\n`{command}`: {'passed' if ok else 'FAILED'}, {seconds:.0f} s\n```\n" + "\n".join(figures(output)) + "\n```\n"
        args.page.write_text(page)
    print(f"{len(results) - failed} passed, {failed} failed")
    sys.exit(failed != 0)


if __name__ == "__main__":
    main()
