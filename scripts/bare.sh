# ./dev test --bare [--web]: README's first command, and with --web the page, on a bare Debian 12 in its own folder.

# How this machine reaches its package registries; a user's machine may have none of these.
bare_settings() { # bare_settings ROOT
  local root=$1 file
  apt-config dump | grep -E '^Acquire::(Check-|http|https|Retries|ForceIP)' \
    >"$root/etc/apt/apt.conf.d/99machine" || true
  for file in /etc/pip.conf ~/.npmrc /etc/resolv.conf /etc/hosts \
    "${PIP_CERT:-}" "${SSL_CERT_FILE:-}" "${NODE_EXTRA_CA_CERTS:-}"; do
    if [ -f "$file" ]; then mkdir -p "$root$(dirname "$file")" && cp -L "$file" "$root$file"; fi
  done
}

# bare_root ROOT: a minimal Debian 12 with this machine's sources, and HEAD of this checkout in /weft.
bare_root() {
  local root=$1 sources=()
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources; do
    if [ -s "$file" ]; then sources+=("$file"); fi
  done
  say "making a bare Debian 12 in $root"
  quietly mmdebstrap --variant=minbase --include=ca-certificates,git --dpkgopt=force-unsafe-io \
    bookworm "$root" "${sources[@]}"
  bare_settings "$root"
  quietly git clone --depth 1 "file://$PWD" "$root/weft"
}

# bare_run ROOT COMMAND...: runs it in the root, in namespaces of its own: what is mounted or left running there ends
# with them, however this ends. The compiler cache is lent, so that this does not take the time of a cold compile.
bare_run() {
  local root=$1 cache variable settings=()
  shift
  cache=$(ccache -k cache_dir)
  mkdir -p "$cache"
  for variable in $(compgen -e); do
    case $variable in
      PIP_* | npm_config_* | *_proxy | *_PROXY | SSL_CERT_FILE | NODE_EXTRA_CA_CERTS | LANG | LC_*)
        settings+=("$variable=${!variable}")
        ;;
    esac
  done
  # shellcheck disable=SC2016
  unshare --mount --pid --fork --kill-child bash -euc '
    root=$1 cache=$2
    shift 2
    mount -t proc proc "$root/proc"
    mount --rbind /dev "$root/dev"
    mkdir -p "$root/ccache"
    mount --bind "$cache" "$root/ccache"
    exec chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root CCACHE_DIR=/ccache "$@"
  ' bash "$root" "$cache" "${settings[@]}" "$@" &
  bare_job=$!
  wait $bare_job
}

bare_end() { # bare_end ROOT
  if [ -n "$bare_job" ] && kill -KILL "$bare_job" 2>/dev/null; then wait "$bare_job" 2>/dev/null || true; fi
  rm -rf --one-file-system "$1" || {
    sleep 1
    rm -rf --one-file-system "$1"
  } # what still writes has been killed
}

task_bare() {
  [ "$(id -u)" = 0 ] || fail "./dev test --bare makes a root file system and changes into it: run it as root."
  setup_packages mmdebstrap git ccache
  bare_job=
  bare_folder=$(mktemp -d --tmpdir weft-bare.XXXXXX)
  trap 'bare_end "$bare_folder"' EXIT
  trap 'exit 130' INT
  trap 'exit 143' TERM HUP
  chmod 755 "$bare_folder"
  bare_root "$bare_folder"
  bare_run "$bare_folder" /weft/scripts/bare_commands.sh "$1"
}
