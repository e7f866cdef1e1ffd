# The jobs of ./dev, each of which sets up what it needs first.

compile() {  # compile PRESET
  [ -e "$(build_folder "$1")/build.ninja" ] || cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" -- --quiet >&2
}
build_folder() { [ "$1" = release ] && echo build || echo "build/$1"; }

task_build() {
  # shellcheck disable=SC2086
  setup_packages $BUILD_PACKAGES
  setup_wgpu
  setup_raw_models
  compile release
  build/make_models .setup/raw models
}

task_run() {
  local scene=${1:-pull-armadillo}
  [ $# -eq 0 ] || shift
  task_build
  local file=$scene name
  [ -e "$file" ] || file=scenes/$scene.json
  name=$(basename "$file" .json)
  build/weft run "$file" --out "out/$name" "$@"
}

task_test() {
  local labels=(-L short)
  if [ "${1:-}" = --long ]; then labels=(); shift; fi
  # shellcheck disable=SC2086
  setup_packages $TEST_PACKAGES
  task_build
  setup_node
  [ -e tests/tint/node_modules/.package-lock.json ] || npm --prefix tests/tint ci --no-audit --no-fund --loglevel=error >/dev/null
  ctest --test-dir build --output-on-failure -j "$(nproc)" --no-tests=error "${labels[@]}" "$@"
}

task_format() {
  setup_packages clang-format-14
  local mode=(-i)
  [ "${1:-}" = --check ] && mode=(--dry-run --Werror)
  git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 "${mode[@]}"
}

task_sanitize() {
  # shellcheck disable=SC2086
  setup_packages $BUILD_PACKAGES $TEST_PACKAGES
  setup_wgpu
  compile sanitize
  ctest --test-dir build/sanitize --output-on-failure -j "$(nproc)" --no-tests=error -L short -E '^(lavapipe|swiftshader|tint)'
}
