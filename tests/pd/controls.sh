#!/bin/sh
# controls.sh EXTERNALS SOURCES NAME: what the controls of patches/NAME.pd say. In a copy of it the patch's own
# names ($0-...) begin with NAME, so that NAME-controls.pd can move them; what that prints as "told" has to be
# what NAME-controls.txt says.
set -eu
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$2/patches" "$2/help" "$2/drums" "$work"
sed "s/\\\\\$0-/$3-/g" "$2/patches/$3.pd" >"$work/patches/$3.pd"
"$here/run_pd.sh" "$1" "$work/patches/$3.pd" -open "$here/$3-controls.pd" >"$work/said" || {
    cat "$work/said"
    exit 1
}
sed -n 's/^told: //p' "$work/said" >"$work/told"
diff "$here/$3-controls.txt" "$work/told"
