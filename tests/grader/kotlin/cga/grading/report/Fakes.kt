package cga.grading.report

import cga.framework.image.ImageData
import cga.framework.image.PngFile
import cga.grading.findings.Check
import cga.grading.findings.Evidence
import cga.grading.findings.FailureReason
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Graded
import cga.grading.findings.LogExcerpt
import cga.grading.findings.Measured
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import cga.grading.findings.Outcome
import cga.grading.findings.Place
import cga.grading.findings.Plot
import cga.grading.findings.Proof
import cga.grading.findings.Refused
import cga.grading.findings.RunFacts
import cga.grading.rubric.Rubric
import cga.imaging.BytePicture
import cga.imaging.PictureFile
import cga.testing.projectRoot
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.math.sin

/** Findings as they come out of the analysis, with pictures made from the golden images. */
internal object Fakes {
    private const val SHADER =
        "vec3 highlight(vec3 n, vec3 l, vec3 v, float shininess) {\n    // Phong\n    vec3 r = reflect(-l, n);\n" +
            "    float cosBeta = max(dot(r, v), 0.0);\n    return vec3(pow(cosBeta, shininess));\n}\n"
    private const val KOTLIN =
        "    override fun bind(program: ShaderProgram, name: String) {\n        super.bind(program, name)\n" +
            "        program.setUniform(\"name.attenuation\", attenuation)\n    }\n"

    const val HOSTILE = "<img src=x onerror=alert(1)> \"' onload=alert(2) x='\u0000\u202Egnp.exe\u001B[31m ]]> &amp;"

    private val golden = projectRoot.toPath().resolve("tests/golden")
    private val facts =
        RunFacts(
            "course",
            "2021",
            "Kotlin 2.2.21, language level 2.0",
            mapOf("unpack" to 0.1, "compile" to 2.9, "run" to 1.4, "measure" to 0.9),
            812L shl 20,
            listOf(LogExcerpt("compiler", "w: src/main/kotlin/cga/exercise/game/Scene.kt:41:13 Variable 'unused' is never used")),
        )

    /** Everything right. */
    fun perfect(folder: Path): Outcome {
        pictures(folder, "step-4.7", "step-4.7")
        return Graded(Findings(Check.entries.map { Measured(it, 0.003, "") }, emptyList(), plots(1.0), evidence(), emptyList()), facts)
    }

    /** Phong left in, and a cone inside out, which explains the highlight in the cone; the rest right but for one check that is open. */
    fun mistaken(folder: Path): Outcome {
        pictures(folder, "step-4.6", "step-4.7")
        val errors = mapOf(Check.HALF_VECTOR to 0.41, Check.CONE to 1.7, Check.CONE_SPECULAR to 0.6, Check.DIFFUSE to 0.1)
        val checks = Check.entries.map { check ->
            when (check) {
                Check.ORBIT_PIVOT -> Measured(check, null, "the motorcycle is hidden behind the camera's near plane")
                Check.MORE_LIGHTS -> Measured(check, null, "no further light changes the picture", found = false)
                Check.MORE_LIGHTS_SHADING -> Measured(check, null, "no further light changes the picture", found = false)
                Check.DIFFUSE -> Measured(check, 0.1, "mean 0.212 where 0.236 was expected, light pointLight.color")
                else -> Measured(check, errors[check] ?: 0.003, "")
            }
        }
        val mistakes =
            listOf(
                Found(
                    Mistake.CONE_INSIDE_OUT, 0.002, 0.31, "spotLight", proof = Proof(0.52, 3.4),
                    places = listOf(
                        Place("cga/exercise/components/light/SpotLight.kt", 3).within(KOTLIN),
                        Place("cga/exercise/game/Scene.kt", 88),
                        Place("cga/exercise/game/Game.kt", 31),
                    ),
                ),
                Found(
                    Mistake.PHONG_LEFT, 0.004, 0.08, "spotLight", listOf(Mistake.HALF_VECTOR_NOT_NORMALIZED),
                    places = listOf(Place("assets/shaders/tron_frag.glsl", 5).within(SHADER)), proof = Proof(0.997, 0.4),
                ),
                Found(Mistake.MORE_LIGHTS_MISSING, 0.0, 0.2, ""),
            )
        val cone = Evidence(Check.CONE, Message.plain("Spotlight alone, first frame"), "spot-measured.png", "spot-expected.png")
        return Graded(
            Findings(
                checks,
                mistakes,
                plots(1.6),
                evidence() + cone,
                listOf(Message.plain("assets/textures/sky.png was missing; a stand-in was given.")),
                Proof(0.94, 2.1),
            ),
            facts,
        )
    }

    /** Every text that a submission can get into the findings is an attack. */
    fun hostile(folder: Path): Outcome {
        pictures(folder, "step-4.2", "step-4.7")
        val checks = Check.entries.map { Measured(it, 0.5, HOSTILE) }
        val curve = Plot(Check.CONE, HOSTILE, HOSTILE, HOSTILE, doubleArrayOf(0.0, 1.0), doubleArrayOf(1.0, 1.0), doubleArrayOf(0.0, 1e300))
        val pictures =
            listOf(
                Evidence(null, Message.plain(HOSTILE), "measured.png", "expected.png"),
                Evidence(Check.CONE, Message.plain(HOSTILE), "gone.png", null),
            )
        val findings =
            Findings(
                checks,
                listOf(Found(Mistake.UNKNOWN, 0.3, 0.3, HOSTILE, places = listOf(Place(HOSTILE, 1, listOf(HOSTILE)), Place(HOSTILE, 2)))),
                listOf(curve),
                pictures,
                listOf(Message.plain(HOSTILE)),
            )
        val logs = listOf(LogExcerpt(HOSTILE, HOSTILE.repeat(2000)))
        return Graded(findings, RunFacts(HOSTILE, HOSTILE, HOSTILE, mapOf(HOSTILE to 1.0), 1, logs))
    }

    /** It does not compile. */
    fun refused(reason: FailureReason = FailureReason.DOES_NOT_COMPILE): Outcome =
        Refused(
            reason,
            "2 errors in src/main/kotlin/cga/exercise/game/Scene.kt",
            RunFacts(
                "course",
                "2021",
                "Kotlin 2.2.21, language level 2.0; then Kotlin 1.4.32",
                mapOf("unpack" to 0.1, "compile" to 4.2),
                700L shl 20,
                listOf(
                    LogExcerpt(
                        "Kotlin 1.4.32",
                        "e: Scene.kt:73:31 unresolved reference: spotLigth\ne: Scene.kt:88:9 expecting an element",
                    ),
                ),
            ),
        )

    fun submission(name: String, folder: Path, outcome: Outcome, rubric: Rubric = Rubric.default()): GradedSubmission =
        GradedSubmission(name, folder, outcome, rubric, 5.3)

    /** A folder below [parent] with an outcome that [make] left there. */
    fun submission(parent: Path, folder: String, name: String = folder, make: (Path) -> Outcome): GradedSubmission {
        val place = parent.resolve(folder).createDirectories()
        return submission(name, place, make(place))
    }

    private fun evidence() =
        listOf(
            Evidence(null, Message.plain("Fourth moment, 4.9 s"), "measured.png", "expected.png"),
            Evidence(Check.POINT_LIGHT, Message.plain("Point light alone (pointLight)"), "point-measured.png", "point-expected.png"),
            Evidence(
                Check.MORE_LIGHTS_SHADING,
                Message.plain("Corner lights alone (corners[0] to corners[3])"),
                "corner-measured.png",
                "corner-expected.png",
            ),
        )

    private fun pictures(folder: Path, measured: String, expected: String) {
        golden.resolve("$measured.png").copyTo(folder.resolve("measured.png"), overwrite = true)
        golden.resolve("$expected.png").copyTo(folder.resolve("expected.png"), overwrite = true)
        light(folder, "point", "step-4.1", "step-4.2")
        light(folder, "spot", "step-4.2", "step-4.3.4")
        light(folder, "corner", "step-4.5", "step-4.6")
    }

    private fun light(folder: Path, name: String, without: String, with: String) {
        val (dark, bright) = listOf(without, with).map { (PictureFile.read(golden.resolve("$it.png")) as BytePicture).image }
        val rgba = ByteArray(dark.rgba.size) { i -> maxOf(0, (bright.rgba[i].toInt() and 0xFF) - (dark.rgba[i].toInt() and 0xFF)).toByte() }
        val light = ImageData(dark.width, dark.height, rgba)
        PngFile.write(light, folder.resolve("$name-expected.png"))
        val half = ImageData(dark.width, dark.height, ByteArray(rgba.size) { ((rgba[it].toInt() and 0xFF) * 3 / 4).toByte() })
        PngFile.write(half, folder.resolve("$name-measured.png"))
    }

    private fun plots(factor: Double): List<Plot> {
        val distance = DoubleArray(120) { 0.5 + it * 0.1 }
        val attenuation = { d: Double, kq: Double -> 1 / (1 + 0.5 * d + kq * d * d) }
        val angle = DoubleArray(90) { it * 0.5 }
        val cone = { degrees: Double -> ((38 - degrees) / 14).coerceIn(0.0, 1.0) }
        return listOf(
            Plot(
                Check.ATTENUATION_POINT,
                "Attenuation of the point light",
                "distance",
                "F",
                distance,
                DoubleArray(120) { attenuation(distance[it], 0.1 * factor) + 0.002 * sin(it * 12.9) },
                DoubleArray(120) { attenuation(distance[it], 0.1) },
            ),
            Plot(
                Check.CONE,
                "Intensity of the spotlight over the angle",
                "angle in degrees",
                "I",
                angle,
                DoubleArray(90) { if (factor == 1.0) cone(angle[it]) else 1 - cone(angle[it]) },
                DoubleArray(90) { cone(angle[it]) },
            ),
        )
    }
}
