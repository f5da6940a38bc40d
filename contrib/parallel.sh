#!/usr/bin/env bash
# contrib/parallel.sh PROPERTY SEED CASES DIR [SHARDS]; add --sshlogin for other machines.
set -euo pipefail
export RAYON_NUM_THREADS=1
seq "${5:-64}" | parallel isogeo fuzz "$1" --seed "$2" --cases "$3" --shard "{}/${5:-64}" --out "$4"
