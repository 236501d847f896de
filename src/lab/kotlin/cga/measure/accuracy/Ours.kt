package cga.measure.accuracy

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.NormalMatrix
import cga.exercise.components.geometry.Transformable
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3f

/** The exercise's own classes, and what its shader does with the lights. */
internal object Ours : Implementation {
    override val name: String = "ours"

    override fun compute(
        operation: Operation,
        input: OracleCase.Input,
    ): DoubleArray? =
        with(input) {
            when (operation) {
                Operation.ROTATION, Operation.ENDLESS_ROTATION -> Transformable().turned(vector()).getLocalModelMatrix().numbers()
                Operation.PLACING -> placed().getLocalModelMatrix().numbers()
                Operation.MOVING -> moved().getLocalModelMatrix().numbers()
                Operation.PARENTS -> descendant().getWorldModelMatrix().numbers()
                Operation.TURN_ABOUT_POINT -> turnedAboutPoint().getLocalModelMatrix().numbers()
                Operation.LOOK_AT -> null
                Operation.CAMERA -> camera().getCalculateViewMatrix().numbers()
                Operation.MODEL_VIEW -> modelView().numbers()
                Operation.PERSPECTIVE -> TronCamera(number(), number(), number(), number()).getCalculateProjectionMatrix().numbers()
                Operation.NORMAL_MATRIX -> NormalMatrix().of(Matrix4d(Matrix4f(columns())), Matrix3f()).numbers()
                Operation.CONE_OF_COSINES -> null
                Operation.CONE_OF_VERSINES -> ShaderFactors.cone(vector(), vector(), number(), number()).numbers()
                Operation.ATTENUATION -> ShaderFactors.attenuation(vector(), vector()).numbers()
            }
        }

    private fun Transformable.turned(angles: Vector3f): Transformable = apply { rotateLocal(angles.x, angles.y, angles.z) }

    private fun OracleCase.Input.placed(parent: Transformable? = null): Transformable =
        Transformable(parent = parent).apply {
            translateLocal(vector())
            turned(vector())
            scaleLocal(vector())
        }

    private fun OracleCase.Input.descendant(): Transformable =
        generateSequence(placed()) { parent -> if (hasMore()) placed(parent) else null }.last()

    private fun OracleCase.Input.columns() = Matrix3f(vector(), vector(), vector())

    private fun OracleCase.Input.moved(): Transformable =
        Transformable().apply {
            translateLocal(vector())
            turned(vector())
            translateLocal(vector())
        }

    private fun OracleCase.Input.turnedAboutPoint(): Transformable =
        Transformable().apply {
            translateGlobal(vector())
            val angles = vector()
            rotateAroundPoint(angles.x, angles.y, angles.z, vector())
        }

    private fun OracleCase.Input.camera(): TronCamera =
        TronCamera().apply {
            translateLocal(vector())
            turned(vector())
        }

    /** As Renderable sends it. */
    private fun OracleCase.Input.modelView(): Matrix4f {
        val view = camera().calculateViewMatrix(Matrix4d())
        return Matrix4f(placed().getWorldModelMatrix(Matrix4d()).mulLocal(view))
    }
}
