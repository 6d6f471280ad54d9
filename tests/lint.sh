#!/usr/bin/env bash
# Checks of the text itself: format, types, names, length, no private paths.
#
# usage: tests/lint.sh        (from anywhere; clang-tidy wants a configured build/)
#
# Prints "ok" or "FAILED" for each check, what is wrong above it, and the sum.
# shellcheck disable=SC2317  # functions reached through check()
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 2

readonly python=/usr/bin/python3 longest=450
passed=0 failed=0

# Tracked files, or all of an exported tree, that match a pattern.
files() {
  {
    git ls-files 2>/dev/null ||
      find . -type f -not -path './build*' -not -path './results/*' -printf '%P\n'
  } | grep -E "$1" | while IFS= read -r file; do
    [[ ! -f $file ]] || echo "$file"
  done
}

scripts() {
  files '' | while IFS= read -r file; do
    [[ $(head -c 21 "$file" | tr -d '\0') != '#!/'*bash* ]] || echo "$file"
  done
}

check() {
  local title=$1 started=$SECONDS
  shift
  if "$@"; then
    passed=$((passed + 1))
    echo "ok $title ($((SECONDS - started)) s)"
  else
    failed=$((failed + 1))
    echo "FAILED $title ($((SECONDS - started)) s)"
  fi
}

cpp_format() {
  files '\.(cc|h)$' | xargs -r clang-format-14 --dry-run -Werror
}

python_format() {
  files '\.py$' | xargs -r "$python" -m black --check --quiet --diff
}

python_types() {
  "$python" -m mypy --strict analysis harness/sweep.py &&
    MYPYPATH=harness "$python" -m mypy --strict --explicit-package-bases tests/sweep \
      tests/reproduce
}

shell_scripts() {
  scripts | xargs -r -n 1 bash -n && scripts | xargs -r shellcheck
}

# Our own folders must not end up in what others clone.
no_private_paths() {
  local found
  found=$(files '' | xargs -r grep -nIE '(^|[^A-Za-z0-9_.}/-])/(home|Users|work)/[A-Za-z0-9]')
  # A short place like /pitbench may well be meant; a deep one is private.
  if [[ $PWD == /*/* ]]; then
    found+=$(files '' | xargs -r grep -nIF "$PWD/")
  fi
  [[ -z $found ]] || {
    printf '%s\n' "$found"
    return 1
  }
}

file_length() {
  files '\.(cc|h|inc|py|sh|sbatch|cmake)$|(^|/)(reproduce|CMakeLists.txt|run)$' |
    xargs -r wc -l | awk -v longest="$longest" '
      $2 != "total" && $1 >= longest { print $2 ": " $1 " lines"; bad = 1 }
      END { exit bad }'
}

# The harness only: a kernel file is compiled once a target, and Highway's
# headers take clang-tidy minutes. A folder's files are looked at as one, since
# their headers, read once a file, take most of the time.
cpp_tidy() {
  if [[ ! -f build/compile_commands.json ]]; then
    echo "no build/compile_commands.json: run cmake --preset release"
    return 1
  fi
  # Not what is compiled for arm64, of which clang-tidy has no command.
  files '^harness/.*\.cc$' | grep -v '^harness/arm64/' |
    "$python" tests/joined_files.py build/joined |
    xargs -r -n 1 -P "$(nproc)" clang-tidy-14 -p build/joined --quiet \
      --header-filter='/(kernels|harness)/[a-z_/-]*\.(h|cc)$' 2>/dev/null
}

check 'clang-format' cpp_format
check 'black' python_format
check 'mypy --strict' python_types
check 'bash -n and shellcheck' shell_scripts
check 'no private paths' no_private_paths
check "code files under $longest lines" file_length
check 'clang-tidy' cpp_tidy
echo "$passed passed, $failed failed"
((failed == 0))
