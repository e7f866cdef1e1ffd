# The jobs of ./dev, each of which sets up what it needs first.

build_folder() { [ "$1" = release ] && echo build || echo "build/$1"; }

# configure PRESET [OPTION]: where it is not done. An option that is on in a build folder stays on: jobs that need less
# build their own targets, and none configures again what another has configured.
configure() {
  local folder
  folder=$(build_folder "$1")
  if [ -e "$folder/build.ninja" ] && { [ $# -eq 1 ] || grep -qs "^$2:BOOL=ON$" "$folder/CMakeCache.txt"; }; then
    return
  fi
  quietly cmake --preset "$1" ${2:+-D "$2=ON"}
}

compile() { cmake --build "$(build_folder "$1")" --target "${@:2}" -- --quiet >&2; } # compile PRESET TARGET...

# The shipped meshes, and nothing that runs.
task_models() {
  setup_packages "${COMPILE_PACKAGES[@]}"
  setup_wgpu
  setup_raw_models
  configure release
  compile release make_models
  build/make_models .setup/raw models
}

task_build() {
  setup_packages "${COMPILE_PACKAGES[@]}" "${RUN_PACKAGES[@]}"
  task_models
  compile release weft
}

# take_scene [SCENE] [OPTION...]: into the caller's scene and options.
take_scene() {
  scene=pull-armadillo options=("$@")
  case "${1:-}" in '' | -*) ;; *)
    scene=$1 options=("${@:2}")
    ;;
  esac
}

task_run() {
  local scene options
  take_scene "$@"
  task_build
  build/weft run "$scene" --out "out/$(basename "$scene" .json)" "${options[@]}"
}

build_window() {
  setup_packages "${WINDOW_PACKAGES[@]}"
  task_build
  configure release WEFT_WINDOW
  compile release weft_window
}

task_view() {
  local scene options
  take_scene "$@"
  build_window
  build/weft view "$scene" "${options[@]}"
}

# The page and its package: the core and the reference as WebAssembly, TypeScript over them, the built page in
# apps/web/dist.
build_web() {
  setup_packages "${COMPILE_PACKAGES[@]}" "${WEB_PACKAGES[@]}"
  setup_npm
  export NODE_PATH=/usr/share/nodejs # where Debian keeps what Emscripten's optimizer needs
  configure web
  compile web core reference
  npm run --silent build --workspace weft-cloth
  npx --no vite build apps/web --logLevel warn >&2
}

task_web() {
  local port=8080
  if [ "${1:-}" = --port ]; then port=${2:-}; fi
  if ! [[ $port =~ ^[0-9]+$ ]] || [ "$port" -lt 1 ] || [ "$port" -gt 65535 ] ||
    { [ $# -ne 0 ] && [ "${1:-}" != --port ]; }; then
    say "usage: ./dev web [--port N] with N from 1 to 65535, not \"$*\""
    exit 2
  fi
  task_models
  build_web
  exec npx --no vite preview apps/web --host 127.0.0.1 --port "$port" --strictPort
}

# Debian's Python, for which setup_packages installs.
paper() { /usr/bin/python3 -m bench.paper "$@"; }

# Measuring needs the binary; only the report needs jinja2, and only the browser's part the page and a browser, which
# are built where they are asked for by name, or where a browser is there already.
bench_paper() {
  setup_packages "${REPORT_PACKAGES[@]}"
  case " $* " in *" --help "* | *" -h "* | *" --stored "* | *" --only report "*)
    paper "$@"
    return
    ;;
  esac
  task_build
  local browser=
  case " $* " in
    *" --only "*chromium*)
      setup_packages chromium
      browser=1
      ;;
    *" --only "* | *" --quick "*) ;;
    *) if command -v "${CHROMIUM:-chromium}" >/dev/null; then browser=1; fi ;;
  esac
  [ -z "$browser" ] || build_web
  paper "$@"
}

# Only the comparison with Embree needs Embree; it runs both on the processor. `web` needs the page and a browser.
task_bench() {
  if [ "${1:-}" = paper ]; then
    shift
    bench_paper "$@"
    return
  fi
  if [ "${1:-}" = web ]; then
    shift
    [ -n "${CHROMIUM:-}" ] || setup_packages chromium
    build_web
    node bench/web/compare.ts "$@"
    return
  fi
  task_build
  if [ "${1:-}" != embree ]; then
    build/weft bench "$@"
    return
  fi
  shift
  setup_packages libembree-dev
  configure release WEFT_EMBREE
  compile release bench_embree
  VK_DRIVER_FILES=/usr/share/vulkan/icd.d/lvp_icd.x86_64.json build/bench_embree "$@"
}

task_test() {
  local labels=(-L short) pages=1
  if [ "${1:-}" = --bare ]; then
    task_bare "${2:-}"
    return
  fi
  if [ "${1:-}" = --long ]; then
    labels=()
    export WEFT_LONG=1
    shift
  elif [ "${1:-}" = --part ]; then
    [[ ${2:-} =~ ^[0-9]$ ]] || fail "./dev test --part takes a digit, not \"${2:-}\"."
    labels=(-L "^part$2\$")
    pages=
    shift 2
  fi
  setup_packages "${TEST_PACKAGES[@]}" "${COMPILE_PACKAGES[@]}" "${RUN_PACKAGES[@]}" "${WHEEL_PACKAGES[@]}"
  setup_format
  setup_python_tests
  setup_docs
  task_models
  configure release WEFT_TESTS
  configure release WEFT_WINDOW
  compile release all
  build_wheel "$DEBIAN_PYTHON"
  build_web
  ctest --test-dir build --output-on-failure -j "$(nproc)" --no-tests=error "${labels[@]}" "$@"
  if [ $# -eq 0 ] && [ -n "$pages" ]; then # a pattern and a part ask for some of ctest's only
    npx --no vitest run --config tests/web/vitest.config.ts
  fi
}

task_format() {
  setup_format
  scripts/format.sh "$@"
}

task_sanitize() {
  setup_packages "${COMPILE_PACKAGES[@]}" "${RUN_PACKAGES[@]}" "${TEST_PACKAGES[@]}"
  setup_wgpu
  configure sanitize
  compile sanitize all
  ctest --test-dir build/sanitize --output-on-failure -j "$(nproc)" --no-tests=error -L short \
    -E '^(lavapipe|swiftshader|tint)'
}
