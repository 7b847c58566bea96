"""Parts of convert.py: glTF floors to USD.

    settings   what a run was asked for
    floor      one floor: the tree of its nodes
      level        what a building's stage says of a level
      naming       valid and unique names
      specs        prims, attributes and relationships of a layer
      describing   names, kinds, extras and labels of nodes
      placing      transforms; door leaves that turn on their hinges
      geometry     meshes of a node: in place, as a prototype, or as an asset
      library      assets that all floors of a run share
      meshes       triangles, normals, coordinates, bindings
      materials    UsdPreviewSurface
      textures     images, copied once a run
      variants     material variants and levels of detail
      lights       UsdLux
      instancer    small objects as one PointInstancer a room
      physics      colliders, masses, joints; what things weigh stands in physics.json
    assembly   buildings of floors, a city of buildings
    record     what a run wrote, and what of it a later run takes away
    writing    files that are there whole or not at all; usdz packages
"""
