package cga.measure.accuracy.hard

import cga.exercise.components.geometry.Material
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.ColorFormat
import cga.framework.GLError
import cga.framework.RenderTarget
import cga.framework.SpecularModel
import cga.framework.image.ImageData
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Matrix4fc
import org.joml.Vector3f
import org.lwjgl.opengl.GL33C.*

/**
 * Shades single points by the scene's own shaders, in floats. Each shot is one vertex in a viewport of one pixel, so that what is shaded
 * is what is given: nothing is interpolated, and every uniform can be another one in the next pixel. Wants a current context.
 */
internal class Probe : AutoCloseable {
    private val target = RenderTarget(SIDE, SIDE, 0, ColorFormat.RGBA32F)
    private val vertices = glGenVertexArrays()
    private val programs = HashMap<Int, ShaderProgram>()
    private val materials = HashMap<Pair<Float, Float>, Material>()

    /** The colours of [shots], in their order. */
    fun shade(shots: List<Shot>): List<Vector3f> = shots.chunked(SIDE * SIDE).flatMap(::shadeGrid)

    /** The colour of one shot. */
    fun shade(shot: Shot): Vector3f = shade(listOf(shot)).single()

    override fun close() {
        programs.values.forEach(ShaderProgram::cleanup)
        materials.values.forEach(Material::cleanup)
        glDeleteVertexArrays(vertices)
        target.close()
    }

    private fun shadeGrid(shots: List<Shot>): List<Vector3f> {
        target.bind()
        glDisable(GL_DEPTH_TEST)
        glDisable(GL_DITHER)
        glBindVertexArray(vertices)
        shots.forEachIndexed { i, shot ->
            // Pictures are read from the top.
            glViewport(i % SIDE, SIDE - 1 - i / SIDE, 1, 1)
            draw(shot)
        }
        GLError.check("drawing ${shots.size} points")
        val rgba = target.readFloats().rgba
        return shots.indices.map { Vector3f(rgba[4 * it], rgba[4 * it + 1], rgba[4 * it + 2]) }
    }

    private fun draw(shot: Shot) {
        val program = program(shot)
        program.use()
        program.setUniform("modelView", Matrix4f(shot.modelView), false)
        program.setUniform("normalMatrix", Matrix3f(Matrix4f(shot.modelView)), false)
        program.setUniform("projection", MIDDLE, false)
        program.setUniform("emissiveTint", Vector3f())
        program.setUniform("ambient", Vector3f())
        program.setUniform("blinnPhong", shot.specularModel == SpecularModel.BLINN_PHONG)
        program.setUniform("inverseGamma", 1f)
        shot.lights.forEachIndexed { i, light -> light.bind(program, "light[$i]", shot.view) }
        material(shot).bind(program)
        // No arrays: the one vertex has the current attributes.
        glVertexAttrib3f(0, shot.position.x(), shot.position.y(), shot.position.z())
        glVertexAttrib2f(1, 0f, 0f)
        glVertexAttrib3f(2, shot.normal.x(), shot.normal.y(), shot.normal.z())
        glDrawArrays(GL_POINTS, 0, 1)
    }

    private fun program(shot: Shot) =
        programs.getOrPut(shot.lights.size) {
            ShaderProgram("shaders/scene.vert", "shaders/scene.frag", mapOf("LIGHTS" to shot.lights.size))
        }

    private fun material(shot: Shot) =
        materials
            .getOrPut(shot.diffuse to shot.specular) { Material(plain(shot.diffuse), plain(0f), plain(shot.specular)) }
            .apply { shininess = shot.k }

    private fun plain(gray: Float) = Texture2D(ImageData.ofColor(gray, gray, gray), false)

    private companion object {
        const val SIDE = 256

        /** Whatever the vertex, the middle of the viewport. */
        val MIDDLE: Matrix4fc = Matrix4f().zero().m33(1f)
    }
}
