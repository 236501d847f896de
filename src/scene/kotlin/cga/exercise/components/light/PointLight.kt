package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.framework.FrameLight
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector2f
import org.joml.Vector2fc
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc
import kotlin.math.abs

/**
 * A light that shines evenly in every direction and fades with distance: F = 1 / (K_c + K_l·d + K_q·d²), where that is at most 1e18.
 *
 * @param position where it starts, in world space (in the parent's space once it has a parent).
 * @param lightColor linear RGB, finite; may exceed 1, up to 1e18: what ten such lights add up to is still a float.
 * @param attenuation (K_c, K_l, K_q), finite, none negative, not all 0.
 * Values outside these ranges are an [IllegalArgumentException], here and when set later.
 */
public open class PointLight(
    position: Vector3fc,
    lightColor: Vector3fc,
    attenuation: Vector3fc = Vector3f(1.0f, 0.5f, 0.1f),
) : Transformable(),
    IPointLight {
    private val world = Matrix4d()
    private val positionView = Vector3f()
    private var uniforms = Uniforms("")

    private val color = Vector3f()
    private val k = Vector3f()

    /** Linear RGB; setting copies, the returned vector follows. */
    public var lightColor: Vector3fc
        get() = color
        set(value) {
            require(value.isFinite && maxOf(abs(value.x()), abs(value.y()), abs(value.z())) <= LARGEST_COLOR) {
                "light colour $value must be finite and not beyond $LARGEST_COLOR"
            }
            color.set(value)
        }

    /** (K_c, K_l, K_q); setting copies, the returned vector follows. */
    public var attenuation: Vector3fc
        get() = k
        set(value) {
            require(value.isFinite && minOf(value.x(), value.y(), value.z()) >= 0f && maxOf(value.x(), value.y(), value.z()) > 0f) {
                "attenuation (K_c, K_l, K_q) = $value must be finite, without negative numbers and not all 0"
            }
            k.set(value)
        }

    init {
        require(position.isFinite) { "light position $position must be finite" }
        this.lightColor = lightColor
        this.attenuation = attenuation
        // solution 4.2.1: move the light to its position
        translateGlobal(Vector3f(position))
        // end of solution
    }

    /** The sheet's form: the position in world space, for shaders that apply the view matrix themselves. */
    override fun bind(
        shaderProgram: ShaderProgram,
        name: String,
    ): Unit = bind(shaderProgram, name, IDENTITY)

    /**
     * Sends the light with its position in view space, which is how our own shaders want it: [viewMatrix] (world space → view space) is
     * applied in double precision, so that a light keeps its place beside the motorcycle however far both are from the origin.
     */
    public open fun bind(
        shaderProgram: ShaderProgram,
        name: String,
        viewMatrix: Matrix4dc,
    ) {
        // solution 4.2.1: send the position, in view space, and the colour to the light that the shaders call by this name
        getWorldModelMatrix(world).mulLocal(viewMatrix)
        if (uniforms.light != name) uniforms = Uniforms(name)
        shaderProgram.setUniform(uniforms.position, positionView.set(world.m30(), world.m31(), world.m32()))
        shaderProgram.setUniform(uniforms.color, color)
        // end of solution
        // solution 4.3.4: send the attenuation
        shaderProgram.setUniform(uniforms.attenuation, k)
        // end of solution
        // solution 4.3.3: where the shaders have one kind of light for all, send a point light's cone: it shines everywhere
        shaderProgram.setUniform(uniforms.direction, NO_DIRECTION)
        shaderProgram.setUniform(uniforms.cone, EVERYWHERE)
        // end of solution
    }

    /** Position in world space, in double precision. */
    public fun getWorldPosition(dest: Vector3d): Vector3d = getWorldModelMatrix(world).getTranslation(dest)

    /** The light as plain data. */
    public open fun toFrameLight(): FrameLight = FrameLight(getWorldPosition(Vector3d()), Vector3f(color), Vector3f(k))

    /** The members' names, put together once and not in every frame. */
    private class Uniforms(val light: String) {
        val position = "$light.position"
        val color = "$light.color"
        val attenuation = "$light.attenuation"
        val direction = "$light.direction"
        val cone = "$light.cone"
    }

    private companion object {
        val IDENTITY: Matrix4dc = Matrix4d()
        const val LARGEST_COLOR = 1e18f

        // solution
        val NO_DIRECTION: Vector3fc = Vector3f()

        /** Beyond 1 − cos of every angle, which is at most 2. */
        val EVERYWHERE: Vector2fc = Vector2f(3f, 4f)
        // end of solution
    }
}
