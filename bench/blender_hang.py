# The load `hang` of hang_bench.cpp in Blender's cloth, at its own settings for cotton: median time of a frame and largest
# strain of a thread. Needs the package blender; run
#     blender -b --factory-startup --python bench/blender_hang.py -- SIDE [QUALITY] [FRAMES]
# with vertices a side, steps a frame (5) and frames (120, of which the last half is timed).
import statistics
import sys
import time

import bpy

arguments = [int(a) for a in sys.argv[sys.argv.index("--") + 1:]]
side, quality, frames = arguments + [None, 5, 120][len(arguments):]
cell = 2 / (side - 1)


def make_sheet():
    vertices = [(-1 + i * cell, 0, -j * cell) for j in range(side) for i in range(side)]
    faces = [(a, a + side, a + side + 1, a + 1) for j in range(side - 1) for a in range(j * side, j * side + side - 1)]
    mesh = bpy.data.meshes.new("sheet")
    mesh.from_pydata(vertices, [], faces)
    sheet = bpy.data.objects.new("sheet", mesh)
    sheet.vertex_groups.new(name="pins").add([0, side - 1], 1, "REPLACE")
    return sheet


def make_cloth(sheet):
    cloth = sheet.modifiers.new("cloth", "CLOTH")
    settings = cloth.settings
    settings.quality = quality
    settings.mass = 0.8 / side**2
    settings.vertex_group_mass = "pins"
    settings.air_damping = 0.1
    settings.tension_stiffness = settings.compression_stiffness = 15
    settings.shear_stiffness = 5
    settings.bending_stiffness = 0.05
    cloth.collision_settings.use_collision = cloth.collision_settings.use_self_collision = False
    cloth.point_cache.frame_start, cloth.point_cache.frame_end = 1, frames + 1


def largest_strain(sheet):
    at = [v.co.copy() for v in sheet.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh().vertices]
    across = [(v, v + 1) for v in range(side**2) if (v + 1) % side]
    down = [(v, v + side) for v in range(side**2 - side)]
    return max((at[a] - at[b]).length / cell - 1 for a, b in across + down)


bpy.ops.object.select_all(action="SELECT")
bpy.ops.object.delete()
scene = bpy.context.scene
scene.render.fps = 60
scene.frame_start, scene.frame_end = 1, frames + 1
scene.gravity = (0, 1, -9.81)
scene.render.threads_mode, scene.render.threads = "FIXED", 1
sheet = make_sheet()
scene.collection.objects.link(sheet)
make_cloth(sheet)
scene.frame_set(1)
times_ms = []
for frame in range(2, frames + 2):
    start = time.perf_counter()
    scene.frame_set(frame)
    times_ms.append(1000 * (time.perf_counter() - start))
print(f"blender {bpy.app.version_string}, {side} a side, quality {quality}: "
      f"{statistics.median(times_ms[frames // 2:]):.2f} ms a frame, strain {100 * largest_strain(sheet):.1f} %")
