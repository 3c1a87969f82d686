# SPDX-License-Identifier: MIT
# Renders a glTF file under a picture of the sky with Cycles, for tools/compare_with_cycles.sh.
# Runs inside Blender:  blender -b --factory-startup -noaudio -P tools/cycles_scene.py -- \
#     MODEL SKY OUT.exr SIZE SAMPLES SCENE.toml
# The camera stands in front of the model, to the right and above. It is written into SCENE.toml
# together with model and sky, for Vitrine.
import math
import os
import sys

import numpy

if not hasattr(numpy, "bool"):
    numpy.bool = bool  # Debian 12's importer asks for a name that its NumPy no longer has

import bpy
from mathutils import Vector

FIELD_OF_VIEW = 40  # degrees
model, sky, out, size, samples, toml = sys.argv[sys.argv.index("--") + 1 :]

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=model)
scene = bpy.context.scene

corners = [
    o.matrix_world @ Vector(c) for o in scene.objects if o.type == "MESH" for c in o.bound_box
]
low = Vector(min(c[i] for c in corners) for i in range(3))
high = Vector(max(c[i] for c in corners) for i in range(3))
target = (low + high) / 2
half = math.radians(FIELD_OF_VIEW / 2)
eye = target + Vector((0.6, -1, 0.35)).normalized() * (0.85 * (high - low).length / 2 / math.sin(half))

camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
scene.collection.objects.link(camera)
scene.camera = camera
camera.data.sensor_fit = "VERTICAL"
camera.data.angle = 2 * half
camera.data.clip_start = 1e-3
camera.location = eye
camera.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()

scene.world = bpy.data.worlds.new("sky")
scene.world.use_nodes = True
nodes = scene.world.node_tree.nodes
picture = nodes.new("ShaderNodeTexEnvironment")
picture.image = bpy.data.images.load(sky)
scene.world.node_tree.links.new(picture.outputs["Color"], nodes["Background"].inputs["Color"])

scene.render.engine = "CYCLES"
scene.cycles.device = "CPU"
scene.cycles.samples = int(samples)
scene.cycles.use_denoising = False
scene.cycles.use_adaptive_sampling = False
scene.render.resolution_x = scene.render.resolution_y = int(size)
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = out
bpy.ops.render.render(write_still=True)


def gltf(v):
    """Blender has z up, glTF y."""
    return [round(v.x, 7), round(v.z, 7), round(-v.y, 7)]


with open(toml, "w") as f:
    f.write(
        f'[render]\nbounces = 8\n[[camera]]\neye = {gltf(eye)}\ntarget = {gltf(target)}\n'
        f'fov = {FIELD_OF_VIEW}\n[environment]\nsky = "{os.path.basename(sky)}"\n'
        f'[[node]]\nname = "model"\ninclude = "model/{os.path.basename(model)}"\n'
    )
