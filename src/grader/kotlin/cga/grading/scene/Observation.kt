package cga.grading.scene

import cga.grading.capture.Moment
import org.joml.Matrix4dc
import org.joml.Vector3dc

/**
 * What a captured frame shows, told in the terms of the scene and no longer in those of the submission's uniforms.
 *
 * @param view world space → view space as the shaders use it; it may be anything, also stretched.
 * @param projection view space → clip space.
 * @param idle what is sent as a light and drawn with by no shader.
 */
public class ObservedFrame(
    public val moment: Moment,
    public val time: Double,
    public val view: Matrix4dc,
    public val projection: Matrix4dc,
    public val objects: List<ObservedObject>,
    public val lights: List<ObservedLight>,
    public val idle: List<ObservedLight> = emptyList(),
)

/**
 * The draws of a frame that share a model matrix and a tint.
 *
 * @param model model space → world space.
 * @param tint factor of the emission that the submission sends, null where none was found; [isTintWritten] where it is a constant of the
 * shader and nothing sends it.
 * @param lights what the lights were while these draws ran, where they differ from the frame's last state; else the same list.
 * @param vertices positions in model space, x y z each, all draws together.
 * @param buffers numbers of the captured buffers it is made of: the same object in another frame has the same.
 */
public class ObservedObject(
    public val model: Matrix4dc,
    public val tint: Vector3dc?,
    public val lights: List<ObservedLight>,
    public val vertices: FloatArray,
    public val buffers: List<Int>,
    public val isTintWritten: Boolean = false,
)

/**
 * A light as the shaders take it.
 *
 * @param name the submission's own, of its colour's uniform; the same light has the same name in every frame.
 * @param position in view space, where the shader's arithmetic effectively puts it.
 * @param color linear RGB.
 * @param k (K_c, K_l, K_q) as effectively used; (1, 0, 0) without attenuation.
 * @param spot its cone, null for a point light.
 * @param placedBy the uniform that its position is sent in; null where that is not known.
 * @param isViewed whether the shaders bring what is sent from world space to view space.
 * @param fadedBy the uniforms that its K is sent in; empty where that is not known.
 */
public class ObservedLight(
    public val name: String,
    public val position: Vector3dc,
    public val color: Vector3dc,
    public val k: Vector3dc,
    public val spot: ObservedCone?,
    public val placedBy: String? = null,
    public val isViewed: Boolean = false,
    public val fadedBy: Set<String> = emptySet(),
) {
    /** The same light by another name. */
    internal fun named(name: String) = ObservedLight(name, position, color, k, spot, placedBy, isViewed, fadedBy)
}

/**
 * A spotlight's cone as effectively used.
 *
 * @param direction in view space, away from the light, unit length.
 * @param innerAngle from the axis to the edge of full light in radians, likewise [outerAngle] to that of darkness; NaN where it has none.
 */
public class ObservedCone(public val direction: Vector3dc, public val innerAngle: Double, public val outerAngle: Double)
