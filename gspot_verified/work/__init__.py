"""How long work runs: ranges, executors, files that it goes on from."""
