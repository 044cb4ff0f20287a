#!/usr/bin/env bash
# perform_kit.sh BUILD: ./perform --kit, from a MIDI file to the sound of a kit in a real Pd in real
# time, by key frames and by the simulated body: every stroke is asked for and made, and what is heard
# is in time.
set -eu
. "$(dirname "$(readlink -f "$0")")/song.sh"
for form in "" --simulated; do
    PERCUSSIONIST_BUILD=$1 "$root/perform" --headless -o "$work/heard.wav" "$work/song.mid" --kit $form | tee "$work/said"
    grep -q 'strokes asked for  8$' "$work/said"
    grep -q 'contacts made      8$' "$work/said"
    # The softest may drown in the one before it.
    grep -Eq 'strokes heard      [78] of 8 ' "$work/said"
    [ -z "$(grep -E "error:|couldn't create" "$work/said")" ]
done
