// A test with a current OpenGL context, which fails on any OpenGL error it leaves behind.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gl/egl_context.h"

namespace nuno {

class GlTest : public testing::Test
{
  protected:
    void TearDown() override
    {
        for (const std::string& error : take_gl_errors()) ADD_FAILURE() << "OpenGL error: " << error;
    }

  private:
    std::unique_ptr<Context> context_ = make_headless_context();
};

}  // namespace nuno
