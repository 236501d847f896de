package cga.measure.accuracy.hard

import cga.exercise.components.light.PointLight
import cga.framework.Frame
import cga.framework.SpecularModel
import cga.reference.Lighting
import cga.reference.ShadedPoint
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc

/**
 * One point of a surface and all that decides its colour: no emission, no ambient light.
 *
 * @param position and [normal] in model space; [modelView] and [view] are rigid.
 * @param diffuse M_d, grey, and [specular] M_s: 0 or 1, so that an 8-bit texture holds them exactly.
 * @param k the specular exponent.
 */
internal data class Shot(
    val position: Vector3fc = Vector3f(0f, 0f, -4f),
    val normal: Vector3fc = Vector3f(0f, 0f, 1f),
    val diffuse: Float = 1f,
    val specular: Float = 0f,
    val k: Float = 1f,
    val specularModel: SpecularModel = SpecularModel.BLINN_PHONG,
    val lights: List<PointLight> = emptyList(),
    val modelView: Matrix4dc = Matrix4d(),
    val view: Matrix4dc = Matrix4d(),
) {
    /** The terms of the lighting model in double precision. */
    fun truth(): ShadedPoint {
        val lighting = Lighting(Frame(view, Matrix4f(), Vector3f(), specularModel, 1f, lights.map { it.toFrameLight() }, emptyList()))
        val point = lighting.newPoint()
        modelView.transformPosition(Vector3d(position), point.position)
        modelView.transformDirection(Vector3d(normal), point.normal)
        point.diffuse.set(diffuse.toDouble())
        point.specular.set(specular.toDouble())
        lighting.shade(point, Vector3d(), k.toDouble())
        return point
    }
}
