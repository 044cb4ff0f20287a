#!/usr/bin/env bash
# render_twice.sh PERCUSSIONIST: a run is reproducible, to the last byte of contacts, motion and sound;
# and what he plays with is heard: a harder tip is louder.
set -eu
percussionist=$1
. "$(dirname "$(readlink -f "$0")")/song.sh"
for run in one two; do "$percussionist" render -o "$work/$run" >"$work/$run.txt"; done
diff -r "$work/one" "$work/two"
diff "$work/one.txt" "$work/two.txt"

peak() {
    "$percussionist" render "$work/song.mid" -o "$work/$1" --with "/mallet 0.05 $2" | sed -n 's/^peak level *//p'
}
soft=$(peak soft 2e7)
hard=$(peak hard 1e10)
awk -v soft="$soft" -v hard="$hard" 'BEGIN { exit !(hard > 1.3 * soft) }' || {
    echo "peak level $soft with a soft tip, $hard with a hard one"
    exit 1
}
