#!/usr/bin/env bash
# A sweep end to end on a real Slurm of one box: shards as a job array, the merge as a dependent
# job, and the same bytes as one run. As root, with Debian's slurm-wlm and munge; everything it
# starts and writes is gone afterwards, whatever happens.
#
#     tests/slurm/run.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
# Debian's daemons are where only root looks.
export PATH="$PATH:/usr/sbin"
work=$(mktemp -d)
export SLURM_CONF=$work/slurm.conf
daemons=()

stop() {
  status=$?
  if [ "$status" -ne 0 ]; then
    tail -n 20 "$work"/*.log "$work"/dealt/*.log 2>/dev/null || true
  fi
  scancel --quiet --name=small,small-merge 2>/dev/null || true
  for daemon in "${daemons[@]}"; do
    kill "$daemon" 2>/dev/null || true
  done
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap stop EXIT

wait_for() {
  for _ in $(seq 100); do
    if "$@" >/dev/null 2>&1; then return; fi
    sleep 0.2
  done
  echo "gave up waiting for: $*" >&2
  return 1
}

# The daemon insists on folders that only their owner can write.
chmod 755 "$work"
dd if=/dev/urandom of="$work/munge.key" bs=64 count=1 status=none
chmod 400 "$work/munge.key"
socket=$work/munge.socket
munged --foreground --force --key-file="$work/munge.key" --socket="$socket" \
  --pid-file="$work/munged.pid" --log-file="$work/munged.log" --seed-file="$work/munged.seed" \
  >"$work/munged.out.log" 2>&1 &
daemons+=($!)
wait_for munge --no-input --socket="$socket"

cores=$(nproc)
node=$(hostname -s)
mkdir "$work/state" "$work/spool"
cat >"$SLURM_CONF" <<CONF
ClusterName=box
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$socket
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=1,sched_interval=2
ReturnToService=2
MpiDefault=none
NodeName=$node NodeAddr=127.0.0.1 CPUs=$cores State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
slurmctld -D -i >"$work/slurmctld.log" 2>&1 &
daemons+=($!)
wait_for sinfo
slurmd -D -N "$node" >"$work/slurmd.log" 2>&1 &
daemons+=($!)
is_idle() { sinfo --noheader --format=%t | grep -q idle; }
wait_for is_idle

cat >"$work/small.sweep.toml" <<'SWEEP'
title = "A sweep for a small cluster"
case = "paper-1"
methods = ["macro-block", "associative", "interval"]

[[vary]]
overburden = { from = 0, to = 3, count = 4 }
SWEEP
cd "$work"
"$program" sweep small.sweep.toml --slurm 4 --out dealt >submit.sh
sh submit.sh
is_merged() { [ -e "$work/dealt/sweep.csv" ]; }
for _ in $(seq 12); do
  if wait_for is_merged 2>/dev/null; then break; fi
done
squeue
"$program" sweep small.sweep.toml --out whole >/dev/null
cmp dealt/sweep.csv whole/sweep.csv
echo "four shards on Slurm $(sinfo --version) and one run give the same $(wc -l <whole/sweep.csv) lines"
