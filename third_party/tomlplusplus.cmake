# toml++
# Version: 3.3.0; 3.0 or newer
# Licence: MIT
# Why: keeps the line and column of every key, which the messages about scene files need.
nuno_find_module(tomlplusplus "tomlplusplus>=3.0" libtomlplusplus-dev)
