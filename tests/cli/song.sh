# Sourced by what plays a song: $root, a folder $work that is gone at the end, and in it song.mid, a
# Standard MIDI File of eight snare notes, half a second apart, each louder than the one before.
root=$(dirname "$(readlink -f "$0")")/../..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
write_song() {
    local events='' velocity
    for velocity in 20 35 50 65 80 95 110 125; do
        events+=$(printf '\\x00\\x99\\x26\\x%02x\\x83\\x60\\x89\\x26\\x00' "$velocity")
    done
    events+='\x00\xff\x2f\x00'
    local length=$((8 * 9 + 4))
    {
        printf 'MThd\x00\x00\x00\x06\x00\x00\x00\x01\x01\xe0'
        # shellcheck disable=SC2059
        printf "MTrk\\x00\\x00\\x00\\x$(printf '%02x' "$length")$events"
    } >"$1"
}
write_song "$work/song.mid"
