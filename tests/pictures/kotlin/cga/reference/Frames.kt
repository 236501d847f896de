package cga.reference

import cga.framework.Frame
import cga.framework.FrameCone
import cga.framework.FrameDraw
import cga.framework.FrameLight
import cga.framework.FrameMaterial
import cga.framework.FrameTexture
import cga.framework.SpecularModel
import cga.framework.image.TextureImage
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Matrix4f
import org.joml.Matrix4fc
import org.joml.Vector2f
import org.joml.Vector3d
import org.joml.Vector3f
import org.joml.Vector3fc
import org.lwjgl.opengl.GL33C.GL_LINEAR
import org.lwjgl.opengl.GL33C.GL_REPEAT

// Small frames to shade. World space is view space; unless a projection is given, a vertex (x, y, z) from −1 to 1 is where clip space has it.

internal val WHITE: Vector3fc = Vector3f(1f)
internal val BLACK: Vector3fc = Vector3f(0f)
internal val NO_FALLOFF: Vector3fc = Vector3f(1f, 0f, 0f)

internal fun frame(
    vararg draws: FrameDraw,
    lights: List<FrameLight> = emptyList(),
    ambient: Vector3fc = BLACK,
    specularModel: SpecularModel = SpecularModel.BLINN_PHONG,
    gamma: Float = 1f,
    projection: Matrix4fc = Matrix4f(),
) = Frame(Matrix4d(), projection, ambient, specularModel, gamma, lights, draws.toList())

internal fun pointLight(
    x: Double,
    y: Double,
    z: Double,
    color: Vector3fc = WHITE,
    k: Vector3fc = NO_FALLOFF,
    cone: FrameCone? = null,
) = FrameLight(Vector3d(x, y, z), color, k, cone)

/** Triangles of vertices with eight numbers each: position, texture coordinates, normal. */
internal fun draw(
    vertices: FloatArray,
    indices: IntArray = IntArray(vertices.size / 8) { it },
    model: Matrix4dc = Matrix4d(),
    tint: Vector3fc = WHITE,
    emissive: FrameTexture = plain(1f),
    diffuse: FrameTexture = plain(0f),
    specular: FrameTexture = plain(0f),
    shininess: Float = 1f,
) = FrameDraw(vertices, indices, model, tint, FrameMaterial(emissive, diffuse, specular, shininess, Vector2f(1f)))

/** A vertex with the texture coordinates (0, 0) and a normal towards +z. */
internal fun vertex(x: Double, y: Double, z: Double = 0.0) = floatArrayOf(x.toFloat(), y.toFloat(), z.toFloat(), 0f, 0f, 0f, 0f, 1f)

/** A texture of one texel. */
internal fun plain(
    gray: Float,
) = FrameTexture(TextureImage.ofColor(Vector3f(gray)), GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR)
