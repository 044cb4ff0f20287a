#!/usr/bin/env bash
# figure.sh PERCUSSIONIST: the shapes that the viewer shows are those the program makes.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" figure -o "$work"
diff -r "$work" "$(dirname "$(readlink -f "$0")")/../../patches/viewer/figure"
