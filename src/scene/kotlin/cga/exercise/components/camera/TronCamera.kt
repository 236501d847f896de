package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3d

/**
 * A perspective camera that looks along its own −z axis.
 *
 * @param fieldOfView vertical, radians, in (0, π).
 * @param aspect width / height of the picture, > 0.
 * @param near distance of the near plane, > 0; [far] that of the far plane, > near.
 * Other values are an [IllegalArgumentException] when the projection is asked for.
 */
public class TronCamera(
    public var fieldOfView: Float = Math.toRadians(90.0).toFloat(),
    public var aspect: Float = 16f / 9f,
    public var near: Float = 0.1f,
    public var far: Float = 100f,
    parent: Transformable? = null,
) : Transformable(parent = parent) {
    private val world = Matrix4d()
    private val x = Vector3d()
    private val y = Vector3d()
    private val z = Vector3d()
    private val projection = Matrix4f()

    /** World space → view space, rounded to floats. */
    public fun getCalculateViewMatrix(): Matrix4f = Matrix4f(calculateViewMatrix(Matrix4d()))

    /** View space → clip space. */
    public fun getCalculateProjectionMatrix(): Matrix4f = calculateProjectionMatrix(Matrix4f())

    /**
     * World space → view space in double precision, into [dest].
     *
     * Rigid whatever the parents do: built from the world position and the world axes made orthonormal, since the inverse of a scaled
     * world matrix would scale every distance to a light too.
     */
    public fun calculateViewMatrix(dest: Matrix4d): Matrix4d {
        getWorldModelMatrix(world)
        z.set(world.m20(), world.m21(), world.m22()).normalize()
        y.set(world.m10(), world.m11(), world.m12()).cross(z, x).normalize()
        z.cross(x, y)
        return dest
            .set(x.x, y.x, z.x, 0.0, x.y, y.y, z.y, 0.0, x.z, y.z, z.z, 0.0, 0.0, 0.0, 0.0, 1.0)
            .translate(-world.m30(), -world.m31(), -world.m32())
    }

    /** View space → clip space, into [dest]. */
    public fun calculateProjectionMatrix(dest: Matrix4f): Matrix4f {
        val usable = fieldOfView > 0f && fieldOfView < Math.PI && aspect > 0f && near > 0f && far > near
        require(usable && aspect.isFinite() && far.isFinite()) {
            "field of view $fieldOfView rad, aspect $aspect, near $near, far $far: must satisfy 0 < fov < π, 0 < aspect, 0 < near < far"
        }
        return dest.setPerspective(fieldOfView, aspect, near, far)
    }

    /** Sends the projection to the program in use; the view reaches it multiplied with each model's matrix. */
    public fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("projection", calculateProjectionMatrix(projection), false)
    }
}
