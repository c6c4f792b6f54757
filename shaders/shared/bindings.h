// Where the simulation's kernels find their inputs and outputs; read by C++ and GLSL.
#define GROUP_SIZE 64

#define UNIT_POSITIONS 0
#define UNIT_VELOCITIES 1
#define UNIT_NEIGHBOURS 2
#define UNIT_REST_LENGTHS 3

#define BLOCK_POSITIONS 0
#define BLOCK_VELOCITIES 1
#define BLOCK_FIRST_BAD 2
#define BLOCK_PARAMS 0
#define BLOCK_COLLIDERS 1

#define LOCATION_SUBSTEP 0
#define LOCATION_WIND 1
#define LOCATION_VERTEX_COUNT 2

// Rest length of a slot without a spring.
#define NO_SPRING (-1.0f)
