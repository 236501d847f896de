package cga.measure.accuracy

import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.NormalMatrix
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.shader.ShaderProgram
import cga.framework.Frame
import cga.framework.FrameTexture
import cga.framework.SpecularModel
import cga.framework.image.ImageData
import cga.framework.image.TextureImage
import cga.reference.ShadedPoint
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/** A term of the lighting model: the emission (with the ambient light), or what one [light] adds, matt or glossy. */
internal class GlAgainstTruthTerm(
    val light: Int,
    val glossy: Boolean,
    val name: String,
) {
    /** What it is in truth. */
    fun of(point: ShadedPoint): Vector3d =
        when {
            light < 0 -> Vector3d(point.emission).add(point.ambient)
            glossy -> point.lights[light].specular
            else -> point.lights[light].diffuse
        }

    companion object {
        fun all(frame: Frame): List<GlAgainstTruthTerm> = listOf(GlAgainstTruthTerm(-1, false, "emission")) +
            frame.lights.flatMapIndexed { i, light ->
                val name = if (light.cone == null) "point light ${i + 1}" else "spotlight"
                listOf(GlAgainstTruthTerm(i, false, "$name diffuse"), GlAgainstTruthTerm(i, true, "$name specular"))
            }
    }
}

/**
 * Draws a frame with the scene's own shaders, all of it or one term of the lighting model: then the other lights are black, and so is the
 * texture of the other kind.
 *
 * @param lights the frame's, which send themselves.
 */
internal class GlAgainstTruthTerms(
    private val frame: Frame,
    private val lights: List<PointLight>,
) : AutoCloseable {
    private val program = ShaderProgram("shaders/scene.vert", "shaders/scene.frag", mapOf("LIGHTS" to lights.size))
    private val meshes = frame.draws.map { Mesh(it.vertices, it.indices, ATTRIBUTES) }
    private val black = upload(TextureImage(ImageData(1, 1, ByteArray(4)), false))
    private val textures = frame.draws.map { draw -> draw.material.run { listOf(emissive, diffuse, specular) }.map(::upload) }

    /** Into the framebuffer that is bound; all terms for null. */
    fun draw(term: GlAgainstTruthTerm?) {
        val emits = term == null || term.light < 0
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)
        glClearColor(0f, 0f, 0f, 1f)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        program.use()
        program.setUniform("projection", frame.projection, false)
        program.setUniform("ambient", if (emits) frame.ambient else BLACK)
        program.setUniform("blinnPhong", frame.specularModel == SpecularModel.BLINN_PHONG)
        program.setUniform("inverseGamma", 1f)
        lights.forEachIndexed { i, light ->
            light.bind(program, "light[$i]", frame.view)
            if (term != null && term.light != i) program.setUniform("light[$i].color", BLACK)
        }
        for (draw in frame.draws.indices) draw(draw, term)
    }

    override fun close() {
        program.cleanup()
        meshes.forEach(Mesh::cleanup)
        for (texture in textures.flatten() + black) glDeleteTextures(texture)
    }

    private fun draw(
        number: Int,
        term: GlAgainstTruthTerm?,
    ) {
        val draw = frame.draws[number]
        val modelView = frame.view.mul(draw.model, Matrix4d())
        program.setUniform("modelView", Matrix4f(modelView), false)
        program.setUniform("normalMatrix", NormalMatrix().of(modelView, Matrix3f()), false)
        program.setUniform("emissiveTint", if (term == null || term.light < 0) draw.tint else BLACK)
        program.setUniform("material.shininess", draw.material.shininess)
        program.setUniform("tcMultiplier", draw.material.tcMultiplier)
        val (emissive, diffuse, specular) = textures[number]
        bind(0, "emissive", emissive)
        bind(1, "diffuse", if (term?.glossy == true) black else diffuse)
        bind(2, "specular", if (term?.glossy == false) black else specular)
        meshes[number].render()
    }

    private fun bind(
        unit: Int,
        name: String,
        texture: Int,
    ) {
        glActiveTexture(GL_TEXTURE0 + unit)
        glBindTexture(GL_TEXTURE_2D, texture)
        program.setUniform("material.$name", unit)
    }

    private companion object {
        val BLACK: Vector3fc = Vector3f()

        /** Position, texture coordinates, normal: eight floats a vertex. */
        val ATTRIBUTES = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

        fun upload(texture: FrameTexture): Int {
            val name = upload(texture.image)
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, texture.wrapS)
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, texture.wrapT)
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, texture.minFilter)
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, texture.magFilter)
            return name
        }

        fun upload(image: TextureImage): Int {
            val name = glGenTextures()
            glBindTexture(GL_TEXTURE_2D, name)
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, image.levels.lastIndex)
            image.levels.forEachIndexed { number, level ->
                val texels = MemoryUtil.memAlloc(level.rgba.size).put(level.rgba).flip()
                glTexImage2D(GL_TEXTURE_2D, number, GL_RGBA8, level.width, level.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels)
                MemoryUtil.memFree(texels)
            }
            return name
        }
    }
}
