package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

/** World matrices are only multiplied again after something has moved. */
open class Transformable(parent: Transformable? = null) {
    private val local = Matrix4f()
    private val world = Matrix4f()
    private var dirty = true
    private val children = mutableListOf<Transformable>()

    var parent: Transformable? = null
        set(value) {
            field?.children?.remove(this)
            field = value
            value?.children?.add(this)
            touch()
        }

    init {
        this.parent = parent
    }

    private fun touch() {
        dirty = true
        children.forEach { it.touch() }
    }

    private inline fun change(what: Matrix4f.() -> Unit) {
        local.what()
        touch()
    }

    fun rotateLocal(pitch: Float, yaw: Float, roll: Float) = change { rotateXYZ(pitch, yaw, roll) }

    fun rotateAroundPoint(pitch: Float, yaw: Float, roll: Float, altMidpoint: Vector3f) = change {
        val (x, y, z) = Triple(altMidpoint.x, altMidpoint.y, altMidpoint.z)
        mulLocal(Matrix4f().translation(x, y, z).rotateXYZ(pitch, yaw, roll).translate(-x, -y, -z))
    }

    fun translateLocal(deltaPos: Vector3f) = change { translate(deltaPos) }

    fun translateGlobal(deltaPos: Vector3f) = change { translateLocal(deltaPos) }

    fun scaleLocal(scale: Vector3f) = change { scale(scale) }

    fun getLocalModelMatrix(): Matrix4f = Matrix4f(local)

    fun getWorldModelMatrix(): Matrix4f {
        if (dirty) {
            parent?.getWorldModelMatrix()?.mul(local, world) ?: world.set(local)
            dirty = false
        }
        return Matrix4f(world)
    }

    fun getPosition(): Vector3f = local.getTranslation(Vector3f())
    fun getWorldPosition(): Vector3f = getWorldModelMatrix().getTranslation(Vector3f())

    fun getXAxis() = local.axis(0)
    fun getYAxis() = local.axis(1)
    fun getZAxis() = local.axis(2)

    fun getWorldXAxis() = getWorldModelMatrix().axis(0)
    fun getWorldYAxis() = getWorldModelMatrix().axis(1)
    fun getWorldZAxis() = getWorldModelMatrix().axis(2)

    private fun Matrix4f.axis(i: Int): Vector3f = getColumn(i, Vector3f()).normalize()
}
