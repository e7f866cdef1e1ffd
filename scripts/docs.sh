# The documentation site: ./dev docs, and what its tests need.
DOCS_PACKAGES=(python3-venv)

# setup_docs: what builds the site, by hash, in .setup/docs-tools, a virtual environment of Debian's Python.
setup_docs() {
  local tools=$SETUP/docs-tools list=scripts/site/requirements.txt
  cmp -s "$list" "$tools/installed.txt" && return 0
  say "installing what builds the documentation"
  rm -rf "$tools"
  quietly "$DEBIAN_PYTHON" -m venv "$tools"
  quietly "$tools/bin/pip" install --disable-pip-version-check --no-compile --no-deps --only-binary=:all: \
    --require-hashes -r "$list"
  cp "$list" "$tools/installed.txt"
}

task_docs() {
  local port=
  if [ "${1:-}" = --port ]; then port=${2:-}; fi
  if [ $# -ne 0 ] && { [ $# -ne 2 ] || ! [[ $port =~ ^[0-9]+$ ]] || [ "$port" -lt 1 ] || [ "$port" -gt 65535 ]; }; then
    say "usage: ./dev docs [--port N] with N from 1 to 65535, not \"$*\""
    exit 2
  fi
  setup_packages "${COMPILE_PACKAGES[@]}" "${DOCS_PACKAGES[@]}"
  setup_docs
  setup_wgpu
  configure release
  compile release weft
  NO_MKDOCS_2_WARNING=1 WEFT=build/weft quietly "$SETUP/docs-tools/bin/mkdocs" build --quiet
  echo build/site/index.html
  [ -z "$port" ] || exec "$DEBIAN_PYTHON" -m http.server --bind 127.0.0.1 --directory build/site "$port"
}
