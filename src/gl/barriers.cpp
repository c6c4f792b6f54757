// The bits name how the later command touches the memory, not how it was written.
#include "gl/barriers.h"

#include "gl/gl.h"

namespace nuno {

void barrier_compute_to_compute()
{
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void barrier_compute_to_draw()
{
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_SHADER_STORAGE_BARRIER_BIT);
}

// A storage barrier also holds later shader writes back until earlier reads, vertex fetches among them, are done.
void barrier_draw_to_compute() { glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT); }

void barrier_compute_to_readback() { glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT); }

void barrier_compute_to_upload() { glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT); }

}  // namespace nuno
