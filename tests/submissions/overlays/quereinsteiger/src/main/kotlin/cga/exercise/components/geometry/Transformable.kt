package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Quaternionf
import org.joml.Vector3f

/**
 * Basically Unity's Transform: position, rotation and scale relative to the parent.
 * Careful: forward is -Z here, not +Z!
 */
open class Transformable(var parent: Transformable? = null) {
    val localPosition = Vector3f()
    val localRotation = Quaternionf()
    val localScale = Vector3f(1.0f)

    val localToParentMatrix: Matrix4f
        get() = Matrix4f().translationRotateScale(localPosition, localRotation, localScale)

    val localToWorldMatrix: Matrix4f
        get() = parent?.localToWorldMatrix?.mul(localToParentMatrix) ?: localToParentMatrix

    /** world position */
    val position: Vector3f
        get() = localToWorldMatrix.getTranslation(Vector3f())

    /** world rotation, whatever the scale is */
    val rotation: Quaternionf
        get() = localToWorldMatrix.getUnnormalizedRotation(Quaternionf())

    /** the blue arrow of the gizmo, in world space */
    val forward: Vector3f
        get() = rotation.transform(Vector3f(0.0f, 0.0f, -1.0f))

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        localRotation.rotateXYZ(pitch, yaw, roll)
    }

    /** like Transform.RotateAround, but point and axis are in the space of the PARENT */
    fun rotateAround(point: Vector3f, axis: Vector3f, angle: Float) {
        val q = Quaternionf().rotationAxis(angle, axis)
        localPosition.sub(point).rotate(q).add(point)
        localRotation.premul(q)
    }

    /** along the own axes, the length is not scaled */
    fun translateLocal(delta: Vector3f) {
        localPosition.add(localRotation.transform(Vector3f(delta)))
    }

    fun translateGlobal(delta: Vector3f) {
        localPosition.add(delta)
    }
}
