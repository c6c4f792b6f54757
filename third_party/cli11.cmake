# CLI11
# Version: 2.1.2; 2.1 or newer
# Licence: BSD-3-Clause
# Why: subcommands and help from declarations, with errors that name the flag.
nuno_find_module(cli11 "CLI11>=2.1" libcli11-dev)
