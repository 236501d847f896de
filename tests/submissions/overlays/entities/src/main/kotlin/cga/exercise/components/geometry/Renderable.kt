package cga.exercise.components.geometry

/** What the model loader gives; entities only take the meshes out of it. */
class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable()
