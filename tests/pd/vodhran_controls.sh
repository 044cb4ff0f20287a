#!/bin/sh
# vodhran_controls.sh EXTERNALS SOURCES: what the controls of patches/vodhran.pd say to the drum. In a copy of
# it the patch's own names are open to all, so that vodhran-controls.pd moves the controls, and prints.
set -eu
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$2/patches" "$2/help" "$2/drums" "$work"
sed 's/\\\$0-/vodhran-/g' "$2/patches/vodhran.pd" >"$work/patches/vodhran.pd"
"$here/run_pd.sh" "$1" "$work/patches/vodhran.pd" -open "$here/vodhran-controls.pd" >"$work/said"
sed -n 's/^drum: //p' "$work/said" >"$work/told"
diff "$here/vodhran-controls.txt" "$work/told"
