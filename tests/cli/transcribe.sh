#!/usr/bin/env bash
# transcribe.sh PERCUSSIONIST ODD-RECORDINGS: whatever the recording is, drums are heard in it, or
# none, or one clear line tells what is wrong with it.
set -u
percussionist=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$2" "$work"
failed=0

fail() {
    echo "$1"
    failed=1
}

# hear FILE: into $work/heard.csv and .mid
hear() {
    "$percussionist" transcribe "$work/$1" -o "$work/heard.mid" >"$work/said" 2>"$work/error" ||
        fail "$1: $(cat "$work/error")"
    [ "$(head -c 4 "$work/heard.mid")" = MThd ] || fail "$1: no MIDI file"
}

# count DRUM: of what was heard last; all: of any drum
count() { if [ "$1" = all ]; then tail -n +2 "$work/heard.csv" | wc -l; else grep -c ",$1," "$work/heard.csv"; fi; }

# alike FILE PERCENT DRUM...: as many strokes as in drums.wav, but for some
alike() {
    local file=$1 percent=$2 drum got
    shift 2
    hear "$file"
    for drum; do
        got=$(count "$drum")
        [ $((100 * (got > expected[$drum] ? got - expected[$drum] : expected[$drum] - got))) -le \
            $((percent * expected[$drum])) ] ||
            fail "$file: $got $drum, ${expected[$drum]} in drums.wav"
    done
}

# at_most FILE COUNT
at_most() {
    hear "$1"
    [ "$(count all)" -le "$2" ] || fail "$1: $(cat "$work/said")"
}

# refused FILE PATTERN: with one line
refused() {
    "$percussionist" transcribe "$work/$1" -o "$work/refused.mid" >"$work/said" 2>"$work/error" &&
        fail "$1: exit code 0"
    if [ "$(wc -l <"$work/error")" != 1 ] || ! grep -q -- "$1: .*$2" "$work/error"; then
        fail "$1: expected one line with '$2', got: $(cat "$work/error")"
    fi
    [ ! -e "$work/refused.mid" ] || fail "$1: a MIDI file all the same"
}

declare -A expected
hear drums.wav
for drum in kick snare all; do expected[$drum]=$(count $drum); done
[ "${expected[all]}" -ge 30 ] || fail "drums.wav: $(cat "$work/said")"

alike drums.flac 0 kick snare all
alike drums.ogg 15 kick snare all
alike drums-96k.wav 15 kick snare all
alike drums-8k.wav 25 kick
alike drums-quiet.wav 15 kick snare all
alike drums-clipped.wav 25 kick
alike drums-offset.wav 15 kick snare all

hear drums-cut.wav
half=$(count all)
[ "$half" -gt 10 ] && [ "$half" -lt "${expected[all]}" ] || fail "drums-cut.wav: $half strokes"

at_most silence.wav 0
at_most none.wav 0
at_most sample.wav 1
at_most click.wav 1
at_most sweep.wav 4
at_most noise.wav 4
at_most speech.wav 4

refused empty.wav ''
refused nan.wav 'sample 12345: expected a number'
refused slow.wav '8000'
refused missing.wav ''
exit $failed
