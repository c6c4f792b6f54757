// Where the renderer's programs find their inputs and outputs; read by C++ and GLSL.
#define NORMAL_GROUP_SIZE 64

#define BLOCK_VIEW 2
#define BLOCK_NORMALS 3

#define UNIT_CLOTH_TEXTURE 4
#define UNIT_FLOOR_SHADOW 5
#define UNIT_BLUR_SOURCE 6
#define UNIT_NORMAL_POSITIONS 7
#define UNIT_CORNER_STARTS 8
#define UNIT_CORNERS 9

#define ATTRIBUTE_POSITION 0
#define ATTRIBUTE_NORMAL 1
#define ATTRIBUTE_UV 2
#define ATTRIBUTE_SPHERE 3

#define LOCATION_TEXTURE_SCALE 0
#define LOCATION_NORMAL_COUNT 0
#define LOCATION_BLUR_STEP 0
