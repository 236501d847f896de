package cga.measure.accuracy

import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Vector3d

/** The same of JOML's double matrices, not rounded. */
internal object JomlDouble : Implementation {
    override val name: String = "JOML double"

    override fun compute(
        operation: Operation,
        input: OracleCase.Input,
    ): DoubleArray? =
        with(input) {
            when (operation) {
                Operation.ROTATION, Operation.ENDLESS_ROTATION -> rotation().numbers()
                Operation.PLACING -> placing().numbers()
                Operation.MOVING -> Matrix4d().translate(wide()).turn(wide()).translate(wide()).numbers()
                Operation.PARENTS -> placing().also { while (hasMore()) it.mul(placing()) }.numbers()
                Operation.TURN_ABOUT_POINT -> turnAboutPoint().numbers()
                Operation.LOOK_AT -> Matrix4d().lookAt(wide(), wide(), wide()).numbers()
                Operation.CAMERA -> camera().numbers()
                Operation.MODEL_VIEW -> camera().mul(placing()).numbers()
                Operation.PERSPECTIVE -> Matrix4d().perspective(wideNumber(), wideNumber(), wideNumber(), wideNumber()).numbers()
                Operation.NORMAL_MATRIX -> Matrix3d(wide(), wide(), wide()).normal().numbers()
                Operation.CONE_OF_COSINES, Operation.CONE_OF_VERSINES, Operation.ATTENUATION -> null
            }
        }

    private fun OracleCase.Input.wideNumber() = number().toDouble()

    private fun OracleCase.Input.wide() = Vector3d(vector())

    private fun OracleCase.Input.rotation() = Matrix4d().turn(wide())

    private fun OracleCase.Input.placing() = Matrix4d().translate(wide()).turn(wide()).scale(wide())

    private fun OracleCase.Input.turnAboutPoint(): Matrix4d {
        val position = Matrix4d().translate(wide())
        val turn = rotation()
        val point = wide()
        return Matrix4d().translate(point).mul(turn).translate(point.negate()).mul(position)
    }

    private fun OracleCase.Input.camera(): Matrix4d {
        val eye = wide()
        val turn = rotation()
        val back = turn.getColumn(2, Vector3d())
        return Matrix4d().lookAt(eye, Vector3d(eye).sub(back), turn.getColumn(1, Vector3d()))
    }

    private fun Matrix4d.turn(angles: Vector3d) = rotateXYZ(angles.x, angles.y, angles.z)
}
