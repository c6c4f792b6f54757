// Where the renderer's programs find their inputs and outputs; read by C++ and GLSL.
#define NORMAL_GROUP_SIZE 64

#define BLOCK_VIEW 2
#define BLOCK_NORMALS 3
#define BLOCK_FABRIC 4
#define BLOCK_SPLIT_POSITIONS 5
#define BLOCK_SPLIT_NORMALS 6

#define UNIT_CLOTH_TEXTURE 4
#define UNIT_FLOOR_SHADOW 5
#define UNIT_BLUR_SOURCE 6
#define UNIT_NORMAL_POSITIONS 7
#define UNIT_CORNER_STARTS 8
#define UNIT_CORNERS 9
#define UNIT_WEAVE 10
#define UNIT_KEY_COMPARED 11
#define UNIT_KEY_DEPTH 12
#define UNIT_LAYER 13
#define UNIT_HEAT 14
#define UNIT_SPLIT_POSITIONS 7
#define UNIT_SPLIT_NORMALS 8
#define UNIT_SPLIT_SOURCES 9

#define ATTRIBUTE_POSITION 0
#define ATTRIBUTE_NORMAL 1
#define ATTRIBUTE_UV 2
#define ATTRIBUTE_BODY 3
#define ATTRIBUTE_BODY_X 4
#define ATTRIBUTE_BODY_Y 5
#define ATTRIBUTE_BODY_Z 6
#define ATTRIBUTE_MARK_FROM 0
#define ATTRIBUTE_MARK_TO 1
#define ATTRIBUTE_MARK_COLOUR 2

#define LOCATION_TEXTURE_SCALE 0
#define LOCATION_WEAVE_SCALE 1
#define LOCATION_NORMAL_COUNT 0
#define LOCATION_SPLIT_COUNT 0
#define LOCATION_BLUR_STEP 0
#define LOCATION_SAMPLE_COUNT 0
#define LOCATION_HEAT_OF_FACES 0
#define LOCATION_PICTURE_SIZE 0
#define LOCATION_MARK_SCALE 1
#define LOCATION_MARK_STRENGTH 2

// A shadow on the floor is as soft as what throws it is high, up to this height [m].
#define SHADOW_HEIGHT 2.0
// The metres of light behind its map and before it, for each metre of the map's side.
#define KEY_DEPTH_SIDES 2.0
// Threads along a side of the weave's texture.
#define WEAVE_THREADS 64
// The brightest that it can hold, of the mean.
#define WEAVE_BRIGHTEST 1.6f
