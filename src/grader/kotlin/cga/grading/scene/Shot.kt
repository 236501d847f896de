package cga.grading.scene

import cga.grading.capture.Moment
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d

/**
 * A frame that can be reckoned with: its view can be inverted and the motorcycle is in it.
 *
 * @param motorcycle its model matrix.
 * @param firstView the view matrix of the first picture of all.
 */
internal class Shot(val frame: ObservedFrame, val motorcycle: Matrix4dc, val firstView: Matrix4dc) {
    val moment: Moment get() = frame.moment
    val view: Matrix4dc get() = frame.view

    /** View space → world space. */
    val fromView: Matrix4d = Matrix4d(frame.view).invert()
    val viewTurn: Matrix3d = rotationPart(frame.view)
    val motorcycleTurn: Matrix3d = rotationPart(motorcycle)

    /** The motorcycle's own space in world units → world space. */
    val motorcycleFrame: Matrix4d = rigidPart(motorcycle)

    /** The camera's space in world units → world space. */
    val camera: Matrix4d = rigidPart(fromView)

    /** The camera's space → the motorcycle's, both in world units: constant for a camera that rides along. */
    val cameraInMotorcycle: Matrix4d = Matrix4d(motorcycleFrame).invert().mul(camera)

    /** From the camera to the motorcycle's origin. */
    val distance: Double = camera.translation().distance(motorcycle.translation())

    /** Where a point in view space is in the world. */
    fun world(light: ObservedLight): Vector3d = fromView.transformPosition(Vector3d(light.position))
}

/** The frames by moment, and those of them that can be reckoned with. */
internal class Timeline(val frames: List<ObservedFrame>, val cast: Cast) {
    private val byMoment = frames.associateBy { it.moment }

    val shots: List<Shot> =
        frames.mapNotNull { frame ->
            val model = cast.motorcycle?.of(frame)?.model
            if (model == null || !model.isUsable() || !frame.view.isUsable()) null else Shot(frame, model, frames[0].view)
        }
    private val shotByMoment = shots.associateBy { it.moment }

    /** What [Moment.FIRST] shows may be a scene that is still being set up. */
    val laterShots: List<Shot> = shots.filter { it.moment != Moment.FIRST }

    /** Before these nothing moved but time: what is bound a frame too late is right here all the same. */
    val settledShots: List<Shot> = shots.filter { it.moment in SETTLED }

    fun frame(moment: Moment): ObservedFrame? = byMoment[moment]

    fun shot(moment: Moment): Shot? = shotByMoment[moment]

    private companion object {
        val SETTLED =
            setOf(
                Moment.SECOND, Moment.TIME_1, Moment.TIME_2, Moment.TIME_3, Moment.TIME_4,
                Moment.MOUSE_FIRST, Moment.ALT_HELD, Moment.ALT_RELEASED,
            )
    }
}
