package cga.grading.pipeline

import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Mistake
import cga.grading.findings.Place
import cga.grading.prepared.Edition
import cga.grading.prepared.Kind
import cga.grading.prepared.Prepared
import cga.grading.prepared.PreparedSource
import cga.grading.prepared.PreparedTree
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

class ExcerptsTest {
    @TempDir
    lateinit var folder: Path

    private fun excerpt(place: String): Place {
        val home = createTempDirectory(folder, "tree")
        val names = listOf("src/main/kotlin/cga/game/Scene.kt", "src/main/kotlin/other/Lamp.kt", "src/main/kotlin/cga/Linked.kt")
        val sources = names.mapIndexed { i, name -> PreparedSource(name, PreparedSource.place(i, name)) }
        for (part in listOf("sources", "reference", "start")) home.resolve(part).createDirectories()
        for (source in sources) {
            val file = home.resolve("sources/${source.file}")
            file.parent.createDirectories()
            file.writeText(List(20) { "line ${it + 1}" }.joinToString("\n"))
        }
        PreparedTree.write(Prepared(Kind.COURSE, Edition.ALL.first(), null, null, emptyList(), sources, emptyList()), home)
        val tree = PreparedTree.read(home)
        home.resolve("sources/${sources[2].file}").run {
            toFile().delete()
            createSymbolicLinkPointingTo(home.resolve("sources/${sources[0].file}"))
        }
        val found = Found(Mistake.MOUSE_FACTOR, 0.0, 1.0, "", places = listOf(Place.of(place)))
        val findings = Findings(emptyList(), listOf(found), emptyList(), emptyList(), emptyList())
        return Excerpts(tree).applied(findings).mistakes.single().places.single()
    }

    @Test
    fun `a line of Kotlin is shown with those around it, by the path of its file`() {
        val place = excerpt("cga/game/Scene.kt:10")
        assertEquals("src/main/kotlin/cga/game/Scene.kt:10", "$place")
        assertEquals((7..13).map { "line $it" } to 7, place.source to place.first)
    }

    @Test
    fun `a file whose folder is not its package is found by its name`() {
        assertEquals("src/main/kotlin/other/Lamp.kt:2", "${excerpt("cga/light/Lamp.kt:2")}")
        assertEquals(listOf("line 1", "line 2", "line 3", "line 4", "line 5"), excerpt("cga/light/Lamp.kt:2").source)
    }

    @Test
    fun `a line that is not there, a file that nobody has and a link are shown without`() {
        for (place in listOf("cga/game/Scene.kt:21", "cga/game/Scene.kt:0", "game/None.kt:1", "../../etc/passwd:1", "cga/Linked.kt:1")) {
            assertEquals(emptyList<String>(), excerpt(place).source, place)
        }
    }
}
