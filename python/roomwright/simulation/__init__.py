"""Levels as models for robot simulators: MJCF for MuJoCo, URDF for the others. Used by convert.py.

    level.py       a glTF file → bodies, in axes.py's frame (Z up)
      prisms.py    walls, floors and frames → boxes and convex prisms, with openings kept open
      colliders.py furniture → boxes and convex parts
      doors.py     leaves → hinges and slides
      movable.py   the pieces that are free bodies, their masses
      pressing.py  the free pieces that begin inside of others, which are fixed
      colours.py   materials → plain colours
    meshes.py      surfaces → OBJ files that all levels share
    mjcf.py, urdf.py   bodies → text
    writing.py     the files of a level and of a building
    bake.py        whether a folder is a finished bake
"""
