#!/usr/bin/env bash
#SBATCH --array=1-64
#SBATCH --cpus-per-task=4
#SBATCH --time=04:00:00
#SBATCH --requeue
# sbatch contrib/slurm.sh PROPERTY SEED CASES DIR: the shard comes from SLURM_ARRAY_TASK_ID and _COUNT.
set -euo pipefail
export RAYON_NUM_THREADS="${SLURM_CPUS_PER_TASK:-1}"
exec isogeo fuzz "$1" --seed "$2" --cases "$3" --out "$4"
