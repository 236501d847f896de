package cga.measure.accuracy

import cga.framework.Frame
import cga.framework.FrameCone
import cga.framework.FrameLight
import cga.framework.SpecularModel
import org.joml.Vector3d
import org.joml.Vector3dc
import org.joml.Vector3fc
import kotlin.math.sin

/**
 * How far off `shaders/scene.frag` may be, computed in floats: its lines in its order, on numbers that carry their bounds.
 *
 * What a cosine's error does to the highlight, k·cos^(k−1)·Δcos, what |l + v| → 0 does to the half vector, and what a narrow cone's width
 * does to I all come out of the arithmetic by themselves.
 */
internal class GlAgainstTruthBound(private val frame: Frame) {
    private val cones = frame.lights.map { light -> light.cone?.let(::Cone) }

    /** The share of each light, before the textures: what M_d and M_s are multiplied with. */
    class Share(
        val cosAlpha: Bounded,
        val gloss: Bounded,
        val strength: BoundedVector,
    )

    /** At the window point ([x], [y]) of a triangle with the exponent [k]. */
    fun shares(
        varyings: GlAgainstTruthVaryings,
        x: Double,
        y: Double,
        k: Double,
    ): List<Share> {
        val n = varyings.normal(x, y).normalize()
        val toCamera = (-varyings.position(x, y)).normalize()
        return frame.lights.mapIndexed { i, light ->
            val unnormalised = varyings.toLight(i, x, y)
            val toLight = unnormalised.normalize()
            val f = attenuation(light, unnormalised)
            val cone = cones[i]
            val intensity = if (cone != null) f * cone.intensity(-toLight) else f
            Share(n.dot(toLight).clamp(), gloss(n, toLight, toCamera, k), exact(light.color) * intensity)
        }
    }

    /** L_O. */
    fun color(
        emissive: BoundedVector,
        diffuse: BoundedVector,
        specular: BoundedVector,
        tint: Vector3fc,
        shares: List<Share>,
    ): BoundedVector =
        shares.fold(emissive * exact(tint) + diffuse * exact(frame.ambient)) { sum, share ->
            sum + (diffuse * share.cosAlpha + specular * share.gloss) * share.strength
        }

    private fun attenuation(
        light: FrameLight,
        toLight: BoundedVector,
    ): Bounded {
        val squared = toLight.dot(toLight)
        val k = exact(light.attenuation)
        return Bounded(1.0) / (k.x + k.y * squared.sqrt() + k.z * squared)
    }

    private fun gloss(
        n: BoundedVector,
        l: BoundedVector,
        v: BoundedVector,
        k: Double,
    ): Bounded {
        val cosine =
            when (frame.specularModel) {
                SpecularModel.BLINN_PHONG -> n.dot((l + v).normalize())
                SpecularModel.PHONG -> (n * (Bounded(2.0) * n.dot(l)) - l).dot(v)
            }
        return cosine.clamp().pow(k)
    }

    private inner class Cone(cone: FrameCone) {
        private val axis = sent(frame.view.transformDirection(cone.direction, Vector3d()))
        private val inner = versine(cone.innerAngle)
        private val outer = versine(cone.outerAngle)

        fun intensity(fromLight: BoundedVector): Bounded {
            val chord = fromLight - axis
            val versine = Bounded(0.5) * chord.dot(chord)
            val width = outer - inner
            return if (width.value >
                0
            ) {
                ((outer - versine) / width).clamp()
            } else {
                Bounded(if (versine.value <= outer.value) 1.0 else 0.0, 1.0)
            }
        }

        private fun versine(angle: Float): Bounded = sent(2 * sin(angle / 2.0) * sin(angle / 2.0))
    }

    private companion object {
        /** A number that the program rounds to a float. */
        fun sent(value: Double) = Bounded(value, Bounded.ULP * kotlin.math.abs(value))

        fun sent(v: Vector3dc) = BoundedVector(sent(v.x()), sent(v.y()), sent(v.z()))

        /** One that is a float. */
        fun exact(v: Vector3fc) = BoundedVector(Bounded(v.x().toDouble()), Bounded(v.y().toDouble()), Bounded(v.z().toDouble()))
    }
}
