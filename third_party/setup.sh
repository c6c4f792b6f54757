# Sourced by run, test and .ci/run: installs missing packages, configures and builds. Needs nuno_root set.
# Speaks only to stderr, and says little unless something fails. Input that is wrong, or a machine that lacks something, exits 2.

nuno_build=$nuno_root/build/release

nuno_say() { printf 'nuno: %s\n' "$*" >&2; }
nuno_fail() {
    nuno_say "$*"
    exit 2
}

# Prints the packages named in the given lists, without comments.
nuno_listed() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' -e 's/[[:space:]]//g' "$@"; }

# Makes sure that every package in the given lists is installed.
nuno_packages() {
    local listed installed missing
    listed=$(nuno_listed "$@")
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        nuno_tools_elsewhere "$listed"
        return
    fi
    # A package may be listed as known but removed; only the state "installed" counts.
    installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' $listed 2>/dev/null |
        awk '$2 == "installed" {print $1}' | sort -u || true)
    missing=$(comm -23 <(sort -u <<<"$listed") <(printf '%s\n' "$installed") | xargs)
    [[ -z $missing ]] && return
    nuno_apt $missing
}

# Installs the named packages, through sudo only where needed.
nuno_apt() {
    local -a become=()
    if [[ $(id -u) -ne 0 ]]; then
        command -v sudo >/dev/null ||
            nuno_fail "these packages are missing: $*. As root: apt-get install --no-install-recommends $*"
        become=(sudo)
    fi
    nuno_say "installing missing packages: $*"
    local log
    log=$(mktemp)
    if ! { "${become[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q update &&
        "${become[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y install --no-install-recommends "$@"; } \
        >"$log" 2>&1 </dev/null; then
        tail -n 30 "$log" >&2
        rm -f "$log"
        nuno_fail "could not install: $*"
    fi
    rm -f "$log"
}

# On a system without apt only the tools can be looked for by name; CMake then names every missing library at once.
nuno_tools_elsewhere() {
    local tool absent=()
    for tool in c++ cmake ninja pkg-config glad; do
        command -v "$tool" >/dev/null || absent+=("$tool")
    done
    [[ ${#absent[@]} -eq 0 ]] ||
        nuno_fail "not found: ${absent[*]}. This system has no apt, so please install what these Debian packages hold:" $1
}

# Runs a command with its output kept in a log, which is shown if it fails.
nuno_logged() {
    local log=$1
    shift
    if ! "$@" >"$log" 2>&1 </dev/null; then
        tail -n 60 "$log" >&2
        nuno_say "failed: $* (whole output in $log)"
        return 1
    fi
}

# Configures build/release if need be, with the given cache settings, and builds the given targets.
# nuno_build_release [-DNAME=VALUE...] [-- TARGET...]
nuno_build_release() {
    local -a settings=() targets=()
    while [[ $# -gt 0 && $1 != -- ]]; do
        settings+=("$1")
        shift
    done
    [[ $# -gt 0 ]] && shift
    targets=("$@")

    local cache=$nuno_build/CMakeCache.txt
    # A build tree that moved with its checkout points at the old place.
    if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$nuno_root" "$cache"; then
        nuno_say "build/release belongs to another checkout; building it anew"
        rm -rf "$nuno_build"
    fi
    mkdir -p "$nuno_build"

    local setting configure=no
    [[ -f $nuno_build/build.ninja ]] || configure=yes
    for setting in "${settings[@]}"; do
        setting=${setting#-D}
        grep -qs "^${setting%%=*}:[A-Z]*=${setting#*=}\$" "$cache" || configure=yes
    done
    if [[ $configure == yes ]]; then
        (cd "$nuno_root" && nuno_logged "$nuno_build/configure.log" cmake --preset release "${settings[@]}") || exit 2
    fi
    # The first steps of a dry run are there at every build (they look for a new commit).
    local steps
    steps=$(ninja -C "$nuno_build" -n "${targets[@]}" 2>/dev/null | grep -c '^\[' || true)
    [[ $steps -lt 8 ]] || nuno_say "building ($steps steps; a second run builds nothing)"
    nuno_logged "$nuno_build/build.log" ninja -C "$nuno_build" "${targets[@]}" || exit 1
}

# The same, alone: two commands started at once must not build into one folder together.
nuno_build_locked() {
    mkdir -p "$nuno_build"
    if command -v flock >/dev/null; then
        (
            flock 9
            nuno_build_release "$@" 9>&-
        ) 9>"$nuno_root/build/.lock"
    else
        (nuno_build_release "$@")
    fi
}
