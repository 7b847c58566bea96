"""Parts of judge.py: rooms judged by their meshes.

    shapes       walls, angles, rectangles in the plan's axes
    roles        what pieces are for, by the names of their classes
    drawn        fixtures in architects' drawings
    pieces       pieces of furniture where they stand
    ifc          furniture in IFC files
    floors       finished files as rooms with pieces
    clear        free space before sides, and where one can walk
    measure      what a measure is
    measures/    one file a subject
    table        all measures
    places       whether an empty room has a place for a bed
    variety      how many arrangements the seeds of a room have
    judgement    every measure's answer for every room of a file
    report       verdicts as tables
    sketch       rooms from above, as SVG
"""
