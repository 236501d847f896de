package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import cga.framework.FrameCone
import cga.framework.FrameLight
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc
import kotlin.math.PI
import kotlin.math.sin

/**
 * A point light that shines into a cone along its own −z axis: fully up to [innerAngle], not at all beyond [outerAngle], and between
 * them linearly in cos θ, I = (cos θ − cos outer) / (cos inner − cos outer).
 *
 * The sheet's prose and its formula swap the two angles; this is the prose. What is sent are the versines 1 − cos: in floats the
 * cosines of narrow cones all round to 1.
 *
 * @param innerAngle from the axis, radians, 0 ≤ inner ≤ outer; equal angles make a hard edge.
 * @param outerAngle from the axis, radians, at most π/2. Other angles are an [IllegalArgumentException].
 * For the rest see [PointLight].
 */
public class SpotLight(
    position: Vector3fc,
    lightColor: Vector3fc,
    innerAngle: Float,
    outerAngle: Float,
    attenuation: Vector3fc = Vector3f(0.5f, 0.05f, 0.01f),
) : PointLight(position, lightColor, attenuation),
    ISpotLight {
    private val world = Matrix4d()
    private val direction = Vector3d()
    private val directionView = Vector3f()
    private val cone = Vector2f()
    private var uniforms = Uniforms("")

    private var innerAngle = 0f
    private var outerAngle = 0f

    init {
        setCone(innerAngle, outerAngle)
    }

    /** Both angles at once, since one limits the other; radians, 0 ≤ [inner] ≤ [outer] ≤ π/2, else an [IllegalArgumentException]. */
    public fun setCone(
        inner: Float,
        outer: Float,
    ) {
        require(inner in 0f..outer && outer <= (PI / 2).toFloat()) {
            "cone angles inner = $inner, outer = $outer rad must satisfy 0 ≤ inner ≤ outer ≤ π/2"
        }
        innerAngle = inner
        outerAngle = outer
        cone.set(versine(inner), versine(outer))
    }

    /** The inner and the outer angle, radians, for whoever shows them. */
    public fun getCone(dest: Vector2f): Vector2f = dest.set(innerAngle, outerAngle)

    override fun bind(
        shaderProgram: ShaderProgram,
        name: String,
        viewMatrix: Matrix4f,
    ): Unit = bind(shaderProgram, name, Matrix4d(viewMatrix))

    override fun bind(
        shaderProgram: ShaderProgram,
        name: String,
        viewMatrix: Matrix4dc,
    ) {
        // solution 4.3.1: send what a point light sends, and then the direction, in view space, and the cone
        super.bind(shaderProgram, name, viewMatrix)
        if (uniforms.light != name) uniforms = Uniforms(name)
        getDirection(direction)
        viewMatrix.transformDirection(direction)
        shaderProgram.setUniform(uniforms.direction, directionView.set(direction))
        shaderProgram.setUniform(uniforms.cone, cone)
        // end of solution
    }

    /** Unit vector in world space along which the light shines. */
    public fun getDirection(dest: Vector3d): Vector3d {
        // solution 4.3.1: the direction of the light's own -z axis in world space
        // instead: return dest.set(0.0, -1.0, 0.0)
        getWorldModelMatrix(world)
        return dest.set(-world.m20(), -world.m21(), -world.m22()).normalize()
        // end of solution
    }

    /** The light as plain data. */
    override fun toFrameLight(): FrameLight =
        super.toFrameLight().run { FrameLight(position, color, attenuation, FrameCone(getDirection(Vector3d()), innerAngle, outerAngle)) }

    private class Uniforms(val light: String) {
        val direction = "$light.direction"
        val cone = "$light.cone"
    }

    private companion object {
        /** 1 − cos a = 2·sin²(a/2): exact to an ulp where 1 − cos(a) would cancel. */
        fun versine(angle: Float): Float = (2.0 * sin(angle / 2.0) * sin(angle / 2.0)).toFloat()
    }
}
