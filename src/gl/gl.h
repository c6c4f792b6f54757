// OpenGL as the loader generated at build time declares it: 4.3 core.
#pragma once

#include <glad/gl.h>
