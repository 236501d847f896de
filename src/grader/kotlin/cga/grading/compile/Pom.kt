package cga.grading.compile

import org.w3c.dom.Element
import org.w3c.dom.Node
import org.xml.sax.SAXException
import java.io.StringReader
import javax.xml.parsers.DocumentBuilderFactory

/** A library that another needs. [isAlone]: without what it needs itself. */
internal class Dependency(
    val artifact: Artifact,
    val isAlone: Boolean,
)

/** What is read of a library's project file. */
internal object Pom {
    /** What [artifact] needs at run time by its project file [text]. Throws [LibraryUnavailable] where that is no sound XML. */
    fun dependencies(text: String, artifact: Artifact): List<Dependency> {
        val project = try {
            factory().newDocumentBuilder().parse(org.xml.sax.InputSource(StringReader(text))).documentElement
        } catch (e: SAXException) {
            throw LibraryUnavailable("the project file of $artifact cannot be read (${e.message}).", cause = e)
        }
        val list = project.child("dependencies")?.children("dependency").orEmpty()
        return list
            .filter { it.text("scope") in RUNTIME && it.text("optional") != "true" && it.text("type") in JARS }
            .mapNotNull { dependency ->
                val version = dependency.text("version")?.replace("\${project.version}", artifact.version)?.takeUnless { '$' in it }
                val excluded = dependency.child("exclusions")?.children("exclusion").orEmpty()
                version?.let {
                    val needed = Artifact(dependency.text("groupId").orEmpty(), dependency.text("artifactId").orEmpty(), it)
                    Dependency(needed, isAlone = excluded.any { exclusion -> exclusion.text("artifactId") == "*" })
                }
            }
    }

    private fun factory() =
        DocumentBuilderFactory.newInstance().apply {
            setFeature("http://apache.org/xml/features/disallow-doctype-decl", true)
            isExpandEntityReferences = false
        }

    private fun Element.children(name: String): List<Element> =
        generateSequence<Node>(firstChild) { it.nextSibling }.filterIsInstance<Element>().filter { it.tagName == name }.toList()

    private fun Element.child(name: String) = children(name).firstOrNull()

    private fun Element.text(name: String) = child(name)?.textContent?.trim()

    private val RUNTIME = setOf(null, "compile", "runtime")
    private val JARS = setOf(null, "jar")
}
