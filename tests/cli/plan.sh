#!/usr/bin/env bash
# plan.sh PERCUSSIONIST: a score becomes gestures in tables and pictures; what is asked for wrongly is
# one line of error.
set -eu
percussionist=$1
. "$(dirname "$(readlink -f "$0")")/song.sh"
"$percussionist" plan "$work/song.mid" --plot "$work/plan" --with '/tempo 1.5 2' '/nuance accent left' |
    tee "$work/said"
strokes=$(sed -n 's/.*: \([0-9]*\) strokes, .*/\1/p' "$work/said")
[ "$strokes" -gt 0 ]
[ "$(($(wc -l <"$work/plan/strokes.csv") - 1))" = "$strokes" ]
grep -q 'left,accent' "$work/plan/strokes.csv"
grep -q '^<svg' "$work/plan/score-01.svg"
[ "$(wc -l <"$work/plan/heights.csv")" -gt 100 ]
if "$percussionist" plan "$work/song.mid" --with '/tempo fast' 2>"$work/error"; then exit 1; fi
grep -q 'FACTOR' "$work/error"
[ "$(wc -l <"$work/error")" -le 2 ]
