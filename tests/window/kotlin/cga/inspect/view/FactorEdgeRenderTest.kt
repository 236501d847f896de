package cga.inspect.view

import cga.exercise.components.geometry.Material
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.texture.Texture2D
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.SpecularModel
import cga.framework.image.ImageData
import cga.testing.FLOAT_ROUNDING
import cga.testing.Offscreen
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*
import kotlin.math.abs

/**
 * At the edges of the formula's domain the factors that the window shows are those that the picture is made of: a white light on a matt and
 * on a glossy white surface is F·I·max(cos α, 0) and F·I·max(cos β, 0)^k.
 */
@ExtendWith(Offscreen::class)
class FactorEdgeRenderTest {
    private class Case(
        val name: String,
        val light: PointLight,
        val normal: Vector3f = Vector3f(0.1f, 0.3f, 1f),
        val k: Float = 8f,
    )

    private val look = Look()

    @Test
    fun `the factors are those of the picture`() {
        for (case in cases()) {
            for (model in SpecularModel.entries) {
                look.specularModel = model
                val strength = factor(case, View.ATTENUATION) * factor(case, View.CONE)
                val isSaturated = factor(case, View.ATTENUATION) >= 2
                for ((matt, factor) in listOf(true to View.COS_ALPHA, false to View.HIGHLIGHT)) {
                    val shown = strength * maxOf(factor(case, factor), 0.0)
                    val drawn = draw(case, View.FULL, matt)[0].toDouble()
                    // Three products and a sum are rounded on the way; a shown F ends at 2.
                    val same = if (isSaturated) drawn >= shown else abs(drawn - shown) <= 8 * FLOAT_ROUNDING * maxOf(shown, 1.0)
                    assertTrue(same) { "${case.name}, $model, $factor: the picture has $drawn, the factors say $shown" }
                }
            }
        }
    }

    private fun cases(): List<Case> {
        val far = Vector3f(0.5f, 0.7f, 0.4f)
        val beside = point(Vector3f(1f, 2f, -3f))
        return listOf(
            Case("an ordinary light", beside),
            Case("a light at the surface", point(SURFACE)),
            Case("a light almost at the surface", point(Vector3f(SURFACE).add(1e-18f, 1e-19f, 1e-18f), Vector3f(0f, 0f, 1f))),
            Case("a light whose d² is almost beyond floats", point(Vector3f(far).mul(1.5e19f), Vector3f(1f, 0f, 0f))),
            Case("a light whose d² is beyond floats", point(Vector3f(far).mul(1e20f), Vector3f(1f, 0f, 0f))),
            Case("light and eye opposite each other", point(Vector3f(SURFACE).mul(3f), Vector3f(1f, 0f, 0f)), Vector3f(1f, 2f, 0.5f), 0f),
            Case("no normal", beside, Vector3f()),
            Case("a normal whose square vanishes", beside, Vector3f(1e-25f, 3e-26f, 1e-24f)),
            Case("a normal whose square overflows", beside, Vector3f(1e22f, 3e23f, 1e24f)),
            Case("an exponent of 0 where the highlight's cosine is negative", point(Vector3f(0f, 0f, -9f)), Vector3f(0f, 0f, 1f), 0f),
            Case("within a cone's edge", spot(0.1f, 1.5f)),
            Case("a cone with a hard edge", spot(0.3f, 0.3f)),
            Case("a cone of one direction", spot(0f, 0f)),
        )
    }

    private fun point(
        position: Vector3f,
        k: Vector3f = Vector3f(1f, 0.5f, 0.1f),
    ) = PointLight(position, Vector3f(1f), k)

    private fun spot(
        inner: Float,
        outer: Float,
    ) = SpotLight(Vector3f(0f, 0f, 1f), Vector3f(1f), inner, outer, Vector3f(1f, 0.5f, 0.1f))

    /** The number whose colour `factors.frag` shows; it ends at 2. */
    private fun factor(
        case: Case,
        view: View,
    ): Double {
        val (red, green, blue) = draw(case, view, isMatt = true)
        return when {
            red == 0f -> -blue.toDouble()
            red < 1f -> red.toDouble()
            else -> 3 - 2.0 * green
        }
    }

    private fun draw(
        case: Case,
        view: View,
        isMatt: Boolean,
    ): List<Float> {
        look.view = view
        val program = InspectedProgram("shaders/scene.vert", "shaders/scene.frag", mapOf("LIGHTS" to 1), look, Traffic())
        val material = Material(plain(if (isMatt) 1f else 0f), plain(0f), plain(if (isMatt) 0f else 1f), case.k)
        val vertices = glGenVertexArrays()
        return RenderTarget(1, 1, 0, ColorFormat.RGBA32F)
            .use { target ->
                target.bind()
                glBindVertexArray(vertices)
                program.use()
                program.setUniform("modelView", Matrix4f().translation(SURFACE), false)
                program.setUniform("normalMatrix", Matrix3f(), false)
                // Whatever the vertex, the middle of the pixel.
                program.setUniform("projection", Matrix4f().zero().m33(1f), false)
                program.setUniform("emissiveTint", Vector3f())
                program.setUniform("ambient", Vector3f())
                program.setUniform("blinnPhong", false)
                program.setUniform("inverseGamma", 1f)
                case.light.bind(program, "light[0]", Matrix4d())
                material.bind(program)
                // No arrays: the one vertex has the current attributes.
                glVertexAttrib3f(0, 0f, 0f, 0f)
                glVertexAttrib2f(1, 0f, 0f)
                glVertexAttrib3f(2, case.normal.x, case.normal.y, case.normal.z)
                glDrawArrays(GL_POINTS, 0, 1)
                target.readFloats().rgba.take(3)
            }.also {
                glDeleteVertexArrays(vertices)
                material.cleanup()
                program.cleanup()
            }
    }

    private fun plain(gray: Float) = Texture2D(ImageData.ofColor(gray, gray, gray), false)

    private companion object {
        val SURFACE = Vector3f(0.5f, -0.25f, -4f)
    }
}
