// The drape of presets (BS 5058, Cusick 1968): the shadow of a disc of 30 cm on one of 18 cm.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/fabric.h"
#include "support/equilibrium.h"
#include "support/verification.h"

namespace nuno {
namespace {

constexpr double kDisc = 0.09, kCloth = 0.15;  // radii [m]

// Rings of vertices, each turned half a step against the last, so that the faces are nearly equal-sided triangles. The
// disc holds the ring at its rim and one within; all others start a little down, with noise.
SheetSource cusick_ring(int around, int rings)
{
    SheetSource source;
    source.name = "disc";
    const double width = (kCloth - kDisc) / rings;
    std::mt19937 random(2);
    for (int ring = -1; ring <= rings; ++ring)
        for (int i = 0; i < around; ++i) {
            const double r = kDisc + ring * width, angle = 2 * M_PI * (i + 0.5 * (ring & 1)) / around;
            const double x = r * std::cos(angle), z = r * std::sin(angle), past = std::max(r - kDisc, 0.0);
            const double noise = ring > 0 ? 1e-4 * (double(random()) / 4294967295.0 - 0.5) : 0;
            source.mesh.positions.emplace_back(x, 0, z);
            source.mesh.uvs.emplace_back(x, z);
            source.start.emplace_back(x, noise - 0.8 * past * past, z);
            if (ring <= 0) source.pins.push_back(static_cast<std::uint32_t>((ring + 1) * around + i));
        }
    const auto at = [&](int ring, int i) { return static_cast<std::uint32_t>(ring * around + (i + around) % around); };
    for (int ring = 0; ring <= rings; ++ring)
        for (int i = 0; i < around; ++i) {
            const int turned = (ring - 1) & 1;
            source.mesh.faces.emplace_back(at(ring, i), at(ring + 1, i + turned), at(ring, i + 1));
            source.mesh.faces.emplace_back(at(ring, i), at(ring + 1, i + turned - 1), at(ring + 1, i + turned));
        }
    return source;
}

// Share of the annulus around the disc that the shadow from above covers, on a raster of 1 mm.
double drape_coefficient(const ClothModel& model, const std::vector<glm::dvec3>& x)
{
    constexpr double pixel = 0.001;
    constexpr int side = 320;
    std::vector<char> dark(side * side);
    for (const glm::uvec3& face : model.faces) {
        const glm::dvec3 a = x[face.x], b = x[face.y] - a, c = x[face.z] - a;
        const double area = b.x * c.z - c.x * b.z;
        if (area == 0) continue;
        // The pixels of its bounding box.
        const auto pixel_of = [&](double place) {
            return std::clamp(static_cast<int>(std::floor(place / pixel)) + side / 2, 0, side - 1);
        };
        const auto [left, right] = std::minmax({a.x, a.x + b.x, a.x + c.x});
        const auto [near, far] = std::minmax({a.z, a.z + b.z, a.z + c.z});
        for (int j = pixel_of(near); j <= pixel_of(far); ++j)
            for (int i = pixel_of(left); i <= pixel_of(right); ++i) {
                const double px = (i - side / 2 + 0.5) * pixel - a.x, pz = (j - side / 2 + 0.5) * pixel - a.z;
                const double s = (px * c.z - c.x * pz) / area, t = (b.x * pz - px * b.z) / area;
                if (s >= 0 && t >= 0 && s + t <= 1) dark[std::size_t(j * side + i)] = 1;
            }
    }
    double covered = 0;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double r = std::hypot(i - side / 2 + 0.5, j - side / 2 + 0.5) * pixel;
            if (r > kDisc && dark[std::size_t(j * side + i)]) covered += pixel * pixel;
        }
    return 100 * covered / (M_PI * (kCloth * kCloth - kDisc * kDisc));
}

double drape_of(SimParams params, int around, int rings)
{
    params.internal_model = InternalModel::continuum;
    const SheetSource source = cusick_ring(around, rings);
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    return drape_coefficient(
        model, equilibrium(model, params, {model.start_positions.begin(), model.start_positions.end()}, 1e-3));
}

SimParams preset(Fabric fabric)
{
    SimParams params;
    params.fabric = fabric;
    apply_fabric(params);
    return params;
}

struct Preset
{
    Fabric fabric;
    double least, most;  // of the drape coefficient, %, where the fabric has been measured
    double finer;        // what it drapes to on a ring of 128 x 12, which takes a minute to find
    const char* source;
};

constexpr Preset kCotton{Fabric::cotton, 60, 76, 73.8, "Gan, Ly and Steven 1991"};
constexpr Preset kWool{Fabric::wool, 40, 70, 49.2, "no single source"};
constexpr Preset kDenim{Fabric::denim, 70, 90, 61.7, "no single source"};

std::string what(Fabric fabric, std::string_view number)
{
    return fmt::format("drape coefficient, {}, {}, %", choice_names(fabric)[std::size_t(fabric)], number);
}

// On a ring of 96 x 9; fails where the finer one moves it by 3 points.
double converged_drape_of(const Preset& of)
{
    const double found = drape_of(preset(of.fabric), 96, 9);
    expect_measured(what(of.fabric, "on 96 x 9 against 128 x 12"), found, of.finer, 3);
    return found;
}

void expect_drapes_as_measured(const Preset& of)
{
    expect_measured(what(of.fabric, fmt::format("band {} to {} ({})", of.least, of.most, of.source)),
                    converged_drape_of(of), (of.least + of.most) / 2, (of.most - of.least) / 2);
}

TEST(Drape, cotton_falls_in_its_band) { expect_drapes_as_measured(kCotton); }
TEST(Drape, wool_falls_in_its_band) { expect_drapes_as_measured(kWool); }

// A known miss: with the bending stiffness that two laboratories measured, denim drapes more than the denims that were
// draped (docs/fabrics.md). What it does is held to what it did.
TEST(Drape, denim_is_softer_than_its_band)
{
    EXPECT_LT(converged_drape_of(kDenim), kDenim.least) << "no miss after all: hold it to its band";
}

// A known miss: silk folds over less than a cell of 7 mm, so its coefficient still falls with the mesh, and on a finer
// one it finds no rest. It is in its band, 20 to 40 (Matsudaira and Yang 2003), on this mesh only.
TEST(Drape, silk_is_not_converged)
{
    const double coarse = drape_of(preset(Fabric::silk), 64, 6), fine = drape_of(preset(Fabric::silk), 96, 9);
    fmt::print("drape coefficient, silk: {:.1f} % on 64 x 6, {:.1f} % on 96 x 9\n", coarse, fine);
    EXPECT_GT(coarse - fine, 3) << "converged after all: hold it to its band";
}

TEST(Drape, rises_with_the_bending_stiffness)
{
    SimParams params = preset(Fabric::denim);
    double last = 0;
    for (const float factor : {0.5f, 1.0f, 2.0f, 4.0f}) {
        SimParams stiffer = params;
        stiffer.bending_warp *= factor;
        stiffer.bending_weft *= factor;
        stiffer.bending_bias *= factor;
        const double drape = drape_of(stiffer, 64, 6);
        fmt::print("denim with {} D: {:.1f} %\n", factor, drape);
        EXPECT_GT(drape, last);
        last = drape;
    }
}

}  // namespace
}  // namespace nuno
