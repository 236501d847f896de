package cga.measure.twin

import cga.exercise.components.shader.ShaderSource
import cga.exercise.game.Scene
import cga.framework.FrameDraw
import cga.framework.FrameTexture
import cga.framework.cooked.CookedFile
import cga.framework.image.CookedTexture
import cga.framework.model.CookedModel
import cga.framework.model.MaterialData
import cga.framework.model.MeshData
import cga.framework.model.ModelData
import org.joml.Vector3f
import java.nio.file.Path
import kotlin.io.path.writeLines
import kotlin.io.path.writeText

/**
 * What the C++ twin (tests/glm/twin.cpp) reads: a recorded frame as text, and beside it the meshes and textures as cooked files.
 *
 * Before the line `frame` stands what is set up once, after it what is sent in every frame, in order:
 *
 *     cga-twin 1
 *     size 1280 720
 *     samples 0
 *     vertex-shader FILE              and fragment-shader
 *     constant LIGHTS 6         for the shaders' "const int" lines
 *     model FILE                      numbered from 0
 *     texture 10497 10497 9987 9729 FILE     wrap s, wrap t, min and mag filter; numbered from 0
 *     parameter heading 0x0.0p0       of the scene
 *     frame
 *     uniform f1 material.shininess 0x1.9p5      i1, f1, f2, f3, m3, m4: type and count
 *     bind 0 7                        texture 7 to unit 0
 *     draw 0 2                        mesh 2 of model 0
 *
 * Numbers are hexadecimal, right to the bit.
 */
internal object Recording {
    /** The name of the text. */
    const val FILE = "frame.txt"
    private const val MODEL = "scene.model"

    /** Writes [recorded] into [folder] and answers the text's path. */
    fun write(
        recorded: RecordedFrame,
        folder: Path,
    ): Path {
        val draws = recorded.frame.draws
        val textures = draws.flatMap(::textures).distinctBy { it.image }
        CookedFile(emptyList(), CookedModel.encode(ModelData(draws.map(::mesh)))).write(folder.resolve(MODEL))
        textures.forEachIndexed { i, texture ->
            CookedFile(emptyList(), CookedTexture.encode(texture.image)).write(folder.resolve("$i.texture"))
        }
        val numbers = textures.withIndex().associate { (number, texture) -> texture.image to number }
        val setUp = header(recorded, folder) + files(folder, textures) + parameters(recorded)
        val lines = setUp + "frame" + frame(recorded) { numbers.getValue(it.image) }
        return folder.resolve(FILE).also { it.writeLines(lines) }
    }

    private fun header(
        recorded: RecordedFrame,
        folder: Path,
    ): List<String> =
        listOf(
            "cga-twin 1",
            "size ${recorded.picture.width} ${recorded.picture.height}",
            "samples ${recorded.samples}",
            "vertex-shader ${shader(Scene.VERTEX_SHADER, folder)}",
            "fragment-shader ${shader(Scene.FRAGMENT_SHADER, folder)}",
        ) + recorded.constants.map { (name, value) -> "constant $name $value" }

    /** The shader in one file, with what it includes. */
    private fun shader(
        path: String,
        folder: Path,
    ): Path = folder.resolve(Path.of(path).fileName).toAbsolutePath().also { it.writeText(ShaderSource.read(path).text) }

    private fun files(
        folder: Path,
        textures: List<FrameTexture>,
    ): List<String> =
        listOf("model ${folder.resolve(MODEL).toAbsolutePath()}") +
            textures.mapIndexed { i, it ->
                "texture ${it.wrapS} ${it.wrapT} ${it.minFilter} ${it.magFilter} ${folder.resolve("$i.texture").toAbsolutePath()}"
            }

    private fun parameters(recorded: RecordedFrame): List<String> =
        recorded.parameters.map { (name, value) -> "parameter $name ${value.toHex()}" }

    /** The uniforms, and where a material's begin its textures, and where they end the draw. */
    private fun frame(
        recorded: RecordedFrame,
        number: (FrameTexture) -> Int,
    ): List<String> {
        val draws = recorded.frame.draws
        var drawn = 0
        val lines =
            recorded.uniforms.flatMap { uniform ->
                val line = listOf("uniform ${uniform.type} ${uniform.name} ${numbers(uniform)}")
                when (uniform.name) {
                    FIRST_OF_MATERIAL -> textures(draws[drawn]).mapIndexed { unit, it -> "bind $unit ${number(it)}" } + line
                    LAST_OF_MATERIAL -> line + "draw 0 ${drawn++}"
                    else -> line
                }
            }
        check(drawn == draws.size) { "$drawn materials were sent, and there are ${draws.size} draws" }
        return lines
    }

    // As Material.bind sends them.
    private const val FIRST_OF_MATERIAL = "material.diffuse"
    private const val LAST_OF_MATERIAL = "tcMultiplier"

    private fun textures(draw: FrameDraw): List<FrameTexture> = draw.material.run { listOf(diffuse, emissive, specular) }

    private fun mesh(draw: FrameDraw) = MeshData(draw.vertices, draw.indices, NO_MATERIAL)

    private fun numbers(uniform: SentUniform): String =
        if (uniform.type == "i1") "${uniform.numbers.single().toInt()}" else uniform.numbers.joinToString(" ") { it.toDouble().toHex() }

    private fun Double.toHex(): String = java.lang.Double.toHexString(this)

    private val NO_MATERIAL = MaterialData("", Vector3f(), Vector3f(), Vector3f(), 0f, null, null, null)
}
