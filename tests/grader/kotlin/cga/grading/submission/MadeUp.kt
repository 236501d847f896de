package cga.grading.submission

import cga.grading.prepared.PreparedTree
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.writeText

/** A small made-up submission. */
object MadeUp {
    const val SCENE =
        "package cga.exercise.game\nclass Scene(val window: cga.framework.GameWindow) {\n" +
            "    fun render(dt: Float, t: Float) { println(\"\$dt \$t\") }\n}\n"
    const val GAME =
        "package cga.exercise.game\nimport cga.framework.GameWindow\n" +
            "class Game : GameWindow(1, 2) { val scene = Scene(this) }\n"
    const val MAIN =
        "package cga.exercise\nimport cga.exercise.game.Game\n" +
            "fun main(args: Array<String>) {\n    val game = Game()\n    game.run()\n}\n"
    const val WINDOW = "package cga.framework\nopen class GameWindow(val width: Int, val height: Int) { fun run() { println(width) } }\n"
    const val ROTATE = "package cga.exercise.components.geometry\nopen class Transformable { fun rotateLocal(a: Float) { println(a) } }\n"

    val FILES = mapOf(
        "src/main/kotlin/cga/exercise/game/Scene.kt" to SCENE,
        "src/main/kotlin/cga/exercise/game/Game.kt" to GAME,
        "src/main/kotlin/cga/exercise/Main.kt" to MAIN,
        "src/main/kotlin/cga/framework/GameWindow.kt" to WINDOW,
        "src/main/kotlin/cga/exercise/components/geometry/Transformable.kt" to ROTATE,
        "assets/shaders/tron_vert.glsl" to "#version 330 core\n",
        "build.gradle" to
            "plugins { id 'org.jetbrains.kotlin.jvm' version '1.3.72' }\nproject.ext.lwjglVersion = \"3.2.3\"\nproject.ext.jomlVersion = '1.9.24'\n",
    )

    /** The plain tree that is made of [files], below [folder], with [window] as what stands in for theirs. */
    internal fun prepare(folder: Path, files: Map<String, String> = FILES, window: String = WINDOW): PreparedTree {
        val target = folder.resolve("tree").createDirectories()
        Preparation.prepare(write(folder.resolve("handed in"), files), target, null)
        return PreparedTree.read(target).also { tree -> tree.files().filterKeys { it.isOurs }.values.single().writeText(window) }
    }

    /** Writes [files] below [folder]. */
    fun write(folder: Path, files: Map<String, String> = FILES): Path {
        for ((name, text) in files) folder.resolve(name).createParentDirectories().writeText(text)
        return folder
    }
}
