"""Reads floor plans out of DXF drawings by a map of their layers, for `roomwright.dxf_to_plan`.

A drawing is read in this order: `layer_map` (roles of layers), `drawing` (entities of each role), `shapes` and `splines` (their outlines),
`rooms`, `groups`, `openings` and `panes`, `walls`, `level` and `plan_file`. Nothing is recognised: what no layer says is not read.

Inside, lengths are metres in the frame of the drawing, x east, y north. Faults name places in units of the drawing, as a
person finds them there.
"""
