# Google Benchmark
# Version: 1.7.1; 1.6 or newer
# Licence: Apache-2.0
# Why: repeats, statistics and JSON output for the timings in bench/.
nuno_find_module(benchmark "benchmark>=1.6" libbenchmark-dev)
