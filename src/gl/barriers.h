// Every ordering between what a shader writes and what comes after, one function a kind; nothing else calls
// glMemoryBarrier. No barrier is needed after an upload (glBufferSubData) or a copy: what is issued later sees it,
// kernels included.
#pragma once

namespace nuno {

// Kernels wrote storage blocks; later kernels read them as storage blocks, buffer textures or images, or write them
// again.
void barrier_compute_to_compute();

// Kernels wrote storage blocks; later draws read them as vertices, indices, buffer textures or storage blocks.
void barrier_compute_to_draw();

// Draws or copies read buffers; later kernels write the same ones.
void barrier_draw_to_compute();

// Kernels wrote a buffer; a copy, glGetBufferSubData or a mapping reads it.
void barrier_compute_to_readback();

// Kernels wrote a buffer; glBufferSubData overwrites a part of it.
void barrier_compute_to_upload();

}  // namespace nuno
