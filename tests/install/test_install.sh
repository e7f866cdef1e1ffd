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

# library_of PROGRAM: "shared" where it loads libweft.so of this minor version, "static" where it has the library in it.
library_of() {
  readelf -d "$1" >dynamic.txt
  nm -C "$1" >symbols.txt
  if grep -q "NEEDED.*\[libweft\.so\.$minor\]" dynamic.txt; then
    echo shared
  elif ! grep -q 'NEEDED.*libweft' dynamic.txt && grep -q ' T weft::World::create(' symbols.txt; then
    echo static
  fi
}

case_libraries() {
  install_weft
  mv prefix moved
  prefix=$folder/moved
  export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
  local version minor main=$checkout/examples/cpp/hello.cpp
  version=$(pkg-config --modversion weft)
  minor=${version%.*}
  expect "the version" "$(sed -nE 's/^project\(weft VERSION ([0-9.]+) .*/\1/p' "$checkout/CMakeLists.txt")" "$version"

  local flags=(-std=c++20 -Wall -Wextra -Wpedantic -Werror) run="-Wl,-rpath,$prefix/lib" cflags libs all native
  read -ra cflags <<<"$(pkg-config --cflags weft)"
  read -ra libs <<<"$(pkg-config --libs weft)"
  read -ra all <<<"$(pkg-config --static --libs weft)"
  read -ra native <<<"$(pkg-config --cflags --libs weft weft-wgpu)"
  g++ "${flags[@]}" "${cflags[@]}" -c "$main"
  g++ hello.o "$run" "${libs[@]}" -o shared
  g++ hello.o "$run" -Wl,-Bstatic "${all[@]}" -o static
  g++ "${flags[@]}" "$checkout/examples/cpp/own_device.cpp" "$run" "${native[@]}" -o own_device
  g++ -std=c++17 -fsyntax-only "${cflags[@]}" "$main" 2>old.txt && exit 1
  grep -q "weft's headers need C++20: compile with -std=c++20 or a later standard" old.txt

  mkdir consumer
  cat >consumer/CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES CXX)
find_package(weft $version CONFIG REQUIRED)
add_executable(by_cmake $main)
target_link_libraries(by_cmake PRIVATE weft::weft_shared)
foreach(other \${weft_VERSION_MAJOR}.99 99.0)
  find_package(later \${other} NAMES weft CONFIG QUIET)
  if(later_FOUND)
    message(FATAL_ERROR "weft \${weft_VERSION} stands for \${other}.")
  endif()
endforeach()
END
  {
    cmake -G Ninja -S consumer -B build -DCMAKE_PREFIX_PATH="$prefix" && cmake --build build
  } >consumer.log 2>&1 || {
    cat consumer.log
    exit 1
  }
  expect "libraries of the programs" "shared static shared shared" \
    "$(library_of shared) $(library_of static) $(library_of own_device) $(library_of build/by_cmake)"

  local scene=$checkout/scenes/hanging.json hash
  hash=$(./static "$scene" 1)
  [[ $hash =~ ^[0-9a-f]{16}$ ]]
  expect "the state by the shared library" "$hash" "$(./shared "$scene" 1)"

  rm "$prefix"/lib/libweft.so* # of a static library alone, --static is all that it takes
  g++ hello.o "$run" "${all[@]}" -o alone
  expect "the library of a prefix without a shared one" static "$(library_of alone)"
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
