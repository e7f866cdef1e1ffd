#!/usr/bin/env bash
# test_install.sh CASE BUILD: one case of the tests of the installed library, in an empty folder. BUILD is a build of
# this checkout.
set -euo pipefail
checkout=$(cd "$(dirname "$0")/../.." && pwd)
build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# expect WHAT EXPECTED FOUND
expect() { [ "$2" = "$3" ] || {
  printf '%s: expected "%s", found "%s"\n' "$1" "$2" "$3"
  exit 1
}; }

case_headers() {
  local headers=("$checkout"/include/weft/*.hpp) found
  [ ${#headers[@]} -gt 5 ]
  found=$(grep -nE '^ *# *include' "${headers[@]}" | grep -vE 'include (<[a-z_0-9]+>|"weft/[a-z_]+\.hpp")$' || true)
  expect "other includes" "" "$found"
  found=$(grep -nE 'webgpu\.h|wgpu|throw ' "${headers[@]}" | grep -v '/native\.hpp:' || true)
  expect "words of the engine's inside" "" "$found"
  found=$(grep -lE '^ *# *include.*native' "${headers[@]}" || true)
  expect "who includes weft/native.hpp" "" "$found"
  local header
  for header in "${headers[@]}"; do # each compiles by itself
    g++ -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Werror -fno-exceptions -fsyntax-only -I "$checkout/include" \
      -x c++ -include "$header" /dev/null
  done
}

install_weft() { cmake --install "$build" --prefix "$folder/prefix" >install.log || {
  cat install.log
  exit 1
}; }

# The examples, away from this checkout.
build_examples() {
  cp -r "$checkout/examples/cpp" examples
  {
    cmake -G Ninja -S examples -B build -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Wshadow -Werror"
    cmake --build build
  } >build.log 2>&1 || {
    cat build.log
    exit 1
  }
}

# block LANGUAGE: the first one of the how-to on C++.
block() { awk -v fence="\`\`\`$1" '$0 == fence { on = 1; next } /^```/ { if (on) exit } on' \
  "$checkout/docs/how-to/cpp.md"; }

# The program of the how-to says how far the sheet hangs down.
run_how_to() {
  mkdir how-to
  block cmake >how-to/CMakeLists.txt
  block cpp >how-to/main.cpp
  {
    cmake -G Ninja -S how-to -B how-to/build -DCMAKE_PREFIX_PATH="$folder/prefix"
    cmake --build how-to/build
  } >how-to.log 2>&1 || {
    cat how-to.log
    exit 1
  }
  how-to/build/mine | tee lowest.txt
  awk '$3 >= before + 0 && NR > 1 { exit 1 } { before = $3 } END { if (NR != 5) exit 1 }' lowest.txt
}

case_package() {
  install_weft
  build_examples
  local scene=$checkout/scenes/hanging.json frames=8
  "$build/weft" run "$scene" --frames $frames --out out --json >summary.json
  local hash
  hash=$(sed -nE 's/.*"state_hash": "([0-9a-f]{16})".*/\1/p' summary.json)
  expect "the hash of $frames frames" "$hash" "$(build/hello "$scene" $frames)"

  run_how_to

  # Positions as read back and as the command line's mesh has them: both are f32 in decimal, of a scene within 4 m.
  build/read_back "$scene" $frames >nodes.csv
  sed 1d nodes.csv | cut -d, -f1-3 | tr , ' ' >read.txt
  sed -nE 's/^v //p' out/final.obj >written.txt
  expect "nodes" "$(wc -l <written.txt)" "$(wc -l <read.txt)"
  paste -d ' ' read.txt written.txt | awk '
    function apart(a, b) { return a - b > 1e-6 || b - a > 1e-6 }
    apart($1, $4) || apart($2, $5) || apart($3, $6) { print "node " NR - 1 ": " $0; bad = 1 }
    END { exit bad }'

  # On a device of the program's, drawn into its texture and copied by it: the same bits, pixels and positions.
  expect "the state on the program's device, and the distance of its copy" "$hash 0" \
    "$(build/own_device "$scene" $frames own_device.png)"
  cmp own_device.png "out/$(printf 'frame_%05d.png' $((frames - 1)))"

  # The middle follows its path to 0.8 m exactly; the rim hangs below it by no more than the cloth is long.
  build/own_mesh disc.png | tee disc.txt
  awk '{ exit !($2 == 0.8 && $5 < 0.7 && $5 > 0.2) }' disc.txt
  expect "the picture" "PNG" "$(head -c 4 disc.png | tail -c 3)"
}

case_folder() {
  cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES C CXX)
add_subdirectory($checkout weft)
add_executable(hello $checkout/examples/cpp/hello.cpp)
target_link_libraries(hello PRIVATE weft::weft)
END
  cmake -G Ninja -S . -B build >configure.log 2>&1 || {
    cat configure.log
    exit 1
  }
  expect "the option WEFT_WERROR" "WEFT_WERROR:BOOL=OFF" "$(grep WEFT_WERROR build/CMakeCache.txt)"
  ninja -C build -t targets all >targets.txt # a pipe into grep -q would end ninja early, and that is a failure here
  grep -q '^hello:' targets.txt
  expect "its tests" "" "$(grep -o 'test_[a-z]*:' targets.txt || true)"
}

"case_$1"
