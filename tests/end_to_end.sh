#!/usr/bin/env bash
# The program, the sweep and the report together, as their users call them.
#
# usage: tests/end_to_end.sh [PITBENCH]        (default: build/pitbench)
#
# Works in a temporary folder. Prints "ok" or "FAILED" for each claim, what was
# seen where it failed, and the sum; exit code 1 when a claim did not hold.
# shellcheck disable=SC2317  # functions reached through check()
set -uo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
pitbench=$(realpath -m "${1:-$repository/build/pitbench}")
cd "$repository" || exit 2
readonly repository pitbench python=/usr/bin/python3
[[ -x $pitbench ]] || {
  echo "end_to_end: $pitbench is not there; run cmake --build --preset release" >&2
  exit 2
}

work=$(mktemp -d)
sweep_pid=''
clean_up() {
  [[ -z $sweep_pid ]] || kill -KILL -- "-$sweep_pid" 2>/dev/null
  rm -rf "$work"
}
trap clean_up EXIT
passed=0 failed=0

# check TITLE COMMAND...: the claim holds if the command succeeds.
check() {
  local title=$1
  shift
  if "$@" >"$work/seen" 2>&1; then
    passed=$((passed + 1))
    echo "ok $title"
  else
    failed=$((failed + 1))
    echo "FAILED $title"
    head -n 30 "$work/seen" | sed 's/^/  | /'
  fi
}

# --- Sweep, kill, resume -------------------------------------------------------

readonly run=$work/results/tiny
sweep=("$python" harness/sweep.py --pitbench "$pitbench" --profile tiny --out "$run")

shard_files() { find "$run" -maxdepth 1 -regex '.*/\(limits\|limits_after\|speed-.*\|accuracy-.*\|maps\|operations\|instructions\)\.json'; }

# The commands of the shards that the sweep is running now.
running_shards() {
  local child
  # shellcheck disable=SC2013  # one line of words
  for child in $(cat "/proc/$1/task/$1/children" 2>/dev/null); do
    tr '\0' ' ' <"/proc/$child/cmdline" 2>/dev/null | grep -E ' (limits|speed|accuracy|maps|operations|instructions) ' || true
  done
}

kill_in_a_shard() {
  setsid "${sweep[@]}" >"$work/first.log" 2>&1 &
  sweep_pid=$!
  local until=$((SECONDS + 120))
  # One shard done, another at work: there is something to lose and to keep.
  until [[ -n $(shard_files) && -n $(running_shards "$sweep_pid") ]]; do
    if ! kill -0 "$sweep_pid" 2>/dev/null || ((SECONDS > until)); then
      cat "$work/first.log"
      echo "the sweep ended before it could be killed"
      return 1
    fi
    sleep 0.01
  done
  kill -KILL -- "-$sweep_pid"
  wait "$sweep_pid" 2>/dev/null
  sweep_pid=''
  shard_files | sort | xargs sha256sum >"$work/kept"
  local have want
  have=$(wc -l <"$work/kept") want=$("$pitbench" shards --profile tiny | wc -l)
  echo "killed with $have of $want shards"
  ((have >= 1 && have < want))
}

every_file_reads() {
  local file
  for file in "$run"/*.json; do
    "$python" -m json.tool "$file" /dev/null || return
  done
}

resumes() {
  "${sweep[@]}" && sha256sum --check "$work/kept"
}

complete() {
  diff <(shard_files | xargs -n 1 basename -s .json | sort) \
    <("$pitbench" shards --profile tiny | cut -f 1 | sort) &&
    [[ -s $run/machine.json && -s $run/methods.json ]] &&
    [[ -z $(find "$run" -name '*.tmp*') ]]
}

runs_nothing_again() {
  "${sweep[@]}" | tee "$work/again" && grep -q '^0 shards run' "$work/again"
}

check 'a sweep is killed with SIGKILL in the middle of a shard' kill_in_a_shard
check 'after the kill every file there is whole' every_file_reads
check 'the next start goes on and keeps what was done' resumes
check 'the resumed run is complete, without leftovers' complete
check 'a third start runs nothing' runs_nothing_again

# --- Report --------------------------------------------------------------------

readonly page=$run/report/index.html

# Of the run and of a copy of it elsewhere, at the same time.
readonly copy=$work/elsewhere/tiny
two_reports() {
  mkdir "${copy%/*}" && cp -r "$run" "$copy" || return
  "$python" -m analysis report "$copy" &
  "$python" -m analysis report "$run" && wait $!
}

one_file_without_network() {
  local bytes
  bytes=$(stat -c %s "$page") || return
  echo "$bytes bytes"
  ((bytes <= 5 * 1024 * 1024)) || return
  # A link to read on is fine; what the page itself would fetch is not.
  ! grep -noE "(src|poster)=[\"'](https?:)?//[^\"']*|<link[^>]*href=[\"'](https?:)?//[^\"']*|@import[^;]*|url\([\"']?(https?:)?//[^)]*" "$page"
}

# Loads a page in headless Chromium; anything on the console is an error.
loads_quietly() {
  local seen=$work/browser
  timeout 120 chromium --headless --no-sandbox --disable-gpu \
    --disable-dev-shm-usage --user-data-dir="$work/chromium" \
    --host-resolver-rules='MAP * ~NOTFOUND' --enable-logging=stderr \
    --virtual-time-budget=10000 --dump-dom "file://$1" >"$seen.html" 2>"$seen.log" || {
    tail -n 20 "$seen.log"
    return 1
  }
  grep -q '</html>' "$seen.html" || {
    echo 'the browser printed no page'
    return 1
  }
  ! grep CONSOLE "$seen.log"
}

notices_a_console_error() {
  echo '<!DOCTYPE html><script>undefinedFunction()</script>' >"$work/broken.html"
  ! loads_quietly "$work/broken.html" && grep -q undefinedFunction "$work/browser.log"
}

check 'two reports of the same run are written' two_reports
check 'they are the same, byte for byte' diff -rq "$copy/report" "$run/report"
check 'the report is one file within 5 MB that fetches nothing' one_file_without_network
check 'Chromium loads the report without a console message' loads_quietly "$page"
check 'and would have noticed one' notices_a_console_error

# --- Noise ---------------------------------------------------------------------

check 'beside a busy process on its core a run is noisy' \
  "$python" tests/busy_core.py "$pitbench" "$work/busy"

# --- The command line: good input ----------------------------------------------

readonly header=ax,ay,bx,by,cx,cy,px,py

classifies_a_million_lines() {
  # Inside, outside, inside, ...: the point alternates.
  awk -v header="$header" 'BEGIN { print header
    for (i = 0; i < 500000; ++i) {
      print "0,0,4,0,0,4,1,1"; print "0,0,4,0,0,4,3,3" } }' >"$work/million.csv"
  "$pitbench" classify --method truth "$work/million.csv" >"$work/answers" &&
    cmp "$work/answers" <(yes $'inside\noutside' | head -n 1000000)
}

reads_stdin_and_hex() {
  [[ $(printf '%s\n0,0,0x1p+2,0,0,4,1,1\n' "$header" |
    "$pitbench" classify --method truth -) == inside ]]
}

agrees_with_real_world() {
  local scalar cases=tests/cases/real_world.csv
  for scalar in $(tail -n +2 $cases | cut -d, -f2 | sort -u); do
    awk -F, -v OFS=, -v scalar="$scalar" -v header="$header" '
      NR == 1 { print header }
      $2 == scalar { print $4, $5, $6, $7, $8, $9, $10, $11 }' \
      $cases >"$work/cases.csv"
    "$pitbench" classify --method truth --scalar "$scalar" "$work/cases.csv" \
      >"$work/answers" || return
    diff "$work/answers" <(awk -F, -v s="$scalar" '$2 == s { print $12 }' $cases) ||
      return
  done
}

# Rounded to doubles, and as they were typed.
knows_both_truths() {
  local column cases=tests/cases/typed_decimals.csv
  awk -F, -v OFS=, -v header="$header" 'NR == 1 { print header }
    NR > 1 { print $4, $5, $6, $7, $8, $9, $10, $11 }' $cases >"$work/typed.csv"
  for column in 12 13; do
    # shellcheck disable=SC2046  # --decimal or nothing
    "$pitbench" classify --method truth $( ((column == 13)) && echo --decimal) \
      "$work/typed.csv" >"$work/answers" || return
    diff "$work/answers" <(tail -n +2 $cases | cut -d, -f$column) || return
  done
}

help_has_examples() {
  local command
  for command in '' classify speed accuracy limits maps operations instructions hunt machine shards list; do
    # shellcheck disable=SC2086  # '' is no argument
    "$pitbench" $command --help | tee -a "$work/help" | grep -q . || return
  done
  grep -qi example "$work/help"
}

check 'classify reads a million lines' classifies_a_million_lines
check 'classify reads stdin and hex floats' reads_stdin_and_hex
check 'truth agrees with every real-world case' agrees_with_real_world
check 'truth knows typed decimals from rounded ones' knows_both_truths
check '--help works everywhere and gives examples' help_has_examples

# --- The command line: bad input -----------------------------------------------

# refused PATTERNS ARGUMENTS...: exit 2, nothing on stdout, and a message that
# matches each of the patterns (separated by "&"); nothing is left on disk.
refused() {
  local patterns status=0 pattern before
  IFS='&' read -r -a patterns <<<"$1"
  shift
  before=$(find "$work/bad" | sort)
  "$pitbench" "$@" >"$work/out" 2>"$work/err" </dev/null || status=$?
  echo "exit $status; stdout: $(head -c 200 "$work/out"); stderr:"
  cat "$work/err"
  ((status == 2)) && [[ ! -s $work/out && -s $work/err ]] || return
  for pattern in "${patterns[@]}"; do
    grep -qE -- "$pattern" "$work/err" || {
      echo "the message lacks: $pattern"
      return 1
    }
  done
  diff <(echo "$before") <(find "$work/bad" | sort)
}

readonly bad=$work/bad
mkdir "$bad"
good_line=0,0,4,0,0,4,1,1
printf '%s\n%s\n0,0,4,0,0\n' $header $good_line >"$bad/truncated.csv"
printf '%s\n%s\n%s,7\n' $header $good_line $good_line >"$bad/long.csv"
printf '%s\n%s\n0,0,four,0,0,4,1,1\n' $header $good_line >"$bad/word.csv"
printf '%s\n0,0,4x,0,0,4,1,1\n' $header >"$bad/trailing.csv"
printf 'x,y,z\n%s\n' $good_line >"$bad/header.csv"
printf '%s\n' $good_line >"$bad/headless.csv"
: >"$bad/empty.csv"
head -c 4096 /dev/zero >"$bad/binary.csv"
{
  echo $header
  yes $good_line | head -n 100000
  echo 0,0,4,0,0,4,1,
} >"$bad/late.csv"

refused_file() {
  check "classify refuses $1: $3" refused "$2" classify --method truth "$bad/$1"
}
refused_file truncated.csv 'truncated.csv&\b3\b&cy' 'names file, line and field'
refused_file long.csv 'long.csv&\b3\b' 'names file and line'
refused_file word.csv 'word.csv&\b3\b&bx&four' 'names file, line, field and text'
refused_file trailing.csv 'trailing.csv&\b2\b&bx' 'a number with letters behind it'
refused_file header.csv "header.csv&$header" 'says what the header must be'
refused_file headless.csv "headless.csv&$header" 'a file without header'
refused_file empty.csv 'empty.csv&empty|header' 'an empty file'
refused_file binary.csv 'binary.csv' 'a file that is not text'
refused_file late.csv 'late.csv&100002&py' 'an error in the last of 100001 lines'
refused_file missing.csv 'missing.csv' 'a missing file'
check 'classify refuses a folder' refused 'bad' classify --method truth "$bad"
check 'classify without a method says so' refused 'method' classify "$bad/word.csv"
check 'a mistyped method suggests the nearest' refused 'edge_function' \
  classify --method edge_funtion "$bad/word.csv"
check 'a mistyped scalar is refused' refused 'f23&f32' \
  classify --method truth --scalar f23 "$bad/word.csv"
check 'a mistyped ISA is refused' refused 'avx2' \
  classify --method edge_function --isa avx22 "$bad/word.csv"
check '--decimal is for truth only' refused 'decimal&truth' \
  classify --method edge_function --decimal "$bad/late.csv"
check 'a mistyped command is refused' refused 'clasify' clasify
check 'a mistyped profile is refused' refused 'quick' shards --profile quik
check 'a broken filter is refused' refused 'filter' \
  speed --filter '(' --out "$bad/out.json"
check 'a filter that matches nothing is refused' refused 'nothing_like_it' \
  accuracy --filter '^nothing_like_it$' --out "$bad/out.json"
check 'a mistyped scene suggests the nearest' refused 'near_edge' \
  accuracy --scene near_egde:ulps=1 --out "$bad/out.json"
check 'speed needs --out' refused 'out' speed --profile tiny

hunts() {
  "$pitbench" hunt --method uv_projection --scalar f32 --seconds 0.2 \
    --out "$work/hunt.csv" >"$work/answers" && cmp "$work/answers" "$work/hunt.csv" || return
  # What it says of the truth is what classify says.
  { echo $header && tail -n +2 "$work/hunt.csv" | cut -d, -f3-10; } >"$work/cases.csv"
  diff <(tail -n +2 "$work/hunt.csv" | cut -d, -f12) \
    <("$pitbench" classify --method truth --scalar f32 "$work/cases.csv") &&
    diff <(tail -n +2 "$work/hunt.csv" | cut -d, -f11) \
      <("$pitbench" classify --method uv_projection --scalar f32 "$work/cases.csv") &&
    [[ $(wc -l <"$work/hunt.csv") -ge 2 ]]
}
check 'hunt finds wrong answers and prints what it stores' hunts
hunts_rays() {
  "$pitbench" hunt --method plane_gram --scalar f32 --seconds 0.2 >"$work/rays.csv" &&
    [[ $(sed -n 2p "$work/rays.csv") == plane_gram,f32,*,hit,miss,* ]] &&
    "$pitbench" hunt --rays --method exact --seconds 0.1 | grep -q ',none_found,,$'
}
check 'hunt finds the rays on which a ray method is wrong, and none of an exact one' hunts_rays
verifies_rays() {
  "$pitbench" verify --rays --method exact --points 2000 2>/dev/null |
    grep -q ' rays (.*, 0 wrong$' || return
  ! "$pitbench" verify --method plane_gram --points 2000 >"$work/answers" 2>"$work/errors" &&
    grep -q 'plane_gram on .* which is ' "$work/errors"
}
check 'verify finds exact rays right and says of which ray another is wrong' verifies_rays
keeps_a_verification() {
  "$pitbench" verify --method exact --scalar f32 --points 2000 --out "$work/verify.json" || return
  "$python" - "$work/verify.json" <<'END'
import sys
from pathlib import Path

from analysis.read.read_json import read_json

found = read_json(Path(sys.argv[1]), "verify")
assert found["points"] >= 2000 and found["wrong"] == 0, found
assert found["boundary_points"] > 0 and found["first_wrong"] is None, found
END
}
check 'verify keeps its result in a file that fits its schema' keeps_a_verification
check 'verify refuses to write to a folder' refused 'bad' \
  verify --method exact --points 1 --out "$bad"
check 'hunt refuses to hunt for no time' refused 'seconds' \
  hunt --method uv_projection --seconds 0
check 'hunt refuses a time that is no number' refused 'seconds' \
  hunt --method uv_projection --seconds soon
check 'hunt suggests the nearest method' refused 'uv_projection' \
  hunt --method uv_projektion --seconds 1
check 'hunt refuses a mistyped ISA' refused 'avx2' \
  hunt --method uv_projection --isa avx22 --seconds 1
check 'hunt refuses to write to a folder' refused 'bad' \
  hunt --method uv_projection --seconds 1 --out "$bad"

readonly quick_cell='^one_triangle/uniform.*/cross_product/f32/scalar$'
for place in "$bad/no/such/folder/out.json" "$bad/word.csv/out.json" "$bad"; do
  for kind in speed accuracy limits maps operations instructions; do
    check "$kind refuses to write to ${place#"$work/"}" refused "${place##*/}" \
      "$kind" --profile tiny --filter "$quick_cell" --out "$place"
  done
  check "machine refuses to write to ${place#"$work/"}" refused "${place##*/}" \
    machine --out "$place"
done

echo "$passed passed, $failed failed"
((failed == 0))
