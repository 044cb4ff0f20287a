#!/usr/bin/env bash
# errors.sh PERCUSSIONIST: what goes wrong is one clear line on standard error and an exit code.
set -u
percussionist=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# expect NAME PATTERN COMMAND...: it has to fail, with one line that matches.
expect() {
    local name=$1 pattern=$2 code lines
    shift 2
    "$@" >/dev/null 2>"$work/error"
    code=$?
    lines=$(wc -l <"$work/error")
    if [ "$code" = 0 ] || [ "$lines" != 1 ] || ! grep -q -- "$pattern" "$work/error"; then
        echo "$name: exit code $code, expected one line with '$pattern', got:"
        cat "$work/error"
        failed=1
    fi
}

expect 'a missing file' 'nowhere.mid' "$percussionist" render nowhere.mid -o "$work/out"
head -c 2000 /dev/zero >"$work/broken.mid"
expect 'a broken file' 'broken.mid: byte 0' "$percussionist" serve "$work/broken.mid" --port 0
expect 'a broken recording' 'broken.mid: byte 0: expected' "$percussionist" replay "$work/broken.mid"
expect 'an impossible folder' 'performance' "$percussionist" check "$work/performance.wav" "$work/c.csv"
expect 'an unknown address' 'no host' "$percussionist" serve --listen no.such.host --port 0

# A busy port, and an orderly end on either signal.
for signal in INT TERM; do
    "$percussionist" serve --port 0 >"$work/said" &
    server=$!
    port=
    until [ -n "$port" ]; do port=$(sed -n 's/^listening on .* port //p' "$work/said"); done
    expect 'a busy port' "port $port" "$percussionist" serve --port "$port"
    kill "-$signal" "$server"
    wait "$server" || { echo "SIG$signal: exit code $?, expected 0"; failed=1; }
done
exit "$failed"
