#version 430 core
// Nothing but the depth of what is drawn.
void main() {}
