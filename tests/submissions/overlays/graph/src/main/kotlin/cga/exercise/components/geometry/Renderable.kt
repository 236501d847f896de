package cga.exercise.components.geometry

/** What the loader makes; the scene only wants its meshes. */
class Renderable(val meshes: MutableList<Mesh> = ArrayList())
