package cga.exercise.components.geometry

import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Matrix4fc
import org.joml.Vector3f
import org.joml.Vector3fc

/**
 * Something that has a place: a model matrix relative to a parent, or to the world when it has none.
 *
 * Angles are in radians; pitch, yaw and roll turn about x, y and z, in that order. Getters return copies; those with a `dest` fill and
 * return it, and allocate nothing. Matrices are multiplied in double precision and rounded once: a long chain of parents would else
 * round at every link. Numbers that are not finite are an
 * [IllegalArgumentException].
 *
 * Not for use by several threads at once.
 *
 * @param modelMatrix local space → the parent's space; copied.
 * @param parent whose space this lives in, or null for the world.
 */
public open class Transformable(
    modelMatrix: Matrix4fc = Matrix4f(),
    parent: Transformable? = null,
) {
    private val modelMatrix = Matrix4f(checked(modelMatrix))
    private val scratch = Matrix4d()
    private val turn = Matrix4d()

    /** Whose space this lives in. Throws [IllegalArgumentException] when that would make this its own ancestor. */
    public var parent: Transformable? = parent
        set(value) {
            require(value == null || generateSequence(value) { it.parent }.none { it === this }) {
                "the new parent is this object itself or one of its descendants: parents would form a cycle"
            }
            field = value
        }

    /** Turns about the object's own axes and origin. */
    public fun rotateLocal(
        pitch: Float,
        yaw: Float,
        roll: Float,
    ) {
        requireFinite(pitch, yaw, roll)
        modelMatrix.set(scratch.set(modelMatrix).mul(turn.rotationOf(pitch, yaw, roll)))
    }

    /** Turns about axes parallel to the parent's, through [altMidpoint] in the parent's space. */
    public fun rotateAroundPoint(
        pitch: Float,
        yaw: Float,
        roll: Float,
        altMidpoint: Vector3f,
    ) {
        requireFinite(pitch, yaw, roll)
        requireFinite(altMidpoint)
        val x = altMidpoint.x.toDouble()
        val y = altMidpoint.y.toDouble()
        val z = altMidpoint.z.toDouble()
        turn.rotationOf(pitch, yaw, roll).translateLocal(x, y, z).translate(-x, -y, -z)
        modelMatrix.set(turn.mul(scratch.set(modelMatrix)))
    }

    /** Moves along the object's own axes, in its own (scaled) units. */
    public fun translateLocal(deltaPos: Vector3f) {
        requireFinite(deltaPos)
        modelMatrix.translate(deltaPos)
    }

    /** Moves along the parent's axes, in the parent's units. */
    public fun translateGlobal(deltaPos: Vector3f) {
        requireFinite(deltaPos)
        modelMatrix.translateLocal(deltaPos)
    }

    /** Scales along the object's own axes, about its origin. */
    public fun scaleLocal(scale: Vector3f) {
        requireFinite(scale)
        modelMatrix.scale(scale)
    }

    /** Replaces the local matrix: for objects that keep their place as numbers and rebuild it, so that errors do not pile up. */
    public fun setLocalModelMatrix(matrix: Matrix4fc) {
        modelMatrix.set(checked(matrix))
    }

    /** Position in the parent's space. */
    public fun getPosition(): Vector3f = modelMatrix.getTranslation(Vector3f())

    /** Position in world space. */
    public fun getWorldPosition(): Vector3f = getWorldModelMatrix().getTranslation(Vector3f())

    /** Unit x axis in the parent's space. */
    public fun getXAxis(): Vector3f = modelMatrix.axis(0)

    /** Unit y axis in the parent's space. */
    public fun getYAxis(): Vector3f = modelMatrix.axis(1)

    /** Unit z axis in the parent's space. */
    public fun getZAxis(): Vector3f = modelMatrix.axis(2)

    /** Unit x axis in world space. */
    public fun getWorldXAxis(): Vector3f = getWorldModelMatrix().axis(0)

    /** Unit y axis in world space. */
    public fun getWorldYAxis(): Vector3f = getWorldModelMatrix().axis(1)

    /** Unit z axis in world space. */
    public fun getWorldZAxis(): Vector3f = getWorldModelMatrix().axis(2)

    /** Local space → world space, rounded to floats. */
    public fun getWorldModelMatrix(): Matrix4f = Matrix4f(getWorldModelMatrix(Matrix4d()))

    /** Local space → world space, the product of the float matrices in double precision. */
    public fun getWorldModelMatrix(dest: Matrix4d): Matrix4d {
        dest.set(modelMatrix)
        var ancestor = parent
        while (ancestor != null) {
            dest.mulLocal(ancestor.scratch.set(ancestor.modelMatrix))
            ancestor = ancestor.parent
        }
        return dest
    }

    /** Local space → the parent's space. */
    public fun getLocalModelMatrix(): Matrix4f = Matrix4f(modelMatrix)

    private fun Matrix4f.axis(column: Int): Vector3f = getColumn(column, Vector3f()).normalize()

    private companion object {
        fun checked(matrix: Matrix4fc): Matrix4fc {
            require(matrix.isFinite) { "model matrix must be finite:\n$matrix" }
            return matrix
        }

        fun requireFinite(vector: Vector3fc) {
            require(vector.isFinite) { "$vector must be finite" }
        }

        fun requireFinite(
            pitch: Float,
            yaw: Float,
            roll: Float,
        ) {
            require(pitch.isFinite() && yaw.isFinite() && roll.isFinite()) { "pitch $pitch, yaw $yaw, roll $roll must be finite" }
        }
    }
}
