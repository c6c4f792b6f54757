#!/usr/bin/env bash
# Runs a sweep in parts by GNU parallel, on this machine or on several, and joins them (docs/cluster.md):
#   bench/sweep.sh PARTS OUT trade|stability [SCENE...] [FLAGS]
# NUNO is the program, build/release/nuno unless set. NUNO_JOBS: parts at once on each machine, one a core unless set.
# NUNO_HOSTS: machines as --sshlogin takes them, such as 2/host1,4/host2; they need the same NUNO, and OUT in one place for all.
set -euo pipefail

if [[ $# -lt 3 || ! $1 =~ ^[1-9][0-9]*$ || ! $3 =~ ^(trade|stability)$ ]]; then
    echo "usage: $0 PARTS OUT trade|stability [SCENE...] [FLAGS]" >&2
    exit 2
fi
command -v parallel >/dev/null || { echo "$0: GNU parallel is missing; on Debian the package parallel has it" >&2 && exit 2; }
nuno=${NUNO:-$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../build/release/nuno}
parts=$1 out=$(realpath -m "$2") threads=()
shift 2
# Points of a stability study do not depend on threads: a part takes one, as the parts are what runs side by side.
[[ $1 == trade ]] || threads=(--threads 1)

mkdir -p "$out"
status=0
parallel --will-cite --quote --workdir . ${NUNO_JOBS:+--jobs "$NUNO_JOBS"} ${NUNO_HOSTS:+--sshlogin "$NUNO_HOSTS"} \
    --joblog "$out/jobs.log" \
    "$nuno" "$@" "${threads[@]}" --shard "{}/$parts" --out "$out/part{}" --quiet ::: $(seq "$parts") >"$out/parts.txt" || status=$?
# 101 and more: parallel itself was ended. Else it counts parts that failed, and joining tells what is missing.
[[ $status -le 101 ]] || exit "$status"
"$nuno" merge "$out"/part*/ --out "$out/whole"
