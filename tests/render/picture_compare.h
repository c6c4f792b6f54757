// Two pictures side by side.
#pragma once

#include <filesystem>
#include <string_view>

#include <glm/vec3.hpp>

#include "render/picture.h"

namespace nuno {

struct PictureDifference
{
    double mean;          // of all channels, 0 .. 255
    double changed_part;  // of the pixels, 0 .. 1: those with a channel that differs by more than 24
};

// Both of one size.
PictureDifference compare_pictures(const Picture& a, const Picture& b);

// The mean colour, 0 .. 255, of the pixels in columns x0 .. x1 and rows y0 .. y1, given as parts of the picture.
glm::vec3 mean_colour(const Picture& picture, double x0, double y0, double x1, double y1);

// Fails the test where `picture` is not tests/render/reference/<name>.png but for what another driver rounds or samples
// otherwise. With NUNO_UPDATE_REFERENCES=1 the reference is written instead.
void expect_matches_reference(const Picture& picture, std::string_view name);

}  // namespace nuno
