package cga.framework.model

import org.joml.Vector3fc

/** A model as plain data, in model space: what a file holds, before any OpenGL. */
public class ModelData(public val meshes: List<MeshData>)

/**
 * Triangles of one material.
 *
 * @param vertices eight floats each: position x y z, texture coordinates u v (v upwards), unit normal x y z.
 * @param indices three a triangle, counter-clockwise seen from outside.
 */
public class MeshData(
    public val vertices: FloatArray,
    public val indices: IntArray,
    public val material: MaterialData,
) {
    public companion object {
        /** Floats a vertex takes in [vertices]. */
        public const val FLOATS_PER_VERTEX: Int = 8
    }
}

/**
 * A surface as the model's author described it: a map (path of a picture) takes the place of the colour of the same name.
 *
 * @param shininess the specular exponent k.
 */
public class MaterialData(
    public val name: String,
    public val diffuse: Vector3fc,
    public val specular: Vector3fc,
    public val emissive: Vector3fc,
    public val shininess: Float,
    public val diffuseMap: String?,
    public val specularMap: String?,
    public val emissiveMap: String?,
)
