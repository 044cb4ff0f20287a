#!/usr/bin/env bash
# animate.sh PERCUSSIONIST: an animation is reproducible to the last byte, a kit written with its poses
# is read back and gives the same contacts, and a faulty kit is one clear line.
set -eu
percussionist=$1
. "$(dirname "$(readlink -f "$0")")/song.sh"
animate() { "$percussionist" animate "$work/song.mid" "$@" >"$work/said"; }

animate -o "$work/one" --pictures 1.5 --write-kit "$work/posed.kit"
animate -o "$work/two" --pictures 1.5
diff -r "$work/one" "$work/two"
for file in motion.bvh motion.glb objects.csv strokes.csv keys.csv report.txt song.wav picture-1.500.svg; do
    [ -s "$work/one/$file" ] || { echo "$file: missing"; exit 1; }
done
grep -q '^notes  *8 = 8 strokes + 0 left out + 0 doubles' "$work/one/report.txt"

animate -o "$work/posed" --kit "$work/posed.kit" --silent
# Poses are written to a hundredth of a degree: no contact is off by more than a millimetre.
tail -n +2 "$work/posed/strokes.csv" | cut -d, -f1-10 | diff - <(tail -n +2 "$work/one/strokes.csv" | cut -d, -f1-10)
awk -F, 'NR > 1 && $11 > 1.0 { print "off by", $11, "mm"; exit 1 }' "$work/posed/strokes.csv"

sed 's/radius 0.178/radius wide/' "$work/posed.kit" >"$work/faulty.kit"
if "$percussionist" animate "$work/song.mid" -o "$work/no" --kit "$work/faulty.kit" 2>"$work/error"; then
    echo 'a faulty kit: expected an error'
    exit 1
fi
[ "$(wc -l <"$work/error")" = 1 ]
grep -q "faulty.kit: line [0-9]*: expected a number after 'radius', found 'wide'" "$work/error"

# A recording beside the kit, at its own rate: there is more to hear, and as long as it lasts.
"$percussionist" animate "$work/song.mid" --audio "$work/one/song.wav" -o "$work/along" >"$work/said"
! cmp -s "$work/along/song.wav" "$work/one/song.wav"
[ "$(stat -c %s "$work/along/song.wav")" = "$(stat -c %s "$work/one/song.wav")" ]
