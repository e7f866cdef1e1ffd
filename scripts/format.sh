#!/usr/bin/env bash
# Formats the tree, or with --check says what is not formatted and ends with 1. The tools are those of setup_format.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH=$PWD/.setup/bin:$PATH

check=
case "${1:-}" in
  --check) check=1 ;;
  "") ;;
  *)
    echo "usage: ./dev format [--check]" >&2
    exit 2
    ;;
esac

wrong=0
# part NAME FIX CHECK FILES...: runs the words of FIX or of CHECK on the files of these patterns.
part() {
  local name=$1 words
  if [ -n "$check" ]; then words=$3; else words=$2; fi
  shift 3
  # shellcheck disable=SC2086
  if ! git ls-files -z --cached --others --exclude-standard "$@" | existing | xargs -0 -r -n 100 -P 2 $words; then
    echo "$name: see above" >&2
    wrong=1
  fi
}
existing() { # a file may be deleted in the tree and still stand in git's index
  local file
  while IFS= read -r -d '' file; do
    if [ -e "$file" ]; then printf '%s\0' "$file"; fi
  done
}

part "C++" "clang-format-14 -i" "clang-format-14 --dry-run --Werror" '*.cpp' '*.hpp'
part "web" "node scripts/format_web.ts" "node scripts/format_web.ts --check" '*.ts' '*.js' '*.css' '*.html'
part "Python" "ruff format --quiet" "ruff format --check" '*.py'
part "shell" "shfmt -i 2 -ci -w" "shfmt -i 2 -ci -d" '*.sh' dev .ci/run
shellcheck --external-sources --check-sourced dev .ci/run scripts/format.sh || wrong=1
if [ -n "$check" ]; then python3 -B scripts/lines.py; else python3 -B scripts/lines.py --fix; fi || wrong=1
exit $wrong
