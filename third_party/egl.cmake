# EGL
# Version: 1.5; 1.5
# Licence: MIT (libglvnd headers)
# Why: an OpenGL context without a window or an X server, for frames rendered in CI.
nuno_find_module(egl "egl" libegl-dev)
