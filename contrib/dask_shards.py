"""python dask_shards.py SCHEDULER PROPERTY SEED CASES DIR [SHARDS]"""

import subprocess
import sys

from dask.distributed import Client

scheduler, prop, seed, cases, folder, *rest = sys.argv[1:]
shards = int(rest[0]) if rest else 64
command = ["isogeo", "fuzz", prop, "--seed", seed, "--cases", cases, "--out", folder]
shard = lambda i: subprocess.run([*command, "--shard", f"{i}/{shards}"]).returncode
# Exit code 1 is a counterexample: a result, not a task to repeat.
client = Client(scheduler)
codes = client.gather(client.map(shard, range(1, shards + 1), retries=3))
print(subprocess.run(["isogeo", "merge", folder], capture_output=True, text=True).stdout)
sys.exit(max(codes))
