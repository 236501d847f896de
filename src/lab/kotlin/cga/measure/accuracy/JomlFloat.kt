package cga.measure.accuracy

import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f

/** JOML's float matrices, used the way courses show. */
internal object JomlFloat : Implementation {
    override val name: String = "JOML float"

    override fun compute(
        operation: Operation,
        input: OracleCase.Input,
    ): DoubleArray? =
        with(input) {
            when (operation) {
                Operation.ROTATION, Operation.ENDLESS_ROTATION -> rotation().numbers()
                Operation.PLACING -> placing().numbers()
                Operation.MOVING -> Matrix4f().translate(vector()).turn(vector()).translate(vector()).numbers()
                Operation.PARENTS -> placing().also { while (hasMore()) it.mul(placing()) }.numbers()
                Operation.TURN_ABOUT_POINT -> turnAboutPoint().numbers()
                Operation.LOOK_AT -> Matrix4f().lookAt(vector(), vector(), vector()).numbers()
                Operation.CAMERA -> camera().numbers()
                Operation.MODEL_VIEW -> camera().mul(placing()).numbers()
                Operation.PERSPECTIVE -> Matrix4f().perspective(number(), number(), number(), number()).numbers()
                Operation.NORMAL_MATRIX -> Matrix3f(vector(), vector(), vector()).normal().numbers()
                Operation.CONE_OF_COSINES, Operation.CONE_OF_VERSINES, Operation.ATTENUATION -> null
            }
        }

    private fun OracleCase.Input.rotation() = Matrix4f().turn(vector())

    private fun OracleCase.Input.placing() = Matrix4f().translate(vector()).turn(vector()).scale(vector())

    private fun OracleCase.Input.turnAboutPoint(): Matrix4f {
        val position = Matrix4f().translate(vector())
        val turn = rotation()
        val point = vector()
        return Matrix4f().translate(point).mul(turn).translate(point.negate()).mul(position)
    }

    private fun OracleCase.Input.camera(): Matrix4f {
        val eye = vector()
        val turn = rotation()
        val back = turn.getColumn(2, Vector3f())
        return Matrix4f().lookAt(eye, Vector3f(eye).sub(back), turn.getColumn(1, Vector3f()))
    }

    private fun Matrix4f.turn(angles: Vector3f) = rotateXYZ(angles.x, angles.y, angles.z)
}
