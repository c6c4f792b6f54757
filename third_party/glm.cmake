# GLM
# Version: 0.9.9.8; 0.9.9 or newer
# Licence: MIT
# Why: vector types with the names and layout of GLSL, so that shaders/shared compiles as both languages.
nuno_find_module(glm "glm>=0.9.9" libglm-dev)
