#!/usr/bin/env bash
# perform.sh BUILD: ./perform, from a MIDI file to sound in a real Pd in real time: every stroke is
# asked for, made and heard.
set -eu
. "$(dirname "$(readlink -f "$0")")/song.sh"
PERCUSSIONIST_BUILD=$1 "$root/perform" --headless -o "$work/heard.wav" "$work/song.mid" | tee "$work/said"
grep -q 'strokes asked for  8$' "$work/said"
grep -q 'contacts made      8$' "$work/said"
grep -q 'strokes heard      8 of 8 ' "$work/said"
