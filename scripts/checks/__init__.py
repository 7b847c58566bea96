"""Parts of validate.py: one file for each kind of check.

    report       what a fault is
    contract     paths, names, extras of a glTF file
    schemas      values against the published JSON Schemas
    geometry     pieces against their boxes, their rooms and each other; with
      pieces       pieces where they stand
      health       closed meshes, faces, normals
      bodies       meshes as solid parts
      overlap      how deep two parts are in each other
    loading      what trimesh makes of a file
    khronos      the Khronos validator
    manifest     files against the manifest
    stages       USD files
"""
