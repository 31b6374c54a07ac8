#!/usr/bin/env bash
# Builds the wheel of the Python module, installs it into a new environment, and runs there the tests of the module, which
# hold it to the command line, and the notebook of docs/.
#
#   tests/package/check_wheel.sh BRDFPLOT    BRDFPLOT: the command to compare with, of the same sources
#
# Nothing is downloaded: NumPy, pytest and Jupyter are Debian's, for which the environment sees the system's packages. Some
# minutes, since the library is compiled again.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
brdfplot=$(realpath "${1:?the path of brdfplot}")
# shellcheck source=scripts/setup.sh
source "$root/scripts/setup.sh"
require_packages "${build_packages[@]}" pybind11-dev python3-dev python3-numpy python3-pytest python3-pip python3-venv \
  python3-setuptools python3-wheel python3-nbconvert python3-ipykernel

work=$(mktemp -d -t brdfplot-wheel.XXXXXX)
trap 'rm -rf "$work"' EXIT
step "Building the wheel"
# Debian's modules are those of Debian's Python, which need not be the first in PATH.
/usr/bin/python3 -m pip wheel "$root" --no-build-isolation --no-deps --wheel-dir "$work"
step "Installing it"
/usr/bin/python3 -m venv --system-site-packages "$work/venv"
python=$work/venv/bin/python
"$python" -m pip install --no-index --no-deps "$work"/brdfplot-*.whl
cd "$work"
"$python" - <<'PYTHON'
import importlib.metadata, sys
import brdfplot

assert brdfplot.__file__.startswith(sys.prefix), brdfplot.__file__
assert importlib.metadata.version("brdfplot") == brdfplot.__version__, brdfplot.__version__
PYTHON
step "Testing it"
PYTHONDONTWRITEBYTECODE=1 BRDFPLOT="$brdfplot" "$python" -m pytest -q -p no:cacheprovider "$root/tests/python"
step "Running the notebook"
export PYDEVD_DISABLE_FILE_VALIDATION=1
"$python" -m ipykernel install --sys-prefix # Debian's own kernel does not see the environment
"$python" -m nbconvert --to notebook --execute --output-dir "$work" "$root/docs/example.ipynb"
"$python" - <<'PYTHON'
import json

outputs = [o for cell in json.load(open("example.ipynb", encoding="utf-8"))["cells"] for o in cell.get("outputs", [])]
assert len(outputs) == 3 and "image/svg+xml" in outputs[-1]["data"], outputs
PYTHON
step "The wheel works"
