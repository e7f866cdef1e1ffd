#!/usr/bin/env bash
# What ./dev test --bare runs in its bare root: README's first command at a small size, and with --web the page.
set -euo pipefail
cd "$(dirname "$0")/.."

timed() {
  local from=$SECONDS
  "$@"
  printf 'weft: %s s for %s\n' $((SECONDS - from)) "$*" >&2
}

timed ./dev run pull-armadillo --frames 2 --set 'cloths.0.grid=[32,32]' --set 'render.size=[320,180]'
python3 scripts/bare_pictures.py out/pull-armadillo 2 320 180
./dev run --help | grep "Usage: weft run" >/dev/null || {
  echo "weft: ./dev run --help shows no help" >&2
  exit 1
}

if [ "${1:-}" != --web ]; then
  echo "weft: the bare machine has run README's first command (${SECONDS} s)" >&2
  exit 0
fi
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
timed ./dev web --port "$port" &
server=$!
# A time limit for a hang only: ten times what a machine of two cores takes.
for _ in $(seq 3600); do
  fetch="import urllib.request; print(urllib.request.urlopen('http://127.0.0.1:$port/').read().decode())"
  if page=$(python3 -c "$fetch" 2>/dev/null); then
    [[ $page == *"<title>weft"* ]] || {
      echo "weft: the page at port $port is another: $page" >&2
      exit 1
    }
    echo "weft: the bare machine has run README's first command, and serves the page (${SECONDS} s)" >&2
    exit 0
  fi
  kill -0 $server 2>/dev/null || {
    echo "weft: ./dev web has ended before its page answered" >&2
    exit 1
  }
  sleep 1
done
echo "weft: the page has not answered for an hour" >&2
exit 1
