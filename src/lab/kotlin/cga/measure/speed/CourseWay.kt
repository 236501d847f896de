package cga.measure.speed

import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.light.PointLight
import org.joml.Matrix3f
import org.joml.Matrix4dc
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector3fc
import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL33C.*

/**
 * Sends what [Submission] sends, the same numbers to the same names, in the manner of the course's original framework: the location of a
 * uniform is asked for whenever it is set, world matrices are made anew at each call and by recursion through the parents, names are put
 * together at each bind. For comparison only.
 */
internal class CourseWay(
    parent: Transformable,
    renderables: List<Renderable>,
    private val lights: List<PointLight>,
    private val mesh: Mesh,
    private val material: Material,
    view: Matrix4dc,
) {
    private class Node(
        val matrix: Matrix4f,
        val parent: Node?,
    ) {
        fun getWorldModelMatrix(): Matrix4f = parent?.getWorldModelMatrix()?.mul(matrix) ?: Matrix4f(matrix)
    }

    private val root = Node(parent.getLocalModelMatrix(), null)
    private val objects = renderables.map { Node(it.getLocalModelMatrix(), root) }
    private val places = lights.map { Node(it.getLocalModelMatrix(), root) }
    private val view = Matrix4f(view)
    private val matrix = BufferUtils.createFloatBuffer(16)

    fun send() {
        val program = glGetInteger(GL_CURRENT_PROGRAM)
        for (i in lights.indices) bind(program, lights[i], places[i], "pointLight[$i]")
        for (node in objects) render(program, node)
    }

    private fun bind(
        program: Int,
        light: PointLight,
        node: Node,
        name: String,
    ) {
        setUniform(program, "$name.position", Matrix4f(view).mul(node.getWorldModelMatrix()).getTranslation(Vector3f()))
        setUniform(program, "$name.color", light.lightColor)
        setUniform(program, "$name.attenuation", light.attenuation)
    }

    private fun render(
        program: Int,
        node: Node,
    ) {
        val modelView = Matrix4f(view).mul(node.getWorldModelMatrix())
        glUniformMatrix4fv(location(program, "modelView"), false, modelView.get(matrix.clear()))
        val normal = Matrix3f(modelView).invert().transpose()
        glUniformMatrix3fv(location(program, "normalMatrix"), false, normal.get(matrix.clear().limit(9)))
        material.diff.bind(0)
        glUniform1i(location(program, "material.diffuse"), 0)
        material.emit.bind(1)
        glUniform1i(location(program, "material.emissive"), 1)
        material.specular.bind(2)
        glUniform1i(location(program, "material.specular"), 2)
        glUniform1f(location(program, "material.shininess"), material.shininess)
        glUniform2f(location(program, "tcMultiplier"), material.tcMultiplier.x, material.tcMultiplier.y)
        mesh.render()
    }

    private fun setUniform(
        program: Int,
        name: String,
        value: Vector3fc,
    ) {
        glUniform3f(location(program, name), value.x(), value.y(), value.z())
    }

    private fun location(
        program: Int,
        name: String,
    ): Int = glGetUniformLocation(program, name)
}
