#!/usr/bin/env bash
# film.sh PERCUSSIONIST: a score becomes a film with all its pictures and sound, and the same film again.
set -eu
percussionist=$1
. "$(dirname "$(readlink -f "$0")")/song.sh"
for take in one two; do
    "$percussionist" film "$work/song.mid" -o "$work/$take.mp4" --with '/tempo 4' --pictures 10 --width 320 \
        --height 240 | tee "$work/said"
done
pictures=$(sed -n 's/^pictures *//p' "$work/said")
[ "$pictures" -gt 30 ]
ffprobe -v error -count_frames -show_entries stream=codec_type,nb_read_frames -of csv=p=0 "$work/one.mp4" |
    grep -q "^video,$pictures"
ffprobe -v error -show_entries stream=codec_type -of csv=p=0 "$work/one.mp4" | grep -q audio
cmp "$work/one.mp4" "$work/two.mp4"
# He moves: while he plays no picture is the one before.
moving=$(ffmpeg -v error -i "$work/one.mp4" -map 0:v -f framemd5 - | grep -v '^#' | sed 's/.*,//' | sort -u | wc -l)
[ "$moving" -gt $((pictures / 2)) ]
