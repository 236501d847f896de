package cga.exercise.components.geometry

class Renderable {
    val meshes = ArrayList<Mesh>()
}
