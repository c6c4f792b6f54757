// Bodies of every shape, moving, and moving pins: compute shaders and CPU threads give the same bits.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "gl/egl_context.h"
#include "solver/method_table.h"
#include "support/bodies.h"

namespace nuno {
namespace {

class BodyParityTest : public testing::TestWithParam<Method>
{
  protected:
    BodyParityTest() : context_(make_headless_context()) {}
    ~BodyParityTest() override
    {
        for (const std::string& error : take_gl_errors()) ADD_FAILURE() << error;
    }

    ClothState run(Backend backend, const ClothModel& model, const Bodies& bodies, int substeps)
    {
        SimParams params;
        params.method = GetParam();
        params.sweep = Sweep::coloured;  // the order of xpbd that both have
        params.backend = backend;
        params.substeps = 60;
        params.thickness = 0.02f;
        params.friction = 0.2f;
        params.static_friction = 0.4f;
        params.tethers = Tethers::none;
        params.damping = params.method == Method::explicit_euler ? 8.0f : 0.2f;
        ThreadPool pool(2);
        const auto solver = make_solver(model, bodies, params, pool);
        ClothState state = start_state(model, params);
        solver->upload(state);
        // In parts, as frames do, so that poses are planned more than once.
        for (int done = 0; done < substeps; done += substeps / 2)
            solver->step({params, done * double(substep_s(params)), substeps / 2});
        solver->download_positions(state.positions);
        solver->download_velocities(state.velocities);
        return state;
    }

    void expect_agreement(const Bodies& bodies, const SheetSource& sheet)
    {
        const ClothModel model = build_cloth_model(std::span(&sheet, 1), MassLumping::area);
        const bool software = gl_info().software;
        const int substeps = software ? 1200 : 10;
        const ClothState cpu = run(Backend::cpu, model, bodies, substeps);
        const ClothState gpu = run(Backend::gpu, model, bodies, substeps);
        if (software) {
            EXPECT_EQ(state_hash(cpu), state_hash(gpu));
            const ClothState alone = run(Backend::cpu, model, {{}, {}, {}, {}, {}, bodies.handles}, substeps);
            if (bodies.shape_count() > 0) {
                EXPECT_NE(state_hash(cpu), state_hash(alone)) << "nothing was touched";
            }
            return;
        }
        for (std::size_t v = 0; v < cpu.positions.size(); ++v)
            EXPECT_LE(glm::distance(glm::vec3(cpu.positions[v]), glm::vec3(gpu.positions[v])), 1e-5f) << v;
    }

    std::unique_ptr<Context> context_;
};

TEST_P(BodyParityTest, each_shape_alone_agrees)
{
    const Bodies all = one_of_each_shape();
    const SheetSource sheet = sheet_over_the_shapes(17);
    expect_agreement({all.planes, {}, {}, {}, {}, {}}, sheet);
    expect_agreement({{}, all.spheres, {}, {}, {}, {}}, sheet);
    expect_agreement({{}, {}, all.capsules, {}, {}, {}}, sheet);
    expect_agreement({{}, {}, {}, all.boxes, {}, {}}, sheet);
    expect_agreement({{}, {}, {}, {}, all.meshes, {}}, sheet);
}

TEST_P(BodyParityTest, all_shapes_and_pins_on_two_handles_agree)
{
    Bodies bodies = one_of_each_shape();
    bodies.meshes.push_back(bodies.meshes.front());
    bodies.meshes.back().position.x += 0.4f;
    bodies.handles.push_back({"a", bodies.spheres[0].motion});
    bodies.handles.push_back({"b", bodies.boxes[0].motion});
    SheetSource sheet = sheet_over_the_shapes(17);
    sheet.handle_pins = {{0, 0}, {16, 1}, {5, 0}, {280, 1}};
    expect_agreement(bodies, sheet);
}

TEST_P(BodyParityTest, pins_alone_agree)
{
    Bodies bodies;
    bodies.handles.push_back({"a", one_of_each_shape().spheres[0].motion});
    SheetSource sheet = sheet_over_the_shapes(17);
    for (std::uint32_t v = 0; v < 17; ++v) sheet.handle_pins.push_back({v, 0});
    expect_agreement(bodies, sheet);
}

std::vector<Method> every_method_of_both()
{
    std::vector<Method> methods;
    for (const MethodInfo& info : method_table())
        if (info.make_cpu && info.make_gpu) methods.push_back(info.method);
    return methods;
}

INSTANTIATE_TEST_SUITE_P(Methods, BodyParityTest, testing::ValuesIn(every_method_of_both()),
                         [](const auto& test) { return std::string(choice_names(Method{})[std::size_t(test.param)]); });

}  // namespace
}  // namespace nuno
