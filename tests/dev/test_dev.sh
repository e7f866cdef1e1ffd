#!/usr/bin/env bash
# test_dev.sh CASE: one case of the tests of ./dev. Each runs the functions of scripts/ in an empty folder, with what
# they would install, build or start replaced.
# Functions are called by those that they stand in for.
# shellcheck disable=SC2317
set -euo pipefail
checkout=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# shellcheck source=scripts/setup.sh
. "$checkout/scripts/setup.sh"
# shellcheck source=scripts/tasks.sh
. "$checkout/scripts/tasks.sh"
# shellcheck source=scripts/wheel.sh
. "$checkout/scripts/wheel.sh"
# shellcheck source=scripts/docs.sh
. "$checkout/scripts/docs.sh"
# shellcheck source=scripts/bare.sh
. "$checkout/scripts/bare.sh"

# expect WHAT EXPECTED FOUND
expect() { [ "$2" = "$3" ] || {
  printf '%s: expected "%s", found "%s"\n' "$1" "$2" "$3"
  exit 1
}; }
prints() {
  echo "$1"
  echo "$2" >&2
  return "$3"
}

case_quiet() {
  expect "a command that succeeds" "" "$(quietly prints out err 0 2>&1)"
  local said status=0
  said=$(quietly prints out err 7 2>&1) || status=$?
  expect "its exit code" 7 $status
  expect "all that it said" $'out\nerr\nweft: "prints out err 7" has failed (exit code 7).' "$said"
}

case_apt() {
  as_root() {
    echo "E: Unable to fetch some archives"
    return 100
  }
  local said status=0
  said=$(setup_packages no-such-package-of-weft 2>&1) || status=$?
  expect "its exit code" 100 $status
  [[ $said == *"E: Unable to fetch some archives"* ]] || {
    printf 'apt-get is not heard: %s\n' "$said"
    exit 1
  }
}

case_run() {
  task_build() { :; }
  build_window() { :; }
  mkdir build scenes
  printf '#!/bin/sh\necho "$@"\n' >build/weft
  chmod +x build/weft
  expect "no scene" "run pull-armadillo --out out/pull-armadillo" "$(task_run)"
  expect "--help" "run pull-armadillo --out out/pull-armadillo --help" "$(task_run --help)"
  expect "a scene's name" "run breeze --out out/breeze --frames 2" "$(task_run breeze --frames 2)"
  expect "a scene's file" "run own.json --out out/own" "$(task_run own.json)"
  expect "a window" "view pull-armadillo --paused" "$(task_view --paused)"
  expect "a window of a scene" "view breeze" "$(task_view breeze)"
}

# What a job configures stays, and no job configures again for what is there.
case_configure() {
  local asked=0
  cmake() {
    asked=$((asked + 1))
    mkdir -p build
    touch build/build.ninja
    if [ $# -gt 2 ]; then echo "${4%=ON}:BOOL=ON" >>build/CMakeCache.txt; fi
  }
  configure release
  configure release
  expect "for ./dev run" 1 $asked
  configure release WEFT_TESTS
  configure release
  configure release WEFT_TESTS
  expect "for ./dev test" 2 $asked
}

# What --part asks ctest for, and that it runs no other test.
case_part() {
  setup_packages() { :; }
  setup_format() { :; }
  setup_python_tests() { :; }
  setup_docs() { :; }
  task_models() { :; }
  configure() { :; }
  compile() { :; }
  build_wheel() { :; }
  build_web() { :; }
  ctest() { echo "$@"; }
  npx() { echo npx; }
  expect "a part" "--test-dir build --output-on-failure -j $(nproc) --no-tests=error -L ^part3$" \
    "$(task_test --part 3)"
  local said status=0
  said=$(task_test --part 10 2>&1) || status=$?
  expect "its exit code" 1 $status
  expect "its sentence" 'weft: ./dev test --part takes a digit, not "10".' "$said"
}

# Which wheel is whose, and that one is made where anything in it is newer.
case_wheel() {
  compile() { :; }
  setup_wheel_tools() {
    echo made
    exit 0
  }
  expect "the tag of Python 3.11" "cp311-*" "$(wheel_tag /usr/bin/python3)"
  mkdir -p python/src python/weft scenes build/wheel
  touch -d '1 hour ago' python/{CMakeLists.txt,pyproject.toml,README.md} scenes/a.json build/weft build/libweft.a \
    python/src python/weft scenes
  expect "without a wheel" made "$(build_wheel /usr/bin/python3)"
  touch build/wheel/weft-1-cp311-cp311-linux.whl
  expect "with a newer one" "" "$(build_wheel /usr/bin/python3)"
  touch -d 'next hour' scenes/a.json
  expect "with an older one" made "$(build_wheel /usr/bin/python3)"
}

# What builds the site is installed once for each list of it; without a port nothing is served.
case_docs() {
  setup_packages() { :; }
  setup_wgpu() { :; }
  configure() { :; }
  compile() { :; }
  mkdir -p scripts/site
  echo mkdocs==1 >scripts/site/requirements.txt
  DEBIAN_PYTHON=$folder/python
  cat >python <<'END'
#!/bin/sh
if [ "$2" = http.server ]; then echo "served: $*"; exit; fi
mkdir -p "$3/bin"
for tool in pip mkdocs; do printf '#!/bin/sh\necho %s "$1" >>said\n' "$tool" >"$3/bin/$tool"; done
chmod +x "$3"/bin/*
END
  chmod +x python
  expect "where it is" build/site/index.html "$(task_docs 2>/dev/null)"
  expect "what was called" $'pip install\nmkdocs build' "$(cat said)"
  expect "with a port" $'build/site/index.html\nserved: -m http.server --bind 127.0.0.1 --directory build/site 8001' \
    "$(task_docs --port 8001)"
  expect "what was called again" $'pip install\nmkdocs build\nmkdocs build' "$(cat said)"
  echo mkdocs==2 >scripts/site/requirements.txt
  expect "for another list" "pip install" "$(task_docs >/dev/null 2>&1 && tail -n 2 said | head -n 1)"
  local said status=0
  said=$(task_docs --port 0 2>&1) || status=$?
  expect "its exit code" 2 $status
  expect "its sentence" 'weft: usage: ./dev docs [--port N] with N from 1 to 65535, not "--port 0"' "$said"
}

case_bare() {
  id() { echo 1000; }
  local said status=0
  said=$(task_bare 2>&1) || status=$?
  expect "its exit code" 1 $status
  expect "its sentence" "weft: ./dev test --bare makes a root file system and changes into it: run it as root." "$said"
}

case_shellcheck() { cd "$checkout" && shellcheck -x dev .ci/run scripts/bare_commands.sh tests/dev/test_dev.sh; }

"case_$1"
