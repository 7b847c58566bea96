"""Roomwright in Blender: imports baked floors into collections, exports a level that was edited.

    import          import_operator -> importing -> floors     which files
                                                 -> datablocks meshes, materials, images and lights, each once
                                                 -> building   objects and collections
    export          export_operator -> exporting -> identities ids and names in the written file
    sidebar         parts_panel -> visibility    shows and hides parts

Modules without bpy (floors, document, identities and what they use) also run outside of Blender. Therefore this file imports
the others only when Blender registers the extension.
"""


def register() -> None:
    for module in _modules():
        module.register()


def unregister() -> None:
    for module in reversed(_modules()):
        module.unregister()


def _modules() -> tuple:
    from . import export_operator, import_operator, parts_panel

    return import_operator, parts_panel, export_operator
