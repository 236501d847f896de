package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

/** A node of the scene graph. "local" is relative to the parent node. */
open class Transformable(var local: Matrix4f = Matrix4f(), var parent: Transformable? = null) {

    /** local space -> world space, walks up the whole chain (always a fresh matrix) */
    val world: Matrix4f
        get() = parent?.world?.mul(local) ?: Matrix4f(local)

    val worldPosition: Vector3f get() = world.getTranslation(Vector3f())
    val worldForward: Vector3f get() = world.getColumn(2, Vector3f()).negate().normalize()
    val forward: Vector3f get() = local.getColumn(2, Vector3f()).negate().normalize()

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) {
        local.rotateXYZ(pitch, yaw, roll)
    }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, pivot: Vector3f) {
        val m = Matrix4f().translate(pivot).rotateXYZ(pitch, yaw, roll).translate(-pivot.x, -pivot.y, -pivot.z)
        m.mul(local, local)
    }

    fun translateLocal(delta: Vector3f) {
        local.translate(delta)
    }

    fun translateGlobal(delta: Vector3f) {
        local.translateLocal(delta) // JOML's "local" means from the left
    }

    fun scaleLocal(factor: Vector3f) {
        local.scale(factor)
    }
}

/** val lamp = PointLight(...) childOf bike */
infix fun <T : Transformable> T.childOf(node: Transformable): T = apply { parent = node }
