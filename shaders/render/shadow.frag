#version 430 core
// The key light does not reach this point of the floor.
out float shadow;

void main()
{
    shadow = 1.0;
}
