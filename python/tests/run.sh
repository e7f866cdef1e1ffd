#!/usr/bin/env bash
# run.sh: the wheel of build/wheel, installed into an empty virtual environment, and its tests in an empty folder.
set -euo pipefail
checkout=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
wheels=("$checkout"/build/wheel/weft-*-cp311-*.whl)
[ -e "${wheels[0]}" ] || {
  echo "There is no wheel for Python 3.11 in $checkout/build/wheel: ./dev wheel makes it."
  exit 1
}
/usr/bin/python3 -m venv env
env/bin/pip install --no-compile --quiet --disable-pip-version-check --no-index \
  --find-links "$checkout/.setup/python-wheels" "${wheels[@]}[ray,usd,alembic]" mypy trimesh
unset WEFT_MODELS XDG_RUNTIME_DIR PYTHONPATH
export PYTHONPYCACHEPREFIX=$folder/compiled # once for all processes, and not in this checkout
env/bin/python -m unittest discover -b -s "$checkout/python/tests" "$@"
