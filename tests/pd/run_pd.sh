#!/bin/sh
# run_pd.sh EXTERNALS PATCH [pd's further arguments]: opens a patch in a real Pd, without sound card
# or window and faster than real time; the patch has to quit by itself. Fails on whatever Pd complains
# of, for Pd's own exit code does not tell.
# PD_MAY_COMPLAIN=1: only its exit code counts. PD_MAY_SAY=PATTERN: these complaints are meant.
# PD_QUIET=1: what it said is not shown. PD_TIMEOUT: after so many seconds it fails (60).
# PD_REAL_TIME=1: by the system's clock, for what has threads or sockets. PD_PRELOAD: a library to preload.
externals=$1
patch=$2
shift 2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
pace=-batch
[ -z "$PD_REAL_TIME" ] || pace="-sleepgrain 0.5"
# shellcheck disable=SC2086  # two words
timeout "${PD_TIMEOUT:-60}" env ${PD_PRELOAD:+LD_PRELOAD="$PD_PRELOAD"} pd -noprefs -nrt -nogui -noaudio $pace -stderr -r 48000 \
    -path "$externals" "$@" -open "$patch" >"$log" 2>&1
code=$?
[ -n "$PD_QUIET" ] || cat "$log"
if [ -z "$PD_MAY_COMPLAIN" ] && grep -vE "${PD_MAY_SAY:-^$}" "$log" |
    grep -qE "couldn't create|error:|can't|no method|expected|connection failed"; then
    exit 1
fi
exit $code
