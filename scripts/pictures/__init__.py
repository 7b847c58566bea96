"""Parts of render.py, gallery.py and contact_sheet.py.

    floor_view     a baked level as pictures need it: rooms, openings, boxes of furniture
    cameras        where the camera stands; with
      camera       what a camera is
      cuts         which walls it looks over
      dollhouse    from outside and above
      eye          from a person's eyes
    stage          a level in Blender, one picture after the other; with
      wall_parts   walls one by one
      sections     walls cut open
      glass        panes
      light        sun, sky and lights
      quality      engine, samples and exposure
    gallery_plans  the plans of the gallery's rooms
    contact_grid   the cells of a contact sheet
    contact_stage  the models of a contact sheet in Blender
"""
