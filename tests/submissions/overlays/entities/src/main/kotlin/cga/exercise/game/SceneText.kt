package cga.exercise.game

/** The whole scene. Angles are in degrees; a thing that is `in` another moves along with it. */
const val SCENE_TEXT = """
    entity ground
        obj assets/models/ground.obj ground 64 60
        emission 0 1 0

    entity motorcycle
        model assets/models/motorcycle/motorcycle.obj
        scale 0.8
        emission 1 1 1
        pulse 1.0 1.6 0.7

    # follows the mouse
    entity boom in motorcycle
    entity eye in boom
        at 0 2.6 4.2
        turn -27 0 0

    point aura in motorcycle at 0 1.5 0.4 color 1 1 1
        pulse 1.0 1.6 0.7
    spot beam in motorcycle at 0 1.0 -1.8 color 3.4 3.4 3.0 inner 12 outer 22
        turn -10 0 0

    point northeast at 13 1.6 -13 color 7 1 0
    point northwest at -13 1.6 -13 color 0 1 7
    point southeast at 13 1.6 13 color 0 6 3
    point southwest at -13 1.6 13 color 6 0 5
"""
