# Sourced by scripts/report, scripts/test and .ci/run: what they need of Debian, and the build in build/.
# shellcheck shell=bash disable=SC2034

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit

# Names a step, after the minutes since the script began.
step() { printf '==> %d:%02d %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"; }

# doctest-dev and python3 are here because the release preset configures the tests too.
build_packages=(g++ cmake ninja-build libcli11-dev nlohmann-json3-dev libeigen3-dev libboost-dev libmuparser-dev
  libembree-dev libtbb-dev libfftw3-dev libpng-dev zlib1g-dev doctest-dev python3)
test_packages=(glslang-tools libxml2-utils librsvg2-bin chromium python3-jsonschema python3-mpmath
  pybind11-dev python3-dev python3-numpy python3-pytest libopenmpi-dev openmpi-bin)
style_packages=(clang-format clang-tidy)
# The sanitizers' build, with libFuzzer.
sanitizer_packages=(clang libclang-rt-14-dev)
# The live page: WebAssembly.
live_packages=(clang-19 lld-19 wasi-libc libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 chromium)

# Installs those of the given Debian packages that are missing.
require_packages() {
  if ! command -v dpkg-query >/dev/null; then
    printf 'Not a Debian system; these are taken to be there: %s\n' "$*"
    return
  fi
  local package missing=()
  for package in "$@"; do
    [[ $(dpkg-query -W -f='${Status}' "$package" 2>/dev/null) == *' ok installed' ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  local log as_root=()
  log=$(mktemp -t brdfplot-apt.XXXXXX.log)
  ((EUID == 0)) || as_root=(sudo)
  step "Installing ${missing[*]} (log: $log)"
  if ! { "${as_root[@]}" apt-get update &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } \
    >"$log" 2>&1 </dev/null; then
    tail -n 20 "$log" >&2
    printf 'Could not install %s\n' "${missing[*]}" >&2
    return 1
  fi
}

# Configures build/ and builds the given targets.
build_release() {
  step "Configuring build/"
  local options=()
  # Debian's Python modules are those of /usr/bin/python3, which need not be the first in PATH.
  [[ -x /usr/bin/python3 ]] && options+=(-DPython3_EXECUTABLE=/usr/bin/python3)
  cmake --preset release --log-level=WARNING "${options[@]}" >/dev/null
  step "Building"
  cmake --build --preset release "${@/#/--target=}"
}

# Runs the tests of a preset and prints "N passed, N failed" as its last line: the cases of doctest where an entry of
# ctest is a doctest executable, the entry itself where it is not.
run_tests() {
  local preset=$1 status=0 results
  shift
  results=$(mktemp -t brdfplot-tests.XXXXXX.xml)
  # doctest counts at the end of its output, which is what truncation has to keep.
  ctest --preset "$preset" -j "$(nproc)" --output-junit "$results" --test-output-truncation head "$@" || status=$?
  python3 - "$results" "$status" <<'PYTHON'
import re, sys
from xml.etree import ElementTree

passed = failed = 0
try:
    entries = list(ElementTree.parse(sys.argv[1]).iter("testcase"))
except ElementTree.ParseError:  # ctest stopped before it wrote its results
    entries = []
for entry in entries:
    cases = re.search(r"^\[doctest\] test cases: .*\| *(\d+) passed \| *(\d+) failed", entry.findtext("system-out", ""), re.M)
    good, bad = map(int, cases.groups()) if cases else (0, 0)
    if entry.get("status") == "run":
        good = good or 1
    else:  # a crash or a timeout is a failure that doctest did not live to count
        bad = bad or 1
    passed += good
    failed += bad
if sys.argv[2] != "0":
    failed = failed or 1
print(f"{passed} passed, {failed} failed")
PYTHON
  rm -f "$results"
  return "$status"
}
