#!/bin/sh
# click_all.sh CLICKS EXTERNALS FOLDER PATCH: a copy of FOLDER, so that what is saved is not saved in the
# sources, and in it every message box of PATCH clicked once by a real Pd. Complains as run_pd.sh does.
set -eu
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$3" "$work/copy"
"$1" "$work/copy/$4" >"$work/clicks.txt"
"$here/run_pd.sh" "$2" "$work/copy/$4" -open "$here/clicks.pd" -send "clicks-list symbol $work/clicks.txt"
