"""The parts of cluster.py, in the order in which they build on each other.

`store`    a folder or a store of objects, with retries and writes that are checked
`failure`  the faults that end a command
`program`  runs the command roomwright
`inputs`   the plans, packed for other machines
`job`      the identity of the work, agreed upon in the store
`node`     what a machine keeps between units: program, inputs, textures
`unit`     one share of the work, from scratch folder to its record
`sizing`   what levels cost, and the units that they are cut into
`listing`  the levels of a job, and the list of each unit
`progress` counts, rate and time left
`local`, `on_ray`  the same units in processes of this machine, or on Ray
`report`   the report of a run, and the joined manifest
"""
