#!/usr/bin/env bash
# find.sh PERCUSSIONIST PD EXTERNALS: a server in a network of its own is found from Pd by name, over
# multicast DNS, through a real Avahi daemon; that an object told what it found answers it with an address
# that it cannot have does no harm. Needs to be root, as that daemon does; exits with 77 where
# there can be none.
set -euo pipefail
if [ "${1:-}" != inside ]; then
    command -v avahi-daemon >/dev/null && command -v dbus-daemon >/dev/null || exit 77
    unshare -nm true 2>/dev/null || exit 77
    exec unshare -nm "$0" inside "$@"
fi
server=$2 pd=$3 externals=$4
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; wait || true; rm -rf "$work"' EXIT

soon() {  # soon COMMAND...: waits until it succeeds, half a minute at most
    for _ in $(seq 300); do
        "$@" >/dev/null 2>&1 && return
        sleep 0.1
    done
    echo "find.sh: in vain: $*" >&2
    cat "$work"/*.txt >&2
    exit 1
}

mount -t tmpfs tmpfs /run  # where the daemon keeps its number
ip link set lo up
ip link add stage type veth peer name wire
ip addr add 10.9.0.1/24 dev stage
ip link set stage up
ip link set wire up

cat >"$work/dbus.conf" <<CONF
<!DOCTYPE busconfig PUBLIC "-//freedesktop//DTD D-Bus Bus Configuration 1.0//EN"
 "http://www.freedesktop.org/standards/dbus/1.0/busconfig.dtd">
<busconfig>
  <type>system</type>
  <listen>unix:path=$work/bus</listen>
  <auth>EXTERNAL</auth>
  <policy context="default">
    <allow send_destination="*"/><allow receive_sender="*"/><allow own="*"/><allow user="*"/>
  </policy>
</busconfig>
CONF
cat >"$work/avahi.conf" <<CONF
[server]
host-name=stage
use-ipv6=no
allow-interfaces=stage
[publish]
publish-workstation=no
CONF
cat >"$work/find.pd" <<PATCH
#N canvas 0 0 400 300 12;
#X obj 10 10 loadbang;
#X msg 10 40 0;
#X obj 10 70 metro 1000;
#X msg 10 100 find;
#X obj 10 130 osc-receive 0;
#X obj 80 160 route found;
#X obj 80 190 print found;
#X connect 0 0 1 0;
#X connect 0 0 2 0;
#X connect 2 0 3 0;
#X connect 3 0 4 0;
#X msg 200 190 listen 203.0.113.5;
#X obj 320 190 t b;
#X obj 320 220 delay 100;
#X obj 320 250 print alive;
#X connect 4 1 5 0;
#X connect 5 0 6 0;
#X connect 5 0 7 0;
#X connect 7 0 4 0;
#X connect 5 0 8 0;
#X connect 8 0 9 0;
#X connect 9 0 10 0;
PATCH

export DBUS_SYSTEM_BUS_ADDRESS=unix:path=$work/bus
# The server first: a daemon that comes later is told too.
"$server" serve --listen 0.0.0.0 --port 7790 >"$work/server.txt" 2>&1 &
soon grep -q listening "$work/server.txt"
dbus-daemon --config-file="$work/dbus.conf" --nofork >"$work/dbus.txt" 2>&1 &
soon test -S "$work/bus"
avahi-daemon -f "$work/avahi.conf" --no-rlimits --no-drop-root --no-chroot >"$work/avahi.txt" 2>&1 &
soon grep -q "startup complete" "$work/avahi.txt"
"$pd" -nogui -noprefs -noaudio -nomidi -stderr -path "$externals" -open "$work/find.pd" \
    >"$work/pd.txt" 2>&1 &
soon grep -qF 'found: 10.9.0.1 7790 percussionist\ on\ stage' "$work/pd.txt"
soon grep -qF 'Cannot assign requested address' "$work/pd.txt"
soon grep -q alive "$work/pd.txt"
echo "found within seconds"
