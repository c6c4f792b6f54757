// Where the simulation's kernels find their inputs and outputs; read by C++ and GLSL. Numbers that stand more than once
// belong to kernels that never run together: each method binds its own before it runs them.
#define GROUP_SIZE 64

// Of kernels that several methods run.
#define UNIT_POSITIONS 0
#define UNIT_VELOCITIES 1
#define UNIT_NEIGHBOURS 2
#define UNIT_STIFFNESS 3
#define UNIT_TENSION 4
#define UNIT_AXIAL 5
#define UNIT_CORNERS 6
#define UNIT_FACE_FORCES 7
#define UNIT_FACES 8
#define UNIT_FACE_RESTS 9
#define UNIT_BODIES 12
#define UNIT_DISTANCES 13
#define UNIT_PIN_VERTICES 14
#define UNIT_PIN_STEPS 15
#define UNIT_ANCHORS 19
#define UNIT_TETHER_LENGTHS 20

#define BLOCK_PARAMS 0  // a uniform block; the others are storage blocks
#define BLOCK_POSITIONS 0
#define BLOCK_VELOCITIES 1
#define BLOCK_FIRST_LOST 2
#define BLOCK_FACE_FORCES 5

#define LOCATION_SUBSTEP 0
#define LOCATION_WIND 1
#define LOCATION_VERTEX_COUNT 2
#define LOCATION_FACE_COUNT 3
#define LOCATION_GUST 4
#define LOCATION_GUST_SEED 5
#define LOCATION_FIRST_BODY 8
#define LOCATION_FIRST_PIN 9
#define LOCATION_PIN_COUNT 10
#define LOCATION_FIRST_PLACE 11
#define LOCATION_END_PLACE 12

// Of contacts between layers, after the substep of any method.
#define CONTACT_GROUP 1024
#define UNIT_COLOURS 16
#define BLOCK_CONTACT_VELOCITIES 2
#define BLOCK_START_POSITIONS 3
#define BLOCK_END_POSITIONS 4
#define BLOCK_CONTACTS 5
#define LOCATION_COLOURS 11
#define LOCATION_FRICTION 12

// Of Euler on a small cloth.
#define UNIT_WINDS 10
#define IMAGE_SHOWN_POSITIONS 0
#define IMAGE_SHOWN_VELOCITIES 1
#define BLOCK_SHOWN_POSITIONS 3
#define BLOCK_SHOWN_VELOCITIES 4
#define LOCATION_SUBSTEP_COUNT 6
#define LOCATION_BODIES_A_SUBSTEP 7

// Of verlet and rk4.
#define UNIT_START_POSITIONS 10
#define UNIT_START_VELOCITIES 11
#define BLOCK_PREDICTED 3
#define BLOCK_ACCELERATIONS 4
#define BLOCK_POSITION_SUMS 3
#define BLOCK_VELOCITY_SUMS 4
#define LOCATION_KICK 6
#define LOCATION_STAGE_STEP 6
#define LOCATION_STAGE_WEIGHT 7

// Of vbd.
#define UNIT_ORDER 16
#define UNIT_MOVES 17
#define UNIT_TARGETS 18
#define BLOCK_MOVES 3
#define BLOCK_TARGETS 4
#define LOCATION_INVERSE_SUBSTEP 13
#define LOCATION_LONGEST 13
#define LOCATION_STIFFER 14
#define LOCATION_DAMPER 15

// Of xpbd: the beginning and the end of a substep.
#define UNIT_PREDICTED 17
#define BLOCK_XPBD_PREDICTED 3
#define BLOCK_LAST_POSITIONS 4
#define BLOCK_LAST_VELOCITIES 5
#define BLOCK_GIVEN_VELOCITIES 6
#define LOCATION_COMMON 11
#define LOCATION_STEP 12
#define LOCATION_KEEP 13
#define LOCATION_PER_STEP 14
#define LOCATION_ALL 11
#define LOCATION_GRAVITY 12

// Of xpbd: constraints in colours, and all at once.
#define UNIT_ENDS 16
#define UNIT_NUMBERS 17
#define UNIT_SHARES 18
#define UNIT_PULL 17
#define UNIT_PULL_LENGTH 18
#define UNIT_LIMIT_PULL 19
#define UNIT_LIMIT_PULL_LENGTH 20
#define LOCATION_PLACE_COUNT 12
#define LOCATION_FIRST_SIDES 13

// Of xpbd on a small cloth, beside those of Euler.
#define UNIT_COMMON 10
#define UNIT_QUAD_GROUPS 11
#define IMAGE_STATE 0
#define BLOCK_STATE 3
#define LOCATION_PAIR_COUNT 15
#define LOCATION_FIRST_SIDE 16
#define LOCATION_GROUP_COUNT 17

// Texels of a BodyStep (src/model/body_steps.h), and numbers ahead of the values of each grid there.
#define BODY_TEXELS 8
#define GRID_HEADER 8
