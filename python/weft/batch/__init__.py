"""Batches of runs: `weft sweep SWEEP.json --out DIR`, one row a run in a table (docs/sweep.md)."""
