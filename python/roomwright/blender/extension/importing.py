"""Imports baked floors into the active scene, or leaves the file as it was.

Blender's own importer reads each mesh, material, image and light once, whatever floors it is in; building.py makes the tree of
nodes. (Where the importer reads whole floors, it looks through all objects for every mesh, and time grows with the square
of the floors.)
"""

from contextlib import contextmanager

import bpy

from .building import Builder
from .document import Document
from .errors import damage_of
from .floors import find_floors
from .options import Options

# Kinds of datablocks that an import can make; if it fails, the new ones are removed.
KINDS = ("scenes", "collections", "objects", "meshes", "lights", "cameras", "materials", "images", "node_groups",
         "textures", "actions")


def import_bake(paths, options: Options = Options(), progress=lambda step, steps, text: None) -> Builder:
    """Imports floors into the active scene. `paths`: a path or several; `progress` is called after each step.

    Raises BakeError, and leaves everything as it was, if a file is missing, damaged or not roomwright's.
    """
    floors = find_floors(paths, options.levels)
    with _all_or_nothing():
        window, scene = bpy.context.window, bpy.context.scene
        builder = Builder(options, scene)
        # The importer works in a scene of its own, else Blender goes through all objects for each floor.
        window.scene = builder.datablocks.scene
        documents = []
        for step, floor in enumerate(floors, 1):
            documents.append(_read(floor, builder))
            progress(step, 2 * len(floors), f"read {floor.name}")
        created = builder.create(documents)
        for step, (floor, document, objects) in enumerate(zip(floors, documents, created), 1 + len(floors)):
            with damage_of(floor.path):
                builder.build(floor, document, objects)
            progress(step, 2 * len(floors), f"built {floor.name}")
        window.scene = scene
        builder.finish()
    return builder


def _read(floor, builder: Builder) -> Document:
    with damage_of(floor.path):
        document = Document(floor.path, builder.datablocks.buffers)
        builder.datablocks.read(document)
        document.forget()
    return document


@contextmanager
def _all_or_nothing():
    """Removes all that was made, and shows the scene that was shown, if something fails."""
    before = {kind: {one.as_pointer() for one in getattr(bpy.data, kind)} for kind in KINDS}
    window, scene = bpy.context.window, bpy.context.scene
    try:
        yield
    except BaseException:
        window.scene = scene
        bpy.data.batch_remove([one for kind in KINDS for one in getattr(bpy.data, kind)
                               if one.as_pointer() not in before[kind]])
        raise
