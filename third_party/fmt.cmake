# {fmt}
# Version: 9.1.0; 8.1 or newer
# Licence: MIT
# Why: formatting checked at compile time; the standard library of GCC 12 has no <format>.
nuno_find_module(fmt "fmt>=8.1" libfmt-dev)
