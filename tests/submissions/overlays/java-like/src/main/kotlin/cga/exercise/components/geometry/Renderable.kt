package cga.exercise.components.geometry

import cga.exercise.components.shader.UniformSender
import org.joml.Vector3f

class Renderable : Transformable {

    val meshes: MutableList<Mesh>
    private var overlayColor: Vector3f = Vector3f(1.0f, 1.0f, 1.0f)

    constructor() : this(ArrayList<Mesh>())

    constructor(meshes: MutableList<Mesh>) : super() {
        this.meshes = meshes
    }

    fun getOverlayColor(): Vector3f {
        return this.overlayColor
    }

    fun setOverlayColor(overlayColor: Vector3f) {
        this.overlayColor = overlayColor
    }

    fun render(sender: UniformSender) {
        sender.sendRenderable(this, this.overlayColor)
        for (i in 0 until this.meshes.size) {
            this.meshes.get(i).render(sender.getShaderProgram())
        }
    }

    fun cleanup() {
        for (i in 0 until this.meshes.size) {
            this.meshes.get(i).cleanup()
        }
    }
}
