#!/usr/bin/env bash
# The example study by HyperQueue and by Slurm, on this machine alone: workers that are ended, and tables that are the same to the byte.
# What is missing is said, with how to install it, and not checked. Everything that is started here is ended here.
#
#   bash tests/many_machines.sh             # builds the example
#   PLM_STUDY=path bash tests/many_machines.sh
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(mkdir -p "${CARGO_TARGET_DIR:-target}" && cd "${CARGO_TARGET_DIR:-target}" && pwd)
study=${PLM_STUDY:-}
if [ -z "$study" ]; then
    cargo build --release --features batch --example study
    study=$target/release/examples/study
fi
folder=$(mktemp -d)
started=()
# The server of HyperQueue does not end otherwise.
trap 'for id in "${started[@]}"; do kill -9 "$id" 2>/dev/null || true; done; rm -rf "$folder"' EXIT

# Waits until a command succeeds, for two minutes at most.
until_so() {
    for _ in $(seq 240); do
        if "$@" >/dev/null 2>&1; then return; fi
        sleep 0.5
    done
    printf 'this did not come true: %s\n' "$*"
    return 1
}

# Rows of one shard alone.
rows() { "$study" --folder "$1" --status | sed -n '1s/.*: \([0-9]*\) of .*/\1/p'; }
has_more_than() { [ "$(rows "$1")" -gt "$2" ]; }

same_table() {
    "$study" --folder "$1" --merge "$1/all.csv" >/dev/null
    cmp "$1/all.csv" "$folder/whole/all.csv"
    printf 'the same %d bytes: %s\n' "$(stat -c %s "$1/all.csv")" "$2"
}

whole() {
    printf '\n== one process\n'
    time "$study" --folder "$folder/whole"
    "$study" --folder "$folder/whole" --merge "$folder/whole/all.csv"
}

# Two workers at a time, each ended without warning, twice.
ended_workers() {
    printf '\n== two workers, ended twice\n'
    local round before k ids
    for round in 1 2; do
        ids=()
        before=$(rows "$folder/ended")
        for k in 1 2; do
            "$study" --folder "$folder/ended" --threads 1 --shard "$k/2" >/dev/null &
            ids+=($!)
        done
        until_so has_more_than "$folder/ended" $((before + 10000))
        kill -9 "${ids[@]}"
        wait "${ids[@]}" 2>/dev/null || true
        printf 'round %d: ended with %d points\n' "$round" "$(rows "$folder/ended")"
    done
    time (
        "$study" --folder "$folder/ended" --threads 1 --shard 1/2 &
        "$study" --folder "$folder/ended" --threads 1 --shard 2/2
        wait
    )
    same_table "$folder/ended" "two workers, ended twice"
}

hyper_queue() {
    printf '\n== HyperQueue\n'
    local python=$target/tools/hyperqueue/bin
    if ! "$python/python3" -c 'import hyperqueue' 2>/dev/null &&
        ! { python3 -m venv "$target/tools/hyperqueue" && "$python/pip" install --quiet hyperqueue; }; then
        printf 'NOT CHECKED: its wheel cannot be had (pip install hyperqueue, in a virtual environment)\n'
        return
    fi
    export HQ_SERVER_DIR=$folder/hq-server
    mkdir "$HQ_SERVER_DIR"
    "$python/python3" - "$HQ_SERVER_DIR" <<'PYTHON' &
import sys, time
from hyperqueue import LocalCluster
from hyperqueue.cluster import WorkerConfig

with LocalCluster(sys.argv[1]) as cluster:
    for _ in range(2):
        cluster.start_worker(WorkerConfig(cores=1))
    while True:
        time.sleep(1)
PYTHON
    started+=($!)
    disown
    until_so test -e "$HQ_SERVER_DIR/hq-current/access.json"
    PATH=$python:$PATH "$study" --folder "$folder/hq" --submit hq --shards 16
    time until_so "$study" --folder "$folder/hq" --merge "$folder/hq/all.csv"
    same_table "$folder/hq" "16 shards by HyperQueue"
}

slurm_settings() {
    cat <<SETTINGS
ClusterName=loopback
SlurmctldHost=$(hostname -s)(127.0.0.1)
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=all Nodes=ALL Default=YES MaxTime=60 State=UP
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
StateSaveLocation=$folder/slurm/state
SlurmdSpoolDir=$folder/slurm/spool
SlurmctldPidFile=$folder/slurm/controller.id
SlurmdPidFile=$folder/slurm/daemon.id
SlurmctldLogFile=$folder/slurm/controller.txt
SlurmdLogFile=$folder/slurm/daemon.txt
SlurmctldPort=17817
SlurmdPort=17818
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SETTINGS
}

slurm() {
    printf '\n== Slurm\n'
    local program job
    for program in sbatch slurmctld slurmd munged; do
        if ! PATH=$PATH:/usr/sbin command -v "$program" >/dev/null; then
            printf 'NOT CHECKED: %s is missing (apt-get install slurm-wlm munge)\n' "$program"
            return
        fi
    done
    PATH=$PATH:/usr/sbin
    mkdir -p "$folder/munge" "$folder/slurm/state" "$folder/slurm/spool"
    head -c 1024 /dev/urandom >"$folder/munge/key"
    chmod 600 "$folder/munge/key"
    munged --force --foreground --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
        --pid-file="$folder/munge/id" --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" 2>/dev/null &
    started+=($!)
    disown
    until_so test -S "$folder/munge/socket"
    export SLURM_CONF=$folder/slurm/slurm.conf
    slurm_settings >"$SLURM_CONF"
    slurmctld -D 2>/dev/null &
    started+=($!)
    disown
    slurmd -D 2>/dev/null &
    started+=($!)
    disown
    until_so sh -c 'sinfo --noheader --format=%T | grep -q idle'
    "$study" --folder "$folder/slurm-run" --submit slurm --shards 16 -- --time=30
    # A task that loses its machine is put back into the queue.
    job=$(squeue --noheader --format=%A | sort -n | head -n 1)
    until_so has_more_than "$folder/slurm-run" 3000
    scontrol requeue "${job}_1"
    # Slurm would let two minutes pass.
    until_so sh -c 'squeue --noheader --states=PD --format=%r | grep -q BeginTime'
    until_so scontrol update JobId="${job}_1" StartTime=now
    printf 'shard 1 was ended and put back\n'
    time until_so "$study" --folder "$folder/slurm-run" --merge "$folder/slurm-run/all.csv"
    same_table "$folder/slurm-run" "16 shards by Slurm"
    cat "$folder/slurm-run/1-of-16.txt"
}

whole
ended_workers
hyper_queue
slurm
