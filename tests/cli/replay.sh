#!/usr/bin/env bash
# replay.sh PERCUSSIONIST: what serve recorded is played again to the last bit, and gives the files that
# render writes of the same, of a score and of a captured motion; a recording that tells of something
# else is found out.
set -eu
percussionist=$1
. "$(dirname "$(readlink -f "$0")")/song.sh"
"$percussionist" serve "$work/song.mid" --port 0 --play --quit-at-end --rate 500 \
    --record "$work/take.recording" --log "$work/live" >"$work/live.txt"
rm "$work/song.mid"
"$percussionist" replay "$work/take.recording" -o "$work/again" >"$work/again.txt"
cat "$work/again.txt"
grep -q 'the same to the last bit' "$work/again.txt"
diff "$work/live/contacts.csv" "$work/again/contacts.csv"
[ -s "$work/again/motion.glb" ] && [ -s "$work/again/motion.bvh" ] && [ -s "$work/again/performance.wav" ]

# Over OSC, where it is told to listen.
"$percussionist" replay --serve --listen 127.0.0.1 --port 0 "$work/take.recording" >"$work/served.txt"
grep -q 'the same to the last bit' "$work/served.txt"
if "$percussionist" replay --port 0 "$work/take.recording" 2>"$work/error.txt"; then
    echo "--port without --serve is accepted"
    exit 1
fi
grep -q -e '--serve' "$work/error.txt"

# The body was made otherwise: nothing is the same.
sed 's/^500$/501/' "$work/take.recording" >"$work/other.recording"
if "$percussionist" replay "$work/other.recording" >"$work/other.txt" 2>"$work/error.txt"; then
    echo "another body is said to play the same"
    exit 1
fi
grep -q 'other.recording: played otherwise than recorded' "$work/error.txt"

# A motion is a score too.
"$percussionist" gestures write legato -o "$work/sticks.csv" --strokes 4 --interval 0.6
"$percussionist" serve "$work/sticks.csv" --port 0 --play --quit-at-end --rate 500 \
    --record "$work/motion.recording" --log "$work/moved" >"$work/moved.txt"
grep -q 'contacts made      4' "$work/moved.txt"
"$percussionist" replay "$work/motion.recording" -o "$work/moved-again" >"$work/again.txt"
grep -q 'the same to the last bit' "$work/again.txt"
diff "$work/moved/contacts.csv" "$work/moved-again/contacts.csv"
