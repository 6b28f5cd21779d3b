# SPDX-License-Identifier: Apache-2.0
"""The build of the Python package: scikit-build-core, once the module that is derived from the RTL is written."""
import py_layout
from scikit_build_core import build

get_requires_for_build_sdist = build.get_requires_for_build_sdist
get_requires_for_build_wheel = build.get_requires_for_build_wheel


def _derived(hook):
    def run(*args, **kwargs):
        py_layout.OUTPUT.write_text(py_layout.text())
        return hook(*args, **kwargs)
    return run


build_sdist = _derived(build.build_sdist)
build_wheel = _derived(build.build_wheel)
prepare_metadata_for_build_wheel = _derived(build.prepare_metadata_for_build_wheel)
