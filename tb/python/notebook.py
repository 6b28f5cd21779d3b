# SPDX-License-Identifier: Apache-2.0
"""Run a notebook; as a program, in place: tb/python/run.sh tb/python/notebook.py FILE"""
import pathlib
import sys

import nbclient
import nbformat


def executed(path):
    """The notebook with the outputs that it has now. CellExecutionError where a cell fails."""
    notebook = nbformat.read(path, as_version=4)
    folder = {"metadata": {"path": str(pathlib.Path(path).parent)}}
    return nbclient.NotebookClient(notebook, timeout=300, record_timing=False, resources=folder).execute()


if __name__ == "__main__":
    nbformat.write(executed(sys.argv[1]), sys.argv[1])
