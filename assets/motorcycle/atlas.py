"""Where each part lies in its material's texture: rectangles (u0, v0, u1, v1), a margin apart."""

WHOLE = (0.0, 0.0, 1.0, 1.0)

# body
HULL = (0.004, 0.02, 0.996, 0.48)  # u along z from the beak to the tail, v along half a section from the crest to the arch
FIN = (0.02, 0.52, 0.48, 0.73)  # of a plate: u around, v from the rim inward
BLADE = (0.52, 0.52, 0.98, 0.73)

# rider
SUIT = (0.02, 0.02, 0.23, 0.48)  # u the distance from a line of light, v from looking down to looking up
BOOT = (0.27, 0.02, 0.48, 0.48)
HELMET = (0.52, 0.02, 0.98, 0.48)  # u around (0.5 lies on top), v from the nape to the front

# glass
SCREEN = (0.0, 0.02, 1.0, 0.48)  # u across, v towards the rider
VISOR = (0.0, 0.52, 1.0, 0.98)
