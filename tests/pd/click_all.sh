#!/bin/sh
# click_all.sh CLICKS EXTERNALS SOURCES PATCH: a copy of all patches, so that what is saved is not saved in
# the sources, and in it every message box of PATCH clicked twice by a real Pd. Complains as run_pd.sh does.
set -eu
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$3/patches" "$3/help" "$3/drums" "$work"
"$1" "$work/$4" >"$work/clicks.txt"
"$here/run_pd.sh" "$2" "$work/$4" -open "$here/clicks.pd" -send "clicks-list symbol $work/clicks.txt"
