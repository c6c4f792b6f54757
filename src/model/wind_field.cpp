// Moving air.
#include "model/wind_field.h"

#include <cmath>

#include "model/formulas.h"

namespace nuno {

AirField air_field(const SimParams& p, double time_s)
{
    AirField field;
    field.wind = {p.wind_x, p.wind_y, p.wind_z};
    field.gust_speed = p.gust_speed;
    field.per_size = 1 / p.gust_size;
    for (int axis = 0; axis < 3; ++axis) {
        const double carried = -double(field.wind[axis]) * time_s * double(field.per_size);
        field.offset[axis] = static_cast<float>(carried - GUST_PERIOD * std::floor(carried / GUST_PERIOD));
    }
    field.seed = static_cast<std::uint32_t>(p.gust_seed) * 0x9e3779b9u;
    return field;
}

glm::dvec3 air_velocity(const AirField& field, const glm::dvec3& x)
{
    const glm::dvec3 q = double(field.per_size) * x + glm::dvec3(field.offset);
    return glm::dvec3(field.wind) + double(field.gust_speed) * formulas_f64::gust_at(q, field.seed);
}

}  // namespace nuno
