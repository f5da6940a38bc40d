#!/usr/bin/env bash
# contrib/hyperqueue.sh PROPERTY SEED CASES DIR [SHARDS], with `hq server` and workers running.
set -euo pipefail
hq submit --array "1-${5:-64}" --cpus 4 --crash-limit 10 --env RAYON_NUM_THREADS=4 --wait -- bash -c \
  "isogeo fuzz '$1' --seed '$2' --cases '$3' --shard \"\$HQ_TASK_ID/${5:-64}\" --out '$4'"
