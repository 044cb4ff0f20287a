#!/usr/bin/env bash
# tour.sh BUILD: the patch of the tour that needs a server, with one, in real time: subscribed, told to
# play, and heard. Complains as tests/pd/run_pd.sh does.
set -eu
build=$1
root=$(dirname "$(readlink -f "$0")")/../..
work=$(mktemp -d)
server=
trap '[ -z "$server" ] || kill "$server"; rm -rf "$work"' EXIT

"$build/bin/percussionist" serve --scores "$work" >"$work/said" &
server=$!
until grep -q '^listening' "$work/said"; do
    kill -0 "$server"
    sleep 0.02
done
PD_REAL_TIME=1 "$root/tests/pd/run_pd.sh" "$build/externals" "$root/patches/tour/09-steer-him.pd" \
    -open "$root/tests/pd/tour.pd"
