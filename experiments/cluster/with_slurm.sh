#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Run a command on a Slurm cluster that is this machine alone: munge, controller and node are started in a
# separate folder, as this user, and stopped afterwards. Nothing of the system's own Slurm is touched.
# Usage: with_slurm.sh COMMAND..
# Exit code: the command's; 77 where the cluster cannot be started, with the reason.
set -uo pipefail

cannot() { echo "with_slurm.sh: $1" >&2; exit 77; }

PATH=$PATH:/usr/sbin:/sbin
for tool in munged slurmctld slurmd sbatch sinfo; do
  command -v "$tool" >/dev/null || cannot "no $tool here (Debian: slurm-wlm, munge)"
done

# Sockets have short names only, so the folder is not below the build.
home=$(mktemp -d /tmp/fretwork_slurm.XXXXXX)
# munge insists on a path that nobody else can write to; /tmp has its sticky bit, which it accepts.
chmod 755 "$home"
mkdir "$home/state" "$home/spool"
pids=()
stop() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null; done
  for pid in "${pids[@]}"; do wait "$pid" 2>/dev/null; done
  rm -rf "$home"
}
trap stop EXIT
trap 'exit 130' INT TERM

free_port() {
  local port
  for port in $(shuf -i 20000-59999 -n 50); do
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || { echo "$port"; return; }
  done
}
node=$(hostname -s)
(umask 077 && head -c 1024 /dev/urandom >"$home/munge.key")
cat >"$home/slurm.conf" <<CONF
ClusterName=fretwork
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$home/munge.socket
CredType=cred/munge
StateSaveLocation=$home/state
SlurmdSpoolDir=$home/spool
SlurmctldPidFile=$home/slurmctld.pid
SlurmdPidFile=$home/slurmd.pid
SlurmctldLogFile=$home/slurmctld.log
SlurmdLogFile=$home/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmdParameters=config_overrides
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF

export SLURM_CONF=$home/slurm.conf
munged --foreground --force --socket="$home/munge.socket" --key-file="$home/munge.key" \
  --pid-file="$home/munge.pid" --log-file="$home/munge.log" --seed-file="$home/munge.seed" >"$home/munge.out" 2>&1 &
pids+=($!)
for _ in $(seq 50); do [[ -S $home/munge.socket ]] && break; sleep 0.1; done
[[ -S $home/munge.socket ]] || cannot "munge does not start: $(tail -n 1 "$home/munge.out")"

slurmctld -D -f "$SLURM_CONF" >"$home/slurmctld.out" 2>&1 &
pids+=($!)
slurmd -D -f "$SLURM_CONF" >"$home/slurmd.out" 2>&1 &
pids+=($!)
for _ in $(seq 150); do
  [[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]] && break
  sleep 0.2
done
[[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]] ||
  cannot "the node does not come up: $(grep -hi error "$home"/slurm*.log | tail -n 1)"

"$@"
