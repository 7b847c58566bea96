"""Parts of convert.py: levels from glTF to USD.

    settings   the options of a run
    floor      one level: the tree of its nodes
      level        the facts of a level that its building's stage needs
      naming       valid and unique names
      specs        prims, attributes and relationships of a layer
      describing   names, kinds, extras and labels of nodes
      placing      transforms; door leaves that turn on their hinges
      geometry     meshes of a node: in place, as a prototype, or as an asset
      library      assets that all levels of a run share
      meshes       triangles, normals, coordinates, bindings
      materials    UsdPreviewSurface
      textures     images, copied once a run
      variants     material variants and levels of detail
      lights       UsdLux
      instancer    small objects as one PointInstancer a room
      physics      colliders, masses, joints; physics.json lists densities
    assembly   stages of buildings and of a city
    record     the files that a run wrote, and which of them a later run removes
    writing    files that are written whole or not at all; usdz packages
"""
