# JSON for Modern C++
# Version: 3.11.2; 3.10 or newer
# Licence: MIT
# Why: writes reports and reads them back in tests; ordered_json keeps the order of the keys.
nuno_find_module(nlohmann_json "nlohmann_json>=3.10" nlohmann-json3-dev)
