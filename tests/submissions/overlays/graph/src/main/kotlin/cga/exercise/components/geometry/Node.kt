package cga.exercise.components.geometry

import cga.exercise.components.camera.ICamera
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/** A place in the scene, which may have things to draw and further nodes. */
open class Node(private val meshes: List<Mesh> = emptyList(), var emission: Vector3f = Vector3f(1.0f)) : Transformable() {
    private val children = mutableListOf<Node>()

    fun attach(vararg nodes: Node): Node {
        for (node in nodes) {
            node.parent = this
            children += node
        }
        return this
    }

    fun visit(action: (Node) -> Unit) {
        action(this)
        children.forEach { it.visit(action) }
    }

    open fun prepare(shader: ShaderProgram, view: Matrix4f) {}

    fun draw(shader: ShaderProgram, camera: ICamera) {
        if (meshes.isEmpty()) return
        shader.uniforms["matrices.modelView"] = camera.getCalculateViewMatrix().mul(getWorldModelMatrix())
        shader.uniforms["emission"] = emission
        meshes.forEach { it.render(shader) }
    }

    fun cleanup() = meshes.forEach { it.cleanup() }
}
