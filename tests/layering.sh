#!/usr/bin/env bash
# layering.sh: dependencies point one way. For each folder, the project's own folders it may include,
# and the foreign headers that only it may.
set -u
cd "$(dirname "$(readlink -f "$0")")/.."
failed=0

complain() {
    echo "$1"
    failed=1
}

# may FOLDER ALLOWED...: what files of FOLDER include of ours lies in one of ALLOWED.
may() {
    local folder=$1 line
    shift
    local allowed=$(IFS='|'; echo "$*")
    [ -d "$folder" ] || return 0
    while IFS= read -r line; do
        complain "$line: $folder may include only of: $*"
    done < <(grep -rn '#include "' "$folder" | grep -vE "#include \"($allowed)/")
}

# only HEADERS FOLDER: nothing but FOLDER includes them.
only() {
    local line
    while IFS= read -r line; do
        complain "$line: only $2 may include it"
    done < <(grep -rnE "#include <($1)>" core pd-externals physics-server | grep -v "^$2/")
}

may core core
may pd-externals/io io core
may pd-externals/pdx pdx core
may pd-externals/objects objects pdx io core
may physics-server/body body core
may physics-server/sim sim body core
may physics-server/osc osc core
may physics-server/files files core
may physics-server/tracker tracker core
may physics-server/app app sim body osc files tracker core

only 'm_pd\.h' pd-externals/pdx
only 'ode/.*' physics-server/sim
only 'lo/.*' physics-server/osc
only 'avahi-.*' physics-server/osc
only 'libserialport\.h' pd-externals/io
only 'sndfile.*|pugixml.*|nlohmann/.*|zip\.h' physics-server/files

while IFS= read -r line; do
    complain "$line: core knows no thread, file or clock"
done < <(grep -rnE '#include <(thread|mutex|condition_variable|future|fstream|filesystem|chrono|ctime|sys/.*|unistd\.h)>' core)

# What a plain compiler may not have is where the world outside is: ports, sockets, devices, processes.
system='unistd\.h|sys/.*|termios\.h|poll\.h|arpa/.*|net/.*|netinet/.*|netdb\.h|ifaddrs\.h|fcntl\.h|pty\.h|spawn\.h|dlfcn\.h|linux/.*|pthread\.h|dirent\.h'
may_use_it='pd-externals/(io/|pdx/registration\.cpp)|physics-server/(tracker/|osc/(udp_socket|audience|answer_budget)|files/text_file\.cpp|app/(film_pictures|fastrak_sim_command|progress)\.cpp)'
while IFS= read -r line; do
    complain "$line: a header that not every system has"
done < <(grep -rnE "#include <($system)>" core pd-externals physics-server | grep -vE "^($may_use_it)")

# What an object has to complain of goes through its error(), or what it throws: a click finds the object.
while IFS= read -r line; do
    complain "$line: an object complains with error() or by what it throws"
done < <(grep -rnE '::post\(|pd_error\(|logpost\(|std::c(err|out)|printf\(std|\bbug\(' pd-externals/objects pd-externals/io |
    grep -v '^pd-externals/objects/describe/')

exit "$failed"
