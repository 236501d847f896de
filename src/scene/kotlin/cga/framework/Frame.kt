package cga.framework

import cga.framework.image.TextureImage
import org.joml.Matrix4dc
import org.joml.Matrix4fc
import org.joml.Vector2fc
import org.joml.Vector3dc
import org.joml.Vector3fc

/** Which vector the specular term looks at. */
public enum class SpecularModel(public val title: String) {
    /** The reflected light vector against the vector to the eye (Phong 1975). */
    PHONG("Phong"),

    /** The half vector against the normal (Blinn 1977). */
    BLINN_PHONG("Blinn-Phong"),
}

/**
 * One picture as plain data: everything that decides its pixels and nothing of OpenGL.
 *
 * A scene makes one, a recorder makes one from draw calls, and the reference shades either. Immutable: the matrices and vectors are
 * copies that nobody changes. Matrices and positions are in double precision, the exact product of the floats that the scene holds.
 *
 * @param view world space → view space, rigid (rotation and translation only).
 * @param projection view space → clip space.
 * @param ambient L_a of the lighting model, linear RGB.
 * @param lights in the order in which their shares are added.
 * @param gamma 1 for none; otherwise colours are raised to 1/gamma at the end.
 */
public class Frame(
    public val view: Matrix4dc,
    public val projection: Matrix4fc,
    public val ambient: Vector3fc,
    public val specularModel: SpecularModel,
    public val gamma: Float,
    public val lights: List<FrameLight>,
    public val draws: List<FrameDraw>,
)

/**
 * One draw call: triangles with one material.
 *
 * @param vertices and [indices] as in [cga.framework.model.MeshData].
 * @param model model space → world space.
 * @param tint factor of the emissive colour, linear RGB.
 */
public class FrameDraw(
    public val vertices: FloatArray,
    public val indices: IntArray,
    public val model: Matrix4dc,
    public val tint: Vector3fc,
    public val material: FrameMaterial,
)

/**
 * M_e, M_d, M_s and k of the lighting model.
 *
 * @param tcMultiplier factor of the texture coordinates.
 */
public class FrameMaterial(
    public val emissive: FrameTexture,
    public val diffuse: FrameTexture,
    public val specular: FrameTexture,
    public val shininess: Float,
    public val tcMultiplier: Vector2fc,
)

/** A texture and how it is sampled; the four parameters are OpenGL's own constants (`GL_REPEAT`, `GL_LINEAR`, …). */
public class FrameTexture(
    public val image: TextureImage,
    public val wrapS: Int,
    public val wrapT: Int,
    public val minFilter: Int,
    public val magFilter: Int,
)
