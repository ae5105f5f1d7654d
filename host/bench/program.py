# SPDX-License-Identifier: BSD-3-Clause
"""Runs `cagewright` and reads its reports."""
import json
import os
import resource
import subprocess
from pathlib import Path

from models import ROOT

BIN = Path(os.environ.get("CAGEWRIGHT_BIN") or ROOT / "build/release/bin")
ORACLE = Path(os.environ.get("CAGEWRIGHT_ORACLE") or ROOT / "build/release/testdata/oracle/cagewright_oracle")


class ProgramError(Exception):
    """A program ended as it should not; the text is its last line."""


def run(command, accepted=(0,)):
    """(standard output, processor seconds) of a program. Raises ProgramError for an exit code that is not accepted."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in accepted:
        last = (done.stderr.strip().splitlines() or ["no message"])[-1]
        raise ProgramError(f"{Path(command[0]).name} ended with {done.returncode}: {last}")
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def cage(model, out, options=(), picture=None):
    """The report of `cagewright cage`; the cage is written to `out`, its report beside it. `options` are words of the command line."""
    out = Path(out)
    out.parent.mkdir(parents=True, exist_ok=True)
    report = out.parent / (out.stem + ".report.json")
    command = [BIN / "cagewright", "cage", model.file, "--slides", model.slides, "-o", out, "--report", report, "--quiet"]
    if picture:
        command = [ROOT / "cmake/with_display", *command, "--picture", *picture]
    run([*command, *options], accepted=(0, 1))
    return json.loads(report.read_text(encoding="utf-8"))


def check(model_file, cage_file, report):
    """The report of `cagewright check`."""
    run([BIN / "cagewright", "check", model_file, cage_file, "--report", report], accepted=(0, 1))
    return json.loads(Path(report).read_text(encoding="utf-8"))


def oracle(model_file, cage_file):
    """What the independent checker says, or None where it is not built."""
    if not ORACLE.is_file():
        return None
    return json.loads(run([ORACLE, model_file, cage_file], accepted=(0, 1))[0])


def settings(**values):
    """--set words: settings(enclose_mode="off") for enclose.mode; the first _ of a name stands for the dot."""
    words = []
    for name, value in values.items():
        words += ["--set", f"{name.replace('_', '.', 1)}={value}"]
    return words
