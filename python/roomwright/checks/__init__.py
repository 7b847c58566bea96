"""Parts of validate.py: one file for each kind of check.

    report       faults
    contract     paths, names, extras of a glTF file
    schemas      values against the published JSON Schemas
    geometry     objects against their boxes, their rooms and each other; with
      pieces       objects in their places
      health       closed meshes, faces, normals
      bodies       meshes as solid parts
      overlap      how deep two parts overlap
    shell        walls, columns, frames and leaves against rooms, doorways and furniture; with
      shell_parts  what they are made of
    stairs       steps against each other, doors and ceilings; with
      storeys      the levels of a building, which stairs join
      undersides   the height that is open over a place
    loading      the same file read by trimesh
    khronos      the Khronos validator
    manifest     files against the manifest
    stages       USD files
    tileset      tilesets; with
      tileset_schema  the shapes of their JSON
      tile_metadata   values against the classes of a schema
      tile_volumes    boxes, and what they hold
    features     the pieces that tiles name
"""
