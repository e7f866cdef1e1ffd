# The Python package: ./dev wheel, and what its tests need.
WHEEL_PACKAGES=(python3-dev python3-venv)
DEBIAN_PYTHON=/usr/bin/python3

python_version() { "$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])'; }

# setup_wheel_tools PYTHON: what builds the wheel, by hash, in a virtual environment of this Python.
setup_wheel_tools() {
  local tools list
  tools=$SETUP/wheel-tools-$(python_version "$1")
  list=python/requirements/build.txt
  cmp -s "$list" "$tools/installed.txt" && return 0
  say "installing what builds the wheel"
  rm -rf "$tools"
  quietly "$1" -m venv "$tools"
  quietly "$tools/bin/pip" install --disable-pip-version-check --no-deps --only-binary=:all: --require-hashes -r "$list"
  cp "$list" "$tools/installed.txt"
}

# setup_python_tests: the wheels that the tests of the package install, by hash, in .setup/python-wheels.
setup_python_tests() {
  local folder=$SETUP/python-wheels list=python/requirements/test.txt
  cmp -s "$list" "$folder/fetched.txt" && return 0
  say "fetching what the tests of the Python package need"
  rm -rf "$folder" && mkdir -p "$folder"
  quietly "$DEBIAN_PYTHON" -m pip download --disable-pip-version-check --no-deps --only-binary=:all: --require-hashes \
    -d "$folder" -r "$list"
  cp "$list" "$folder/fetched.txt"
}

# wheel_tag PYTHON: what pip calls the Pythons that its wheel is for.
wheel_tag() { "$1" -c 'import sys; v = sys.version_info[:2]; print("cp312-abi3" if v >= (3, 12) else "cp%d%d-*" % v)'; }

# build_wheel PYTHON: build/wheel/weft-*.whl, unless it is newer than all that is in it. It asks for no newer libraries
# than Debian 12's.
build_wheel() {
  local tools made parts=(python/CMakeLists.txt python/pyproject.toml python/README.md python/src python/weft scenes
    build/weft build/libweft.a)
  compile release weft weft_library
  made=$(compgen -G "build/wheel/weft-*-$(wheel_tag "$1")-*.whl" || true)
  if [ -n "$made" ] && [ -z "$(find "${parts[@]}" -newer "$made" -print -quit)" ]; then
    return
  fi
  rm -f "$made"
  tools=$SETUP/wheel-tools-$(python_version "$1")
  setup_wheel_tools "$1"
  quietly cmake --install build --prefix build/prefix
  rm -rf build/wheel/raw && mkdir -p build/wheel/raw
  cp LICENSE NOTICE THIRD_PARTY.md python/
  PATH=$tools/bin:$PATH CMAKE_CXX_COMPILER_LAUNCHER=ccache quietly "$tools/bin/pip" wheel \
    --disable-pip-version-check --no-deps --no-build-isolation --no-index -w build/wheel/raw \
    --config-settings=cmake.define.weft_ROOT="$PWD/build/prefix" \
    --config-settings=cmake.define.WEFT_PROGRAM="$PWD/build/weft" ./python
  rm python/LICENSE python/NOTICE python/THIRD_PARTY.md
  PATH=$tools/bin:$PATH quietly auditwheel repair --plat manylinux_2_36_x86_64 -w build/wheel build/wheel/raw/*.whl
  rm -r build/wheel/raw
}

task_wheel() {
  local python=${1:-$DEBIAN_PYTHON}
  [ $# -le 1 ] || fail "usage: ./dev wheel [PYTHON]"
  setup_packages "${COMPILE_PACKAGES[@]}" "${WHEEL_PACKAGES[@]}"
  setup_wgpu
  configure release
  build_wheel "$python"
  ls build/wheel/*.whl
}
