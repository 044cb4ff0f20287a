#!/usr/bin/env bash
# render_twice.sh PERCUSSIONIST: a run is reproducible, to the last byte of contacts, motion and sound.
set -eu
percussionist=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for run in one two; do "$percussionist" render -o "$work/$run" >"$work/$run.txt"; done
diff -r "$work/one" "$work/two"
diff "$work/one.txt" "$work/two.txt"
